//! Fresnel reflectance: Schlick's approximation and the exact term of a conductor, in three
//! channels.
//!
//! Layer 4. The lobe's functions leave it out, as engines bring their own; the facade needs one.

use crate::error::Error;
use crate::scalar::Real;

/// A Fresnel term in three channels, of the cosine between a direction and the half vector.
///
/// ```
/// use lobe::material::Fresnel;
/// let gold = Fresnel::conductor([0.18_f64, 0.42, 1.37], [3.42, 2.35, 1.77])?;
/// let schlick = Fresnel::schlick(gold.reflectance(1.0))?;
/// assert!((gold.reflectance(0.5)[0] - schlick.reflectance(0.5)[0]).abs() < 0.05);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel<R> {
    term: Term<R>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Term<R> {
    Schlick { normal: [R; 3] },
    Conductor { eta: [R; 3], k: [R; 3] },
}

impl<R: Real> Fresnel<R> {
    /// Reflectance 1 at every angle: a white furnace, or a Fresnel term applied elsewhere.
    #[inline]
    pub const fn white() -> Self {
        Self { term: Term::Schlick { normal: [R::ONE; 3] } }
    }

    /// The reflectance at normal incidence of Schlick's term, or eta and k of a conductor.
    #[cfg(feature = "serde")]
    pub(crate) const fn parts(&self) -> Result<[R; 3], [[R; 3]; 2]> {
        match self.term {
            Term::Schlick { normal } => Ok(normal),
            Term::Conductor { eta, k } => Err([eta, k]),
        }
    }

    /// Schlick's approximation, $F = F_0 + (1 - F_0)(1 - \cos\theta)^5$, from the reflectance at
    /// normal incidence.
    ///
    /// Source: Schlick 1994, Eq. 15.
    ///
    /// # Errors
    /// [`Error::Reflectance`] unless all channels lie in \[0, 1\].
    ///
    /// ```
    /// use lobe::material::Fresnel;
    /// let plastic = Fresnel::schlick([0.04_f32; 3])?;
    /// assert_eq!(plastic.reflectance(1.0), [0.04; 3]);
    /// assert_eq!(plastic.reflectance(0.0), [1.0; 3]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_fresnel_schlick")]
    pub fn schlick(normal: [R; 3]) -> Result<Self, Error> {
        match normal.iter().find(|f| !(**f >= R::ZERO && **f <= R::ONE)) {
            Some(&f) => Err(Error::Reflectance(f.into())),
            None => Ok(Self { term: Term::Schlick { normal } }),
        }
    }

    /// The exact unpolarized term of an interface with complex index `eta + i k`, relative to the
    /// outside; `k = 0` is a dielectric seen from outside, or from inside if `eta < 1`.
    ///
    /// With $a + i b = \sqrt{(\eta + i k)^2 - \sin^2\theta}$:
    /// $R_s = \frac{(a - \cos\theta)^2 + b^2}{(a + \cos\theta)^2 + b^2}$,
    /// $R_p = R_s \frac{(a \cos\theta - \sin^2\theta)^2 + b^2 \cos^2\theta}{(a \cos\theta +
    /// \sin^2\theta)^2 + b^2 \cos^2\theta}$, $F = (R_s + R_p)/2$.
    ///
    /// Source: Born & Wolf, section 14.2, as sums of squares, which do not cancel.
    ///
    /// # Errors
    /// [`Error::Eta`] unless `eta` lies in $(0, 10^9]$; [`Error::K`] unless `k` lies in $[0,
    /// 10^9]$.
    ///
    /// ```
    /// use lobe::material::Fresnel;
    /// // At normal incidence ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
    /// let glass = Fresnel::conductor([1.5_f64; 3], [0.0; 3])?;
    /// assert!((glass.reflectance(1.0)[0] - 0.04).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_fresnel_conductor")]
    pub fn conductor(eta: [R; 3], k: [R; 3]) -> Result<Self, Error> {
        if let Some(&x) = eta.iter().find(|x| !(x.is_magnitude() && **x > R::ZERO)) {
            return Err(Error::Eta(x.into()));
        }
        match k.iter().find(|x| !x.is_magnitude()) {
            Some(&x) => Err(Error::K(x.into())),
            None => Ok(Self { term: Term::Conductor { eta, k } }),
        }
    }

    /// Reflectance per channel for the cosine between a direction and the half vector, in \[0, 1\].
    ///
    /// Cosines outside \[0, 1\] count as the nearest end; 1 at grazing incidence.
    #[doc(alias = "lobe_fresnel_schlick")]
    #[doc(alias = "lobe_fresnel_conductor")]
    #[inline]
    pub fn reflectance(&self, cos: R) -> [R; 3] {
        let cos = cos.max(R::ZERO).min(R::ONE);
        match self.term {
            Term::Schlick { normal } => {
                let rest = R::ONE - cos;
                let power = (rest * rest) * (rest * rest) * rest;
                normal.map(|f| f + (R::ONE - f) * power)
            }
            Term::Conductor { eta, k } => [0, 1, 2].map(|n| conductor(eta[n], k[n], cos)),
        }
    }
}

/// The unpolarized reflectance of one channel.
#[inline]
fn conductor<R: Real>(eta: R, k: R, cos: R) -> R {
    let sin2 = (R::ONE - cos) * (R::ONE + cos);
    let cos2 = cos * cos;
    // The root of real + 2 i eta k: its larger part directly, the other by a b = eta k.
    let (real, half_imaginary) = ((eta - k) * (eta + k) - sin2, eta * k);
    let modulus = (real * real + R::lit(4.0) * half_imaginary * half_imaginary).sqrt();
    let larger = (R::HALF * (modulus + real.abs())).sqrt().max(R::MIN_POSITIVE);
    let smaller = half_imaginary / larger;
    let (a, b) = if real >= R::ZERO { (larger, smaller) } else { (smaller, larger) };
    let square = |x: R| x * x;
    let least = R::MIN_POSITIVE;
    let s = (square(a - cos) + b * b) / (square(a + cos) + b * b).max(least);
    let (run, rise) = (a * cos, b * b * cos2);
    let p = (square(run - sin2) + rise) / (square(run + sin2) + rise).max(least);
    (R::HALF * s * (R::ONE + p)).min(R::ONE)
}
