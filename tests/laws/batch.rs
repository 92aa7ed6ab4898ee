//! Batches: what functions of one element give, to the bit, at any length; lengths that differ are
//! refused before anything is written.

use crate::common::ODD;
use crate::common::arbitrary::Source;
use crate::common::size::size;
use lobe::batch::{self, Columns, Fixed, Footprint};
use lobe::filter::{
    DiskKernel, kaplanyan_deferred_alpha, kaplanyan_deferred_alphas, largest_deferred_alpha,
    tokuyoshi_deferred_alpha, tokuyoshi_kaplanyan_deferred_alpha,
};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{
    Anisotropic, AxisAligned, Distribution, Error, Ggx, Isotropic, Kernel, LobeShape, Ndf,
    NonCentered, PixelFilter, Psd, Real, Roughness, SlopeMoments,
};

/// Any filter.
const FILTER: PixelFilter = PixelFilter::TOKUYOSHI_KAPLANYAN;

/// What batches read, a column for each number.
struct Data<R> {
    alphas: [Vec<R>; 2],
    factor: [Vec<R>; 3],
    mean: [Vec<R>; 2],
    second: [Vec<R>; 3],
    sides: [Vec<R>; 4],
    slope: [Vec<R>; 2],
    wo: [Vec<R>; 3],
    wi: [Vec<R>; 3],
    turns: [Vec<R>; 6],
}

/// Columns of what `of` makes of each element's own source.
fn columns<R: Real, const N: usize>(
    length: usize,
    seed: u64,
    of: impl Fn(&mut Source) -> [f64; N],
) -> [Vec<R>; N] {
    let elements: Vec<[f64; N]> =
        (0..length as u64).map(|k| of(&mut Source::from_seed(1000 * seed + k))).collect();
    std::array::from_fn(|n| elements.iter().map(|element| R::lit(element[n])).collect())
}

/// Numbers of a texture: some of them odd.
fn stored<const N: usize>(source: &mut Source, numbers: [f64; N]) -> [f64; N] {
    numbers.map(|x| if source.pick(8) == 0 { ODD[source.pick(17) as usize] } else { x })
}

impl<R: Real> Data<R> {
    fn new(length: usize) -> Self {
        let seed = length as u64;
        let factor = |s: &mut Source| [s.alpha(), s.uniform(-0.5, 0.5), s.alpha()];
        let second = |s: &mut Source| {
            let [x, y] = s.vector(0.01, 1.0);
            [x * x + 0.1 * s.unit(), x * y, y * y + 0.1 * s.unit()]
        };
        Self {
            alphas: columns(length, seed, |s| {
                let alphas = [s.alpha(), s.alpha()];
                stored(s, alphas)
            }),
            factor: columns(length, seed + 1, |s| {
                let numbers = factor(s);
                stored(s, numbers)
            }),
            mean: columns(length, seed + 2, |s| {
                let mean = s.mean();
                stored(s, mean)
            }),
            second: columns(length, seed + 3, |s| {
                let numbers = second(s);
                stored(s, numbers)
            }),
            sides: columns(length, seed + 4, |s| {
                let footprint = s.footprint();
                let ([a, b], [c, d]) = (footprint.u, footprint.v);
                [a, b, c, d]
            }),
            slope: columns(length, seed + 5, Source::slope),
            wo: columns(length, seed + 6, Source::direction),
            wi: columns(length, seed + 7, Source::direction),
            turns: columns(length, seed + 8, |s| {
                let turns = std::array::from_fn(|_| s.uniform(-0.3, 0.3));
                stored(s, turns)
            }),
        }
    }

    fn length(&self) -> usize {
        self.slope[0].len()
    }

    /// The footprints, as columns and one by one.
    fn footprints(&self) -> Footprint<[&[R]; 2]> {
        let [a, b, c, d] = slices(&self.sides);
        Footprint { u: [a, b], v: [c, d] }
    }

    fn footprint(&self, k: usize) -> lobe::Footprint<R> {
        let [a, b, c, d] = element(&self.sides, k);
        lobe::Footprint::from_slopes([a, b], [c, d])
    }

    fn kernel(&self, k: usize) -> Kernel<R> {
        Kernel::of(&self.footprint(k), FILTER)
    }

    fn disk_kernel(&self, k: usize) -> DiskKernel<R> {
        let [a, b, c, d] = element(&self.sides, k);
        DiskKernel::of([a, b], [c, d], FILTER)
    }

