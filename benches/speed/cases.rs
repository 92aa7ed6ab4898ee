//! What is timed: each case is one pass over all samples, as a plain loop.
//!
//! Evaluations are in `evaluations`, over columns. Here are the means over footprints by regime,
//! whose shapes are built beforehand, as an engine's material or decoded G-buffer has them.

use super::limit::Operations;
use super::samples::{COUNT, Regime, Sample, samples};
use super::{batch, evaluations, glints, hand_written, maps};
use lobe::{Anisotropic, AxisAligned, Footprint, Ggx, Isotropic, Roughness, filter};
use std::hint::black_box;

/// The group whose rows go by their names alone.
pub(crate) const EVALUATION: &str = "evaluation";

/// One pass over all samples.
pub(crate) struct Case {
    pub(crate) group: &'static str,
    pub(crate) name: &'static str,
    pub(crate) pass: Box<dyn FnMut()>,
    /// What the machine needs at least.
    pub(crate) limit: Option<Limit>,
}

/// A loop that does nothing but the divisions, roots, loads and stores of a case.
pub(crate) struct Limit {
    pub(crate) operations: Operations,
    pub(crate) pass: Box<dyn FnMut()>,
}

impl Case {
    /// The name in the table: with its group, unless it is an evaluation.
    pub(crate) fn row_name(&self) -> String {
        let Self { group, name, .. } = self;
        if *group == EVALUATION { (*name).to_owned() } else { format!("{group}/{name}") }
    }
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
    Case { group, name, pass: Box::new(pass), limit: None }
}

fn isotropic(s: &Sample) -> Isotropic<f32> {
    Isotropic::new(s.alphas[0]).expect("a valid alpha")
}

fn axis_aligned(s: &Sample) -> AxisAligned<f32> {
    AxisAligned::new(s.alphas[0], s.alphas[1]).expect("valid alphas")
}

fn anisotropic(s: &Sample) -> Anisotropic<f32> {
    Anisotropic::new(Roughness::from_matrix(s.matrix))
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
    let mut cases = evaluations::rows();
    cases.extend(batch::rows());
    for regime in Regime::ALL {
        cases.extend(footprints(regime));
    }
    cases.extend(maps::cases());
    cases.extend(glints::cases());
    cases
}
