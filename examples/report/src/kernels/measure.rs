//! Numbers that say how wrong a density is, against another.

use serde::Serialize;

use super::density::{DIRECTIONS, Density};

/// How wrong one filter is on one pixel.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Measures {
    /// $2 \sigma^2 / \alpha^2$ of the pixel.
    pub(crate) kappa: f64,
    /// Filter over truth at the center, minus 1.
    pub(crate) peak_error: f64,
    /// Integral of |filter - truth| over the plane, at most 2; none where the filter's error does
    /// not fall with distance.
    pub(crate) l1_error: Option<f64>,
    /// Largest |filter / truth - 1| within [`REACH`] alphas.
    pub(crate) largest_error: f64,
    /// Filter over truth at [`REACH`] alphas; of two directions the one farther from 1.
    pub(crate) tail_ratio: f64,
    /// The same at [`FAR`] alphas, where only tails are left.
    pub(crate) far_ratio: f64,
}

/// How far from the lobe's center densities are compared, in alphas.
pub(crate) const REACH: f64 = 20.0;

/// Far beyond any pixel, in alphas.
pub(crate) const FAR: f64 = 1000.0;

/// Slopes compared per alpha.
const PER_ALPHA: f64 = 8.0;

/// Circles of the integral over the plane.
const RINGS: usize = 1024;

/// Values of a density where it is compared.
pub(super) struct Samples {
    /// From the center to [`REACH`], along the axis and along the diagonal.
    rays: [Vec<f64>; 2],
    /// At [`FAR`], in the same directions.
    far: [f64; 2],
    /// On circles over the whole plane.
    rings: Vec<[f64; DIRECTIONS]>,
    /// c of [`circles`].
    spread2: f64,
    /// Whether the plane has an integral of it.
    decays: bool,
}

/// The slope at a distance along the axis and along the diagonal, exact in f32.
fn directions(distance: f64) -> [[f64; 2]; 2] {
    let diagonal = f64::from((distance * std::f64::consts::FRAC_1_SQRT_2) as f32);
    [[distance, 0.0], [diagonal, diagonal]]
}

/// Radius and area per unit of u of circles $r^2 = c\, u/(1 - u)$ at equal steps of u.
///
/// u is the mass of GGX of alpha $\sqrt c$ within r: for lobes of about that width the integrand is
/// nearly flat, its tail to infinity included.
fn circles(c: f64) -> impl Iterator<Item = (f64, f64)> {
    let parameters = (0..RINGS).map(|k| (k as f64 + 0.5) / RINGS as f64);
    parameters.map(move |u| {
        let rest = 1.0 - u;
        ((c * u / rest).sqrt(), std::f64::consts::PI * c / (rest * rest))
    })
}

impl Samples {
    /// Of a density about as wide as `spread` alphas.
    pub(super) fn of(density: &Density, spread: f64) -> Self {
        let count = (REACH * PER_ALPHA) as i32;
        let ray = |direction: usize| {
            let slopes = (0..=count).map(|k| directions(f64::from(k) / PER_ALPHA)[direction]);
            slopes.map(|slope| density.at(slope)).collect()
        };
        let spread2 = spread * spread;
        Self {
            rays: [ray(0), ray(1)],
            far: directions(FAR).map(|slope| density.at(slope)),
            rings: circles(spread2).map(|(radius, _)| density.ring(radius)).collect(),
            spread2,
            decays: density.decays(),
        }
    }