    fn round(&self, k: usize) -> Isotropic<R> {
        Isotropic::saturating(self.alphas[0][k])
    }

    fn any(&self, k: usize) -> Anisotropic<R> {
        let factor = Psd::saturating_cholesky(element(&self.factor, k));
        Anisotropic::new(Roughness::from_matrix(factor))
    }
}

fn slices<R, const N: usize>(columns: &[Vec<R>; N]) -> [&[R]; N] {
    std::array::from_fn(|n| columns[n].as_slice())
}

fn element<R: Copy, const N: usize>(columns: &[Vec<R>; N], k: usize) -> [R; N] {
    std::array::from_fn(|n| columns[n][k])
}

/// A deferred alpha of one element.
type Deferred<R> = fn(R, [R; 3], [R; 3], PixelFilter, R) -> Result<R, Error>;

/// Equal bits, or NaN both times.
#[track_caller]
fn equal<R: Real>(got: &[R], want: impl Fn(usize) -> R) {
    for (k, got) in got.iter().enumerate() {
        let (got, want) = (got.to_f64(), want(k).to_f64());
        let same = got.to_bits() == want.to_bits() || got.is_nan() && want.is_nan();
        assert!(same, "{got:e} is not {want:e} at {k} of {}", std::any::type_name::<R>());
    }
}

/// Density and BRDF of GGX over shapes, of columns and `one` by one.
fn agrees<S: Columns<Item: LobeShape<Scalar = R>>, R: Real>(
    data: &Data<R>,
    shapes: S,
    one: impl Fn(usize) -> S::Item,
) {
    let (ndf, batch) = (|k| Ggx::new(one(k)), batch::Ggx::new(shapes));
    let mut out = vec![R::ZERO; data.length()];
    batch.slope_pdf(slices(&data.slope), &mut out).expect("one length");
    equal(&out, |k| ndf(k).slope_pdf(element(&data.slope, k)));
    batch.brdf(slices(&data.wo), slices(&data.wi), &mut out).expect("one length");
    equal(&out, |k| ndf(k).brdf(element(&data.wo, k), element(&data.wi, k)));
}

/// The same of all that a distribution gives.
fn all_agrees<D: Distribution, S: Columns<Item: LobeShape<Scalar = R>>, R: Real>(
    data: &Data<R>,
    shapes: S,
    one: impl Fn(usize) -> S::Item,
) {
    let ndf = |k| Ndf::<D, S::Item>::new(one(k));
    let (batch, up) = (batch::Ndf::<D, S>::new(shapes), [R::lit(0.6), R::ZERO, R::lit(0.8)]);
    let (wo, wi) = (slices(&data.wo), slices(&data.wi));
    let (o, i) = (|k| element(&data.wo, k), |k| element(&data.wi, k));
    let mut out = vec![R::ZERO; data.length()];
    batch.slope_pdf(slices(&data.slope), &mut out).expect("one length");
    equal(&out, |k| ndf(k).slope_pdf(element(&data.slope, k)));
    batch.d(wo, &mut out).expect("one length");
    equal(&out, |k| ndf(k).d(o(k)));
    batch.projected_area(wo, &mut out).expect("one length");
    equal(&out, |k| ndf(k).projected_area(o(k)));
    batch.g1(wo, &mut out).expect("one length");
    equal(&out, |k| ndf(k).g1(o(k)));
    batch.visibility(wo, wi, &mut out).expect("one length");
    equal(&out, |k| ndf(k).visibility(o(k), i(k)));
    batch.brdf(Fixed(up), wi, &mut out).expect("one length");
    equal(&out, |k| ndf(k).brdf(up, i(k)));
}

/// Lengths around those of lanes, and of more than one block.
fn lengths() -> impl Iterator<Item = usize> {
    (0..=67).step_by(size(3, 1)).chain([64, 65, 255, 256, 257, 600])
}

