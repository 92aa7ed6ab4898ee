//! Symmetric positive semi-definite 2x2 matrices, kept as a factor.
//!
//! Layer 0. A matrix near rank one loses its determinant in its entries: of alpha = 1e-4 under a
//! kernel of size 1, f32 entries keep nothing of the minor axis. A factor L with $L L^T = A$ keeps
//! both axes, so that determinants, forms and sums are products and sums of squares in plain
//! arithmetic.

use super::Real;
use super::exact::difference_of_products;
use crate::error::{Error, Value};
use core::ops::{Add, AddAssign, Mul};

/// A symmetric positive semi-definite matrix $A = L L^T$: a roughness or a covariance.
///
/// It is kept as its Cholesky factor, $L = \begin{pmatrix} l_{xx} & 0 \\\\ l_{yx} & l_{yy}
/// \end{pmatrix}$ with $l_{xx}, l_{yy} \ge 0$: its determinant is right to a rounding however thin
/// the ellipse is. Entries are products of the factor, rounded.
///
/// ```
/// use lobe::Psd;
/// let a = Psd::new(2.0_f64, 1.0, 2.0)?;
/// assert!((a.det() - 3.0).abs() < 1e-12);
/// let eigen = a.eigen();
/// assert!((eigen.major - 3.0).abs() < 1e-12 && (eigen.minor - 1.0).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: scalar/eigen.rs, scalar/factor.rs.
#[doc(alias = "LobePsd")]
#[doc(alias = "lobe_psd_mul")]
#[doc(alias = "lobe_psd_add")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(clippy::struct_field_names, reason = "entries of the factor L")]
pub struct Psd<R> {
    pub(super) l_xx: R,
    pub(super) l_yx: R,
    pub(super) l_yy: R,
}

/// The least entry xx that a factor has digits for: below it the squares that make it are no longer
/// normal numbers, and the matrix counts as one along y.
#[inline(always)]
fn flat<R: Real>(xx: R) -> bool {
    xx < R::MIN_POSITIVE / R::EPSILON
}

