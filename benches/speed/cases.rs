//! What is timed: each case is one pass over all samples, as a plain loop.
//!
//! Shapes are built beforehand where a case is named for its evaluation, as an engine's material or
//! decoded G-buffer has them; `per_sample` cases build them inside.

use super::samples::{COUNT, Regime, Sample, samples};
use super::{glints, hand_written, maps};
use lobe::filter::{self, DiskKernel};
use lobe::{
    Anisotropic, AxisAligned, Beckmann, Footprint, Ggx, Isotropic, Kernel, NonCentered,
    PixelFilter, Roughness,
};
use std::hint::black_box;

/// One pass over all samples.
pub(crate) struct Case {
    pub(crate) group: &'static str,
    pub(crate) name: &'static str,
    pub(crate) pass: Box<dyn FnMut()>,
}

/// A case from inputs and a function of one of them.
#[inline(always)]
pub(crate) fn case<T: 'static>(
    group: &'static str,
    name: &'static str,
    inputs: Vec<T>,
    f: impl Fn(&T) -> f32 + 'static,
) -> Case {
    assert_eq!(inputs.len(), COUNT);
    let mut out = vec![0.0_f32; COUNT];
    let pass = move || {
        for (out, input) in out.iter_mut().zip(black_box(inputs.as_slice())) {
            *out = f(input);
        }
        black_box(&out);
    };
    Case { group, name, pass: Box::new(pass) }
}

type Vector = [f32; 3];

fn isotropic(s: &Sample) -> Isotropic<f32> {
    Isotropic::new(s.alphas[0]).expect("a valid alpha")
}

fn axis_aligned(s: &Sample) -> AxisAligned<f32> {
    AxisAligned::new(s.alphas[0], s.alphas[1]).expect("valid alphas")
}

fn anisotropic(s: &Sample) -> Anisotropic<f32> {
    Anisotropic::new(Roughness::from_matrix(s.matrix))
}

/// D at the half vector, with visibility: the BRDF without Fresnel.
fn shading() -> Vec<Case> {
    const GROUP: &str = "shading";
    let samples = samples(Regime::Mixed);
    let with = |pick: fn(&Sample) -> f32| -> Vec<(f32, Vector, Vector)> {
        samples.iter().map(|s| (pick(s), s.wo, s.wi)).collect()
    };
    let pairs: Vec<([f32; 2], Vector, Vector)> =
        samples.iter().map(|s| (s.alphas, s.wo, s.wi)).collect();
    let round: Vec<_> = samples.iter().map(|s| (isotropic(s), s.wo, s.wi)).collect();
    let aligned: Vec<_> = samples.iter().map(|s| (axis_aligned(s), s.wo, s.wi)).collect();
    let any: Vec<_> = samples.iter().map(|s| (anisotropic(s), s.wo, s.wi)).collect();
    let non_centered: Vec<_> = samples
        .iter()
        .map(|s| (NonCentered::new(anisotropic(s), s.mean).expect("a valid mean"), s.wo, s.wi))
        .collect();
    let alpha = |s: &Sample| s.alphas[0];
    let filtered: Vec<_> = samples
        .iter()
        .map(|s| {
            let roughness = Roughness::from_alpha(s.alphas[0]).expect("a valid alpha");
            (roughness, s.footprint, s.wo, s.wi)
        })
        .collect();
    vec![
        case(GROUP, "isotropic_by_hand", with(alpha), |&(a, wo, wi)| {
            hand_written::isotropic(a, wo, wi)
        }),
        case(GROUP, "isotropic", round.clone(), |&(shape, wo, wi)| Ggx::new(shape).brdf(wo, wi)),
        case(GROUP, "isotropic_per_sample", with(alpha), |&(a, wo, wi)| {
            Isotropic::new(a).map_or(f32::NAN, |shape| Ggx::new(shape).brdf(wo, wi))
        }),
        case(GROUP, "axis_aligned_by_hand", pairs, |&(a, wo, wi)| {
            hand_written::axis_aligned(a, wo, wi)
        }),
        case(GROUP, "axis_aligned", aligned, |&(shape, wo, wi)| Ggx::new(shape).brdf(wo, wi)),
        case(GROUP, "anisotropic", any, |&(shape, wo, wi)| Ggx::new(shape).brdf(wo, wi)),
        case(GROUP, "non_centered", non_centered, |&(shape, wo, wi)| Ggx::new(shape).brdf(wo, wi)),
        case(GROUP, "beckmann_isotropic", round, |&(shape, wo, wi)| {
            Beckmann::new(shape).brdf(wo, wi)
        }),
        case(GROUP, "variance_addition", filtered.clone(), |&(roughness, footprint, wo, wi)| {
            let widened = roughness.widened(&Kernel::of(&footprint, PixelFilter::BOX));
            Ggx::new(Anisotropic::new(widened)).brdf(wo, wi)
        }),
        case(GROUP, "peak_fitted", filtered.clone(), |&(roughness, footprint, wo, wi)| {
            let widened = roughness.peak_fitted(&Kernel::of(&footprint, PixelFilter::BOX));
            Ggx::new(Anisotropic::new(widened)).brdf(wo, wi)
        }),
        case(GROUP, "projected_space", filtered, |&(roughness, footprint, wo, wi)| {
            let kernel = DiskKernel::of(footprint.u, footprint.v, PixelFilter::BOX);
            Ggx::new(Anisotropic::new(roughness.widened_on_disk(&kernel))).brdf(wo, wi)
        }),
    ]
}

/// The mean of GGX over a footprint: the exact parallelogram against Appendix A's rectangle around
/// it.
fn footprints(regime: Regime) -> Vec<Case> {
    let group = regime.name();
    let samples = samples(regime);
    let place = |s: &Sample| -> ([f32; 2], Footprint<f32>) { (s.slope, s.footprint) };
    let round: Vec<_> = samples.iter().map(|s| (isotropic(s), place(s))).collect();
    let aligned: Vec<_> = samples.iter().map(|s| (axis_aligned(s), place(s))).collect();
    let any: Vec<_> = samples.iter().map(|s| (anisotropic(s), place(s))).collect();
    vec![
        case(group, "appendix_a_by_hand", samples.clone(), |s| {
            hand_written::appendix_a(s.alphas, s.slope, s.footprint.extents())
        }),
        case(group, "appendix_a", samples, |s| {
            filter::kaplanyan_rectangle_mean(s.alphas, s.slope, s.footprint.extents())
        }),
        case(group, "isotropic", round, |&(shape, (slope, ref footprint))| {
            Ggx::new(shape).parallelogram_mean(slope, footprint)
        }),
        case(group, "axis_aligned", aligned, |&(shape, (slope, ref footprint))| {
            Ggx::new(shape).parallelogram_mean(slope, footprint)
        }),
        case(group, "anisotropic", any, |&(shape, (slope, ref footprint))| {
            Ggx::new(shape).parallelogram_mean(slope, footprint)
        }),
    ]
}

/// Every case of the bench.
pub(crate) fn all() -> Vec<Case> {
    let mut cases = shading();
    for regime in Regime::ALL {
        cases.extend(footprints(regime));
    }
    cases.extend(maps::cases());
    cases.extend(glints::cases());
    cases
}