fn shapes_agree<R: Real>() {
    for data in lengths().map(Data::<R>::new) {
        let (alphas, means) = (slices(&data.alphas), slices(&data.mean));
        agrees(&data, batch::Isotropic(alphas[0]), |k| data.round(k));
        let alpha = R::lit(0.2);
        agrees(&data, batch::Isotropic(Fixed(alpha)), |_| Isotropic::saturating(alpha));
        let aligned = |k: usize| AxisAligned::saturating(data.alphas[0][k], data.alphas[1][k]);
        agrees(&data, batch::AxisAligned(alphas), aligned);
        let any = batch::Anisotropic(slices(&data.factor));
        agrees(&data, any, |k| data.any(k));
        let tilted = |k| NonCentered::saturating(data.any(k), element(&data.mean, k));
        let shapes = batch::NonCentered { shapes: any, means };
        all_agrees::<GgxDistribution, _, R>(&data, shapes, tilted);
        all_agrees::<BeckmannDistribution, _, R>(&data, shapes, tilted);
        let mean = [R::lit(0.3), R::lit(-0.1)];
        let round = batch::Isotropic(alphas[0]);
        agrees(&data, batch::NonCentered { shapes: round, means: Fixed(mean) }, |k| {
            NonCentered::saturating(data.round(k), mean)
        });
    }
}

fn widened_shapes_agree<R: Real>() {
    for data in lengths().map(Data::<R>::new) {
        let (footprints, filter) = (data.footprints(), FILTER);
        let shapes = batch::Isotropic(data.alphas[0].as_slice());
        agrees(&data, batch::Widened { shapes, footprints, filter }, |k| {
            data.kernel(k).widen(data.round(k))
        });
        agrees(&data, batch::WidenedOnDisk { shapes, footprints, filter }, |k| {
            data.disk_kernel(k).widen(data.round(k))
        });
        let (any, means) = (batch::Anisotropic(slices(&data.factor)), slices(&data.mean));
        let tilted = |k| NonCentered::saturating(data.any(k), element(&data.mean, k));
        let shapes = batch::NonCentered { shapes: any, means };
        agrees(&data, batch::WidenedToPeak { shapes, footprints, filter }, |k| {
            data.kernel(k).widen_to_peak(tilted(k))
        });
        let pixel = lobe::Footprint::rectangle([R::lit(0.1), R::lit(0.02)]);
        let footprints = Fixed(pixel);
        agrees(&data, batch::Widened { shapes, footprints, filter }, |k| {
            Kernel::of(&pixel, filter).widen(tilted(k))
        });
    }
}

fn moments_agree<R: Real>() {
    for data in lengths().map(Data::<R>::new) {
        let (means, seconds) = (slices(&data.mean), slices(&data.second));
        let moments =
            |k| SlopeMoments::saturating_raw(element(&data.mean, k), element(&data.second, k));
        let base = batch::Isotropic(data.alphas[0].as_slice());
        agrees(&data, batch::SlopeMoments { means, seconds, base }, |k| {
            moments(k).lobe(data.round(k).into()).shape()
        });
        let one = Roughness::from_matrix(Psd::saturating_cholesky([R::HALF, R::HALF, R::HALF]));
        agrees(&data, batch::SlopeMoments { means, seconds, base: Fixed(one) }, |k| {
            moments(k).lobe(one).shape()
        });
    }
}

fn polygon_means_agree<R: Real>() {
    let agrees = |data: &Data<R>| {
        let shapes = batch::AxisAligned([Fixed(R::lit(0.2)), Fixed(R::lit(0.05))]);
        let ggx = Ggx::new(AxisAligned::saturating(R::lit(0.2), R::lit(0.05)));
        let mut out = vec![R::ZERO; data.length()];
        let batch = batch::Ggx::new(shapes);
        let slopes = slices(&data.slope);
        batch.parallelogram_mean(slopes, data.footprints(), &mut out).expect("one length");
        equal(&out, |k| ggx.parallelogram_mean(element(&data.slope, k), &data.footprint(k)));
        let (wo, wi) = (slices(&data.wo), slices(&data.wi));
        batch.parallelogram_mean_in_lanes(slopes, data.footprints(), &mut out).expect("one length");
        equal(&out, |k| {
            ggx.parallelogram_mean_in_lanes(element(&data.slope, k), &data.footprint(k))
        });
        batch.brdf_over_in_lanes(wo, wi, data.footprints(), &mut out).expect("one length");
        equal(&out, |k| {
            ggx.brdf_over_in_lanes(element(&data.wo, k), element(&data.wi, k), &data.footprint(k))
        });
        batch.brdf_over(wo, wi, data.footprints(), &mut out).expect("one length");
        equal(&out, |k| {
            ggx.brdf_over(element(&data.wo, k), element(&data.wi, k), &data.footprint(k))
        });
    };
    lengths().map(Data::new).for_each(|data| agrees(&data));
}

