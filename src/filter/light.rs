//! Area lights as kernels: a spherical Gaussian light widens the lobe by the same algebra as a
//! pixel.
//!
//! Layer 3. The half vector moves as the light's direction does; its spread over the light is one
//! more covariance.

use super::disk::DiskKernel;
use super::kernel::{Kernel, PixelFilter};
use crate::error::{Error, Value};
use crate::scalar::Real;
use crate::slope::direction::{dot, normalize};
use crate::slope::{Footprint, Motion};

/// A light of radiance $e^{\lambda (w \cdot w_i - 1)}$: brightest along its direction, of variance
/// $1/\lambda$ per axis in radians squared.
///
/// Its reflection is close to [`SphericalGaussian::integral`] times the BRDF of the widened lobe
/// for $w_i$ times cosine: exact in slope space for Beckmann but for the curvature of the half
/// vector's map, variance addition for GGX. Good while the light is smaller than the angle to the
/// horizon.
///
/// ```
/// use lobe::{Beckmann, Lobe, Roughness, filter::SphericalGaussian};
/// // The sun: half a degree across.
/// let (wo, wi) = ([0.6_f64, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// let sun = SphericalGaussian::from_angular_radius(wi, 0.00465)?;
/// let lobe = Lobe::centered(Roughness::from_alpha(0.005)?);
/// let lit = lobe.widened(&sun.kernel(wo));
/// let radiance = sun.integral() * Beckmann::new(lit.shape()).brdf(wo, wi) * wi[2];
/// assert!(radiance > 0.0 && radiance < 1.0); // never brighter than the light
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeSphericalGaussian")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalGaussian<R> {
    direction: [R; 3],
    sharpness: R,
}

impl<R: Real> SphericalGaussian<R> {
    /// From the direction of the brightest point (tangent frame, any length) and the sharpness
    /// lambda.
    ///
    /// # Errors
    /// [`Error::Direction`] for a direction without length; [`Error::Sharpness`] unless in
    /// $[10^{-9}, 10^{18}]$.
    #[doc(alias = "lobe_spherical_gaussian_new")]
    pub fn new(direction: impl Into<[R; 3]>, sharpness: R) -> Result<Self, Error> {
        let given = direction.into();
        let direction = normalize(given);
        // `normalize` gives zeros for no length or an infinite one, and keeps NaN.
        if !(dot(direction, direction) > R::HALF) {
            return Err(Error::Direction(given.map(Value::from)));
        }
        let least = R::ONE / R::LARGEST;
        if !(sharpness >= least && sharpness <= R::LARGEST * R::LARGEST) {
            return Err(Error::Sharpness(sharpness.into()));
        }
        Ok(Self { direction, sharpness })
    }

    /// The Gaussian with the variance of a uniform disk of this angular radius: $\lambda = 4/r^2$.
    ///
    /// # Errors
    /// [`Error::Direction`] as [`SphericalGaussian::new`]; [`Error::Radius`] unless the radius lies
    /// in $[2 \cdot 10^{-9}, 6 \cdot 10^4]$ radians.
    #[doc(alias = "lobe_spherical_gaussian_from_angular_radius")]
    pub fn from_angular_radius(direction: impl Into<[R; 3]>, radius: R) -> Result<Self, Error> {
        // A radius of either sign has one square.
        let sharpness = if radius > R::ZERO { R::lit(4.0) / radius / radius } else { R::ZERO };
        Self::new(direction, sharpness).map_err(|error| match error {
            Error::Sharpness(_) => Error::Radius(radius.into()),
            other => other,
        })
    }

    /// [`SphericalGaussian::new`] of a direction that it has returned: taken as it is, as another
    /// normalization could change its last bit.
    #[cfg(feature = "serde")]
    pub(crate) fn restored(direction: [R; 3], sharpness: R) -> Result<Self, Error> {
        let made = Self::new(direction, sharpness)?;
        let is_unit = (dot(direction, direction) - R::ONE).abs() <= R::lit(4.0) * R::EPSILON;
        Ok(if is_unit { Self { direction, ..made } } else { made })
    }

    /// The unit direction of the brightest point.
    pub const fn direction(&self) -> [R; 3] {
        self.direction
    }

    /// The sharpness lambda.
    pub const fn sharpness(&self) -> R {
        self.sharpness
    }

