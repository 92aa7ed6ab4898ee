//! Kaplanyan's Eq. 20: the exact peak of GGX over a square, and the form that stands for it.

use lobe::filter::{box_peak_alpha, kaplanyan_proxy_alpha};
use lobe::{Error, Footprint, Ggx, Isotropic, Kernel, PixelFilter, Roughness};
use serde::Serialize;

/// alpha' of the two forms and of variance addition that comes close, for alpha = 1 and one width.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Proxy {
    /// Width of the square, in alphas.
    pub(crate) width: f64,
    /// alpha' with the exact peak.
    pub(crate) exact: f64,
    /// alpha' of the last form, $\alpha^2 + w^2$.
    pub(crate) last_form: f64,
    /// alpha' of $\alpha^2 + w^2/\pi$.
    pub(crate) over_pi: f64,
    /// Peak of the GGX of each over the mean over the square at the center, in that order.
    pub(crate) peak_ratios: [f64; 3],
}

/// Widths per decade.
const PER_DECADE: i32 = 16;

impl Proxy {
    pub(super) fn of_width(width: f64) -> Result<Self, Error> {
        let kernel =
            Kernel::of(&Footprint::rectangle([width; 2]), PixelFilter::TOKUYOSHI_KAPLANYAN);
        let over_pi = Roughness::from_alpha(1.0)?.widened(&kernel).alphas().major;
        let alphas = [box_peak_alpha(1.0, width)?, kaplanyan_proxy_alpha(1.0, width)?, over_pi];
        let mean = Ggx::new(Isotropic::new(1.0)?).rectangle_mean([0.0; 2], [width; 2]);
        let ratio = |alpha: f64| 1.0 / (std::f64::consts::PI * alpha * alpha * mean);
        Ok(Self {
            width,
            exact: alphas[0],
            last_form: alphas[1],
            over_pi: alphas[2],
            peak_ratios: alphas.map(ratio),
        })
    }

    /// From a hundredth of alpha to ten alphas.
    pub(super) fn all() -> Result<Vec<Self>, Error> {
        let exponents = -2 * PER_DECADE..=PER_DECADE;
        let widths = exponents.map(|k| 10.0_f64.powf(f64::from(k) / f64::from(PER_DECADE)));
        widths.map(Self::of_width).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Proxy;

    #[test]
    fn the_re_derived_form_has_the_peak_of_the_square_and_the_last_form_does_not() {
        for proxy in Proxy::all().unwrap() {
            let [exact, last_form, over_pi] = proxy.peak_ratios.map(|ratio| (ratio - 1.0).abs());
            assert!(exact < 1e-12, "{proxy:?}");
            assert!(over_pi < last_form, "{proxy:?}");
        }
        // Small squares: alpha'^2 - alpha^2 is w^2/3, not w^2.
        let small = Proxy::of_width(0.01).unwrap();
        let ratio = (small.last_form.powi(2) - 1.0) / (small.exact.powi(2) - 1.0);
        assert!((ratio - 3.0).abs() < 1e-3, "{ratio}");
        // Large squares: pi times too wide a square of alpha.
        let large = Proxy::of_width(1e3).unwrap();
        assert!((large.peak_ratios[1] * std::f64::consts::PI - 1.0).abs() < 1e-2);
    }
}
