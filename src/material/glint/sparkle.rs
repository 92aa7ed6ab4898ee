//! How much brighter than its smooth lobe a glittering pixel is: what its cells draw.
//!
//! Layer 4.

use super::binomial::Binomial;
use super::color::tint;
use super::glints::Groove;
use super::level::CoveredCell;
use super::light::light_blur;
use super::ndf::GlintNdf;
use crate::material::cells::Cell;
use crate::scalar::quantile::normal_quantile;
use crate::scalar::{Psd, Real};
use crate::slope::LobeShape;
use crate::slope::direction::half_vector;

/// Below this probability of a reflecting detail nothing is drawn: the smooth lobe is as good.
const LEAST: f64 = 1e-30;

/// What all cells of a pixel share under one half vector.
#[derive(Clone, Copy, Debug)]
struct Reflection<R> {
    probability: R,
    /// The half vector in bins.
    bin: [R; 2],
}

/// What the cells of a pixel make of its sparkle.
#[derive(Clone, Copy, Debug)]
enum Mixture<R> {
    /// Nothing was drawn: the sparkle itself.
    Even(R),
    /// Their parts were given away, and are to be divided by the sum of their shares.
    Cells(R),
}

impl<R: Real> GlintNdf<R> {
    /// Probability that a detail reflects at the unit normal `h`, under a light of this `blur`; in
    /// [0, 1], 0 at the horizon and below.
    #[doc(alias = "lobe_glint_ndf_probability")]
    #[inline]
    pub fn probability(&self, h: impl Into<[R; 3]>, blur: R) -> R {
        let h = h.into();
        if !(h[2] > R::ZERO) {
            return R::ZERO;
        }
        self.reflection(h, self.blurred(blur)).probability
    }

    /// How much brighter than the smooth lobe the pixel is at the unit half vector `h`: not
    /// negative, 1 on average.
    ///
    /// `blur` is what a light's extent adds to $\alpha^2$ ([`light_blur`]), 0 of a point. Where a
    /// detail reflects with a probability below $10^{-30}$, and where details are mirrors under a
    /// point, 1. 0 below the horizon.
    #[doc(alias = "lobe_glint_ndf_sparkle")]
    pub fn sparkle(&self, h: impl Into<[R; 3]>, blur: R) -> R {
        let mut sum = R::ZERO;
        match self.mixed(h.into(), blur, |_, part, _| sum = sum + part) {
            Mixture::Even(sparkle) => sparkle,
            Mixture::Cells(shares) => R::ONE + self.share * (sum / shares - R::ONE),
        }
    }

    /// The same in colors: each cell has one of a palette, and white where its details are many.
    ///
    /// `palette` gives a color for a number in [0, 1]; with a mean of 1 in each channel, as
    /// [`hue_wheel`](super::hue_wheel) has it, the sparkle's mean stays 1.
    ///
    /// Source: Zirr & Kaplanyan 2016, section 4.5.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::glint::{Biscale, Glints, hue_wheel};
    /// let foil = Glints::new(Biscale::from_fractions([0.3_f64, 0.3], [0.1, 0.1])?, 100.0)?;
    /// let pixel = foil.ndf(&Patch::new([0.4, 0.2], [0.1, 0.0], [0.0, 0.1]));
    /// let h = [0.0, 0.0, 1.0];
    /// let golden = pixel.colored_sparkle(h, 0.0, |hue| [1.2 - 0.4 * hue, 1.0, 0.8 + 0.4 * hue]);
    /// assert!((golden[1] - pixel.sparkle(h, 0.0)).abs() < 1e-12);
    /// assert!(pixel.colored_sparkle(h, 0.0, hue_wheel).iter().all(|x| *x >= 0.0));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_glint_ndf_colored_sparkle")]
    pub fn colored_sparkle(
        &self,
        h: impl Into<[R; 3]>,
        blur: R,
        palette: impl Fn(R) -> [R; 3],
    ) -> [R; 3] {
        let mut sum = [R::ZERO; 3];
        let mixture = self.mixed(h.into(), blur, |cell, part, count| {
            let color = tint(palette(cell.hue()), count);
            sum = [0, 1, 2].map(|k| sum[k] + part * color[k]);
        });
        match mixture {
            Mixture::Even(sparkle) => [sparkle; 3],
            Mixture::Cells(shares) => sum.map(|x| R::ONE + self.share * (x / shares - R::ONE)),
        }
    }

    /// Slope density at the slope of the unit normal `h`: that of the smooth lobe times the
    /// sparkle.
    #[doc(alias = "lobe_glint_ndf_slope_pdf")]
    pub fn slope_pdf(&self, h: impl Into<[R; 3]>, blur: R) -> R {
        let h = h.into();
        if !(h[2] > R::ZERO) {
            return R::ZERO;
        }
        let smooth = self.smooth().slope_pdf(crate::slope::direction::slope_of(h));
        (smooth * self.sparkle(h, blur)).min(R::MAX)
    }