impl<R: Real> Psd<R> {
    /// The matrix with these entries, by one compensated determinant.
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
        Self::with_root_det([xx, xy, yy], det.max(R::ZERO).sqrt())
    }

    /// The matrix with these entries, `xx`, `xy`, `yy`, whose determinant is known better than they
    /// tell it.
    #[inline(always)]
    pub(crate) fn with_root_det([xx, xy, yy]: [R; 3], root_det: R) -> Self {
        let flat = flat(xx);
        let l_xx = xx.max(R::MIN_POSITIVE).sqrt();
        let inverse = R::ONE / l_xx;
        let along_y = Self { l_xx: R::ZERO, l_yx: R::ZERO, l_yy: yy.max(R::ZERO).sqrt() };
        let regular = Self { l_xx, l_yx: xy * inverse, l_yy: root_det * inverse };
        if flat { along_y } else { regular }
    }

    /// The zero matrix.
    pub const fn zero() -> Self {
        Self { l_xx: R::ZERO, l_yx: R::ZERO, l_yy: R::ZERO }
    }

    /// `diag(x^2, y^2)`.
    #[inline(always)]
    pub(crate) const fn diagonal(x: R, y: R) -> Self {
        Self { l_xx: x, l_yx: R::ZERO, l_yy: y }
    }

    /// `diag(x^2, y^2)` turned by an angle given as cosine and sine: the square of a scaling
    /// along axes.
    pub(crate) fn from_axes(x: R, y: R, cos: R, sin: R) -> Self {
        if sin == R::ZERO {
            return Self::diagonal(x, y);
        }
        let (xx, yy) = (x * x, y * y);
        let entries = [
            xx * cos * cos + yy * sin * sin,
            (x - y) * (x + y) * cos * sin,
            xx * sin * sin + yy * cos * cos,
        ];
        Self::with_root_det(entries, x * y)
    }

    /// Standard deviations and correlation: `[[x^2, rho x y], [rho x y, y^2]]`.
    pub(crate) fn from_deviations(x: R, y: R, rho: R) -> Self {
        let complement = ((R::ONE - rho) * (R::ONE + rho)).sqrt();
        let along_y = Self { l_xx: R::ZERO, l_yx: R::ZERO, l_yy: y };
        let regular = Self { l_xx: x, l_yx: rho * y, l_yy: y * complement };
        if x > R::ZERO { regular } else { along_y }
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
        Self::outer_sum_with_root_det(u, v, (u[0] * v[1] - u[1] * v[0]).abs())
    }

    /// [`Psd::outer_sum`] of vectors whose cross product is known better than by their components.
    #[inline]
    pub(crate) fn outer_sum_with_root_det(u: [R; 2], v: [R; 2], root_det: R) -> Self {
        let entries =
            [u[0] * u[0] + v[0] * v[0], u[0] * u[1] + v[0] * v[1], u[1] * u[1] + v[1] * v[1]];
        Self::with_root_det(entries, root_det)
    }

    /// $A + u u^T + v v^T$: the rows of $[L\; u\; v]$ turned to a triangle.
    ///
    /// With r the first row over its length, $l_{yx}'$ is the second row along r and $l_{yy}'^2$
    /// the sum of the squared minors of the two rows (Cauchy-Binet): nothing but one product less
    /// another cancels when a small round lobe meets a long thin kernel.
    #[doc(alias = "lobe_psd_with_columns")]
    #[inline(always)]
    pub(crate) fn with_columns(&self, u: [R; 2], v: [R; 2]) -> Self {
        let Self { l_xx, l_yx, l_yy } = *self;
        let xx = l_xx * l_xx + (u[0] * u[0] + v[0] * v[0]);
        let flat = flat(xx);
        let length = xx.max(R::MIN_POSITIVE).sqrt();
        let inverse = R::ONE / length;
        let [r, r_u, r_v] = [l_xx * inverse, u[0] * inverse, v[0] * inverse];
        let lean = r * l_yx + (r_u * u[1] + r_v * v[1]);
        let minors = [r * u[1] - r_u * l_yx, r * v[1] - r_v * l_yx, r_u * v[1] - r_v * u[1]];
        let [a, b, c] = minors;
        let along_y = l_yx * l_yx + (u[1] * u[1] + v[1] * v[1]);
        let across = a * a + (b * b + c * c);
        let yy = l_yy * l_yy + if flat { along_y } else { across };
        Self {
            l_xx: if flat { R::ZERO } else { length },
            l_yx: if flat { R::ZERO } else { lean },
            l_yy: yy.sqrt(),
        }
    }

    /// The entries `xx`, `xy`, `yy`: products of the factor, each right to two roundings.
    #[doc(alias = "lobe_psd_entries")]
    #[inline(always)]
    pub fn entries(&self) -> [R; 3] {
        let Self { l_xx, l_yx, l_yy } = *self;
        [l_xx * l_xx, l_xx * l_yx, l_yx * l_yx + l_yy * l_yy]
    }

    /// Determinant.
    #[doc(alias = "lobe_psd_det")]
    #[inline(always)]
    pub fn det(&self) -> R {
        self.root_det() * self.root_det()
    }

    /// Square root of the determinant: the area scale of the ellipse.
    #[doc(alias = "lobe_psd_root_det")]
    #[inline(always)]
    pub fn root_det(&self) -> R {
        self.l_xx * self.l_yy
    }

    /// Trace.
    #[doc(alias = "lobe_psd_trace")]
    #[inline(always)]
    pub fn trace(&self) -> R {
        self.l_xx * self.l_xx + (self.l_yx * self.l_yx + self.l_yy * self.l_yy)
    }

    /// True if the determinant is below the smallest normal number: a mirror along some axis.
    #[doc(alias = "lobe_psd_is_singular")]
    #[inline(always)]
    pub fn is_singular(&self) -> bool {
        !(self.det() >= R::MIN_POSITIVE)
    }

    /// $v^T \mathrm{adj}(A)\, v = \det(A)\, v^T A^{-1} v$, a sum of squares.
    #[doc(alias = "lobe_psd_adjugate_form")]
    #[inline(always)]
    pub(crate) fn adjugate_form(&self, v: [R; 2]) -> R {
        let along = self.l_xx * v[1] - self.l_yx * v[0];
        let across = self.l_yy * v[0];
        along * along + across * across
    }

    /// $\mathrm{tr}(\mathrm{adj}(A)\, B)$, the adjugate form of B's columns.
    #[inline(always)]
    pub(crate) fn mixed_det(&self, other: &Self) -> R {
        let [u, v] = other.columns();
        self.adjugate_form(u) + self.adjugate_form(v)
    }

    /// $w^T A w = |L^T w|^2$, a sum of squares.
    #[doc(alias = "lobe_psd_quadratic")]
    #[inline(always)]
    pub fn quadratic(&self, w: [R; 2]) -> R {
        let along = self.l_xx * w[0] + self.l_yx * w[1];
        let across = self.l_yy * w[1];
        along * along + across * across
    }
}

impl<R: Real> Mul<R> for Psd<R> {
    type Output = Self;

    /// The matrix times a finite factor; a negative one and NaN count as 0.
    #[inline]
    fn mul(self, factor: R) -> Self {
        let root = factor.max(R::ZERO).sqrt();
        Self { l_xx: self.l_xx * root, l_yx: self.l_yx * root, l_yy: self.l_yy * root }
    }
}

impl<R: Real> Add for Psd<R> {
    type Output = Self;

    /// The sum of two matrices.
    #[inline]
    fn add(self, other: Self) -> Self {
        let [u, v] = other.columns();
        self.with_columns(u, v)
    }
}

impl<R: Real> AddAssign for Psd<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
