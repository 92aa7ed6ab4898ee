//! Mip chains of moments: unions, order, exact consistency at any size, digits, and what samplers
//! read.
#![cfg(feature = "lean")]

use crate::common::arbitrary::Source;
use crate::common::{ULP, check, ensure, near, near_all};
use lobe::material::lean::{Border, MomentMap};
use lobe::{Error, SlopeMoments};
use nalgebra::{Matrix2, Vector2};
use proptest::test_runner::TestCaseResult;

/// Mean and covariance of weighted slopes, in two passes.
fn direct(slopes: &[([f64; 2], f64)]) -> ([f64; 2], [f64; 3]) {
    let total: f64 = slopes.iter().map(|(_, w)| w).sum();
    let mean = slopes.iter().map(|(s, w)| Vector2::from(*s) * *w).sum::<Vector2<f64>>() / total;
    let covariance = slopes
        .iter()
        .map(|(s, w)| {
            let d = Vector2::from(*s) - mean;
            d * d.transpose() * *w
        })
        .sum::<Matrix2<f64>>()
        / total;
    (mean.into(), [covariance[(0, 0)], covariance[(0, 1)], covariance[(1, 1)]])
}

/// A small map of any shape, with slopes around a mean that may be large against them.
fn map(source: &mut Source) -> ([usize; 2], Vec<[f64; 2]>) {
    let side = |source: &mut Source| 1 + source.pick(11) as usize;
    let size = [side(source), side(source)];
    let (mean, seed) = (source.mean(), source.pick(u64::MAX));
    let (spread, thin) = (source.log_uniform(1e-3, 1.0), source.pick(3) == 0);
    let slopes = (0..size[0] as u64 * size[1] as u64).map(|texel| {
        let mut texels = Source::from_seed(seed.wrapping_add(texel));
        let x = spread * texels.uniform(-1.0, 1.0);
        let y = if thin { 0.5 * x } else { spread * texels.uniform(-1.0, 1.0) };
        [mean[0] + x, mean[1] + y]
    });
    (size, slopes.collect())
}

/// Agreement up to rounding: `ulps` units of a mean's rounding, which covariances meet as a shift
/// of the mean.
fn agrees(
    got: &SlopeMoments<f64>,
    want: &([f64; 2], [f64; 3]),
    ulps: f64,
    inputs: &dyn core::fmt::Debug,
) -> TestCaseResult {
    let (mean, covariance) = want;
    let trace = covariance[0].abs() + covariance[2].abs();
    let shift = ulps * ULP * (mean[0].abs().max(mean[1].abs()) + trace.sqrt());
    near_all(&got.mean(), mean, shift, inputs)?;
    let tolerance = shift * (shift + 2.0 * trace.sqrt());
    near_all(&got.covariance().entries(), covariance, tolerance, inputs)
}

#[test]
fn the_last_level_is_the_whole_map() {
    check(2_000, |source| {
        let (size, slopes) = map(source);
        let weighted: Vec<_> = slopes.iter().map(|&s| (s, 1.0)).collect();
        let chain = MomentMap::from_slopes(size, slopes, Border::Wrap).expect("a map");
        let last = chain.texel(chain.levels() - 1, 0, 0);
        agrees(&last, &direct(&weighted), 16.0, &size)
    });
}

