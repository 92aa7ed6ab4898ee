//! Filters of GGX without a renderer: what each makes of a lobe under a pixel, against what it
//! should.
//!
//! GGX scales, so one lobe of alpha 1 stands for all, and one number for the pixel: kappa, twice
//! its variance over alpha squared. Projected-space filters are left out: what they add depends on
//! alpha and on where the half vector stands, not on kappa alone.

mod density;
mod filter;
mod measure;
mod pixel;
mod proxy;

use lobe::Error;
use serde::Serialize;

pub(crate) use filter::{Family, Filter};
pub(crate) use measure::{FAR, Measures, REACH};
pub(crate) use pixel::Truth;
pub(crate) use proxy::Proxy;

use filter::FILTERS;
use measure::Samples;
use pixel::Pixel;

/// All that was measured.
#[derive(Serialize)]
pub(crate) struct Kernels {
    /// One for each truth and filter, in that order.
    pub(crate) curves: Vec<Curve>,
    pub(crate) proxies: Vec<Proxy>,
}

/// One filter against one truth, over the size of the pixel.
#[derive(Serialize)]
pub(crate) struct Curve {
    pub(crate) truth: Truth,
    pub(crate) filter: &'static Filter,
    /// alpha' of the resulting GGX for each pixel; empty if the filter gives none.
    pub(crate) alphas: Vec<f64>,
    /// For each pixel.
    pub(crate) points: Vec<Measures>,
}

/// Pixels per decade of kappa.
const PER_DECADE: i32 = 4;

impl Kernels {
    /// Every filter on pixels of kappa from 0.01 to 100.
    pub(crate) fn measured() -> Result<Self, Error> {
        let exponents = -2 * PER_DECADE..=2 * PER_DECADE;
        let kappas = exponents.map(|k| 10.0_f64.powf(f64::from(k) / f64::from(PER_DECADE)));
        Ok(Self { curves: curves(kappas)?, proxies: Proxy::all()? })
    }
}

fn curves(kappas: impl Iterator<Item = f64>) -> Result<Vec<Curve>, Error> {
    let mut curves: Vec<_> = Truth::ALL.into_iter().flat_map(Curve::empty_of_all).collect();
    for kappa in kappas {
        let pixel = Pixel::of_kappa(kappa);
        // Between the narrowest and the widest of the filters.
        let spread = (1.0 + 6.0 * kappa).powf(0.25);
        let filters = FILTERS.iter().map(|filter| {
            let samples = Samples::of(&filter.density(&pixel)?, spread);
            Ok((filter.alpha(&pixel)?, samples))
        });
        let filters = filters.collect::<Result<Vec<_>, Error>>()?;
        for (truth, curves) in Truth::ALL.iter().zip(curves.chunks_mut(FILTERS.len())) {
            let truth = Samples::of(&truth.density(&pixel)?, spread);
            for (curve, (alpha, samples)) in curves.iter_mut().zip(&filters) {
                curve.alphas.extend(alpha);
                curve.points.push(Measures::of(kappa, samples, &truth));
            }
        }
    }
    Ok(curves)
}

impl Curve {
    fn empty_of_all(truth: Truth) -> impl Iterator<Item = Self> {
        FILTERS.iter().map(move |filter| Self {
            truth,
            filter,
            alphas: Vec::new(),
            points: Vec::new(),
        })
    }

