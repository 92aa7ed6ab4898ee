//! Distributions of columns of shapes: densities, masking and the BRDF of every element.
//!
//! Layer 5.

use super::columns::Columns;
use super::fill::{fill, fill_one_by_one, fill_or};
use crate::error::Error;
use crate::ndf::{self, BeckmannDistribution, Distribution, GgxDistribution};
use crate::slope::{Footprint, LobeShape, Whiten};
use core::marker::PhantomData;

/// A distribution over columns of shapes; used through [`Beckmann`] and [`Ggx`].
///
/// Each method writes for every element what the method of the same name of [`lobe::Ndf`](ndf::Ndf)
/// gives, to the bit, whatever the length and the instructions.
///
/// ```
/// use lobe::batch::{Fixed, Ggx, Isotropic};
/// let (alpha, x, z): (&[f32], &[f32], &[f32]) = (&[0.2, 0.4], &[0.6, 0.0], &[0.8, 1.0]);
/// let (wo, wi) = ([x, &[0.0, 0.0], z], Fixed([0.0, 0.0, 1.0]));
/// let mut brdf = [0.0; 2];
/// Ggx::new(Isotropic(alpha)).brdf(wo, wi, &mut brdf)?;
/// let second = lobe::Ggx::new(lobe::Isotropic::new(0.4)?);
/// assert_eq!(brdf[1], second.brdf([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]));
/// // Columns of another length are refused before anything is written.
/// let refused = Ggx::new(Isotropic(&alpha[1..])).brdf(wo, wi, &mut brdf);
/// assert_eq!(refused, Err(lobe::Error::Length { expected: 2, found: 1 }));
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ndf<D, S> {
    shapes: S,
    distribution: PhantomData<D>,
}

/// GGX over columns of shapes.
pub type Ggx<S> = Ndf<GgxDistribution, S>;

/// Beckmann over columns of shapes.
pub type Beckmann<S> = Ndf<BeckmannDistribution, S>;

/// The precision of columns of shapes.
type Scalar<S> = <<S as Columns>::Item as LobeShape>::Scalar;

impl<D: Distribution, S: Columns<Item: LobeShape>> Ndf<D, S> {
    /// The distribution over these shapes.
    pub const fn new(shapes: S) -> Self {
        Self { shapes, distribution: PhantomData }
    }

    /// [`lobe::Ndf::slope_pdf`](ndf::Ndf::slope_pdf) of every element.
    ///
    /// # Errors
    /// [`Error::Length`] unless all columns are as long as `out`; nothing is then written.
    pub fn slope_pdf(
        &self,
        slopes: impl Columns<Item = [Scalar<S>; 2]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, slopes),
            [out],
            #[inline(always)]
            |(shape, slope)| [ndf::Ndf::<D, _>::new(shape).slope_pdf(slope)],
        )
    }

    /// [`lobe::Ndf::d`](ndf::Ndf::d) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn d(
        &self,
        normals: impl Columns<Item = [Scalar<S>; 3]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, normals),
            [out],
            #[inline(always)]
            |(shape, m)| [ndf::Ndf::<D, _>::new(shape).d(m)],
        )
    }

    /// [`lobe::Ndf::projected_area`](ndf::Ndf::projected_area) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn projected_area(
        &self,
        w: impl Columns<Item = [Scalar<S>; 3]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, w),
            [out],
            #[inline(always)]
            |(shape, w)| [ndf::Ndf::<D, _>::new(shape).projected_area(w)],
        )
    }

    /// [`lobe::Ndf::g1`](ndf::Ndf::g1) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn g1(
        &self,
        w: impl Columns<Item = [Scalar<S>; 3]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, w),
            [out],
            #[inline(always)]
            |(shape, w)| [ndf::Ndf::<D, _>::new(shape).g1(w)],
        )
    }

    /// [`lobe::Ndf::visibility`](ndf::Ndf::visibility) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn visibility(
        &self,
        wo: impl Columns<Item = [Scalar<S>; 3]>,
        wi: impl Columns<Item = [Scalar<S>; 3]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, wo, wi),
            [out],
            #[inline(always)]
            |(shape, wo, wi)| [ndf::Ndf::<D, _>::new(shape).visibility(wo, wi)],
        )
    }

    /// [`lobe::Ndf::brdf`](ndf::Ndf::brdf) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn brdf(
        &self,
        wo: impl Columns<Item = [Scalar<S>; 3]>,
        wi: impl Columns<Item = [Scalar<S>; 3]>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, wo, wi),
            [out],
            #[inline(always)]
            |(shape, wo, wi)| [ndf::Ndf::<D, _>::new(shape).brdf(wo, wi)],
        )
    }
}

