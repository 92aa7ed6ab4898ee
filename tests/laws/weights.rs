//! Mip chains by weights: covered texels alone make every level, and nothing depends on a texel
//! without weight.
#![cfg(feature = "lean")]

use crate::common::arbitrary::Source;
use crate::common::{ULP, check, ensure, near, near_all};
use lobe::material::lean::{Border, MomentMap};
use lobe::{Error, SlopeMoments};
use nalgebra::{Matrix2, Vector2};
use proptest::test_runner::TestCaseResult;

/// A map with its weights.
struct Weighted {
    size: [usize; 2],
    slopes: Vec<[f64; 2]>,
    weights: Vec<f64>,
}

/// A small map of any shape: islands, single texels, partial coverage, weights of any scale.
fn map(source: &mut Source) -> Weighted {
    let side = |source: &mut Source| 1 + source.pick(11) as usize;
    let size = [side(source), side(source)];
    let (mean, spread) = (source.mean(), source.log_uniform(1e-3, 1.0));
    let (scale, kind) = (source.log_uniform(1e-6, 1e6), source.pick(4));
    let count = size[0] * size[1];
    let slopes = (0..count).map(|_| mean.map(|x| x + spread * source.uniform(-1.0, 1.0))).collect();
    let mut weights: Vec<f64> = (0..count)
        .map(|k| match kind {
            // Islands of three columns, gaps of two.
            0 => f64::from(u8::from(k % size[0] % 5 < 3)),
            1 => source.unit(),
            2 => f64::from(u8::from(source.pick(5) == 0)),
            // As 8 bits of alpha have it.
            _ => source.pick(256) as f64 / 255.0,
        })
        .map(|weight| scale * weight)
        .collect();
    let one = source.pick(count as u64) as usize;
    weights[one] = weights[one].max(0.5 * scale);
    Weighted { size, slopes, weights }
}

impl Weighted {
    fn chain(&self, border: Border) -> MomentMap<f64> {
        let (slopes, weights) = (self.slopes.clone(), self.weights.clone());
        MomentMap::from_weighted_slopes(self.size, slopes, weights, border).expect("a map")
    }
}

/// Mean and covariance of weighted patches, in two passes, and the sum of their weights.
fn merged(patches: &[(SlopeMoments<f64>, f64)]) -> ([f64; 2], [f64; 3], f64) {
    let total: f64 = patches.iter().map(|(_, weight)| weight).sum();
    let mean =
        patches.iter().map(|(m, w)| Vector2::from(m.mean()) * *w).sum::<Vector2<f64>>() / total;
    let covariance = patches
        .iter()
        .map(|(moments, weight)| {
            let [xx, xy, yy] = moments.covariance().entries();
            let d = Vector2::from(moments.mean()) - mean;
            (Matrix2::new(xx, xy, xy, yy) + d * d.transpose()) * *weight
        })
        .sum::<Matrix2<f64>>()
        / total;
    (mean.into(), [covariance[(0, 0)], covariance[(0, 1)], covariance[(1, 1)]], total)
}

/// Agreement up to rounding, which covariances meet as a shift of the mean.
fn agrees(
    got: &SlopeMoments<f64>,
    want: ([f64; 2], [f64; 3]),
    inputs: &dyn core::fmt::Debug,
) -> TestCaseResult {
    agrees_within(16.0, got, want, inputs)
}

/// Agreement within units of a mean's rounding.
fn agrees_within(
    ulps: f64,
    got: &SlopeMoments<f64>,
    (mean, covariance): ([f64; 2], [f64; 3]),
    inputs: &dyn core::fmt::Debug,
) -> TestCaseResult {
    let trace = covariance[0].abs() + covariance[2].abs();
    let shift = ulps * ULP * (mean[0].abs().max(mean[1].abs()) + trace.sqrt());
    near_all(&got.mean(), &mean, shift, inputs)?;
    near_all(&got.covariance().entries(), &covariance, shift * (shift + 2.0 * trace.sqrt()), inputs)
}