    /// Integral over the plane of a function of two densities sampled with one spread, if both
    /// decay.
    fn integral(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Option<f64> {
        let rings = self.rings.iter().zip(&other.rings).zip(circles(self.spread2));
        let sum = rings.map(|((a, b), (_, area))| {
            area * a.iter().zip(b).map(|(&a, &b)| of(a, b)).sum::<f64>()
        });
        let mean = sum.sum::<f64>() / (RINGS * DIRECTIONS) as f64;
        (self.decays && other.decays).then_some(mean)
    }
}

impl Measures {
    /// Of a filter against the truth, both sampled with one spread.
    pub(super) fn of(kappa: f64, filter: &Samples, truth: &Samples) -> Self {
        let ratios = |k: usize| filter.rays[k].iter().zip(&truth.rays[k]).map(|(f, t)| f / t);
        let farther = |a: f64, b: f64| if b.ln().abs() > a.ln().abs() { b } else { a };
        let last = |k: usize| ratios(k).next_back().unwrap_or(f64::NAN);
        let far = |k: usize| filter.far[k] / truth.far[k];
        Self {
            kappa,
            peak_error: ratios(0).next().unwrap_or(f64::NAN) - 1.0,
            l1_error: filter.integral(truth, |f, t| (f - t).abs()),
            largest_error: ratios(0).chain(ratios(1)).map(|r| (r - 1.0).abs()).fold(0.0, f64::max),
            tail_ratio: farther(last(0), last(1)),
            far_ratio: farther(far(0), far(1)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Measures, Samples};
    use crate::kernels::density::Density;
    use crate::kernels::pixel::{Pixel, Truth};

    /// GGX of alpha a against b.
    fn between(a: f64, b: f64) -> Measures {
        let samples = |alpha| Samples::of(&Density::widened(alpha).unwrap(), 1.5);
        Measures::of(0.0, &samples(a), &samples(b))
    }

    #[test]
    fn a_density_is_not_wrong_against_itself() {
        let pixel = Pixel::of_kappa(1.0);
        for truth in Truth::ALL {
            let samples = Samples::of(&truth.density(&pixel).unwrap(), 1.0);
            let m = Measures::of(1.0, &samples, &samples);
            assert_eq!([m.peak_error, m.largest_error], [0.0; 2]);
            assert_eq!(m.l1_error, Some(0.0));
            assert_eq!([m.tail_ratio, m.far_ratio], [1.0; 2]);
        }
    }

    #[test]
    fn two_ggx_differ_as_their_masses_say() {
        // They cross at r^2 = a b, where the masses within are b/(a+b) and a/(a+b).
        for (a, b) in [(1.0_f64, 2.0_f64), (2.0, 1.0), (0.5, 4.0)] {
            let l1 = 2.0 * (a - b).abs() / (a + b);
            assert!((between(a, b).l1_error.unwrap() - l1).abs() < 1e-4, "{a} {b}");
        }
    }

    #[test]
    fn two_ggx_differ_as_an_integral_over_squares_says() {
        // Simpson's rule in both slopes of one quadrant up to 40, the mass beyond by the tails'
        // difference.
        let density = |alpha: f64, q: f64| {
            let a2 = alpha * alpha;
            a2 / (std::f64::consts::PI * (a2 + q) * (a2 + q))
        };
        let (half, count) = (40.0_f64, 1600_u32);
        let step = half / f64::from(count);
        let weight = |k: u32| match k {
            0 => 1.0,
            k if k == count => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let mut inside = 0.0;
        for j in 0..=count {
            for k in 0..=count {
                let (x, y) = (f64::from(j) * step, f64::from(k) * step);
                let q = x * x + y * y;
                inside += weight(j) * weight(k) * (density(1.0, q) - density(2.0, q)).abs();
            }
        }
        inside *= 4.0 * step * step / 9.0;
        // Beyond the square the densities are a^2/(pi r^4): 1/(pi r^4) integrates to (1/2 +
        // 1/pi)/half^2 outside.
        let outside = (4.0 - 1.0) * (0.5 + std::f64::consts::FRAC_1_PI) / (half * half);
        let l1 = between(1.0, 2.0).l1_error.unwrap();
        assert!((l1 - inside - outside).abs() < 1e-4, "{l1} {inside} {outside}");
    }

    #[test]
    fn truths_have_mass_one() {
        for truth in Truth::ALL {
            for kappa in [0.01_f64, 1.0, 100.0] {
                let spread = (1.0 + 6.0 * kappa).powf(0.25);
                let samples = Samples::of(&truth.density(&Pixel::of_kappa(kappa)).unwrap(), spread);
                let mass = samples.integral(&samples, |_, t| t).unwrap();
                assert!((mass - 1.0).abs() < 1e-4, "{truth:?} {kappa}: {mass}");
            }
        }
    }
    #[test]
    fn the_rounding_error_of_appendix_a_does_not_fall_with_distance() {
        let pixel = Pixel::of_kappa(0.01);
        let (single, exact) =
            (Density::AppendixA(pixel.width as f32), Density::square(&pixel).unwrap());
        let error = |radius: f64| {
            let rings = single.ring(radius).into_iter().zip(exact.ring(radius));
            rings.map(|(f, t)| (f - t).abs()).sum::<f64>()
        };
        // Ten thousand times farther out it would be 1e-16 times as large, if it fell like the
        // density.
        assert!(error(1e5) > 0.1 * error(10.0) && !single.decays());
    }
}
