//! Batches: what `lobe::batch` makes of columns, beside the loops of the other rows.
//!
//! With the feature `dispatch` of this package, which is on by default, by the best instructions of
//! the machine; without it, by those of the target.

use super::cases::{Case, EVALUATION};
use super::columns::{Column, EMPTY, Inputs, columns};
use super::samples::{COUNT, Regime, Sample, samples};
use lobe::PixelFilter;
use lobe::batch::{Anisotropic, Footprint, Ggx, Isotropic, Widened};
use std::hint::black_box;
use std::rc::Rc;

/// Numbers of all samples, without the padding.
fn slices<const N: usize>(columns: &[Column; N]) -> [&[f32]; N] {
    columns.each_ref().map(|column| &column[..COUNT])
}

/// What a row computes of parameters and directions.
type Batch<const N: usize> = fn([&[f32]; N], [&[f32]; 6], &mut [f32]);

/// A row of directions and parameters.
fn row<const N: usize>(
    inputs: &Inputs,
    name: &'static str,
    pick: fn(&Sample) -> [f32; N],
    batch: Batch<N>,
) -> Case {
    let parameters: Rc<[Column; N]> = columns(&inputs.samples, pick);
    let directions = inputs.directions.clone();
    let mut out: Box<Column> = Box::new(EMPTY);
    let pass = move || {
        let (directions, parameters) = (black_box(&*directions), black_box(&*parameters));
        batch(slices(parameters), slices(directions), &mut out[..COUNT]);
        black_box(&out);
    };
    Case { group: EVALUATION, name, pass: Box::new(pass), limit: None }
}

/// Every row.
pub(crate) fn rows() -> [Case; 3] {
    let inputs = Inputs::new(samples(Regime::Mixed));
    [
        row(
            &inputs,
            "batch_ggx_isotropic",
            |s| [s.alphas[0]],
            |[alpha], [a, b, c, d, e, f], out| {
                let ggx = Ggx::new(Isotropic(alpha));
                ggx.brdf([a, b, c], [d, e, f], out).expect("one length");
            },
        ),
        row(
            &inputs,
            "batch_ggx_widened_isotropic",
            |s| {
                let ([a, b], [c, d]) = (s.footprint.u, s.footprint.v);
                [s.alphas[0], a, b, c, d]
            },
            |[alpha, p, q, r, s], [a, b, c, d, e, f], out| {
                let footprints = Footprint { u: [p, q], v: [r, s] };
                let shapes = Isotropic(alpha);
                let ggx = Ggx::new(Widened { shapes, footprints, filter: PixelFilter::BOX });
                ggx.brdf([a, b, c], [d, e, f], out).expect("one length");
            },
        ),
        row(
            &inputs,
            "batch_ggx_parallelogram_double",
            |s| {
                let ([l_xx, l_yx, l_yy], [x, y]) = (s.matrix.cholesky(), s.slope);
                let ([a, b], [c, d]) = (s.footprint.u, s.footprint.v);
                [l_xx, l_yx, l_yy, x, y, a, b, c, d]
            },
            |[l_xx, l_yx, l_yy, x, y, a, b, c, d], _, out| {
                let footprints = Footprint { u: [a, b], v: [c, d] };
                let ggx = Ggx::new(Anisotropic([l_xx, l_yx, l_yy]));
                ggx.parallelogram_mean_in_double([x, y], footprints, out).expect("one length");
            },
        ),
    ]
}
