//! Symmetric positive semi-definite 2x2 matrices that carry the root of their determinant.
//!
//! Layer 0. A covariance near rank one loses its determinant in its entries: alpha = 1e-4 under a
//! kernel of size 1 leaves nothing of the minor axis in f32. Every operation here that knows the
//! determinant better than the rounded entries do (axes, outer products, sums) carries it along.

use super::Real;
use super::exact::{cross, difference_of_products, sum_of_products};
use crate::error::{Error, Value};
use core::ops::{Add, AddAssign, Mul};

/// A symmetric positive semi-definite matrix `[[xx, xy], [xy, yy]]`: a roughness or a covariance.
///
/// ```
/// use lobe::Psd;
/// let a = Psd::new(2.0_f64, 1.0, 2.0)?;
/// assert!((a.det() - 3.0).abs() < 1e-12);
/// let eigen = a.eigen();
/// assert!((eigen.major - 3.0).abs() < 1e-12 && (eigen.minor - 1.0).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobePsd")]
#[doc(alias = "lobe_psd_mul")]
#[doc(alias = "lobe_psd_add")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Psd<R> {
    xx: R,
    xy: R,
    yy: R,
    root_det: R,
}

/// Eigenvalues and major axis of a [`Psd`].
#[doc(alias = "LobeEigen")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Eigen<R> {
    /// The larger eigenvalue.
    pub major: R,
    /// The smaller eigenvalue, without cancellation: determinant over `major`.
    pub minor: R,
    /// Unit vector of the major axis; `[1, 0]` for a multiple of the identity.
    pub axis: [R; 2],
}

impl<R: Real> Psd<R> {
    /// The matrix with these entries.
    ///
    /// A determinant that is negative by no more than the rounding of the entries
    /// ($2 \epsilon\, xx\, yy$, or underflow) counts as zero: the outer product of a rounded vector
    /// passes.
    ///
    /// # Errors
    /// [`Error::MatrixEntry`] unless all entries lie in $[-10^{18}, 10^{18}]$,
    /// [`Error::MatrixNotPositive`].
    #[doc(alias = "lobe_psd_new")]
    pub fn new(xx: R, xy: R, yy: R) -> Result<Self, Error> {
        let largest = R::LARGEST * R::LARGEST;
        if let Some(&beyond) = [xx, xy, yy].iter().find(|entry| !(entry.abs() <= largest)) {
            return Err(Error::MatrixEntry(beyond.into()));
        }
        let det = difference_of_products(xx, yy, xy, xy);
        let rounding = R::TWO * R::EPSILON * (xx * yy).abs() + R::MIN_POSITIVE;
        if xx < R::ZERO || yy < R::ZERO || det < -rounding {
            return Err(Error::MatrixNotPositive([xx, xy, yy].map(Value::from)));
        }
        Ok(Self::from_entries(xx, xy, yy))
    }

    /// The matrix with these entries, trusted to be positive semi-definite up to rounding.
    pub(crate) fn from_entries(xx: R, xy: R, yy: R) -> Self {
        let det = difference_of_products(xx, yy, xy, xy);
        Self { xx, xy, yy, root_det: det.max(R::ZERO).sqrt() }
    }

    /// The matrix with these entries, `xx`, `xy`, `yy`, whose determinant is known better than they
    /// tell it.
    #[inline(always)]
    pub(crate) const fn with_root_det([xx, xy, yy]: [R; 3], root_det: R) -> Self {
        Self { xx, xy, yy, root_det }
    }

    /// The nearest positive semi-definite matrix: negative eigenvalues become 0.
    ///
    /// For covariances that storage has rounded; [`Psd::new`] refuses what this mends. Entries up
    /// to $10^{18}$; NaN gives the zero matrix.
    ///
    /// ```
    /// let mended = lobe::Psd::nearest(1.0_f64, 2.0, 1.0); // eigenvalues 3 and -1
    /// assert!(mended.entries().iter().all(|x| (x - 1.5).abs() < 1e-15));
    /// ```
    #[doc(alias = "lobe_psd_nearest")]
    pub fn nearest(xx: R, xy: R, yy: R) -> Self {
        let det = difference_of_products(xx, yy, xy, xy);
        if xx >= R::ZERO && yy >= R::ZERO && det >= R::ZERO {
            return Self::from_entries(xx, xy, yy);
        }
        let (major, [x, y]) = principal(xx, xy, yy);
        let length = major.max(R::ZERO).sqrt();
        Self::outer_sum([length * x, length * y], [R::ZERO; 2])
    }