#[test]
fn polygon_means_by_f64_inside_agree() {
    let agrees = |data: &Data<f32>| {
        let shapes = batch::AxisAligned([Fixed(0.2), Fixed(0.05)]);
        let ggx = Ggx::new(AxisAligned::saturating(0.2, 0.05));
        let mut out = vec![0.0; data.length()];
        let (slopes, over) = (slices(&data.slope), data.footprints());
        batch::Ggx::new(shapes)
            .parallelogram_mean_in_double(slopes, over, &mut out)
            .expect("one length");
        equal(&out, |k| {
            ggx.parallelogram_mean_in_double(element(&data.slope, k), &data.footprint(k))
        });
    };
    lengths().map(Data::new).for_each(|data| agrees(&data));
}

fn maps_of_roughness_agree<R: Real>() {
    for data in lengths().map(Data::<R>::new) {
        let mut out: [Vec<R>; 3] = std::array::from_fn(|_| vec![R::ZERO; data.length()]);
        let agree = |out: &[Vec<R>; 3], one: &dyn Fn(usize) -> Roughness<R>| {
            for (n, column) in out.iter().enumerate() {
                equal(column, |k| one(k).matrix().cholesky()[n]);
            }
        };
        let (round, any) = (batch::Isotropic(data.alphas[0].as_slice()), slices(&data.factor));
        let (footprints, any) = (data.footprints(), batch::Anisotropic(any));
        let base = |k: usize| Roughness::from(data.round(k));
        batch::widened(round, footprints, FILTER, out.each_mut().map(Vec::as_mut_slice))
            .expect("one length");
        agree(&out, &|k| base(k).widened(&data.kernel(k)));
        batch::widened(any, footprints, FILTER, out.each_mut().map(Vec::as_mut_slice))
            .expect("one length");
        agree(&out, &|k| data.any(k).roughness().widened(&data.kernel(k)));
        batch::peak_fitted(any, footprints, FILTER, out.each_mut().map(Vec::as_mut_slice))
            .expect("one length");
        agree(&out, &|k| data.any(k).roughness().peak_fitted(&data.kernel(k)));
        batch::widened_on_disk(round, footprints, FILTER, out.each_mut().map(Vec::as_mut_slice))
            .expect("one length");
        agree(&out, &|k| base(k).widened_on_disk(&data.disk_kernel(k)));
    }
}

fn deferred_alphas_agree<R: Real>() {
    for data in lengths().map(Data::<R>::new) {
        let mut out = vec![R::ZERO; data.length()];
        let ([a, b, c, d, e, f], alphas) = (slices(&data.turns), data.alphas[0].as_slice());
        let (u, v, limit) = ([a, b, c], [d, e, f], R::lit(0.18));
        let one = |k: usize, of: Deferred<R>| {
            let [a, b, c, d, e, f] = element(&data.turns, k);
            of(data.round(k).alpha(), [a, b, c], [d, e, f], FILTER, limit).expect("an alpha")
        };
        batch::tokuyoshi_deferred_alpha(alphas, u, v, FILTER, limit, &mut out).expect("valid");
        equal(&out, |k| one(k, tokuyoshi_deferred_alpha));
        batch::tokuyoshi_kaplanyan_deferred_alpha(alphas, u, v, FILTER, limit, &mut out)
            .expect("valid");
        equal(&out, |k| one(k, tokuyoshi_kaplanyan_deferred_alpha));
        batch::largest_deferred_alpha(alphas, u, v, FILTER, limit, &mut out).expect("valid");
        equal(&out, |k| one(k, largest_deferred_alpha));
        batch::kaplanyan_deferred_alpha(alphas, data.footprints(), FILTER, limit, &mut out)
            .expect("valid");
        equal(&out, |k| {
            kaplanyan_deferred_alpha(data.round(k).alpha(), &data.footprint(k), FILTER, limit)
                .expect("an alpha")
        });
        let mut across = out.clone();
        let pair = [&mut out[..], &mut across];
        let both = [alphas, data.alphas[1].as_slice()];
        batch::kaplanyan_deferred_alphas(both, data.footprints(), FILTER, limit, pair)
            .expect("valid");
        let one = |k: usize| {
            let alphas = [0, 1].map(|n| Isotropic::saturating(data.alphas[n][k]).alpha());
            kaplanyan_deferred_alphas(alphas, &data.footprint(k), FILTER, limit).expect("alphas")
        };
        equal(&out, |k| one(k)[0]);
        equal(&across, |k| one(k)[1]);
        let refused = batch::largest_deferred_alpha(alphas, u, v, FILTER, -R::ONE, &mut out);
        assert_eq!(refused, Err(Error::Limit((-1.0_f64).into())));
    }
}

