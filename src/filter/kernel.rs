//! The pixel's kernel as a slope covariance, with the pixel filter named.
//!
//! Layer 3. The same citation hides factors from 0.159 to 0.5 in shipped code, because the filter's
//! variance is left unsaid. Here it has a name.

use crate::error::{Error, Value};
use crate::scalar::{Eigen, Psd, Real};
use crate::slope::Footprint;
use core::ops::{Add, AddAssign, Mul};

/// The pixel filter that a Gaussian kernel stands for, as a variance in squared pixels.
///
/// ```
/// use lobe::PixelFilter;
/// assert_eq!(PixelFilter::BOX.variance(), 1.0 / 12.0);
/// assert!(PixelFilter::with_variance(-1.0).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelFilter {
    variance: f64,
}

impl PixelFilter {
    /// The variance of the box pixel, 1/12: what a reference with uniform samples in the pixel
    /// sees.
    pub const BOX: Self = Self { variance: 1.0 / 12.0 };

    /// A Gaussian of half a pixel's deviation, 1/4: Kaplanyan et al. 2016 section 4.3, Tokuyoshi
    /// 2017 Eq. 2, Tokuyoshi & Kaplanyan 2019. Three times the box's variance.
    pub const KAPLANYAN: Self = Self { variance: 0.25 };

    /// A Gaussian whose peak is one per pixel, $1/(2\pi)$: Tokuyoshi & Kaplanyan 2021.
    ///
    /// Also what makes variance addition meet the peak of GGX over a large square pixel: it adds
    /// $w^2/\pi$, and is within 0.55 % of [`box_peak_alpha`](super::box_peak_alpha) at any width.
    pub const TOKUYOSHI_KAPLANYAN: Self = Self { variance: 0.5 * core::f64::consts::FRAC_1_PI };

    /// What Kaplanyan's "GGX proxy", $\alpha^2 + w^2$, comes to: 1/2. Six times the box's variance,
    /// and a peak up to 3.1 times too dark; here to reproduce it (Kaplanyan et al. 2016, Eq. 20,
    /// last form).
    pub const KAPLANYAN_PROXY: Self = Self { variance: 0.5 };

    /// A filter of this variance, in squared pixels.
    ///
    /// # Errors
    /// [`Error::Variance`] unless in $[0, 10^9]$.
    ///
    /// ```
    /// use lobe::PixelFilter;
    /// // Constant evaluation refuses what the constructor refuses.
    /// const TENT: PixelFilter = match PixelFilter::with_variance(1.0 / 6.0) {
    ///     Ok(filter) => filter,
    ///     Err(_) => panic!("in range"),
    /// };
    /// assert_eq!(TENT.variance(), 2.0 * PixelFilter::BOX.variance());
    /// ```
    pub const fn with_variance(variance: f64) -> Result<Self, Error> {
        if variance >= 0.0 && variance <= 1e9 {
            Ok(Self { variance })
        } else {
            Err(Error::Variance(Value::new(variance)))
        }
    }

    /// The variance in squared pixels.
    pub const fn variance(self) -> f64 {
        self.variance
    }
}

/// The covariance $\Sigma_K$ of a Gaussian kernel on the slope plane.
///
/// $\Sigma_K = \sigma_{px}^2 (d_u d_u^T + d_v d_v^T)$: outer products of the derivative vectors,
/// not the Gram matrix of the pixel axes that Kaplanyan's Eq. 13 gives when read with row vectors,
/// and that shaders ported from row-major to column-major languages compute. Trace and determinant
/// of the two agree, so only a rotated footprint shows the difference.
///
/// ```
/// use lobe::{Footprint, Kernel, PixelFilter};
/// // The same step on both pixel axes: all spread is along that step.
/// let footprint = Footprint::from_slopes([0.1_f64, 0.0], [0.1, 0.0]);
/// let [xx, xy, yy] = Kernel::of(&footprint, PixelFilter::KAPLANYAN).covariance().entries();
/// assert!((xx - 0.005).abs() < 1e-15 && xy == 0.0 && yy == 0.0);
/// ```
// Further methods: filter/disk.rs, filter/gaussian.rs, filter/proxy.rs.
#[doc(alias = "Sigma_K")]
#[doc(alias = "LobeKernel")]
#[doc(alias = "lobe_kernel_add")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Kernel<R> {
    /// Columns with $2 \Sigma_K = u u^T + v v^T$.
    u: [R; 2],
    v: [R; 2],
}

