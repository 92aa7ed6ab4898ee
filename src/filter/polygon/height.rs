//! The BRDF over a footprint in straight-line code: how high the normals stand, from the mean
//! alone.
//!
//! Layer 3. brdf.rs asks where a footprint and a lobe meet; here two Gaussians say it, with one
//! root and two divisions.

use super::halves::Halves;
use super::lanes::inverse_and_limit;
use crate::ndf::{GgxDistribution, Ndf};
use crate::scalar::Real;
use crate::slope::{Footprint, LobeShape, Whiten};
use core::f64::consts::FRAC_1_PI;

/// How much the mean of g, g = 1/(1 + q), lies below the root of the mean of its square, for a
/// footprint of y squared widths of the lobe: by the factor 1/(1 + 0.02 y).
///
/// By hand, on 24,000 random lobes and footprints against quadrature (tests/laws/over.rs has the
/// draws): 0.016 to 0.03 do nearly as well, and 0 leaves 74 in place of 93 of 100 draws with
/// footprints up to 30 within 10 %.
const JENSEN: f64 = 0.02;

#[inline(always)]
fn square<R: Real>(v: [R; 2]) -> R {
    v[0] * v[0] + v[1] * v[1]
}

/// A half vector's slope, and the lobe that it meets.
struct Meeting<R> {
    /// The slope less the mean slope, and the mean slope.
    offset: [R; 2],
    mean_slope: [R; 2],
    /// The factor of A, and the sum of the footprint's squared half sides, as slopes.
    factor: [R; 3],
    sides2: R,
}

/// $\pi \sqrt{\det A}$ times the mean of $P_{22} (1 + |s|^2)^2$, of a whitened footprint and the
/// mean of $1/(1 + q)^2$ over it.
///
/// $(1 + |s|^2)/(1 + q)$ is rate + (1 - rate) g with $g = 1/(1 + q)$ for a lobe that is round with
/// $\alpha^2$ = rate. Any lobe is taken for that beyond the place that its mean comes from: the
/// mean of lobe times footprint, both as Gaussians, the lobe's of the covariance $A (1 + q)/3$ at
/// the mean's own q, the footprint's that of the box. The rate is how the covariance of their
/// product whitens. The third was chosen like [`JENSEN`]; 1/3.5 to 1/2.5 do nearly as well.
#[inline(always)]
fn raised<R: Real>(halves: &Halves<R>, at: &Meeting<R>, mean: R, centered: bool) -> R {
    let Halves { c, a, b, aa, bb, ca, cb, ab, .. } = *halves;
    let Meeting { offset, mean_slope, factor: [l_xx, l_yx, l_yy], sides2 } = *at;
    let (zero, one) = (R::ZERO, R::ONE);
    let trace = (l_xx * l_xx + l_yx * l_yx) + l_yy * l_yy;
    let sides = aa + bb;
    // Towards the lobe's center: whitened, and as a slope.
    let e = [ca * a[1] + cb * b[1], -(ca * a[0] + cb * b[0])];
    let es = [l_xx * e[0], l_yx * e[0] + l_yy * e[1]];
    let m = mean.sqrt();
    let m_ab = m * ab;
    let y = m * sides + m_ab * m_ab;
    let whole = one + y;
    let spread = one + R::lit(JENSEN) * y;
    let inverse = one / (whole * spread);
    let inverse_whole = spread * inverse;
    let less = (R::lit(2.0 * JENSEN) * y) * (whole * inverse);
    let at_place = |from: R, e: R| (from + m * e) * inverse_whole;
    let q = square([at_place(c[0], e[0]), at_place(c[1], e[1])]);
    let beside = [at_place(offset[0], es[0]), at_place(offset[1], es[1])];
    let slope = [mean_slope[0] + beside[0], mean_slope[1] + beside[1]];
    let tan2 = square(if centered { beside } else { slope });
    let both = m_ab * ab;
    // The floor is the least square that the sum of two may be in f32 with all its digits.
    let rate = (sides2 + both * trace) / (sides + (both + both)).max(R::lit(1e-30));
    let f = rate * (one - m * (one + q)).max(zero) + m * (one + tan2);
    f * f - (less * rate) * (f - rate).max(zero)
}

