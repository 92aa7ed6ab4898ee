//! Eigenvalues of symmetric 2x2 matrices, and what is made by them.
//!
//! Layer 0.

use super::exact::difference_of_products;
use super::{Psd, Real};

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

    /// Eigenvalues and major axis.
    #[doc(alias = "lobe_psd_eigen")]
    pub fn eigen(&self) -> Eigen<R> {
        let [xx, xy, yy] = self.entries();
        let (major, axis) = principal(xx, xy, yy);
        let root_det = self.root_det();
        let minor = root_det * (root_det / major.max(R::MIN_POSITIVE)).kept();
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

/// The larger eigenvalue of a symmetric matrix.
#[inline]
pub(crate) fn largest_eigenvalue<R: Real>(xx: R, xy: R, yy: R) -> R {
    principal(xx, xy, yy).0
}

/// The larger eigenvalue of a symmetric matrix and its unit vector.
fn principal<R: Real>(xx: R, xy: R, yy: R) -> (R, [R; 2]) {
    let half_difference = R::HALF * (xx - yy);
    let scale = half_difference.abs().max(xy.abs());
    // Of a matrix that is round up to some roundings of its entries no axis is known.
    let least = R::lit(4.0) * R::EPSILON * (xx + yy).abs();
    if scale <= least.max(R::MIN_POSITIVE) {
        return (xx.max(yy), [R::ONE, R::ZERO]);
    }
    let (h, k) = ((half_difference / scale).kept(), (xy / scale).kept());
    let r = (h * h + k * k).sqrt();
    // The larger of the two equivalent vectors, so that neither component cancels.
    let (x, y) = if h >= R::ZERO { (h + r, k) } else { (k, r - h) };
    let length = (x * x + y * y).sqrt();
    (R::HALF * (xx + yy) + r * scale, [x / length, y / length])
}