#[test]
fn every_texel_is_the_merge_of_what_it_covers() {
    check(1_000, |source| {
        let (size, slopes) = map(source);
        let chain = MomentMap::from_slopes(size, slopes, Border::Clamp).expect("a map");
        for level in 1..chain.levels() {
            let ([fine_width, fine_height], [width, height]) =
                (chain.size(level - 1), chain.size(level));
            // By the overlap of intervals, and raw moments in f64.
            let overlap = |k: usize, count: usize, j: usize, fine: usize| {
                let scale = fine as f64 / count as f64;
                let (low, high) = (k as f64 * scale, (k + 1) as f64 * scale);
                (high.min((j + 1) as f64) - low.max(j as f64)).max(0.0)
            };
            for row in 0..height {
                for column in 0..width {
                    let mut parts = Vec::new();
                    let mut within = Matrix2::zeros();
                    let mut total = 0.0;
                    for y in 0..fine_height {
                        for x in 0..fine_width {
                            let weight = overlap(column, width, x, fine_width)
                                * overlap(row, height, y, fine_height);
                            let part = chain.texel(level - 1, x, y);
                            let [xx, xy, yy] = part.covariance().entries();
                            within += Matrix2::new(xx, xy, xy, yy) * weight;
                            total += weight;
                            parts.push((part.mean(), weight));
                        }
                    }
                    let (mean, mut covariance) = direct(&parts);
                    within /= total;
                    let add = [within[(0, 0)], within[(0, 1)], within[(1, 1)]];
                    for (sum, x) in covariance.iter_mut().zip(add) {
                        *sum += x;
                    }
                    let got = chain.texel(level, column, row);
                    agrees(&got, &(mean, covariance), 16.0, &(size, level, column, row))?;
                }
            }
        }
        Ok(())
    });
}

#[test]
fn covariances_are_positive_and_know_their_determinants() {
    check(1_000, |source| {
        let (size, slopes) = map(source);
        let single = slopes.iter().map(|s| s.map(|x| x as f32)).collect();
        let chain = MomentMap::from_slopes(size, single, Border::Wrap).expect("a map");
        for level in 0..chain.levels() {
            let [width, height] = chain.size(level);
            for place in 0..width * height {
                let covariance = chain.texel(level, place % width, place / width).covariance();
                let [xx, xy, yy] = covariance.entries().map(f64::from);
                ensure(xx >= 0.0 && yy >= 0.0, "variances", &(size, level, xx, yy))?;
                let det = f64::from(covariance.root_det()).powi(2);
                // What is carried is the determinant of the entries, as far as these know it.
                near(det, xx * yy - xy * xy, 2e-6 * xx * yy, &(size, level, [xx, xy, yy]))?;
            }
        }
        // The same between texels.
        for _ in 0..4 {
            let uv = [source.uniform(-1.0, 2.0) as f32, source.uniform(-1.0, 2.0) as f32];
            let lod = source.uniform(0.0, 4.0) as f32;
            let covariance = chain.trilinear(uv, lod).covariance();
            let [xx, xy, yy] = covariance.entries().map(f64::from);
            ensure(xx >= 0.0 && yy >= 0.0, "variances", &(size, uv, lod))?;
            let det = f64::from(covariance.root_det()).powi(2);
            near(det, xx * yy - xy * xy, 2e-6 * xx * yy, &(size, uv, lod, [xx, xy, yy]))?;
        }
        Ok(())
    });
}

#[test]
fn the_order_of_a_merge_does_not_matter() {
    check(2_000, |source| {
        let ([width, height], slopes) = map(source);
        let chain = |slopes: &[[f64; 2]]| {
            let chain = MomentMap::from_slopes([width, height], slopes.to_vec(), Border::Wrap);
            let chain = chain.expect("a map");
            chain.texel(chain.levels() - 1, 0, 0)
        };
        let mirrored: Vec<[f64; 2]> = slopes.iter().rev().copied().collect();
        let (one, other) = (chain(&slopes), chain(&mirrored));
        // One by one, from a seeded order.
        let mut order: Vec<usize> = (0..slopes.len()).collect();
        order.sort_by_key(|&k| k.wrapping_mul(0x9E37_79B9) % 1009);
        let mut grown = SlopeMoments::of_slope(slopes[order[0]]).expect("a slope");
        for (count, &k) in order.iter().enumerate().skip(1) {
            let next = SlopeMoments::of_slope(slopes[k]).expect("a slope");
            grown = grown.merged(count as f64, &next, 1.0).expect("weights");
        }
        let want = (one.mean(), one.covariance().entries());
        agrees(&other, &want, 16.0, &(width, height))?;
        agrees(&grown, &want, 16.0, &(width, height))
    });
}