impl<R: Real> Kernel<R> {
    /// The Gaussian kernel of a footprint under a pixel filter.
    ///
    /// Total and without a branch, for loops over pixels. Footprints of grazing half vectors have
    /// no bound: where a matrix is made of the kernel, deviations beyond $10^9$ count as that, as
    /// squares would overflow f32, and so do those without a number. A lobe that
    /// [`Kernel::widen`] makes of such a kernel has density 0.
    #[doc(alias = "lobe_kernel_of")]
    #[inline(always)]
    pub fn of(footprint: &Footprint<R>, filter: PixelFilter) -> Self {
        let factor = (R::TWO * R::lit(filter.variance)).sqrt();
        Self { u: footprint.u, v: footprint.v }.scaled(factor)
    }

    #[inline(always)]
    fn scaled(&self, factor: R) -> Self {
        Self { u: self.u.map(|x| x * factor), v: self.v.map(|x| x * factor) }
    }

    /// A kernel of this covariance: an area light, a depth of field, a normal map's spread.
    #[doc(alias = "lobe_kernel_from_covariance")]
    #[inline]
    pub fn from_covariance(covariance: Psd<R>) -> Self {
        let [u, v] = (covariance * R::TWO).columns();
        Self { u, v }
    }

    /// A kernel that adds $u u^T + v v^T$ to a roughness matrix: $2 \Sigma_K$.
    ///
    /// # Errors
    /// [`Error::Column`] unless all components lie in $[-10^9, 10^9]$.
    ///
    /// ```
    /// use lobe::Kernel;
    /// let kernel = Kernel::from_columns([0.3_f64, 0.0], [0.1, 0.2])?;
    /// assert_eq!(kernel.columns(), [[0.3, 0.0], [0.1, 0.2]]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn from_columns(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>) -> Result<Self, Error> {
        let (u, v) = (u.into(), v.into());
        let beyond = [u, v].into_iter().find(|column| !column.iter().all(|x| x.is_slope()));
        beyond.map_or(Ok(Self { u, v }), |column| Err(Error::Column(column.map(Value::from))))
    }

    /// The covariance $\Sigma_K$.
    #[doc(alias = "lobe_kernel_covariance")]
    #[inline]
    pub fn covariance(&self) -> Psd<R> {
        let [u, v] = self.added();
        Psd::outer_sum(u, v) * R::HALF
    }

    /// Two columns whose outer products sum to $2 \Sigma_K$, what the kernel adds to a roughness
    /// matrix: the footprint's sides times $\sqrt 2$ of the filter's deviation, or the factor of a
    /// covariance times $\sqrt 2$.
    #[inline(always)]
    pub const fn columns(&self) -> [[R; 2]; 2] {
        [self.u, self.v]
    }

    /// The columns within the range of slopes, of which matrices are made.
    #[inline(always)]
    pub(crate) fn added(&self) -> [[R; 2]; 2] {
        let within = |x: R| x.max(-R::LARGEST).min(R::LARGEST);
        [self.u.map(within), self.v.map(within)]
    }

    /// The footprint that this kernel is of, under a pixel filter: along the axes of the
    /// covariance.
    ///
    /// The way back from [`Kernel::of`], which knows no other parallelogram of the same covariance.
    /// It lets the exact GGX mean and its bounding rectangle filter nested kernels. Sides end at
    /// $10^9$; for a filter of variance 0, no footprint.
    ///
    /// Source: Kaplanyan et al. 2016, section 5.5 ("the rectangle around the vectors of the
    /// standard deviations").
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter};
    /// let kernel =
    ///     Kernel::of(&Footprint::from_slopes([0.3_f64, 0.1], [0.1, 0.2]), PixelFilter::BOX);
    /// let back = Kernel::of(&kernel.footprint(PixelFilter::BOX), PixelFilter::BOX);
    /// let (a, b) = (kernel.covariance().entries(), back.covariance().entries());
    /// assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15));
    /// ```
    #[doc(alias = "lobe_kernel_footprint")]
    pub fn footprint(&self, filter: PixelFilter) -> Footprint<R> {
        let Eigen { major, minor, axis: [cos, sin] } = self.covariance().eigen();
        if filter.variance <= 0.0 {
            return Footprint::default();
        }
        // Sides of at most the largest slope; an infinite quotient counts as that.
        let variance = R::lit(filter.variance).max(R::MIN_POSITIVE);
        let [long, short] =
            [major, minor].map(|x| (x / variance).min(R::LARGEST * R::LARGEST).sqrt());
        Footprint { u: [long * cos, long * sin], v: [-(short * sin), short * cos] }
    }

    /// The kernel with the alpha^2 it adds, $2\Sigma_K$, limited to `limit` along each of its axes.
    /// A negative limit counts as 0.
    ///
    /// Kaplanyan's code and Tokuyoshi 2017 limit it to 0.18 ([`Kernel::ALPHA_SQUARED_LIMIT`]) per
    /// frame axis or as a scalar; limiting the eigenvalues is the same for a kernel along the
    /// frame's axes, and does not depend on the frame.
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter};
    /// let wide = Kernel::of(&Footprint::rectangle([9.0_f64, 0.1]), PixelFilter::BOX);
    /// let capped = wide.capped(0.18).covariance().entries();
    /// assert!((capped[0] - 0.09).abs() < 1e-15 && (capped[2] - 0.01 / 12.0).abs() < 1e-15);
    /// ```
    #[doc(alias = "lobe_kernel_capped")]
    #[must_use]
    pub fn capped(&self, limit: R) -> Self {
        let covariance = self.covariance();
        let capped = covariance.capped(R::HALF * limit);
        if capped == covariance { *self } else { Self::from_covariance(capped) }
    }

    /// The limit on added alpha^2 of Kaplanyan's 2016 code and of Tokuyoshi 2017, Eq. 10 and 13.
    pub const ALPHA_SQUARED_LIMIT: f64 = 0.18;
}