impl<S: Whiten> Ndf<GgxDistribution, S> {
    /// The BRDF with D averaged over a footprint around the half vector's slope, without a branch:
    /// [`Ndf::brdf_over`] for loops that become vectors, and for GPUs. Masking and shadowing are
    /// unfiltered.
    ///
    /// With $M = \pi \sqrt{\det A}\,\overline{P_{22}}$ of [`Ndf::parallelogram_mean_in_lanes`], $m
    /// = \sqrt M$, and the place $s_*$ that the mean comes from ($q_*$ in the lobe's units),
    /// $\tilde D = [F^2 - 2 (1 - r)\, \rho \max(F - \rho, 0)]/(\pi \sqrt{\det A})$ where $F = \rho
    /// \max(1 - m (1 + q_*), 0) + m (1 + |s_*|^2)$. $\rho$ is how fast $1 + |s|^2$ grows with q
    /// around that place, $\alpha^2$ if the lobe is round, and r the ratio of the mean of 1/(1 + q)
    /// to m.
    ///
    /// $\tilde D$ is an estimate; for centered lobes of alphas up to 1 it is never above the peak
    /// but by rounding. Over random lobes of alphas 0.05 to 0.9, slopes and footprints up to 2, it
    /// is within 10 % of the mean of D in 99 of 100 draws and within a factor 2 in all of 12,000;
    /// up to 30, within 10 % in 92 and within a factor 2 in 99 of 100. Rare ones come out far too
    /// large there: 1 of 12,000 by a factor 16, where only the tip of a large footprint reaches a
    /// long lobe (tests/laws/lanes.rs).
    ///
    /// A zero footprint gives the BRDF within 2e-5, but for half vectors that stand more than 1e9
    /// alphas from the lobe in f32: 0 there. 0 as well for a mirror or a groove, where `brdf_over`
    /// knows better, where [`Ndf::brdf`] is 0 by the horizon, and for NaN; never NaN, negative or
    /// infinite.
    ///
    /// Cost: 17 divisions and 8 roots; in a loop over f32 samples about 13 times the isotropic
    /// BRDF, where `brdf_over` costs 180 times as much.
    ///
    /// Source: ours; Kaplanyan et al. 2016, Eq. 11, but for the factor, as `brdf_over`.
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Isotropic};
    /// let ggx = Ggx::new(Isotropic::new(0.1_f32)?);
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.5, 0.1, 0.86]);
    /// let pixel = Footprint::from_slopes([0.1, 0.0], [0.05, 0.2]);
    /// let ratio = ggx.brdf_over_in_lanes(wo, wi, &pixel) / ggx.brdf_over(wo, wi, &pixel);
    /// assert!((ratio - 1.0).abs() < 1e-2);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_brdf_over_in_lanes")]
    #[inline(always)]
    pub fn brdf_over_in_lanes(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
        footprint: &Footprint<S::Scalar>,
    ) -> S::Scalar {
        let (wo, wi) = (wo.into(), wi.into());
        let (zero, one) = (S::Scalar::ZERO, S::Scalar::ONE);
        let Footprint { u, v } = *footprint;
        let (inverse, limit) = inverse_and_limit(self.shape().root_det());
        let half = [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]];
        let inverse_z = -one / half[2].max(S::Scalar::MIN_POSITIVE);
        // As the BRDF: the form of the sum less the mean, before it is divided.
        let [x, y] = self.shape().relative(half);
        let offset = [x * inverse_z, y * inverse_z];
        let whiten = |v| self.shape().whiten_with(v, inverse);
        let halves = Halves::new(offset, footprint, whiten);
        let at = Meeting {
            offset,
            mean_slope: self.shape().relative([zero, zero, one]),
            factor: self.shape().factor(),
            sides2: S::Scalar::lit(0.25) * (square(u) + square(v)),
        };
        let raised =
            raised(&halves, &at, halves.mean().value, <S as LobeShape>::CENTERED).max(zero);
        let density = (S::Scalar::lit(FRAC_1_PI) * inverse) * raised;
        let brdf = density * self.visibility(wo, wi);
        let limit = if half[2] > zero { limit } else { zero };
        brdf.max(zero).min(limit)
    }
}