#[test]
fn a_million_nearly_equal_slopes_keep_their_covariance_in_single_precision() {
    // Sums of uniform numbers: deviation 1e-4 around 10; alone, and in the ways in which means of
    // large areas differ.
    type Pattern = fn(f64, f64) -> f64;
    let patterns: [(&str, [usize; 2], Pattern); 5] = [
        ("noise", [1000, 1000], |noise, _| noise),
        ("ramp", [999, 1001], |_, t| 3.4 * t - 1.7),
        ("halves", [1000, 1000], |noise, t| 0.1 * noise + (t - 0.5).signum()),
        ("period", [1024, 977], |_, t| 1.4 * (core::f64::consts::TAU * t).sin()),
        ("rows", [1023, 977], |noise, t| 0.3 * noise + 1.4 * (600.0 * t).sin()),
    ];
    let mut last = SlopeMoments::default();
    for (name, size, pattern) in patterns {
        let slopes: Vec<[f32; 2]> = (0..size[0] as u64 * size[1] as u64)
            .map(|seed| {
                let mut source = Source::from_seed(seed);
                let mut gauss = || (0..12).map(|_| source.unit()).sum::<f64>() - 6.0;
                let t = seed as f64 / (size[0] * size[1]) as f64;
                let (x, y) = (pattern(gauss(), t), gauss());
                [10.0 + 1e-4 * x, 10.0 + 1e-4 * (0.6 * x + 0.8 * y)].map(|s| s as f32)
            })
            .collect();
        let weighted: Vec<_> = slopes.iter().map(|s| (s.map(f64::from), 1.0)).collect();
        let (mean, want) = direct(&weighted);
        // Odd sides somewhere down the chain, or from the start.
        let chain = MomentMap::from_slopes(size, slopes, Border::Wrap).expect("a map");
        last = chain.texel(chain.levels() - 1, 0, 0);
        for (got, want) in last.covariance().entries().into_iter().zip(want) {
            let error = (f64::from(got) / want - 1.0).abs();
            assert!(error < 1e-5, "{name}: {got:e} for {want:e}: {error:e}");
        }
        assert!((f64::from(last.mean()[0]) - mean[0]).abs() < 1e-6, "{name}");
    }
    // Raw moments cannot: 100 has no digit left at 1e-8.
    let [x, _] = last.mean();
    let raw = x * x + last.covariance().entries()[0];
    assert!(((raw - x * x) / last.covariance().entries()[0] - 1.0).abs() > 0.5);
}

#[test]
fn texels_and_lobes_turn_alike() {
    check(1_000, |source| {
        let (size, slopes) = map(source);
        let angle = source.angle();
        let turned: Vec<[f64; 2]> =
            slopes.iter().map(|&s| crate::common::reference::rotate(s, angle)).collect();
        let last = |slopes: Vec<[f64; 2]>| {
            let chain = MomentMap::from_slopes(size, slopes, Border::Wrap).expect("a map");
            chain.texel(chain.levels() - 1, 0, 0)
        };
        let (before, after) = (last(slopes), last(turned));
        let rotated = before.rotated(angle).expect("an angle");
        agrees(&after, &(rotated.mean(), rotated.covariance().entries()), 16.0, &size)?;
        let root = |m: &SlopeMoments<f64>| m.covariance().root_det();
        let slack = 1e-7 * before.covariance().trace() + 1e-14 * before.mean()[0].powi(2);
        near(root(&after), root(&before), slack, &size)
    });
}

