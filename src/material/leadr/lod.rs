//! Which level of a cube map a solid angle asks for.
//!
//! Layer 4.

use crate::scalar::Real;

/// Level of detail of a cube map of `face` texels a side whose texels cover `solid_angle` on
/// average: $\frac{1}{2} \log_2 \frac{6\,\mathrm{face}^2\,\omega}{4\pi}$. Negative where the map is
/// too coarse.
///
/// A solid angle of 0 and below counts as the smallest f32: level -63 of a face of 1.
///
/// ```
/// use lobe::material::leadr::cube_lod;
/// let texel = 4.0 * core::f64::consts::PI / (6.0 * 64.0 * 64.0);
/// assert!(cube_lod(texel, 64.0).abs() < 1e-15);
/// assert!((cube_lod(16.0 * texel, 64.0) - 2.0).abs() < 1e-15);
/// ```
#[doc(alias = "lobe_cube_lod")]
pub fn cube_lod<R: Real>(solid_angle: R, face: R) -> R {
    let texels = R::lit(1.5 * core::f64::consts::FRAC_1_PI) * solid_angle;
    log_two(texels) * R::HALF + log_two(face)
}

/// The paper's rule for a grid of `nodes` x `nodes`, as its listing has it: $\log_2(2 \pi^{-3/2}\,
/// \mathrm{face}\, \sqrt\omega)$ plus a bias of 1.98 levels for 5 nodes and fewer, 0.98 for 32,
/// none from 128 on, in between by $\log_2$ of the nodes.
///
/// The formula takes a texel's angle as $\pi/(2\,\mathrm{face})$ and a disk for the facet's: 0.94
/// levels sharper than [`cube_lod`]. (Algorithm 1 has a third form, 1.29 levels sharper.) The
/// biases are what makes up for a Jacobian that is not constant over a large facet, and are printed
/// for the three sizes only.
///
/// Source: Dupuy et al. 2013, section 3.5.
///
/// ```
/// use lobe::material::leadr::{cube_lod, dupuy_cube_lod};
/// let difference = |nodes| dupuy_cube_lod(0.01_f64, 64.0, nodes) - cube_lod(0.01, 64.0);
/// assert!((difference(128) + 0.944).abs() < 1e-3 && (difference(5) - 1.036).abs() < 1e-3);
/// ```
pub fn dupuy_cube_lod<R: Real>(solid_angle: R, face: R, nodes: usize) -> R {
    // log2(2 pi^(-3/2)); the listing rounds it to -1.48, and writes 0.5 and -0.5 with the biases
    // in.
    let constant = R::lit(-1.477_244_194_208_478);
    let biases = [(5.0_f64, 1.98), (32.0, 0.98), (128.0, 0.0)];
    let n = (nodes as f64).clamp(5.0, 128.0);
    let mut bias = 0.0;
    for pair in biases.windows(2) {
        let ((low, at_low), (high, at_high)) = (pair[0], pair[1]);
        if n >= low && n <= high {
            let t = Real::ln(n / low) / Real::ln(high / low);
            bias = at_low + t * (at_high - at_low);
        }
    }
    constant + R::lit(bias) + log_two(face) + R::HALF * log_two(solid_angle)
}

/// Logarithm to base 2; that of the smallest number from there down.
fn log_two<R: Real>(x: R) -> R {
    x.max(R::lit(f64::from(f32::MIN_POSITIVE))).ln() * R::lit(core::f64::consts::LOG2_E)
}
