//! Many lobes in one pixel: its integral, its evenness, its masking, and what it tends to (laws C3
//! to C6).
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::facets::{dictionary, dot, integral, kernels, pixel, roughness};
use crate::common::quadrature::midpoints;
use crate::common::size::size;
use crate::common::{check, ensure, near};
use lobe::material::cells::Patch;
use lobe::material::multilobe::{MultiLobe, PatchNdf};
use lobe::ndf::{cavity_masking, cavity_masking_shadowing};
use lobe::slope::MeanFrame;
use lobe::slope::direction::{half_vector, normal_of, normalize, slope_of};
use lobe::{Anisotropic, Beckmann, Footprint, Kernel, PixelFilter, Psd, Roughness, SlopeMoments};

/// A pixel as it is, under kernels of all forms, over a normal map, with smooth cells, and by mips.
fn variants(pixel: PatchNdf<'static, f64>) -> Vec<PatchNdf<'static, f64>> {
    let relief = Psd::new(0.03, 0.01, 0.02).expect("valid");
    let over = pixel.over(&SlopeMoments::new([0.0; 2], relief).expect("in range"));
    let footprint = Footprint::from_slopes([0.1, 0.05], [-0.02, 0.2]);
    let kernels = kernels(roughness().covariance());
    let under = kernels.iter().map(|kernel| pixel.widened(kernel));
    [pixel, over, pixel.with_mips(&footprint, 0.5)].into_iter().chain(under).collect()
}

/// Deviations beyond which nothing is: a table's diagonal, and half that of the widest kernel.
const REACH: f64 = 8.7;

/// The square that the k-th variant is integrated over: its half side in deviations, and its
/// midpoints along a side. Unfiltered lobes end sooner, and have kinks at nodes 1/16 apart.
fn square(k: usize) -> (f64, u32) {
    if [0, 2].contains(&k) { (5.7, 460) } else { (REACH, 400) }
}

/// Law C3: every pixel's density integrates to 1, whatever filters it.
#[test]
fn every_pixel_s_density_integrates_to_one() {
    for index in 0..2 {
        let variants = variants(pixel([1.0, 1e3][index as usize], index));
        // An ordinary run takes some variants of each pixel, and others of the next.
        let (first, step) = size((4 * index as usize, 8), (0, 1));
        for (k, pixel) in variants.iter().enumerate().skip(first).step_by(step) {
            let (reach, nodes) = square(k);
            let whole = integral(|slope| pixel.slope_pdf(slope), reach, nodes);
            // A sum of midpoints over lines between nodes, turned by anything.
            assert!((whole - 1.0).abs() < 1e-3, "{index}, variant {k}: {whole}");
        }
    }
}

/// The same in f32, by midpoints that rounding cannot move to another cell's border.
#[test]
fn the_same_in_single_precision() {
    use lobe::material::multilobe::{Dictionary, Recipe};
    let dictionary = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    let facets = MultiLobe::new(Roughness::from_alpha(0.4_f32).expect("in range"), 30.0);
    let facets = facets.expect("in range");
    for index in 0..size(10, 40_u8) {
        let patch = Patch::new([0.37 * f32::from(index), 0.2], [1.0, 0.0], [0.0, 1.5]);
        // Square pixels, and those that rounding makes nearly so.
        let side = 0.05 + 0.02 * f32::from(index);
        let footprint = Footprint::from_slopes(
            [side, 0.0],
            [0.0, side * [1.0, 1.0 + 1e-7][usize::from(index % 2)]],
        );
        let pixel =
            facets.ndf(&dictionary, &patch).widened(&Kernel::of(&footprint, PixelFilter::BOX));
        let density = |slope: [f64; 2]| f64::from(pixel.slope_pdf(slope.map(|x| x as f32)));
        let whole = midpoints(2.6, 200, density);
        assert!((whole - 1.0).abs() < 4e-3, "{index}, side {side}: {whole}");
    }
}

/// Law C4: it is even, to the bit.
#[test]
fn every_pixel_s_density_is_even() {
    for index in 0..12 {
        let mut source = Source::from_seed(index);
        for pixel in variants(pixel([1.0, 30.0, 1e4][index as usize % 3], index)) {
            for _ in 0..8 {
                let slope = [source.uniform(-0.9, 0.9), source.uniform(-0.5, 0.5)];
                for slope in [slope, [slope[0], 0.0], [0.0, slope[1]]] {
                    let there = pixel.slope_pdf(slope.map(|x| -x));
                    assert_eq!(pixel.slope_pdf(slope), there, "{index}: {slope:?}");
                }
            }
        }
    }
}

/// Law C5: V-cavities are exact for every pixel, $\int G_1 (w \cdot m)^+ D\, dm = w_z$.
#[test]
fn masking_is_exact() {
    for index in 0..5_u8 {
        let angle = [0.0_f64, 0.5, 1.0, 1.4, 1.5][usize::from(index)];
        let turn = f64::from(index);
        let wo = [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()];
        let pixel = pixel([3.0, 1e3][usize::from(index % 2)], index.into());
        // Each view has some of the forms of kernels.
        let step = size(13, 5);
        let variants = variants(pixel);
        for (k, pixel) in variants.iter().enumerate().skip(usize::from(index)).step_by(step) {
            // D dm = P22 ds / m_z.
            let seen = |slope: [f64; 2]| {
                let m = normal_of(slope);
                pixel.slope_pdf(slope) * cavity_masking(wo, m) * dot(wo, m).max(0.0) / m[2]
            };
            let (reach, nodes) = square(k);
            let whole = integral(seen, reach, nodes);
            assert!(
                (whole / wo[2] - 1.0).abs() < 1e-3,
                "{index}, variant {k}: {whole} of {}",
                wo[2]
            );
        }
    }
}

/// Cells without facets are the smooth lobe: all of them it is to the bit, some of them leave an
/// integral of 1.
#[test]
fn a_share_of_the_cells_has_facets() {
    let patch = Patch::new([0.3, 0.7], [1.5, 0.2], [-0.3, 1.1]);
    let with = |share: f64| {
        let facets = MultiLobe::new(roughness(), 2.0).expect("in range");
        facets.with_share(share).expect("in range").ndf(dictionary(), &patch)
    };
    let slope = [0.2, 0.1];
    let smooth = with(0.0).smooth().slope_pdf(slope);
    assert!((with(0.0).slope_pdf(slope) / smooth - 1.0).abs() < 1e-14);
    let whole = integral(|slope| with(0.3).slope_pdf(slope), 7.0, 400);
    assert!((whole - 1.0).abs() < 1e-3, "{whole}");
    // How much a pixel is like the smooth lobe: in the mean as much as the share leaves.
    let smooth_part = |share: f64| {
        let facets = MultiLobe::new(roughness(), 1e-3).expect("in range").with_variation(0.0);
        let facets = facets.expect("in range").with_share(share).expect("in range");
        // Four deviations out tables end: what is there is smooth cells alone.
        let far = [4.2 * 0.3 * 1.5, 4.2 * 0.15 * 1.5];
        let parts = (0..4000).map(|k| {
            let patch = Patch::new([40.0 * f64::from(k), 0.2], [1.0, 0.0], [0.0, 1.0]);
            let pixel = facets.ndf(dictionary(), &patch);
            pixel.slope_pdf(far) / pixel.smooth().slope_pdf(far)
        });
        parts.sum::<f64>() / 4000.0
    };
    // A pixel has about five cells: 20,000 of them, of which 0.3 vary by 0.46.
    assert!((smooth_part(0.3) - 0.7).abs() < 5.0 * 0.46 / 20_000.0_f64.sqrt());
    assert!(smooth_part(1.0) == 0.0);
}

/// Masking and shadowing by the smaller of both is the product up to 45 degrees from the pole, and
/// never below it.
#[test]
fn the_smaller_masking_is_no_less_than_the_product() {
    check(20_000, |source| {
        let mut any = || {
            normalize([
                source.uniform(-1.0, 1.0),
                source.uniform(-1.0, 1.0),
                source.uniform(0.0, 1.0),
            ])
        };
        let (wo, wi) = (any(), any());
        let h = half_vector(wo, wi);
        let [o, i] = [wo, wi].map(|w| cavity_masking(w, h));
        let both = cavity_masking_shadowing(wo, wi, h);
        ensure(both >= o * i && both <= 1.0, "a masking", &(wo, wi))?;
        if h[2] * h[2] >= 0.5 {
            near(both, o * i, 1e-12, &(wo, wi))?;
        }
        Ok(())
    });
}

/// Law C6: very many facets are the correlated Beckmann lobe, to the last digit: where no cell is
/// asked, and where all are.
#[test]
fn very_many_facets_are_the_smooth_lobe() {
    let smooth = Beckmann::new(Anisotropic::new(roughness()));
    // As many as the last level has, in every cell: none is beyond all random numbers, and none has
    // a table.
    let last = MultiLobe::new(roughness(), 4.0_f64.powi(16)).expect("in range");
    let last = last.with_variation(0.0).expect("in range");
    for index in 0..20 {
        let patch = Patch::new([0.37 * index as f64, 0.2], [1.0, 0.0], [0.0, 1.0]);
        for pixel in [pixel(50.0_f64.exp(), index), last.ndf(dictionary(), &patch)] {
            for slope in [[0.0, 0.0], [0.3, -0.2], [0.9, 0.1]] {
                let want = smooth.slope_pdf(slope);
                assert!((pixel.slope_pdf(slope) / want - 1.0).abs() < 1e-12);
            }
            let (wo, wi) = (normalize([0.3, 0.1, 1.0]), normalize([0.2, -0.5, 1.0]));
            let h = half_vector(wo, wi);
            let want = smooth.d(h) * cavity_masking_shadowing(wo, wi, h) / (4.0 * wo[2] * wi[2]);
            assert!((pixel.brdf(wo, wi) / want - 1.0).abs() < 1e-12);
        }
    }
}

/// A mirror has no density, with facets as without, until a kernel widens it.
#[test]
fn a_mirror_has_no_density() {
    let mirrors = [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.3, 0.2, 1.0]];
    for [x, y, rho] in mirrors {
        let mirror = Roughness::from_sigma_rho(x, y, rho).expect("in range");
        let pixel =
            MultiLobe::new(mirror, 10.0).expect("in range").ndf(dictionary(), &Patch::default());
        assert_eq!(pixel.slope_pdf([0.0, 0.0]), 0.0, "{x} {y} {rho}");
        let kernel = Kernel::from_covariance(Psd::new(0.02, 0.0, 0.01).expect("valid"));
        let pixel = pixel.widened(&kernel);
        let whole = midpoints(2.0, 600, |slope| pixel.slope_pdf(slope));
        // Boxes of 0.35 at least, of which midpoints miss half a step at each side.
        assert!((whole - 1.0).abs() < 2.0 * (4.0 / 600.0) / 0.35, "{x} {y} {rho}: {whole}");
    }
}