/// Raw moments of four texels by bilinear weights.
fn raw_bilinear(map: &MomentMap<f64>, level: usize, uv: [f64; 2]) -> ([f64; 2], [f64; 3]) {
    let [width, height] = map.size(level);
    let around = |u: f64, count: usize| {
        let x = u * count as f64 - 0.5;
        let count = i64::try_from(count).expect("a side");
        let fold = |k: i64| {
            let k = match map.border() {
                Border::Wrap => k.rem_euclid(count),
                Border::Clamp => k.clamp(0, count - 1),
            };
            usize::try_from(k).expect("a place")
        };
        let first = x.floor();
        ([fold(first as i64), fold(first as i64 + 1)], x - first)
    };
    let ((columns, fx), (rows, fy)) = (around(uv[0], width), around(uv[1], height));
    let (mut first, mut second) = ([0.0; 2], [0.0; 3]);
    for (row, wy) in rows.into_iter().zip([1.0 - fy, fy]) {
        for (column, wx) in columns.into_iter().zip([1.0 - fx, fx]) {
            let texel = map.texel(level, column, row);
            let ([x, y], [xx, xy, yy]) = (texel.mean(), texel.covariance().entries());
            let w = wx * wy;
            first = [first[0] + w * x, first[1] + w * y];
            let raw = [xx + x * x, xy + x * y, yy + y * y];
            second = [0, 1, 2].map(|k| second[k] + w * raw[k]);
        }
    }
    (first, second)
}

fn central((mean, second): ([f64; 2], [f64; 3])) -> ([f64; 2], [f64; 3]) {
    let [x, y] = mean;
    (mean, [second[0] - x * x, second[1] - x * y, second[2] - y * y])
}

#[test]
fn samples_are_what_raw_moments_interpolate_to() {
    check(2_000, |source| {
        let (size, slopes) = map(source);
        let border = if source.pick(2) == 0 { Border::Wrap } else { Border::Clamp };
        let chain = MomentMap::from_slopes(size, slopes, border).expect("a map");
        let uv = [source.uniform(-2.0, 3.0), source.uniform(-2.0, 3.0)];
        let level = source.pick(chain.levels() as u64) as usize;
        let inputs = (size, level, uv, border);
        let want = raw_bilinear(&chain, level, uv);
        // Raw moments lose what the square of the mean has over the spread: the root of a unit.
        let lost = 8.0 / ULP.sqrt();
        agrees(&chain.bilinear(level, uv), &central(want), lost, &inputs)?;
        let t = source.unit();
        let (fine, coarse) = (want, raw_bilinear(&chain, level + 1, uv));
        let mixed = (
            [0, 1].map(|k| fine.0[k] + t * (coarse.0[k] - fine.0[k])),
            [0, 1, 2].map(|k| fine.1[k] + t * (coarse.1[k] - fine.1[k])),
        );
        let want = if level + 1 < chain.levels() { mixed } else { fine };
        let got = chain.trilinear(uv, level as f64 + t);
        agrees(&got, &central(want), lost, &inputs)
    });
}

#[test]
fn a_long_footprint_averages_along_its_length() {
    // Stripes across x, eight texels each.
    let slopes: Vec<[f64; 2]> =
        (0..64 * 64).map(|k| [if (k % 64) / 8 % 2 == 0 { 1.0 } else { -1.0 }, 0.0]).collect();
    let map = MomentMap::from_slopes([64, 64], slopes, Border::Wrap).expect("a map");
    let texel = 1.0 / 64.0;
    let thin =
        |along: [f64; 2], across: [f64; 2]| map.anisotropic([0.5625, 0.5], along, across, 16);
    // Along a stripe nothing varies, however long; a round footprint of that size would mix all.
    let stripe = thin([0.0, 12.0 * texel], [texel, 0.0]);
    assert!(stripe.covariance().trace() < 1e-12, "{stripe:?}");
    let round = map.trilinear([0.5625, 0.5], 12.0_f64.log2());
    assert!(round.covariance().trace() > 0.3, "{round:?}");
    // Across whole periods: half and half.
    let periods = thin([32.0 * texel, 0.0], [0.0, 2.0 * texel]);
    // But for the ends: the probes' places are few, and have a variance, not a box.
    let (mean, spread) = (periods.mean()[0], periods.covariance().trace());
    assert!(mean.abs() < 0.1 && (spread - 1.0).abs() < 0.02, "{mean} {spread}");
    // The sides' order is none, and one probe is a trilinear one for the longer side.
    assert_eq!(thin([texel, 0.0], [0.0, 12.0 * texel]), stripe);
    let one = map.anisotropic([0.3, 0.7], [8.0 * texel, 0.0], [0.0, texel], 1);
    // Between levels of variances 4 and 16 texels a third of 64 is at a share of 4/36.
    let want = map.trilinear([0.3, 0.7], 2.0 + (64.0 / 3.0 - 16.0) / 48.0);
    assert!((one.mean()[0] - want.mean()[0]).abs() < 1e-12);
    assert!((one.covariance().trace() - want.covariance().trace()).abs() < 1e-12);
}