impl<R: Real> Add for Kernel<R> {
    type Output = Self;

    /// Two kernels one after the other: covariances add. Nested filtering, of a normal map and a
    /// pixel, say.
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 21. For GGX over an area, [`Kernel::footprint`].
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness, SlopeMoments};
    /// let texels = SlopeMoments::from_raw([0.0_f64, 0.0], [0.01, 0.0, 0.02])?;
    /// let pixel = Kernel::of(&Footprint::rectangle([0.1, 0.1]), PixelFilter::KAPLANYAN);
    /// let base = Roughness::from_alpha(0.1)?;
    /// // A map's spread as a kernel, or as a lobe: the same.
    /// let nested = base.widened(&(Kernel::from_covariance(texels.covariance()) + pixel));
    /// assert_eq!(
    ///     nested.matrix().entries()[0],
    ///     texels.lobe(base).widened(&pixel).roughness().matrix().entries()[0]
    /// );
    /// # Ok::<(), lobe::Error>(())
    /// ```
    fn add(self, other: Self) -> Self {
        // Nothing is rounded where one of the two is no kernel.
        if self == Self::default() {
            return other;
        }
        if other == Self::default() {
            return self;
        }
        let ([a, b], [u, v]) = (self.added(), other.added());
        let [u, v] = Psd::outer_sum(a, b).with_columns(u, v).columns();
        Self { u, v }
    }
}

impl<R: Real> AddAssign for Kernel<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> Mul<R> for Kernel<R> {
    type Output = Self;

    /// The kernel with its covariance times a finite factor; a negative one counts as 0.
    #[inline]
    fn mul(self, factor: R) -> Self {
        self.scaled(factor.max(R::ZERO).sqrt())
    }
}
