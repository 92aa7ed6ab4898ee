//! GGX over a parallelogram, exactly: any A, any mean, any aspect, zero area included.
//!
//! Layer 3. Whitened by $L^{-1}$ ($A = L L^T$), GGX is the unit density $1/(\pi (1 + |w|^2)^2)$,
//! and its mass over a polygon is Lambert's formula in another guise: GGX is a linearly transformed
//! cosine. This settles what Kaplanyan et al. 2016 leave open in section 5.3. One formula does not
//! serve every footprint in floating point; the size of the parallelogram against its distance from
//! the lobe decides among some that agree where they meet:
//!
//! - longer than $2^{48}$ lobes ($2^{106}$ in f64), or over a mirror or a groove: the lobe is a
//!   point or a line (groove.rs);
//! - small: tensor Gauss-Legendre, no transcendental function;
//! - thick, and around or beside the lobe: the sum over the four edges, straight from the corners
//!   (edges.rs);
//! - narrow: exact means along the long side, Gauss-Legendre across (strip.rs);
//! - thin though sheared: the same for its pieces (thin.rs);
//! - otherwise: the edges again, far ones without the turns that they add up to (edges.rs).
//!
//! Of a footprint that is long against its distance, whitened coordinates have lost the digits that
//! matter: its corners then come from slope space, with compensated sums (frame.rs).

use super::frame::Frame;
use super::segment::unit_density;
use super::strip::{Strip, Whitened};
use super::{edges, thin};
use crate::filter::groove;
use crate::ndf::{GgxDistribution, Ndf};
use crate::scalar::exact::two_sum;
use crate::scalar::quadrature::{GAUSS_EIGHT, GAUSS_FOUR, GAUSS_TWO, Rule};
use crate::scalar::{Internal, Real};
use crate::slope::{Footprint, Whiten};

/// Squared ratio of a side to the distance of the nearest pole, below which a rule of N nodes
/// serves.
///
/// The density has its poles where $|w|^2 = -1$: as far from a side's complex plane as the root of
/// [`Frame::nearness`]. A rule of N nodes over x times that distance errs by about $(x/4)^{2N}$. In
/// f32 two nodes to 0.05 and four to 0.5 (6e-8); in f64 four nodes to 0.05 and eight to 0.5
/// (3e-15).
const COARSE: f64 = 0.05 * 0.05;
const FINE: f64 = 0.5 * 0.5;

/// The same for eight nodes in f32, 4e-7 at 1.6: a sharp corner of a long footprint holds so little
/// mass that the edges' terms, of order one, cancel to it.
const SHARP: f64 = 1.6 * 1.6;

#[inline(always)]
fn tensor<R: Real, const N: usize>(w: &Whitened<R>, rule: &Rule<N>) -> R {
    rule.mean(|j| {
        let (x, y) = (w.midpoint[0] + j * w.v[0], w.midpoint[1] + j * w.v[1]);
        rule.mean(|i| unit_density(x + i * w.u[0], y + i * w.u[1]))
    })
}

/// Mean of the unit density over any footprint that is not small.
#[inline(never)]
fn general_mean<R: Real>(frame: &Frame<R>) -> R {
    let long = frame.length * frame.length > R::lit(8.0 * 8.0) * frame.nearness;
    let thickness2 = thin::thickness_squared(frame);
    if thickness2 <= R::lit(FINE) {
        if R::SINGLE { thin::mean(frame, &GAUSS_FOUR) } else { thin::mean(frame, &GAUSS_EIGHT) }
    } else if R::SINGLE && long && thickness2 <= R::lit(SHARP) {
        thin::mean(frame, &GAUSS_EIGHT)
    } else {
        edges::mass(frame) / (frame.length * frame.height)
    }
}

