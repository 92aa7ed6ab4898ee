//! Laws of the mean over a footprint by f64 inside: every error is within the promise of the tree.

use crate::common::arbitrary::Source;
use crate::common::{ODD, check, ensure};
use core::f64::consts::PI;
use lobe::{Anisotropic, AxisAligned, Footprint, Ggx, NonCentered, Psd, Roughness};

/// Relative errors that the documentation promises: within ten alphas of the lobe, and beyond.
const NEAR: f64 = 1e-5;
const FAR: f64 = 1e-3;

fn double(v: [f32; 2]) -> [f64; 2] {
    v.map(f64::from)
}

/// A lobe of any matrix, a center up to `reach` alphas away, and sides of 1e-4 to `largest` alphas,
/// half of them nearly parallel; against the tree in f64.
fn errs_as_promised(source: &mut Source, reach: f64, largest: f64) -> Result<(), String> {
    let alphas = [0; 2].map(|_| source.log_uniform(1e-3, 1.0) as f32);
    let roughness = Roughness::from_alphas(alphas[0], alphas[1], source.angle() as f32);
    let narrow = roughness.expect("alphas in range");
    let factor = narrow.matrix().cholesky().map(f64::from);
    let wide = Roughness::from_matrix(Psd::from_cholesky(factor).expect("a factor"));
    let turned = |length: f64, angle: f64| {
        let [x, y] = [length * angle.cos(), length * angle.sin()];
        [factor[0] * x, factor[1] * x + factor[2] * y].map(|x| x as f32)
    };
    let slope = turned(reach * source.unit(), source.uniform(0.0, 2.0 * PI));
    let angle = source.uniform(0.0, 2.0 * PI);
    let between = match source.pick(2) {
        0 => source.uniform(0.0, 2.0 * PI),
        _ => source.log_uniform(1e-6, 1.0) * source.sign(),
    };
    let u = turned(source.log_uniform(1e-4, largest), angle);
    let v = turned(source.log_uniform(1e-4, largest), angle + between);
    let mean = source.vector(1e-3, 3.0).map(|x| x as f32);
    let shape = NonCentered::new(Anisotropic::new(narrow), mean).expect("in range");
    let exact = NonCentered::new(Anisotropic::new(wide), double(mean)).expect("in range");
    let slope = [slope[0] + mean[0], slope[1] + mean[1]];
    let got = Ggx::new(shape).parallelogram_mean_in_double(slope, &Footprint { u, v });
    let over = Footprint { u: double(u), v: double(v) };
    let want = Ggx::new(exact).parallelogram_mean(double(slope), &over);
    let error = (f64::from(got) / want - 1.0).abs();
    // The center's distance less half of the diagonals is at most the footprint's.
    let budget = if reach <= 10.0 { NEAR } else { FAR };
    let inputs = (alphas, factor, slope, mean, u, v, got, want);
    if error < budget || want < f64::from(f32::MIN_POSITIVE) {
        return Ok(());
    }
    Err(format!("{error:e} of {budget:e}: {inputs:?}"))
}

#[test]
fn every_mean_errs_as_the_tree_promises() {
    for (reach, largest) in [(3.0, 1e2), (10.0, 1e6), (30.0, 1e2), (300.0, 1e2), (1e5, 1e6)] {
        check(40_000, |source| {
            let erred = errs_as_promised(source, reach, largest).err();
            ensure(erred.is_none(), "within the promise", &erred)
        });
    }
}

/// Mirrors, grooves and odd numbers are the tree's; numbers give a number that is not negative.
#[test]
fn where_the_sum_does_not_serve_the_tree_does() {
    check(100_000, |source| {
        let alphas = [0; 2].map(|_| match source.pick(6) {
            0 => 0.0,
            1 => 1e-9,
            2 => 1e9,
            _ => source.log_uniform(1e-4, 30.0) as f32,
        });
        let mut number = || match source.pick(6) {
            0 => ODD[source.pick(ODD.len() as u64) as usize] as f32,
            1 => 0.0,
            _ => (source.log_uniform(1e-12, 1e6) * source.sign()) as f32,
        };
        let [slope, u, v] = [0; 3].map(|_| [number(), number()]);
        let ggx = Ggx::new(AxisAligned::new(alphas[0], alphas[1]).expect("in range"));
        let over = Footprint { u, v };
        let got = ggx.parallelogram_mean_in_double(slope, &over);
        let inputs = (alphas, slope, over, got);
        let finite = [slope, u, v].as_flattened().iter().all(|x| x.is_finite());
        ensure((got.is_finite() && got >= 0.0) || !finite, "finite, not negative", &inputs)?;
        let resolved = alphas[0] * alphas[1] >= f32::MIN_POSITIVE;
        let tree = ggx.parallelogram_mean(slope, &over);
        let known = got.to_bits() == tree.to_bits();
        ensure(known || (finite && resolved), "the tree's", &(inputs, tree))
    });
}