    /// Integral of the radiance over the sphere, $\frac{2\pi}{\lambda} (1 - e^{-2\lambda})$.
    ///
    /// ```
    /// use lobe::filter::SphericalGaussian;
    /// // A light of no sharpness is the whole sphere.
    /// let sky = SphericalGaussian::new([0.0_f64, 0.0, 1.0], 1e-9)?;
    /// assert!((sky.integral() / (4.0 * core::f64::consts::PI) - 1.0).abs() < 1e-8);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_spherical_gaussian_integral")]
    pub fn integral(&self) -> R {
        let x = R::TWO * self.sharpness;
        // (1 - e^-x)/x by its series where the difference cancels; the next term is x^3/24.
        let part = if x < R::lit(0.001) {
            R::ONE - x * (R::HALF - x / R::lit(6.0))
        } else {
            (R::ONE - (-x).exp()) / x
        };
        R::lit(4.0) * R::PI * part
    }

    /// The kernel on the slope plane for a viewer along `wo`: $\Sigma = \frac{1}{\lambda} J J^T$, J
    /// the derivative of the half vector's slope by the light's direction.
    ///
    /// Zero where the half vector is not above the surface. Add the pixel's to it: kernels
    /// have `+`.
    ///
    /// Source: Tokuyoshi et al. 2024, here in slope space.
    #[doc(alias = "lobe_spherical_gaussian_kernel")]
    #[inline]
    pub fn kernel(&self, wo: impl Into<[R; 3]>) -> Kernel<R> {
        Kernel::of(&self.footprint(wo), self.spread())
    }

    /// The same on the projected disk, for
    /// [`Roughness::widened_on_disk`](crate::Roughness::widened_on_disk).
    ///
    /// Source: Tokuyoshi et al. 2024, $K = \frac{2}{\lambda} J J^T$. The published code takes the
    /// determinant of the sum with the kernel's diagonal swapped, which is right for equal alphas
    /// only; sums here are matrices.
    ///
    /// ```
    /// use lobe::{Roughness, filter::SphericalGaussian};
    /// let up = [0.0_f64, 0.0, 1.0];
    /// let lamp = SphericalGaussian::new(up, 100.0)?;
    /// // Straight above, the half vector turns by half the light's angle: variance 1/400.
    /// let kernel = lamp.disk_kernel(up);
    /// assert!((kernel.covariance().entries()[0] - 0.0025).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_spherical_gaussian_disk_kernel")]
    #[inline]
    pub fn disk_kernel(&self, wo: impl Into<[R; 3]>) -> DiskKernel<R> {
        let g = self.sum(wo.into());
        let squared = dot(g, g);
        let inverse = R::ONE / squared.max(R::MIN_POSITIVE).sqrt();
        let h = g.map(|x| x * inverse);
        let [u, v] = self.tangents().map(|t| {
            let along = dot(h, t);
            [(t[0] - h[0] * along) * inverse, (t[1] - h[1] * along) * inverse]
        });
        if g[2] > R::ZERO { DiskKernel::of(u, v, self.spread()) } else { DiskKernel::default() }
    }

    /// How the half vector's slope changes per radian of the light's direction: for
    /// [`Ndf::brdf_over`](crate::Ndf::brdf_over), scaled to the size of a light.
    #[doc(alias = "lobe_spherical_gaussian_footprint")]
    #[inline]
    pub fn footprint(&self, wo: impl Into<[R; 3]>) -> Footprint<R> {
        let [u, v] = self.tangents().map(|half_vector| Motion { half_vector, ..Motion::default() });
        Footprint::from_motion(self.sum(wo.into()), &u, &v).unwrap_or_default()
    }

    #[inline]
    fn sum(&self, wo: [R; 3]) -> [R; 3] {
        [0, 1, 2].map(|k| wo[k] + self.direction[k])
    }

    /// The variance of the light, in squared radians, in the place of a pixel filter's.
    #[inline]
    fn spread(&self) -> PixelFilter {
        // The least sharpness, rounded to f32, may have a variance just beyond the largest.
        let variance = (1.0 / self.sharpness.to_f64()).min(1e9);
        PixelFilter::with_variance(variance).unwrap_or(PixelFilter::BOX)
    }

    /// Two unit vectors across the light's direction and each other.
    ///
    /// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
    #[inline]
    fn tangents(&self) -> [[R; 3]; 2] {
        let [x, y, z] = self.direction;
        let sign = if z >= R::ZERO { R::ONE } else { -R::ONE };
        let a = -R::ONE / (sign + z);
        let b = x * y * a;
        [[R::ONE + sign * x * x * a, sign * b, -(sign * x)], [b, sign + y * y * a, -y]]
    }
}