/// Normal maps enter through the covariance, seen from their mean, and M with its correlation
/// carries it.
#[test]
fn moments_enter_through_the_covariance() {
    let covariance = Psd::new(0.02, -0.01, 0.03).expect("valid");
    for mean in [[0.0, 0.0], [0.8, -0.5]] {
        let moments = SlopeMoments::new(mean, covariance).expect("in range");
        let pixel = pixel(50.0_f64.exp(), 3).over(&moments);
        // Its columns by differences of slopes in the frame of the mean.
        let (frame, step) = (MeanFrame::of(mean), 1e-6);
        let at = |x: f64, y: f64| slope_of(frame.to_local(normal_of([mean[0] + x, mean[1] + y])));
        let column = |[x, y]: [f64; 2]| {
            let (ahead, behind) = (at(step * x, step * y), at(-step * x, -step * y));
            nalgebra::Vector2::from([0, 1].map(|k| (ahead[k] - behind[k]) / (2.0 * step)))
        };
        let j = nalgebra::Matrix2::from_columns(&[column([1.0, 0.0]), column([0.0, 1.0])]);
        let [xx, xy, yy] = covariance.entries();
        let seen = j * nalgebra::Matrix2::new(xx, xy, xy, yy) * j.transpose();
        let seen = Psd::new(seen[(0, 0)], seen[(0, 1)], seen[(1, 1)]).expect("valid");
        let sum = Roughness::from_covariance(roughness().covariance() + seen);
        let want = Beckmann::new(Anisotropic::new(sum)).slope_pdf([0.2, 0.1]);
        assert!((pixel.slope_pdf([0.2, 0.1]) / want - 1.0).abs() < 1e-8, "{mean:?}");
    }
}