    /// The value of a measure where its distance from right is largest.
    pub(crate) fn worst(&self, value: fn(&Measures) -> f64, distance: fn(f64) -> f64) -> f64 {
        let values = self.points.iter().map(value);
        values.max_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use super::{Curve, FAR, Kernels, Truth, curves};

    fn find<'a>(curves: &'a [Curve], truth: Truth, name: &str) -> &'a Curve {
        curves.iter().find(|c| c.truth == truth && c.filter.name == name).unwrap()
    }

    static ALL: LazyLock<Kernels> = LazyLock::new(|| Kernels::measured().unwrap());

    #[test]
    fn variance_addition_is_too_bright_by_the_known_percentages() {
        let curves = curves([0.1, 1.0, 3.0, 10.0].into_iter()).unwrap();
        let added = find(&curves, Truth::Gaussian, "variance addition, 1/12");
        for (point, percent) in added.points.iter().zip([8.0, 24.0, 22.0, 14.0]) {
            assert!((100.0 * point.peak_error - percent).abs() < 0.5, "{point:?}");
        }
    }

    #[test]
    fn matching_the_peak_beats_variance_addition_there_on_every_pixel() {
        let curves = &ALL.curves;
        for (truth, matched) in
            [(Truth::Box, "Eq. 20, re-derived"), (Truth::Gaussian, "Gaussian peak, exact")]
        {
            let matched = find(curves, truth, matched);
            for name in ["none", "variance addition, 1/12", "variance addition, 1/4"] {
                let other = find(curves, truth, name);
                for (m, o) in matched.points.iter().zip(&other.points) {
                    assert!(m.peak_error.abs() < 1e-9, "{truth:?} {m:?}");
                    assert!(m.peak_error.abs() < o.peak_error.abs(), "{truth:?} {name} {o:?}");
                }
            }
        }
    }

    #[test]
    fn the_last_form_of_eq_20_is_worse_than_its_repair_on_every_pixel() {
        let curves = &ALL.curves;
        for truth in Truth::ALL {
            let printed = find(curves, truth, "Eq. 20, last form");
            let repaired = find(curves, truth, "variance addition, 1/(2 pi)");
            for (p, r) in printed.points.iter().zip(&repaired.points) {
                assert!(p.peak_error.abs() > r.peak_error.abs(), "{truth:?} {p:?} {r:?}");
                assert!(p.l1_error > r.l1_error, "{truth:?} {p:?} {r:?}");
            }
        }
    }

    #[test]
    fn tails_of_widened_lobes_are_too_bright_by_the_ratio_of_their_squared_alphas() {
        for curve in ALL.curves.iter().filter(|c| c.filter.is_closed()) {
            let name = curve.filter.name;
            for (point, alpha) in curve.points.iter().zip(&curve.alphas) {
                // Terms of the next order: (1 + (s/alpha')^-2)^-2, and s^-4 averaged over the
                // pixel.
                let next = 2.0 * (alpha * alpha + 4.0 * point.kappa) / (FAR * FAR);
                let ratio = point.far_ratio / (alpha * alpha);
                assert!((ratio - 1.0).abs() < 2.0 * next + 1e-6, "{name} {point:?}");
            }
            if name != "none" {
                let last = curve.points.last().unwrap();
                assert!(last.kappa > 99.0 && last.tail_ratio > 1.0, "{name} {last:?}");
            }
        }
    }

    #[test]
    fn in_f32_the_exact_square_keeps_its_digits_where_appendix_a_does_not() {
        let curves = &ALL.curves;
        let exact = find(curves, Truth::Box, "exact square, f32");
        let printed = find(curves, Truth::Box, "Appendix A rectangle, f32");
        for point in &exact.points {
            // What the library promises: 1e-5 within ten alphas, 1e-3 anywhere.
            assert!(point.peak_error.abs() < 1.2e-5 && point.largest_error < 1e-3, "{point:?}");
        }
        assert!(printed.points[0].largest_error > 0.1, "{:?}", printed.points[0]);
        assert!(exact.points.iter().all(|point| point.l1_error < Some(1e-5)));
        assert!(printed.points.iter().all(|point| point.l1_error.is_none()));
    }

    #[test]
    fn the_fit_follows_the_exact_peak() {
        let curves = &ALL.curves;
        let fit = find(curves, Truth::Gaussian, "Gaussian peak, fitted");
        for point in &fit.points {
            // 0.04 % of alpha'^2, stated at Roughness::peak_fitted.
            assert!(point.peak_error.abs() < 4.5e-4, "{point:?}");
        }
    }
}