#[test]
fn batches_of_shapes_are_loops_to_the_bit() {
    shapes_agree::<f32>();
    shapes_agree::<f64>();
}

#[test]
fn batches_of_widened_shapes_are_loops_to_the_bit() {
    widened_shapes_agree::<f32>();
    widened_shapes_agree::<f64>();
}

#[test]
fn batches_of_moments_are_loops_to_the_bit() {
    moments_agree::<f32>();
    moments_agree::<f64>();
}

#[test]
fn batches_of_polygon_means_are_loops_to_the_bit() {
    polygon_means_agree::<f32>();
    polygon_means_agree::<f64>();
}

#[test]
fn batches_of_roughness_are_loops_to_the_bit() {
    maps_of_roughness_agree::<f32>();
    maps_of_roughness_agree::<f64>();
}

#[test]
fn batches_of_deferred_alphas_are_loops_to_the_bit() {
    deferred_alphas_agree::<f32>();
    deferred_alphas_agree::<f64>();
}

/// Runs `batch` with each of N columns of input shortened and lengthened in turn, and with each of
/// M of output: all are refused, and nothing is written.
fn refuses<const N: usize, const M: usize>(
    batch: impl Fn([&[f32]; N], [&mut [f32]; M]) -> Result<(), Error>,
) {
    const LENGTH: usize = 5;
    let input = [0.3; LENGTH + 1];
    let run = |lengths: [usize; N], sizes: [usize; M]| {
        let mut out = [[7.0; LENGTH + 1]; M];
        let mut sizes = sizes.iter();
        let slices = out.each_mut().map(|out| &mut out[..*sizes.next().expect("a size")]);
        (batch(lengths.map(|length| &input[..length]), slices), out)
    };
    let (done, out) = run([LENGTH; N], [LENGTH; M]);
    assert_eq!(done, Ok(()));
    assert!(out.iter().all(|out| out[0] != 7.0 && out[LENGTH] == 7.0));
    for wrong in [0, LENGTH - 1, LENGTH + 1] {
        for column in 0..N {
            let mut lengths = [LENGTH; N];
            lengths[column] = wrong;
            let (refused, out) = run(lengths, [LENGTH; M]);
            assert_eq!(refused, Err(Error::Length { expected: LENGTH, found: wrong }), "{column}");
            assert_eq!(out, [[7.0; LENGTH + 1]; M], "{column}");
        }
        for column in 0..M {
            let mut sizes = [LENGTH; M];
            sizes[column] = wrong;
            let (refused, out) = run([LENGTH; N], sizes);
            assert!(matches!(refused, Err(Error::Length { .. })), "{column}: {refused:?}");
            assert_eq!(out, [[7.0; LENGTH + 1]; M], "{column}");
        }
    }
}