#[test]
fn a_footprint_on_an_even_slope_has_its_own_variance() {
    // A plane that bends: slopes change by 1e-3 a texel along x, and twice that along y. Far from
    // the border.
    let slopes: Vec<[f64; 2]> =
        (0..512 * 512).map(|k| [1e-3 * f64::from(k % 512), 2e-3 * f64::from(k / 512)]).collect();
    let map = MomentMap::from_slopes([512, 512], slopes, Border::Clamp).expect("a map");
    let texel = 1.0 / 512.0;
    for (long, short) in
        [(16.0, 16.0), (16.1, 16.0), (20.0, 9.0), (64.0, 12.5), (100.0, 8.0), (31.0, 4.7)]
    {
        let scale = 3.0_f64.sqrt() * texel;
        let (mut along, mut across) = (0.0, 0.0);
        // Mean over the phases of a lookup.
        let phases = 256;
        for phase in 0..phases {
            let uv = [0.5 + 64.0 * texel * (f64::from(phase) + 0.5) / f64::from(phases); 2];
            let got =
                map.anisotropic(uv, [long * scale, 0.0], [0.0, short * scale], 64).covariance();
            let [xx, _, yy] = got.entries();
            along += xx / f64::from(phases);
            across += yy / f64::from(phases);
        }
        // Texels are points: n of them have (n^2 - 1)/12.
        let point = 1.0 / 12.0;
        let side = |size: f64, step: f64| (3.0 * size * size / 12.0 - point) * step * step;
        let (x, y) = (along / side(long, 1e-3), across / side(short, 2e-3));
        assert!((x - 1.0).abs() < 0.02 && (y - 1.0).abs() < 0.02, "{long} {short}: {x} {y}");
    }
}

#[test]
fn maps_refuse_what_is_none() {
    let chain = |size, count| {
        MomentMap::from_slopes(size, vec![[0.0_f32; 2]; count], Border::Wrap).map(|_| ())
    };
    assert!(matches!(chain([0, 0], 0), Err(Error::MapSize { .. })));
    assert!(matches!(chain([2, 2], 3), Err(Error::MapSize { .. })));
    assert!(matches!(chain([usize::MAX, 2], 3), Err(Error::MapSize { .. })));
    let steep = MomentMap::from_slopes([1, 1], vec![[f32::NAN, 0.0]], Border::Wrap);
    assert!(matches!(steep.map(|_| ()), Err(Error::Mean(_))));
    let one = MomentMap::from_slopes([1, 1], vec![[1.0_f32, 2.0]], Border::Clamp).expect("a map");
    assert_eq!((one.levels(), one.size(9)), (1, [1, 1]));
    for uv in [[f32::NAN, 0.0], [f32::INFINITY, -1e30], [-7.3, 1e20]] {
        assert_eq!(one.trilinear(uv, f32::NAN).mean(), [1.0, 2.0]);
        let long = one.anisotropic(uv, [f32::INFINITY, 0.0], [f32::NAN, 1.0], 16);
        assert_eq!(long.mean(), [1.0, 2.0]);
    }
}