impl<S: Whiten> Ndf<GgxDistribution, S> {
    /// Mean of $P_{22}$ over the parallelogram `slope +- u/2 +- v/2` of a footprint: exact.
    ///
    /// The mass over a polygon is, whitened ($w = L^{-1}(s - \mu)$), a sum over its edges:
    /// $\frac{1}{2\pi} \sum \frac{d}{\sqrt q} \mathrm{atan2}(\ell \sqrt q, q + t_0 t_1)$, $d$ the
    /// signed distance of the edge's line, $q = 1 + d^2$. A zero footprint gives $P_{22}$ itself, a
    /// segment the mean along it. Error, relative: f32 below 1e-5 within ten alphas of the lobe
    /// (1.2e-5 in one of ten million random footprints) and 1e-3 wherever the mean is a normal
    /// number; f64 below 1e-9. Components beyond $10^9$ shrink the footprint to that, in
    /// proportion. Divide by $h_z^4$ for the filtered D ([`Ndf::brdf_over`] does).
    ///
    /// A mirror's mean is one over the footprint's area if the footprint holds the lobe's mean
    /// slope, half of that if the mean slope lies on a side, a quarter if it is a corner, and 0
    /// outside. A groove's, of a lobe that is a mirror along one axis, is the mass of the chord
    /// that the footprint cuts from the line through the mean slope, $\frac12 [x/\sqrt{\alpha^2 +
    /// x^2}]$ between the chord's ends, over the area. A footprint without area has the mean 0 of a
    /// mirror, and of a groove unless it is a segment that crosses it. Alphas in between tend to
    /// these values: below 1e-9 in f32 within 1e-4 of one over the area. A lobe also counts as a
    /// mirror or as a groove if $\sqrt{\det A}$ is no normal number of f32, if the footprint is
    /// thicker than $2^{48}$ of the wider alpha, or if it reaches across a groove, of alphas
    /// $2^{24}$ apart, by $2^{48}$ of the narrower one ($2^{106}$ in f64).
    ///
    /// Source: derived here by Green's theorem; the polygon integral of Loubet et al. 2020 in
    /// another form. It answers the open question of Kaplanyan et al. 2016, section 5.3.
    ///
    /// ```
    /// use lobe::{Anisotropic, Footprint, Ggx, Roughness};
    /// let ggx = Ggx::new(Anisotropic::new(Roughness::from_alphas(0.1_f64, 0.02, 0.4)?));
    /// let wide = Footprint::from_slopes([300.0, 0.0], [100.0, 400.0]);
    /// let mass = ggx.parallelogram_mean([0.0, 0.0], &wide) * wide.area();
    /// assert!((mass - 1.0).abs() < 1e-6);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_parallelogram_mean")]
    pub fn parallelogram_mean(
        &self,
        slope: impl Into<[S::Scalar; 2]>,
        footprint: &Footprint<S::Scalar>,
    ) -> S::Scalar {
        let footprint = &footprint.bounded();
        let offset = self.offset_of(slope.into(), [S::Scalar::ZERO; 2]);
        let whitened = Whitened::new(self.shape(), offset.0, offset.1, footprint);
        let side2 = whitened.longer_side_squared();
        if let Some(covered) = groove::unresolved(self.shape(), side2, offset, footprint) {
            return covered.mean;
        }
        self.mean_of(&whitened, offset, footprint)
    }

    /// The mean over a whitened footprint that resolves the lobe, `offset` its center less the
    /// lobe's, as an unevaluated sum.
    pub(super) fn mean_of(
        &self,
        whitened: &Whitened<S::Scalar>,
        (offset, low): ([S::Scalar; 2], [S::Scalar; 2]),
        footprint: &Footprint<S::Scalar>,
    ) -> S::Scalar {
        let shape = self.shape();
        let root_det = shape.root_det();
        let (center2, side2) = (whitened.midpoint_squared(), whitened.longer_side_squared());
        // The distance to the footprint is at least two thirds of that to its center, or does not
        // matter.
        let nearness = S::Scalar::ONE + S::Scalar::lit(4.0 / 9.0) * center2;
        let around = || {
            let exact_area = || footprint.area() / root_det;
            let plain = edges::serves_plain_corners(side2);
            if plain { edges::around_the_lobe(whitened, center2, side2, exact_area) } else { None }
        };
        let mean = if side2 <= S::Scalar::lit(COARSE) * nearness {
            if S::Scalar::SINGLE {
                tensor(whitened, &GAUSS_TWO)
            } else {
                tensor(whitened, &GAUSS_FOUR)
            }
        } else if S::Scalar::SINGLE && side2 <= S::Scalar::lit(FINE) * nearness {
            tensor(whitened, &GAUSS_FOUR)
        } else if let Some(mean) = around() {
            mean
        } else {
            let strip = Strip::new(whitened);
            let narrow = strip.is_narrow();
            if strip.keeps_digits() {
                if narrow { strip.mean() } else { general_mean(&Frame::plain(whitened)) }
            } else {
                // What looks narrow from afar may not be.
                let sharpened = if narrow {
                    strip.sharpened_mean(whitened, shape, (offset, low), footprint)
                } else {
                    None
                };
                sharpened.unwrap_or_else(|| {
                    general_mean(&Frame::exact(whitened, shape, offset, low, footprint))
                })
            }
        };
        mean / root_det
    }

    /// Slope less mean of `slope + slope_low`, as an unevaluated sum.
    pub(super) fn offset_of(
        &self,
        slope: [S::Scalar; 2],
        slope_low: [S::Scalar; 2],
    ) -> ([S::Scalar; 2], [S::Scalar; 2]) {
        let (offset, low) = self.shape().offset(slope);
        let (x, y) =
            (two_sum(offset[0], low[0] + slope_low[0]), two_sum(offset[1], low[1] + slope_low[1]));
        ([x.0, y.0], [x.1, y.1])
    }

    /// Mean of $P_{22}$ over the rectangle `slope +- widths/2` along the slope axes: exact, and
    /// stable where the closed form of Appendix A is not.
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 16, for any A and mean; see
    /// `kaplanyan_rectangle_mean` for the paper's form.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ggx = Ggx::new(Isotropic::new(0.1_f32)?);
    /// let point = ggx.slope_pdf([0.05, 0.0]);
    /// assert!((ggx.rectangle_mean([0.05, 0.0], [1e-5, 1e-5]) / point - 1.0).abs() < 1e-6);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_rectangle_mean")]
    pub fn rectangle_mean(
        &self,
        slope: impl Into<[S::Scalar; 2]>,
        widths: impl Into<[S::Scalar; 2]>,
    ) -> S::Scalar {
        self.parallelogram_mean(slope, &Footprint::rectangle(widths))
    }
}