    /// The zero matrix.
    pub const fn zero() -> Self {
        Self { xx: R::ZERO, xy: R::ZERO, yy: R::ZERO, root_det: R::ZERO }
    }

    /// `diag(x^2, y^2)` turned by an angle given as cosine and sine: the square of a scaling
    /// along axes.
    pub(crate) fn from_axes(x: R, y: R, cos: R, sin: R) -> Self {
        let (xx, yy) = (x * x, y * y);
        Self {
            xx: xx * cos * cos + yy * sin * sin,
            xy: (x - y) * (x + y) * cos * sin,
            yy: xx * sin * sin + yy * cos * cos,
            root_det: x * y,
        }
    }

    /// Standard deviations and correlation: `[[x^2, rho x y], [rho x y, y^2]]`.
    pub(crate) fn from_deviations(x: R, y: R, rho: R) -> Self {
        let complement = ((R::ONE - rho) * (R::ONE + rho)).sqrt();
        Self { xx: x * x, xy: rho * x * y, yy: y * y, root_det: x * y * complement }
    }

    /// $u u^T + v v^T$, whose determinant is the square of the cross product. Components up to
    /// $10^9$.
    ///
    /// ```
    /// use lobe::Psd;
    /// let k = Psd::outer_sum([1.0_f32, 1.0], [1.0, 1.0 + 1e-3]);
    /// assert!((k.root_det() - 1e-3).abs() < 1e-6);
    /// ```
    #[doc(alias = "lobe_psd_outer_sum")]
    #[inline]
    pub fn outer_sum(u: [R; 2], v: [R; 2]) -> Self {
        Self {
            xx: u[0] * u[0] + v[0] * v[0],
            xy: sum_of_products(u[0], u[1], v[0], v[1]),
            yy: u[1] * u[1] + v[1] * v[1],
            root_det: cross(u, v).abs(),
        }
    }

    /// The entries `xx`, `xy`, `yy`.
    #[inline]
    pub const fn entries(&self) -> [R; 3] {
        [self.xx, self.xy, self.yy]
    }

    /// Determinant.
    #[doc(alias = "lobe_psd_det")]
    #[inline]
    pub fn det(&self) -> R {
        self.root_det * self.root_det
    }

    /// Square root of the determinant: the area scale of the ellipse.
    #[inline(always)]
    pub const fn root_det(&self) -> R {
        self.root_det
    }

    /// Trace.
    #[doc(alias = "lobe_psd_trace")]
    pub fn trace(&self) -> R {
        self.xx + self.yy
    }

    /// True if the smaller eigenvalue is no number of this precision: a mirror along some axis.
    #[doc(alias = "lobe_psd_is_singular")]
    #[inline(always)]
    pub fn is_singular(&self) -> bool {
        let minor = self.root_det * (self.root_det / self.trace().max(R::MIN_POSITIVE)).kept();
        let least = minor.min(self.xx).min(self.yy);
        !(least >= R::MIN_POSITIVE)
    }

    /// $\mathrm{tr}(\mathrm{adj}(A)\, B)$ as a sum of squares: with `u = a_xx b_xy - a_xy b_xx`,
    /// $(u^2 + \det A\, b_{xx}^2 + \det B\, a_{xx}^2) / (a_{xx} b_{xx})$.
    #[inline]
    pub(crate) fn mixed_det(&self, other: &Self) -> R {
        let u = difference_of_products(self.xx, other.xy, self.xy, other.xx);
        // Below this the entries and their products have no digits to divide by: the square of a
        // right angle's cosine, 6e-17, already is at the end of f32.
        let least = R::MIN_POSITIVE / (R::EPSILON * R::EPSILON);
        let (inverse, inverse_other) = (R::ONE / self.xx.max(least), R::ONE / other.xx.max(least));
        // Quotients first: squares of the smallest entries underflow in f32.
        let quotient = |inverse: R| (u * inverse).abs().min(R::MAX);
        let squares = quotient(inverse) * quotient(inverse_other)
            + other.xx * (self.root_det * (self.root_det * inverse).kept()).kept()
            + self.xx * (other.root_det * (other.root_det * inverse_other).kept()).kept();
        // One of the two is a line along y, or nothing: its xy is 0, or nearly, and no term
        // cancels.
        let products = self.xx * other.yy + self.yy * other.xx - R::TWO * self.xy * other.xy;
        if self.xx.min(other.xx) < least { products.max(R::ZERO) } else { squares }
    }