#[test]
fn lengths_that_differ_are_refused_before_anything_is_written() {
    refuses(|[a, b, x, y], [out]| {
        batch::Ggx::new(batch::AxisAligned([a, b])).slope_pdf([x, y], out)
    });
    refuses(|[a, x, y, z], [out]| batch::Ggx::new(batch::Isotropic(a)).d([x, y, z], out));
    refuses(|[a, x, y, z], [out]| batch::Beckmann::new(batch::Isotropic(a)).g1([x, y, z], out));
    refuses(|[l, m, n, x, y, z], [out]| {
        batch::Ggx::new(batch::Anisotropic([l, m, n])).projected_area([x, y, z], out)
    });
    refuses(|[x, y, z, u, v, w], [out]| {
        let ggx = batch::Ggx::new(batch::Isotropic(Fixed(0.1)));
        ggx.visibility([x, y, z], [u, v, w], out)
    });
    refuses(|[m, n, xx, xy, yy, base], [out]| {
        let base = batch::Isotropic(base);
        let shapes = batch::SlopeMoments { means: [m, n], seconds: [xx, xy, yy], base };
        batch::Ggx::new(shapes).slope_pdf(Fixed([0.0; 2]), out)
    });
    refuses(|[a, m, n, p, q, r, s, o, i], [out]| {
        let shapes = batch::NonCentered { shapes: batch::Isotropic(a), means: [m, n] };
        let footprints = Footprint { u: [p, q], v: [r, s] };
        let shapes = batch::Widened { shapes, footprints, filter: FILTER };
        batch::Beckmann::new(shapes).brdf([o, o, o], [i, i, i], out)
    });
    refuses(|[a, p, q, r, s, x, y], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::Ggx::new(batch::Isotropic(a)).parallelogram_mean([x, y], footprints, out)
    });
    refuses(|[a, p, q, r, s, x, y], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        let ggx = batch::Ggx::new(batch::Isotropic(a));
        ggx.parallelogram_mean_in_double([x, y], footprints, out)
    });
    refuses(|[a, p, q, r, s, x, y], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        let ggx = batch::Ggx::new(batch::Isotropic(a));
        ggx.parallelogram_mean_in_lanes([x, y], footprints, out)
    });
    refuses(|[a, p, q, r, s, o, i], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::Ggx::new(batch::Isotropic(a)).brdf_over_in_lanes(
            [o, o, o],
            [i, i, i],
            footprints,
            out,
        )
    });
    refuses(|[a, p, q, r, s, o, i], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::Ggx::new(batch::Isotropic(a)).brdf_over([o, o, o], [i, i, i], footprints, out)
    });
}

#[test]
fn maps_of_different_lengths_are_refused_before_anything_is_written() {
    refuses(|[a, p, q, r, s], out: [&mut [f32]; 3]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::widened(batch::Isotropic(a), footprints, FILTER, out)
    });
    refuses(|[a, b, p, q, r, s], out: [&mut [f32]; 3]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::peak_fitted(batch::AxisAligned([a, b]), footprints, FILTER, out)
    });
    refuses(|[a, p, q, r, s], out: [&mut [f32]; 3]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::widened_on_disk(batch::Isotropic(a), footprints, FILTER, out)
    });
    refuses(|[alphas, a, b, c, d, e, f], [out]| {
        batch::tokuyoshi_deferred_alpha(alphas, [a, b, c], [d, e, f], FILTER, 0.18, out)
    });
    refuses(|[alphas, a, b, c, d, e, f], [out]| {
        batch::tokuyoshi_kaplanyan_deferred_alpha(alphas, [a, b, c], [d, e, f], FILTER, 0.18, out)
    });
    refuses(|[alphas, a, b, c, d, e, f], [out]| {
        batch::largest_deferred_alpha(alphas, [a, b, c], [d, e, f], FILTER, 0.18, out)
    });
    refuses(|[alphas, p, q, r, s], [out]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::kaplanyan_deferred_alpha(alphas, footprints, FILTER, 0.18, out)
    });
    refuses(|[a, b, p, q, r, s], out: [&mut [f32]; 2]| {
        let footprints = Footprint { u: [p, q], v: [r, s] };
        batch::kaplanyan_deferred_alphas([a, b], footprints, FILTER, 0.18, out)
    });
}

#[test]
fn numbers_beyond_their_range_count_as_the_nearest() {
    let psd = Psd::saturating_cholesky([f64::NAN, 0.5, 0.5]);
    assert_eq!(psd.cholesky(), [0.0, 0.0, 0.5]);
    for &x in &ODD {
        for &y in &ODD {
            let [l_xx, l_yx, l_yy] = Psd::saturating_cholesky([x, y, x]).cholesky();
            assert!(Psd::from_cholesky([l_xx, l_yx, l_yy]).is_ok(), "{x} {y}");
            let valid = Psd::from_cholesky([x, y, x]);
            let equal = |factor: Psd<f64>| factor.cholesky() == [l_xx, l_yx, l_yy];
            assert!(valid.is_err() || valid.is_ok_and(equal), "{x} {y}");
            let moments = SlopeMoments::saturating_raw([x, y], [x, y, x]);
            let checked = SlopeMoments::new(moments.mean(), moments.covariance());
            assert_eq!(checked, Ok(moments));
            let valid = SlopeMoments::from_raw([x, y], [x, y, x]);
            assert!(valid.is_err() || valid == Ok(moments), "{x} {y}");
        }
    }
}
