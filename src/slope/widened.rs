//! A shape under two columns: a lobe that a pixel's kernel widens, without a matrix.
//!
//! Layer 1.

use super::shape::{Extent, LobeShape, cross_squared};
use crate::scalar::Real;

/// $A' = A + u u^T + v v^T$ around the mean of a shape.
///
/// Every answer adds two squares to that of the shape (Cauchy-Binet): $\det A' = \det A + u^T
/// \mathrm{adj}(A)\, u + v^T \mathrm{adj}(A)\, v + (u \times v)^2$, the form gains $(u \times
/// x)^2 + (v \times x)^2$ and the squared stretch $(u \cdot w)^2 + (v \cdot w)^2$. An isotropic
/// lobe under a pixel meets no general matrix.
#[doc(alias = "LobeWidened")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Widened<S: LobeShape> {
    shape: S,
    u: [S::Scalar; 2],
    v: [S::Scalar; 2],
}

impl<S: LobeShape> Widened<S> {
    /// The shape under these columns, with components in $[-10^9, 10^9]$, which are not checked.
    ///
    /// [`Kernel::widen`](crate::Kernel::widen) takes them from a kernel.
    ///
    /// ```
    /// use lobe::{Isotropic, LobeShape, slope::Widened};
    /// let widened = Widened::new(Isotropic::new(0.3_f64)?, [0.4, 0.0], [0.0, 0.4]);
    /// assert!((widened.root_det() - 0.25).abs() < 1e-15); // alpha^2 = 0.3^2 + 0.4^2
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_widened_new")]
    #[inline(always)]
    pub const fn new(shape: S, u: [S::Scalar; 2], v: [S::Scalar; 2]) -> Self {
        Self { shape, u, v }
    }
}

impl<S: LobeShape> LobeShape for Widened<S> {
    type Scalar = S::Scalar;
    const CENTERED: bool = S::CENTERED;

    #[inline(always)]
    fn extent(&self) -> Extent<S::Scalar> {
        let det = self.shape.widened_det(self.u, self.v);
        let root_det = det.sqrt();
        Extent { root_det, unit: det, scale: root_det }
    }
    #[inline(always)]
    fn relative(&self, m: [S::Scalar; 3]) -> [S::Scalar; 2] {
        self.shape.relative(m)
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [S::Scalar; 2]) -> S::Scalar {
        self.shape.adjugate_form(v) + cross_squared(self.u, v) + cross_squared(self.v, v)
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [S::Scalar; 3]) -> S::Scalar {
        let along_u = self.u[0] * w[0] + self.u[1] * w[1];
        let along_v = self.v[0] * w[0] + self.v[1] * w[1];
        self.shape.stretch_squared(w) + along_u * along_u + along_v * along_v
    }
    #[inline(always)]
    fn mean_area(&self, w: [S::Scalar; 3]) -> S::Scalar {
        self.shape.mean_area(w)
    }
}
