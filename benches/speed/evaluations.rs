//! The rows of evaluations: GGX and Beckmann over every shape, filtered or not, each one loop over
//! columns.
//!
//! Shapes are built inside the loop, of alphas or of factors; `tree` and `baked` rows read shapes
//! that were built before.

use super::cases::Case;
use super::columns::Inputs;
use super::formulas::{
    axis_aligned, brdf_over, brdf_over_in_lanes, full, isotropic, parallelogram,
    parallelogram_by_double, parallelogram_in_lanes, peak_fitted, peak_fitted_full, tilted,
    tilted_axis_aligned, tilted_isotropic, widened_axis_aligned, widened_full, widened_isotropic,
    widened_on_disk, widened_tilted_axis_aligned, widened_tilted_full, widened_tilted_isotropic,
};
use super::samples::{Regime, Sample, samples};
use super::{cpp, hand_written};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{Anisotropic, AxisAligned, Ggx, Isotropic, Real, Roughness};

/// Any A, built before.
fn any<R: Real>(s: &Sample) -> Anisotropic<R> {
    let [x, y, angle] = [s.alphas[0], s.alphas[1], s.angle].map(|x| R::lit(x.into()));
    Anisotropic::new(Roughness::from_alphas(x, y, angle).expect("valid alphas"))
}

fn alpha(s: &Sample) -> [f32; 1] {
    [s.alphas[0]]
}

fn alphas(s: &Sample) -> [f32; 2] {
    s.alphas
}

fn factor(s: &Sample) -> [f32; 3] {
    s.matrix.cholesky()
}

fn mean(s: &Sample) -> [f32; 2] {
    s.mean
}

fn slope(s: &Sample) -> [f32; 2] {
    s.slope
}

fn footprint(s: &Sample) -> [f32; 4] {
    let ([a, b], [c, d]) = (s.footprint.u, s.footprint.v);
    [a, b, c, d]
}

/// The columns of a row: those of its parts, one after the other.
macro_rules! joined {
    ($($part:ident),*) => {
        |s: &Sample| {
            let mut all = [$($part(s).as_slice()),*].concat().into_iter();
            std::array::from_fn(|_| all.next().expect("as many as the row takes"))
        }
    };
}

/// The rows of a distribution: twelve shapes.
macro_rules! shapes {
    ($inputs:ident, $name:literal, $d:ty) => {
        [
            $inputs.row(
                concat!($name, "_isotropic"),
                alpha,
                isotropic::<$d, _>,
                isotropic::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_axis_aligned"),
                alphas,
                axis_aligned::<$d, _>,
                axis_aligned::<$d, _>,
            ),
            $inputs.row(concat!($name, "_full"), factor, full::<$d, _>, full::<$d, _>),
            $inputs.row(
                concat!($name, "_tilted_isotropic"),
                joined!(alpha, mean),
                tilted_isotropic::<$d, _>,
                tilted_isotropic::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_tilted_axis_aligned"),
                joined!(alphas, mean),
                tilted_axis_aligned::<$d, _>,
                tilted_axis_aligned::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_tilted"),
                joined!(factor, mean),
                tilted::<$d, _>,
                tilted::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_isotropic"),
                joined!(alpha, footprint),
                widened_isotropic::<$d, _>,
                widened_isotropic::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_axis_aligned"),
                joined!(alphas, footprint),
                widened_axis_aligned::<$d, _>,
                widened_axis_aligned::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_full"),
                joined!(factor, footprint),
                widened_full::<$d, _>,
                widened_full::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_tilted_isotropic"),
                joined!(alpha, mean, footprint),
                widened_tilted_isotropic::<$d, _>,
                widened_tilted_isotropic::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_tilted_axis_aligned"),
                joined!(alphas, mean, footprint),
                widened_tilted_axis_aligned::<$d, _>,
                widened_tilted_axis_aligned::<$d, _>,
            ),
            $inputs.row(
                concat!($name, "_widened_tilted"),
                joined!(factor, mean, footprint),
                widened_tilted_full::<$d, _>,
                widened_tilted_full::<$d, _>,
            ),
        ]
    };
}

/// Every row.
pub(crate) fn rows() -> Vec<Case> {
    let inputs = Inputs::new(samples(Regime::Mixed));
    let mut rows = cpp::rows(&inputs);
    rows.extend(shapes!(inputs, "ggx", GgxDistribution));
    rows.extend(shapes!(inputs, "beckmann", BeckmannDistribution));
    rows.extend([
        inputs.record_row(
            "ggx_axis_aligned_aos",
            alphas,
            axis_aligned::<GgxDistribution, _>,
            axis_aligned::<GgxDistribution, _>,
        ),
        inputs.row(
            "ggx_widened_on_disk",
            joined!(alpha, footprint),
            widened_on_disk,
            widened_on_disk,
        ),
        inputs.row("ggx_peak_fitted", joined!(alpha, footprint), peak_fitted, peak_fitted),
        inputs.row(
            "ggx_peak_fitted_full",
            joined!(factor, footprint),
            peak_fitted_full,
            peak_fitted_full,
        ),
        inputs.baked_row(
            "ggx_parallelogram_tree",
            joined!(slope, footprint),
            any,
            parallelogram,
            any,
            parallelogram,
        ),
        inputs.baked_row("ggx_brdf_over_tree", footprint, any, brdf_over, any, brdf_over),
        inputs.row(
            "ggx_parallelogram_f32",
            joined!(factor, slope, footprint),
            parallelogram_in_lanes,
            parallelogram_in_lanes,
        ),
        inputs.uncounted_row(
            "ggx_parallelogram_f64",
            joined!(factor, slope, footprint),
            |_| (),
            |pair, p, ()| parallelogram_by_double(pair, p),
        ),
        inputs.row(
            "ggx_brdf_over_f32",
            joined!(factor, footprint),
            brdf_over_in_lanes,
            brdf_over_in_lanes,
        ),
    ]);
    rows.extend(by_hand(&inputs));
    rows
}

/// Promises: shapes that were checked before the loop, and the same formulas written by hand, which
/// check nothing; both read what they know of a sample's roughness from one place.
fn by_hand(inputs: &Inputs) -> [Case; 4] {
    let round = |s: &Sample| Isotropic::new(s.alphas[0]).expect("a valid alpha");
    let aligned = |s: &Sample| AxisAligned::new(s.alphas[0], s.alphas[1]).expect("valid alphas");
    [
        inputs.uncounted_row(
            "by_hand_ggx_isotropic",
            |_| [],
            |s| s.alphas[0],
            |pair, [], &alpha| hand_written::isotropic(alpha, pair.wo, pair.wi),
        ),
        inputs.uncounted_row(
            "by_hand_ggx_axis_aligned",
            |_| [],
            alphas,
            |pair, [], &alphas| hand_written::axis_aligned(alphas, pair.wo, pair.wi),
        ),
        inputs.uncounted_row(
            "ggx_isotropic_baked",
            |_| [],
            round,
            |pair, [], shape| Ggx::new(*shape).brdf(pair.wo, pair.wi),
        ),
        inputs.uncounted_row(
            "ggx_axis_aligned_baked",
            |_| [],
            aligned,
            |pair, [], shape| Ggx::new(*shape).brdf(pair.wo, pair.wi),
        ),
    ]
}
