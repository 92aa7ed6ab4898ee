//! The C++ twin's rows: the formulas that engines ship, over the same columns and records.
//!
//! The one module with unsafe code: the calls.

use super::cases::Case;
#[cfg(cpp)]
use super::cases::EVALUATION;
use super::columns::Inputs;
#[cfg(cpp)]
use super::{
    columns::{Column, EMPTY, Pair, columns},
    formulas,
    samples::Sample,
};
#[cfg(cpp)]
use lobe::ndf::GgxDistribution;

/// How far a sample of the twin may be from Rust's, relative to it.
#[cfg(cpp)]
const TOLERANCE: f32 = 1e-4;

#[cfg(cpp)]
#[expect(unsafe_code, reason = "functions of another language")]
mod foreign {
    use crate::columns::{Column, Record};
    use crate::samples::COUNT;

    unsafe extern "C" {
        fn lobe_bench_ggx_isotropic(
            count: usize,
            wo_x: *const f32,
            wo_y: *const f32,
            wo_z: *const f32,
            wi_x: *const f32,
            wi_y: *const f32,
            wi_z: *const f32,
            alpha: *const f32,
            out: *mut f32,
        );
        fn lobe_bench_ggx_axis_aligned(
            count: usize,
            wo_x: *const f32,
            wo_y: *const f32,
            wo_z: *const f32,
            wi_x: *const f32,
            wi_y: *const f32,
            wi_z: *const f32,
            alpha_x: *const f32,
            alpha_y: *const f32,
            out: *mut f32,
        );
        fn lobe_bench_ggx_axis_aligned_aos(count: usize, records: *const Record, out: *mut f32);
    }

    pub(super) fn isotropic(directions: &[Column; 6], [alpha]: &[Column; 1], out: &mut Column) {
        let [a, b, c, d, e, f] = directions.each_ref().map(|column| column.as_ptr());
        let (alpha, out) = (alpha.as_ptr(), out.as_mut_ptr());
        // SAFETY: every pointer is to a column of at least COUNT numbers, and `out` is borrowed
        // alone.
        unsafe { lobe_bench_ggx_isotropic(COUNT, a, b, c, d, e, f, alpha, out) }
    }

    pub(super) fn axis_aligned(directions: &[Column; 6], [x, y]: &[Column; 2], out: &mut Column) {
        let [a, b, c, d, e, f] = directions.each_ref().map(|column| column.as_ptr());
        let (x, y, out) = (x.as_ptr(), y.as_ptr(), out.as_mut_ptr());
        // SAFETY: every pointer is to a column of at least COUNT numbers, and `out` is borrowed
        // alone.
        unsafe { lobe_bench_ggx_axis_aligned(COUNT, a, b, c, d, e, f, x, y, out) }
    }

    pub(super) fn axis_aligned_records(records: &[Record; COUNT], out: &mut Column) {
        // SAFETY: there are COUNT records, laid out as the twin's structure of eight floats, and
        // `out`, of at least COUNT numbers, is borrowed alone.
        unsafe { lobe_bench_ggx_axis_aligned_aos(COUNT, records.as_ptr(), out.as_mut_ptr()) }
    }
}

/// A row of the twin, after one pass of which every sample has been held to Rust's.
#[cfg(cpp)]
fn row(
    inputs: &Inputs,
    name: &'static str,
    mut pass: impl FnMut(&mut Column) + 'static,
    rust: impl Fn(Pair<f32>, [f32; 2]) -> f32,
) -> Case {
    let mut out: Box<Column> = Box::new(EMPTY);
    pass(&mut out);
    for (i, (sample, &found)) in inputs.samples.iter().zip(out.iter()).enumerate() {
        let expected = rust(Pair { wo: sample.wo, wi: sample.wi }, sample.alphas);
        let close = (found - expected).abs() <= TOLERANCE * expected.abs();
        assert!(close, "{name}, sample {i}: C++ has {found:e}, Rust {expected:e}: {sample:?}");
    }
    let pass = move || {
        pass(&mut out);
        std::hint::black_box(&out);
    };
    Case { group: EVALUATION, name, pass: Box::new(pass), limit: None }
}

/// The rows of the twin; none where it was not built.
///
/// # Panics
/// If a sample of the twin's is not Rust's.
#[cfg(cpp)]
pub(crate) fn rows(inputs: &Inputs) -> Vec<Case> {
    let alphas = |s: &Sample| s.alphas;
    let round = columns(&inputs.samples, |s| [s.alphas[0]]);
    let aligned = columns(&inputs.samples, alphas);
    let records = inputs.records(alphas);
    let isotropic =
        |pair, [alpha, _]: [f32; 2]| formulas::isotropic::<GgxDistribution, f32>(pair, [alpha]);
    let axis_aligned = formulas::axis_aligned::<GgxDistribution, f32>;
    let (first, second) = (inputs.directions.clone(), inputs.directions.clone());
    let pass = move |out: &mut Column| foreign::isotropic(&first, &round, out);
    let rounds = row(inputs, "cpp_ggx_isotropic", pass, isotropic);
    let pass = move |out: &mut Column| foreign::axis_aligned(&second, &aligned, out);
    let columns = row(inputs, "cpp_ggx_axis_aligned", pass, axis_aligned);
    let pass = move |out: &mut Column| foreign::axis_aligned_records(&records, out);
    let records = row(inputs, "cpp_ggx_axis_aligned_aos", pass, axis_aligned);
    vec![rounds, columns, records]
}

/// The rows of the twin; none where it was not built.
#[cfg(not(cpp))]
pub(crate) fn rows(_: &Inputs) -> Vec<Case> {
    Vec::new()
}