    /// $w^T M w$, as a sum of squares: exact to a few ulp even along the minor axis.
    #[doc(alias = "lobe_psd_quadratic")]
    pub fn quadratic(&self, w: [R; 2]) -> R {
        if self.xx < R::MIN_POSITIVE {
            return self.yy * w[1] * w[1];
        }
        let u = sum_of_products(self.xx, w[0], self.xy, w[1]);
        let along_y = self.root_det * w[1];
        (u * u + along_y * along_y) / self.xx
    }

    /// Columns `[l11, l21]` and `[0, l22]` of the factor with $L L^T = M$, as `[l11, l21, l22]`.
    ///
    /// ```
    /// use lobe::Psd;
    /// assert_eq!(Psd::new(4.0, 2.0, 2.0)?.cholesky(), [2.0_f64, 1.0, 1.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_psd_cholesky")]
    pub fn cholesky(&self) -> [R; 3] {
        if self.xx < R::MIN_POSITIVE {
            return [R::ZERO, R::ZERO, self.yy.sqrt()];
        }
        let l11 = self.xx.sqrt();
        [l11, self.xy / l11, self.root_det / l11]
    }

    /// Eigenvalues and major axis.
    #[doc(alias = "lobe_psd_eigen")]
    pub fn eigen(&self) -> Eigen<R> {
        let (major, axis) = principal(self.xx, self.xy, self.yy);
        let minor = self.root_det * (self.root_det / major.max(R::MIN_POSITIVE)).kept();
        let minor = minor.min(major);
        Eigen { major, minor, axis }
    }

    /// The matrix with both eigenvalues limited to `limit`; the axes stay. A negative limit counts
    /// as 0.
    #[doc(alias = "lobe_psd_capped")]
    #[must_use]
    pub fn capped(&self, limit: R) -> Self {
        let limit = limit.max(R::ZERO);
        let Eigen { major, minor, axis: [cos, sin] } = self.eigen();
        if major <= limit {
            return *self;
        }
        Self::from_axes(limit.sqrt(), minor.min(limit).sqrt(), cos, sin)
    }
}

impl<R: Real> Mul<R> for Psd<R> {
    type Output = Self;

    /// The matrix times a finite factor; a negative one and NaN count as 0.
    #[inline]
    fn mul(self, factor: R) -> Self {
        let factor = factor.max(R::ZERO);
        Self {
            xx: self.xx * factor,
            xy: self.xy * factor,
            yy: self.yy * factor,
            root_det: self.root_det * factor,
        }
    }
}

impl<R: Real> Add for Psd<R> {
    type Output = Self;

    /// The sum of two matrices.
    ///
    /// $\det(A + B) = \det A + \mathrm{tr}(\mathrm{adj}(A)\, B) + \det B$, every term non-negative:
    /// nothing cancels when a small round lobe meets a long thin kernel.
    #[inline]
    fn add(self, other: Self) -> Self {
        let det = self.det() + self.mixed_det(&other) + other.det();
        Self {
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            yy: self.yy + other.yy,
            root_det: det.sqrt(),
        }
    }
}

impl<R: Real> AddAssign for Psd<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// The larger eigenvalue of a symmetric matrix and its unit vector.
fn principal<R: Real>(xx: R, xy: R, yy: R) -> (R, [R; 2]) {
    let half_difference = R::HALF * (xx - yy);
    let scale = half_difference.abs().max(xy.abs());
    if scale < R::MIN_POSITIVE {
        return (xx, [R::ONE, R::ZERO]);
    }
    let (h, k) = ((half_difference / scale).kept(), (xy / scale).kept());
    let r = (h * h + k * k).sqrt();
    // The larger of the two equivalent vectors, so that neither component cancels.
    let (x, y) = if h >= R::ZERO { (h + r, k) } else { (k, r - h) };
    let length = (x * x + y * y).sqrt();
    (R::HALF * (xx + yy) + r * scale, [x / length, y / length])
}
