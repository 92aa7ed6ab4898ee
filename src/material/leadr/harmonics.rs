//! Irradiance of any environment in nine numbers a channel.
//!
//! Layer 4. A cosine over the hemisphere is smooth: spherical harmonics up to the second order hold
//! it to 1 % of its energy. A single light is what they show worst: off by up to 9.4 % of its peak,
//! where a facet is edge-on to it.

use super::environment::Light;
use crate::scalar::Real;
use crate::slope::direction::normalize;

/// Second-order spherical harmonics of the light around a point, and the irradiance on facets.
///
/// Sources: Ramamoorthi & Hanrahan 2001, Eq. 3, 7 to 9; Dupuy et al. 2013, Algorithm 2 (whose L00
/// adds itself twice).
///
/// ```
/// use lobe::material::leadr::Irradiance;
/// // Light 1 from everywhere: pi on any facet.
/// let mut even = Irradiance::<f64>::dark();
/// even.add_light(&|_: [f64; 3], _: f64| [1.0; 3], 64);
/// assert!((even.at([0.0, 0.6, 0.8])[0] - core::f64::consts::PI).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Irradiance<R> {
    coefficients: [[R; 3]; 9],
}

/// The harmonics at a unit direction: 1; y, z, x; xy, yz, 3z^2 - 1, xz, x^2 - y^2, with their
/// constants.
fn harmonics<R: Real>([x, y, z]: [R; 3]) -> [R; 9] {
    // sqrt(1/4 pi), sqrt(3/4 pi), sqrt(15/4 pi), sqrt(5/16 pi), sqrt(15/16 pi).
    let [zeroth, first, second, polar, sectoral] = [
        0.282_094_791_773_878_14,
        0.488_602_511_902_919_9,
        1.092_548_430_592_079_2,
        0.315_391_565_252_520_05,
        0.546_274_215_296_039_6,
    ]
    .map(R::lit);
    let three = R::lit(3.0);
    [
        zeroth,
        first * y,
        first * z,
        first * x,
        second * x * y,
        second * y * z,
        polar * (three * z * z - R::ONE),
        second * x * z,
        sectoral * (x * x - y * y),
    ]
}

impl<R: Real> Irradiance<R> {
    /// No light.
    pub const fn dark() -> Self {
        Self { coefficients: [[R::ZERO; 3]; 9] }
    }

    /// Adds a distant light: the direction to it (any length), its radiance times solid angle.
    ///
    /// ```
    /// use lobe::material::leadr::Irradiance;
    /// let mut sun = Irradiance::<f64>::dark();
    /// sun.add_directional([0.0, 0.0, 2.0], [1.0; 3]);
    /// let facing = sun.at([0.0, 0.0, 1.0])[0];
    /// assert!((facing - 1.0625).abs() < 1e-6); // of 1: the second order's own error
    /// ```
    pub fn add_directional(&mut self, direction: impl Into<[R; 3]>, irradiance: [R; 3]) {
        let at = harmonics(normalize(direction));
        for (sum, y) in self.coefficients.iter_mut().zip(at) {
            *sum = [0, 1, 2].map(|k: usize| sum[k] + y * irradiance[k]);
        }
    }

    /// Adds light from everywhere: `rows` x 2 `rows` directions of equal solid angle; none of 0
    /// rows.
    ///
    /// Under even light 8 rows are within 1 %, 64 within 0.02 %.
    pub fn add_light(&mut self, light: &impl Light<R>, rows: usize) {
        let columns = 2 * rows;
        let solid_angle = 4.0 * core::f64::consts::PI / (rows * columns).max(1) as f64;
        let solid_angle = R::lit(solid_angle);
        for row in 0..rows {
            let z = R::lit((2 * row + 1) as f64 / rows as f64 - 1.0);
            let radius = ((R::ONE - z) * (R::ONE + z)).sqrt();
            for column in 0..columns {
                let turn = (2 * column + 1) as f64 / columns as f64;
                let (sin, cos) = R::lit(turn * core::f64::consts::PI).sin_cos();
                let wi = [radius * cos, radius * sin, z];
                let radiance = light.radiance(wi, solid_angle);
                self.add_directional(wi, radiance.map(|l| l * solid_angle));
            }
        }
    }

    /// Irradiance on a facet of a unit normal; not below 0.
    ///
    /// $E(m) = \pi L_{00} Y_{00} + \frac{2\pi}{3} \sum L_{1m} Y_{1m} + \frac{\pi}{4} \sum L_{2m}
    /// Y_{2m}$.
    pub fn at(&self, normal: impl Into<[R; 3]>) -> [R; 3] {
        let at = harmonics(normal.into());
        let pi = core::f64::consts::PI;
        let cosine = [pi, 2.0 * pi / 3.0, 0.25 * pi].map(R::lit);
        let mut sum = [R::ZERO; 3];
        for (place, (coefficient, y)) in self.coefficients.iter().zip(at).enumerate() {
            let order = usize::from(place > 0) + usize::from(place > 3);
            sum = [0, 1, 2].map(|k: usize| sum[k] + cosine[order] * y * coefficient[k]);
        }
        sum.map(|e| e.max(R::ZERO))
    }
}