#[test]
fn the_last_level_is_the_covered_part_of_the_map() {
    check(2_000, |source| {
        let map = map(source);
        let chain = map.chain(Border::Wrap);
        let slopes = map.slopes.iter().map(|&s| SlopeMoments::of_slope(s).expect("a slope"));
        let patches: Vec<_> = slopes.zip(map.weights.iter().copied()).collect();
        let (mean, covariance, total) = merged(&patches);
        let last = chain.levels() - 1;
        // Every level rounds its weights anew.
        let ulps = 16.0 * (1.0 + last as f64);
        agrees_within(ulps, &chain.texel(last, 0, 0), (mean, covariance), &map.size)?;
        let largest = map.weights.iter().fold(0.0_f64, |most, w| most.max(*w));
        let coverage = total / largest / map.weights.len() as f64;
        near(chain.weight(last, 0, 0), coverage, 16.0 * ULP * coverage, &map.size)
    });
}

#[test]
fn every_texel_is_the_weighted_merge_of_what_it_covers() {
    check(1_000, |source| {
        let map = map(source);
        let chain = map.chain(Border::Clamp);
        // The overlap of two intervals of a side.
        let overlap = |k: usize, count: usize, j: usize, fine: usize| {
            let scale = fine as f64 / count as f64;
            let (low, high) = (k as f64 * scale, (k + 1) as f64 * scale);
            (high.min((j + 1) as f64) - low.max(j as f64)).max(0.0)
        };
        for level in 1..chain.levels() {
            let ([wide, high], [width, height]) = (chain.size(level - 1), chain.size(level));
            for place in 0..width * height {
                let (column, row) = (place % width, place / width);
                let shares: Vec<_> = (0..wide * high)
                    .map(|k| {
                        let (x, y) = (k % wide, k / wide);
                        let area = overlap(column, width, x, wide) * overlap(row, height, y, high);
                        // Rounded ends of intervals are no overlap.
                        let area = if area < 1e-9 { 0.0 } else { area };
                        (chain.texel(level - 1, x, y), area, chain.weight(level - 1, x, y))
                    })
                    .collect();
                let areas: f64 = shares.iter().map(|(_, area, _)| area).sum();
                let patches: Vec<_> = shares.iter().map(|(m, area, w)| (*m, area * w)).collect();
                let (mean, covariance, total) = merged(&patches);
                let inputs = (map.size, level, column, row);
                let weight = chain.weight(level, column, row);
                near(weight, total / areas, 16.0 * ULP * weight, &inputs)?;
                let got = chain.texel(level, column, row);
                if weight > 0.0 {
                    agrees(&got, (mean, covariance), &inputs)?;
                } else {
                    // The coarser texel's moments, to the bit: the last one of an odd side covers
                    // three.
                    let [columns, rows] = chain.size(level + 1);
                    let (x, y) = ((column / 2).min(columns - 1), (row / 2).min(rows - 1));
                    ensure(got == chain.texel(level + 1, x, y), "filled", &inputs)?;
                }
            }
        }
        for (place, weight) in map.weights.iter().enumerate() {
            let [columns, rows] = chain.size(1);
            let (column, row) = (place % map.size[0], place / map.size[0]);
            let coarse = chain.texel(1, (column / 2).min(columns - 1), (row / 2).min(rows - 1));
            let want = if *weight > 0.0 { map.slopes[place] } else { coarse.mean() };
            ensure(chain.slopes()[place] == want, "slopes", &(map.size, place))?;
        }
        Ok(())
    });
}

/// The end of a light island: shares of $2^{-9}$ on nine levels leave the first texel of level 9 a
/// weight of 4e-33, too small for f32 to divide by. It counts as none, and the texel has the
/// moments of the coarser one.
#[test]
fn a_weight_too_small_to_divide_by_is_none() {
    let size = [(1 << 18) - 1, 1];
    let (mut slopes, mut weights) = (vec![[-0.5_f32, 0.1]; size[0]], vec![0.0_f32; size[0]]);
    (slopes[1022], weights[1022]) = ([0.5, 0.25], 1e-8);
    weights[size[0] - 1] = 1.0;
    let map = MomentMap::from_weighted_slopes(size, slopes, weights, Border::Clamp).expect("a map");
    assert!(map.weight(9, 1, 0) > 0.0 && map.weight(9, 0, 0) == 0.0, "{}", map.weight(9, 0, 0));
    assert_eq!(map.texel(9, 0, 0), map.texel(10, 0, 0));
    let [x, y] = map.texel(9, 0, 0).mean();
    assert!((x - 0.5).abs() < 1e-6 && (y - 0.25).abs() < 1e-6, "{x} {y}");
}