    /// The BRDF without Fresnel, as [`Ndf::brdf`](crate::Ndf::brdf) of the smooth lobe, times the
    /// sparkle, under a light that appears with this radius, in radians (0: a point).
    #[doc(alias = "lobe_glint_ndf_brdf")]
    pub fn brdf(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>, radius: R) -> R {
        let (wo, wi) = (wo.into(), wi.into());
        let brdf = self.smooth().brdf(wo, wi);
        if brdf > R::ZERO {
            let sparkle = self.sparkle(half_vector(wo, wi), light_blur(wo, wi, radius));
            (brdf * sparkle).min(R::MAX)
        } else {
            R::ZERO
        }
    }

    /// Details under a light: $A_l$ plus its blur.
    #[inline]
    fn blurred(&self, blur: R) -> Psd<R> {
        let blur = blur.max(R::ZERO).min(R::LARGEST);
        let round = Psd::with_root_det([blur, R::ZERO, blur], blur);
        self.biscale.local().matrix() + round
    }

    #[inline]
    fn reflection(&self, h: [R; 3], local: Psd<R>) -> Reflection<R> {
        // Mirrors have nothing to divide by.
        let (one, least) = (R::ONE, R::MIN_POSITIVE);
        let global = self.global.matrix();
        let ([g, _, g_along], [l, _, l_along]) = (global.entries(), local.entries());
        let shape = self.smooth_lobe().shape();
        let [l11, l21, l22] = local.cholesky();
        let side = R::PI.sqrt();
        match self.groove {
            Groove::None => {
                let form = shape.form(h);
                let exponent = form / (shape.extent().unit * h[2] * h[2]).max(least);
                let peaks = (local.root_det() / global.root_det().max(least)).min(one);
                let per_bin = R::TWO / ((one + h[2]) * side);
                let x = h[0] * per_bin / l11.max(least);
                let bin = [x, (h[1] * per_bin - l21 * x) / l22.max(least)];
                // `max` drops a NaN.
                Reflection { probability: (peaks * (-exponent).exp()).max(R::ZERO), bin }
            }
            Groove::AlongV => self.across(0, h, l, g),
            Groove::AlongU => self.across(1, h, l_along, g_along),
        }
    }

    /// The same of grooves: along them every detail has all slopes, so only the slope across
    /// decides.
    #[inline]
    fn across(&self, axis: usize, h: [R; 3], local: R, global: R) -> Reflection<R> {
        let slope = h[axis] / h[2];
        let offset = slope + self.mean[axis];
        let global = global.max(R::MIN_POSITIVE);
        let peaks = (local / global).min(R::ONE).sqrt();
        // `max` drops a NaN.
        let probability = (peaks * (-(offset * offset / global)).exp()).max(R::ZERO);
        let mut bin = [R::ZERO; 2];
        bin[axis] = slope / (R::PI.sqrt() * local.sqrt()).max(R::MIN_POSITIVE);
        Reflection { probability, bin }
    }

    /// Calls `add` with every cell, its part of the sparkle and the count of its reflecting
    /// details.
    #[inline]
    fn mixed(&self, h: [R; 3], blur: R, mut add: impl FnMut(Cell, R, R)) -> Mixture<R> {
        if !(h[2] > R::ZERO) {
            return Mixture::Even(R::ZERO);
        }
        let Reflection { probability, bin } = self.reflection(h, self.blurred(blur));
        if !(probability >= R::lit(LEAST)) {
            return Mixture::Even(R::ONE);
        }
        let numbers = self.numbers();
        let draws = numbers.map(|n| Binomial::new(n, probability));
        let finer = self.grid.exponent();
        let shares = self.grid.walk(|CoveredCell { exponent, share, .. }, cell| {
            let level = usize::from(exponent != finer);
            let (n, draw) = self.varied(cell, numbers[level], draws[level], probability);
            let [a, b] = cell.jitter::<R>();
            let count = draw.draw(cell.count([(bin[0] + a).floor(), (bin[1] + b).floor()]));
            add(cell, share * (count / (n * probability)), count);
        });
        Mixture::Cells(shares.max(R::MIN_POSITIVE))
    }

    /// A cell's number of details, at least one, and their draw: of the level's, unless numbers
    /// vary.
    #[inline]
    fn varied(&self, cell: Cell, n: R, draw: Binomial<R>, probability: R) -> (R, Binomial<R>) {
        let (one, most) = (R::ONE, R::LARGEST * R::LARGEST);
        if !(self.variation > R::ZERO) {
            return (n.max(one).min(most), draw);
        }
        let z = normal_quantile(cell.size::<R>());
        let n = n * (self.variation * (z - R::HALF * self.variation)).exp();
        (n.max(one).min(most), Binomial::new(n, probability))
    }

    /// Details of a cell on the finer level and on the coarser one, before they vary.
    #[inline]
    fn numbers(&self) -> [R; 2] {
        let size = R::power_of_two(self.grid.exponent());
        let across = self.density.sqrt() * size;
        match self.groove {
            Groove::None => [across * across, R::lit(4.0) * (across * across)],
            _ => [across, R::TWO * across],
        }
    }
}
