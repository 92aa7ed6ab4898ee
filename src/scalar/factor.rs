//! Cholesky factors of symmetric 2x2 matrices from outside, and to there.
//!
//! Layer 0.

use super::{Psd, Real};
use crate::error::{Error, Value};

impl<R: Real> Psd<R> {
    /// The matrix with this Cholesky factor, `[l_xx, l_yx, l_yy]`: the inverse of
    /// [`Psd::cholesky`], to the bit.
    ///
    /// # Errors
    /// [`Error::Factor`] unless `l_xx` and `l_yy` lie in $[0, 10^9]$ and `l_yx` in $[-10^9, 10^9]$,
    /// or if `l_xx` is 0 and `l_yx` is not.
    ///
    /// ```
    /// use lobe::Psd;
    /// let psd = Psd::from_cholesky([2.0_f64, 1.0, 1.0])?;
    /// assert_eq!(psd.entries(), [4.0, 2.0, 2.0]);
    /// assert_eq!(psd.cholesky(), [2.0, 1.0, 1.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn from_cholesky([l_xx, l_yx, l_yy]: [R; 3]) -> Result<Self, Error> {
        let lies = l_xx > R::ZERO || l_yx == R::ZERO;
        if l_xx.is_magnitude() && l_yy.is_magnitude() && l_yx.is_slope() && lies {
            Ok(Self { l_xx, l_yx, l_yy })
        } else {
            Err(Error::Factor([l_xx, l_yx, l_yy].map(Value::from)))
        }
    }

    /// The matrix with the Cholesky factor of three textures, `[l_xx, l_yx, l_yy]`: the nearest
    /// numbers in the ranges of [`Psd::from_cholesky`] count.
    ///
    /// NaN counts as 0 on the diagonal and as an end of its range beside it; where `l_xx` is 0,
    /// `l_yx` counts as 0, too.
    ///
    /// ```
    /// use lobe::Psd;
    /// assert_eq!(Psd::saturating_cholesky([2.0_f32, 1.0, -1.0]).cholesky(), [2.0, 1.0, 0.0]);
    /// assert_eq!(Psd::saturating_cholesky([0.0_f32, 1.0, 1.0]).cholesky(), [0.0, 0.0, 1.0]);
    /// ```
    #[inline(always)]
    pub fn saturating_cholesky([l_xx, l_yx, l_yy]: [R; 3]) -> Self {
        let [l_xx, l_yy] = [l_xx, l_yy].map(|x| x.max(R::ZERO).min(R::LARGEST));
        let beside = l_yx.max(-R::LARGEST).min(R::LARGEST);
        Self { l_xx, l_yx: if l_xx > R::ZERO { beside } else { R::ZERO }, l_yy }
    }

    /// [`Psd::from_cholesky`] of any finite factor.
    #[cfg(feature = "serde")]
    pub(crate) fn of_factor([l_xx, l_yx, l_yy]: [R; 3]) -> Result<Self, Error> {
        let finite = l_xx.is_finite() && l_yx.is_finite() && l_yy.is_finite();
        let lies = l_xx > R::ZERO || l_yx == R::ZERO;
        if finite && l_xx >= R::ZERO && l_yy >= R::ZERO && lies {
            Ok(Self { l_xx, l_yx, l_yy })
        } else {
            Err(Error::Factor([l_xx, l_yx, l_yy].map(Value::from)))
        }
    }

    /// Columns `[l_xx, l_yx]` and `[0, l_yy]` of the factor with $L L^T = A$, as
    /// `[l_xx, l_yx, l_yy]`.
    ///
    /// ```
    /// use lobe::Psd;
    /// assert_eq!(Psd::new(4.0, 2.0, 2.0)?.cholesky(), [2.0_f64, 1.0, 1.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub const fn cholesky(&self) -> [R; 3] {
        [self.l_xx, self.l_yx, self.l_yy]
    }

    /// The columns of the factor.
    #[inline(always)]
    pub(crate) const fn columns(&self) -> [[R; 2]; 2] {
        [[self.l_xx, self.l_yx], [R::ZERO, self.l_yy]]
    }
}
