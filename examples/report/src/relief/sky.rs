//! What the sphere reflects: a sky and lamps around the world, as they are and as a solid angle of
//! them.

use std::f64::consts::TAU;

use crate::scalar::Scalar;
use crate::vector::{Vector, cast, dot};

/// A sky that changes with height, and lamps.
#[derive(Clone, Debug)]
pub(super) struct Sky<R> {
    /// Coefficients of the Legendre polynomials of degree 0, 1 and 2 in height.
    gradient: [R; 3],
    lamps: Vec<Lamp<R>>,
}

/// A spherical Gaussian of unit vector `direction`: $b e^{\lambda (w \cdot d - 1)}$.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lamp<R> {
    pub(super) direction: Vector<R>,
    pub(super) sharpness: R,
    brightness: R,
    /// Radiance integrated over all directions: irradiance of a surface that faces it, if it is
    /// small.
    pub(super) irradiance: R,
}

/// Unit directions as whole numbers over 9: at the left in front, at the right, above and behind.
/// The viewer looks along +y, up is +z.
const LAMPS: [([f64; 3], f64, f64); 3] =
    [([-4.0, -7.0, 4.0], 100.0, 15.0), ([8.0, -4.0, 1.0], 40.0, 6.0), ([1.0, 4.0, 8.0], 12.0, 2.0)];

impl Sky<f64> {
    /// Sky and lamps.
    pub(super) fn whole() -> Self {
        let lamps = LAMPS.map(|(direction, sharpness, brightness)| Lamp {
            direction: direction.map(|x| x / 9.0),
            sharpness,
            brightness,
            irradiance: brightness * integral(sharpness),
        });
        Self { gradient: [0.3, 0.2, 0.1], lamps: lamps.into() }
    }

    /// The narrowest lamp alone.
    pub(super) fn lamp() -> Self {
        let whole = Self::whole();
        Self { gradient: [0.0; 3], lamps: whole.lamps[..1].into() }
    }

    pub(super) fn cast<R: Scalar>(&self) -> Sky<R> {
        let lamps = self.lamps.iter().map(|lamp| Lamp {
            direction: cast(lamp.direction),
            sharpness: R::lit(lamp.sharpness),
            brightness: R::lit(lamp.brightness),
            irradiance: R::lit(lamp.irradiance),
        });
        Sky { gradient: self.gradient.map(R::lit), lamps: lamps.collect() }
    }
}

impl<R: Scalar> Sky<R> {
    pub(super) fn lamps(&self) -> &[Lamp<R>] {
        &self.lamps
    }

    /// Radiance from a unit direction.
    #[inline]
    pub(super) fn radiance(&self, w: Vector<R>) -> R {
        let lamps = self.lamps.iter().map(|lamp| lamp.radiance(w));
        lamps.fold(self.gradient(w[2], [R::ONE; 2]), |sum, x| sum + x)
    }

    /// Mean radiance of about this solid angle around a unit direction.
    ///
    /// A square of solid angle $\Omega$ has variance $v = \Omega/12$ along each axis. Blurred by a
    /// Gaussian of that, harmonics of degree l fade by $e^{-l(l+1)v/2}$, and a lamp of variance
    /// $1/\lambda$ has $1/\lambda + v$ and sends as much light as before.
    #[inline]
    pub(super) fn blurred(&self, w: Vector<R>, solid_angle: R) -> R {
        let variance = solid_angle * R::lit(1.0 / 12.0);
        let fade = (-variance).exp();
        let sky = self.gradient(w[2], [fade, fade * fade * fade]);
        self.lamps.iter().fold(sky, |sum, lamp| sum + lamp.blurred(variance).radiance(w))
    }

    #[inline]
    fn gradient(&self, z: R, fade: [R; 2]) -> R {
        let second = R::lit(1.5) * z * z - R::HALF;
        self.gradient[0] + self.gradient[1] * fade[0] * z + self.gradient[2] * fade[1] * second
    }
}

impl<R: Scalar> Lamp<R> {
    #[inline]
    pub(super) fn radiance(&self, w: Vector<R>) -> R {
        self.brightness * (self.sharpness * (dot(self.direction, w) - R::ONE)).exp()
    }

    #[inline]
    fn blurred(&self, variance: R) -> Self {
        let sharpness = self.sharpness / (R::ONE + self.sharpness * variance);
        Self { sharpness, brightness: self.irradiance / integral(sharpness), ..*self }
    }
}

/// Of $e^{\lambda (w \cdot d - 1)}$ over all directions.
#[inline]
fn integral<R: Scalar>(sharpness: R) -> R {
    R::lit(TAU) * (R::ONE - (-R::TWO * sharpness).exp()) / sharpness
}

#[cfg(test)]
mod tests {
    use super::Sky;
    use crate::vector::dot;

    /// Mean over the sphere of a function: midpoints in height and angle.
    fn mean(of: impl Fn([f64; 3]) -> f64) -> f64 {
        let (rings, spokes) = (600, 400);
        let mut sum = 0.0;
        for ring in 0..rings {
            let z = (2.0 * f64::from(ring) + 1.0) / f64::from(rings) - 1.0;
            for spoke in 0..spokes {
                let (y, x) =
                    (std::f64::consts::TAU * f64::from(spoke) / f64::from(spokes)).sin_cos();
                let r = (1.0 - z * z).sqrt();
                sum += of([r * x, r * y, z]);
            }
        }
        sum / f64::from(rings * spokes)
    }

    #[test]
    fn blur_moves_light_and_keeps_it() {
        let sky = Sky::whole();
        for lamp in sky.lamps() {
            assert!((dot(lamp.direction, lamp.direction) - 1.0).abs() < 1e-15);
        }
        let whole = mean(|w| sky.radiance(w));
        for solid_angle in [0.0, 0.01, 0.3, 4.0] {
            assert!((mean(|w| sky.blurred(w, solid_angle)) / whole - 1.0).abs() < 1e-3);
        }
        let lamp = Sky::lamp();
        let irradiance = 4.0 * std::f64::consts::PI * mean(|w| lamp.radiance(w));
        assert!((irradiance / lamp.lamps()[0].irradiance - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_blurred_lamp_is_the_mean_of_a_square() {
        let sky = Sky::lamp();
        let d = sky.lamps()[0].direction;
        // A square of half width h in the plane across, small enough to be flat: its center sees
        // the mean over it.
        let across = lobe::slope::direction::normalize([d[1], -d[0], 0.0]);
        let along = crate::vector::cross(d, across);
        let h = 0.05;
        let mut sum = 0.0;
        for i in -20..20 {
            for j in -20..20 {
                let [a, b] = [i, j].map(|k| h * (f64::from(k) + 0.5) / 20.0);
                let w = [0, 1, 2].map(|k| d[k] + a * across[k] + b * along[k]);
                sum += sky.radiance(lobe::slope::direction::normalize(w));
            }
        }
        // Fourth moments of square and Gaussian differ: (h^2 lambda)^2 / 36 of it or less.
        let ratio = sky.blurred(d, 4.0 * h * h) / (sum / 1600.0);
        assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    }
}