impl<S: Columns<Item: Whiten>> Ggx<S> {
    /// [`lobe::Ndf::parallelogram_mean`](ndf::Ndf::parallelogram_mean) of every element, one after
    /// the other: its tree of branches is no lanes.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn parallelogram_mean(
        &self,
        slopes: impl Columns<Item = [Scalar<S>; 2]>,
        footprints: impl Columns<Item = Footprint<Scalar<S>>>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill_one_by_one((self.shapes, slopes, footprints), [out], |(shape, slope, footprint)| {
            [ndf::Ggx::new(shape).parallelogram_mean(slope, &footprint)]
        })
    }

    /// [`lobe::Ndf::parallelogram_mean_in_lanes`](ndf::Ndf::parallelogram_mean_in_lanes) of every
    /// element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn parallelogram_mean_in_lanes(
        &self,
        slopes: impl Columns<Item = [Scalar<S>; 2]>,
        footprints: impl Columns<Item = Footprint<Scalar<S>>>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, slopes, footprints),
            [out],
            #[inline(always)]
            |(shape, slope, footprint)| {
                [ndf::Ggx::new(shape).parallelogram_mean_in_lanes(slope, &footprint)]
            },
        )
    }

    /// [`lobe::Ndf::brdf_over_in_lanes`](ndf::Ndf::brdf_over_in_lanes) of every element.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    pub fn brdf_over_in_lanes(
        &self,
        wo: impl Columns<Item = [Scalar<S>; 3]>,
        wi: impl Columns<Item = [Scalar<S>; 3]>,
        footprints: impl Columns<Item = Footprint<Scalar<S>>>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill(
            (self.shapes, wo, wi, footprints),
            [out],
            #[inline(always)]
            |(shape, wo, wi, footprint)| {
                [ndf::Ggx::new(shape).brdf_over_in_lanes(wo, wi, &footprint)]
            },
        )
    }

    /// [`lobe::Ndf::brdf_over`](ndf::Ndf::brdf_over) of every element, one after the other: its
    /// tree of branches is no lanes.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    ///
    /// ```
    /// use lobe::batch::{Fixed, Footprint, Ggx, Isotropic};
    /// let (wo, wi) = (Fixed([0.6_f64, 0.0, 0.8]), Fixed([-0.6, 0.0, 0.8]));
    /// let footprints = Footprint { u: Fixed([0.3, 0.0]), v: Fixed([0.0, 0.1]) };
    /// let alphas: &[f64] = &[0.1, 0.4];
    /// let mut mean = [0.0; 2];
    /// Ggx::new(Isotropic(alphas)).brdf_over(wo, wi, footprints, &mut mean)?;
    /// assert!(mean[0] > mean[1]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn brdf_over(
        &self,
        wo: impl Columns<Item = [Scalar<S>; 3]>,
        wi: impl Columns<Item = [Scalar<S>; 3]>,
        footprints: impl Columns<Item = Footprint<Scalar<S>>>,
        out: &mut [Scalar<S>],
    ) -> Result<(), Error> {
        fill_one_by_one((self.shapes, wo, wi, footprints), [out], |(shape, wo, wi, footprint)| {
            [ndf::Ggx::new(shape).brdf_over(wo, wi, &footprint)]
        })
    }
}

impl<S: Columns<Item: Whiten<Scalar = f32>>> Ggx<S> {
    /// [`lobe::Ndf::parallelogram_mean_in_double`](ndf::Ndf::parallelogram_mean_in_double) of every
    /// element: in lanes of f64 where they serve, by the tree elsewhere.
    ///
    /// # Errors
    /// As [`Ndf::slope_pdf`].
    ///
    /// ```
    /// use lobe::batch::{Fixed, Footprint, Ggx, Isotropic};
    /// let footprints = Footprint { u: Fixed([0.3, 0.0]), v: Fixed([0.0, 0.1]) };
    /// let alphas: &[f32] = &[0.1, 0.4];
    /// let mut mean = [0.0; 2];
    /// let ggx = Ggx::new(Isotropic(alphas));
    /// ggx.parallelogram_mean_in_double(Fixed([0.0, 0.0]), footprints, &mut mean)?;
    /// assert!(mean[0] > mean[1]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn parallelogram_mean_in_double(
        &self,
        slopes: impl Columns<Item = [f32; 2]>,
        footprints: impl Columns<Item = Footprint<f32>>,
        out: &mut [f32],
    ) -> Result<(), Error> {
        fill_or(
            (self.shapes, slopes, footprints),
            out,
            #[inline(always)]
            |(shape, slope, footprint)| {
                ndf::Ggx::new(shape).parallelogram_mean_if_known(slope, &footprint)
            },
            |(shape, slope, footprint)| ndf::Ggx::new(shape).parallelogram_mean(slope, &footprint),
        )
    }
}