#[test]
fn nothing_depends_on_slopes_without_weight() {
    check(1_000, |source| {
        let map = map(source);
        let chain = map.chain(Border::Wrap);
        let strange = [f64::NAN, f64::INFINITY, -1e300, 1e9, -0.0];
        let slopes = map.slopes.iter().zip(&map.weights).map(|(slope, weight)| {
            let any = |source: &mut Source| strange[source.pick(5) as usize];
            if *weight == 0.0 { [any(source), any(source)] } else { *slope }
        });
        let other = MomentMap::from_weighted_slopes(
            map.size,
            slopes.collect(),
            map.weights.clone(),
            Border::Wrap,
        );
        ensure(other == Ok(chain), "a stranger's slope", &map.size)
    });
}

#[test]
fn equal_weights_are_none_and_their_scale_is_nothing() {
    check(1_000, |source| {
        let map = map(source);
        let plain =
            MomentMap::from_slopes(map.size, map.slopes.clone(), Border::Wrap).expect("a map");
        let weight = source.log_uniform(1e-100, 1e100);
        let even = Weighted {
            weights: vec![weight; map.weights.len()],
            slopes: map.slopes.clone(),
            size: map.size,
        };
        let even = even.chain(Border::Wrap);
        let uv = [source.uniform(-1.0, 2.0), source.uniform(-1.0, 2.0)];
        let lod = source.uniform(0.0, 4.0);
        let (du, dv) = ([source.uniform(0.0, 1.0), 0.1], [0.0, source.uniform(0.0, 1.0)]);
        let pairs = [
            (plain.trilinear(uv, lod), even.trilinear(uv, lod)),
            (plain.anisotropic(uv, du, dv, 8), even.anisotropic(uv, du, dv, 8)),
        ];
        for (plain, even) in pairs {
            let want = (plain.mean(), plain.covariance().entries());
            // Up to nine probes of eight texels.
            agrees_within(64.0, &even, want, &(map.size, uv, lod))?;
        }
        // Another unit of weights, a power of two, moves no bit.
        let chain = map.chain(Border::Wrap);
        let weights = map.weights.iter().map(|w| 0.125 * w).collect();
        let scaled = Weighted { weights, ..map };
        ensure(scaled.chain(Border::Wrap) == chain, "scale", &scaled.size)
    });
}

#[test]
fn lookups_weigh_their_texels() {
    check(2_000, |source| {
        let map = map(source);
        let chain = map.chain(Border::Clamp);
        let level = source.pick(chain.levels() as u64) as usize;
        let uv = [source.unit(), source.unit()];
        // Four texels and their bilinear shares.
        let corners = |level: usize| {
            let [width, height] = chain.size(level);
            let side = |u: f64, count: usize| {
                let x = u * count as f64 - 0.5;
                let (low, t) = (x.floor(), x - x.floor());
                // Not negative after the clamp.
                #[allow(clippy::cast_sign_loss)]
                let at = |k: f64| k.clamp(0.0, (count - 1) as f64) as usize;
                [(at(low), 1.0 - t), (at(low + 1.0), t)]
            };
            let mut patches = Vec::new();
            for (row, v) in side(uv[1], height) {
                for (column, u) in side(uv[0], width) {
                    let moments = chain.texel(level, column, row);
                    patches.push((moments, u * v, chain.weight(level, column, row)));
                }
            }
            patches
        };
        let expected = |patches: Vec<(SlopeMoments<f64>, f64, f64)>| {
            let covered =
                patches.iter().map(|(_, share, weight)| share * weight).sum::<f64>() > 0.0;
            let by = |(m, share, weight): (SlopeMoments<f64>, f64, f64)| {
                (m, if covered { share * weight } else { share })
            };
            let (mean, covariance, _) = merged(&patches.into_iter().map(by).collect::<Vec<_>>());
            (mean, covariance)
        };
        let inputs = (map.size, level, uv);
        agrees(&chain.bilinear(level, uv), expected(corners(level)), &inputs)?;
        if level + 1 < chain.levels() {
            let t = source.uniform(0.1, 0.9);
            let near = corners(level).into_iter().map(|(m, s, w)| (m, (1.0 - t) * s, w));
            let far = corners(level + 1).into_iter().map(|(m, s, w)| (m, t * s, w));
            let both = near.chain(far).collect();
            agrees(&chain.trilinear(uv, level as f64 + t), expected(both), &inputs)?;
        }
        Ok(())
    });
}

#[test]
fn a_long_footprint_sees_islands_only() {
    // Columns of slope 1 and -1 in turn are covered at the left, the right half holds steep
    // garbage.
    let slopes: Vec<[f64; 2]> = (0..64 * 64)
        .map(|k| if k % 64 < 32 { [1.0 - 2.0 * f64::from(k % 2), 0.0] } else { [-7.0, 9.0] })
        .collect();
    let weights = (0..64 * 64).map(|k| f64::from(u8::from(k % 64 < 32))).collect();
    let map =
        MomentMap::from_weighted_slopes([64, 64], slopes, weights, Border::Clamp).expect("a map");
    for most in [2, 5, 16] {
        let seen = map.anisotropic([0.5, 0.5], [0.9, 0.0], [0.0, 0.2], most);
        let [xx, xy, yy] = seen.covariance().entries();
        assert!(seen.mean()[0].abs() < 0.1 && seen.mean()[1] == 0.0, "{seen:?}");
        assert!((xx - 1.0).abs() < 0.01 && xy == 0.0 && yy == 0.0, "{seen:?}");
    }
    // Far from any island the moments of coarser levels, which know of one.
    let far = map.anisotropic([0.8, 0.5], [0.2, 0.0], [0.0, 0.2], 8);
    assert!((far.covariance().trace() - 1.0).abs() < 1e-12, "{far:?}");
}

#[test]
fn covariances_are_positive_and_know_their_determinants_in_single_precision() {
    check(1_000, |source| {
        let map = map(source);
        let slopes = map.slopes.iter().map(|s| s.map(|x| x as f32)).collect();
        let weights = map.weights.iter().map(|&w| w as f32).collect();
        let chain = MomentMap::from_weighted_slopes(map.size, slopes, weights, Border::Wrap);
        let chain = chain.expect("a map");
        for level in 0..chain.levels() {
            for moments in chain.level(level) {
                let [xx, xy, yy] = moments.covariance().entries().map(f64::from);
                ensure(xx >= 0.0 && yy >= 0.0, "variances", &(map.size, level, xx, yy))?;
                let det = f64::from(moments.covariance().root_det()).powi(2);
                near(det, xx * yy - xy * xy, 2e-6 * xx * yy, &(map.size, level, [xx, xy, yy]))?;
            }
        }
        Ok(())
    });
}

#[test]
fn weights_that_are_none_are_refused() {
    let chain = |size, slopes: Vec<[f32; 2]>, weights: Vec<f32>| {
        MomentMap::from_weighted_slopes(size, slopes, weights, Border::Wrap).map(|_| ())
    };
    let two = vec![[0.0; 2]; 2];
    for bad in [-1e-30, f32::NAN, f32::INFINITY] {
        assert!(matches!(chain([2, 1], two.clone(), vec![1.0, bad]), Err(Error::Weight(_))));
    }
    assert_eq!(chain([2, 1], two.clone(), vec![0.0, -0.0]), Err(Error::WeightSum(0.0.into())));
    assert!(matches!(chain([2, 1], two.clone(), vec![1.0]), Err(Error::Length { .. })));
    assert_eq!(
        chain([2, 2], two.clone(), vec![1.0; 2]),
        Err(Error::MapSize { size: [2, 2], texels: 2 })
    );
    assert!(matches!(chain([0, 0], vec![], vec![]), Err(Error::MapSize { .. })));
    let nan = chain([2, 1], vec![[f32::NAN, 0.0], [0.0; 2]], vec![1.0; 2]);
    assert_eq!(nan, Err(Error::Mean(f32::NAN.into())));
    // A weight below a billionth of the largest is none, and its slope may be anything.
    let faint = vec![[f32::NAN, 0.0], [0.5, 0.0]];
    let map = MomentMap::from_weighted_slopes([2, 1], faint, vec![1e-10, 1.0], Border::Wrap);
    let map = map.expect("a map");
    assert_eq!((map.weight(0, 0, 0), map.slopes()[0]), (0.0, [0.5, 0.0]));
    // The largest weights there are.
    let huge = MomentMap::from_weighted_slopes([2, 1], two, vec![f32::MAX; 2], Border::Wrap);
    assert_eq!(huge.expect("a map").weight(1, 0, 0), 1.0);
}
