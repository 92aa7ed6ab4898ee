//! Columns: an array for each number of many elements, or one number for all of them.
//!
//! Layer 5.

use crate::error::{Error, same_length};

/// What a batch reads: an item at each index.
///
/// - A slice, `&[T]`, has an item for each element.
/// - [`Fixed`] has the same item for all.
/// - An array or a tuple of columns has arrays and tuples as items: `[&x, &y, &z]` are directions.
/// - [`Isotropic`](super::Isotropic) and the other shapes of this module are columns of shapes.
///
/// Callers with other storage (halves, bytes of a texture) implement it for a view of theirs. To
/// become lanes, loops want [`Columns::at`] as `#[inline(always)]`, without a branch.
///
/// ```
/// use lobe::Error;
/// use lobe::batch::{Columns, Ggx, Isotropic};
/// // Alphas as a texture of bytes has them.
/// #[derive(Clone, Copy)]
/// struct Bytes<'a>(&'a [u8]);
/// impl Columns for Bytes<'_> {
///     type Item = f32;
///     fn check(&self, length: usize) -> Result<(), Error> {
///         self.0.check(length)
///     }
///     fn part(&self, start: usize, length: usize) -> Self {
///         Self(self.0.part(start, length))
///     }
///     #[inline(always)]
///     fn at(&self, index: usize) -> f32 {
///         f32::from(self.0[index]) / 255.0
///     }
/// }
/// let slopes: [&[f32]; 2] = [&[0.0, 0.0], &[0.0, 0.0]];
/// let mut peaks = [0.0; 2];
/// Ggx::new(Isotropic(Bytes(&[51, 255]))).slope_pdf(slopes, &mut peaks)?;
/// assert!(peaks[0] > 20.0 * peaks[1]);
/// # Ok::<(), Error>(())
/// ```
pub trait Columns: Copy {
    /// What stands at an index.
    type Item;

    /// Whether there are items for `length` elements.
    ///
    /// # Errors
    /// [`Error::Length`] if a column has another length.
    fn check(&self, length: usize) -> Result<(), Error>;

    /// The `length` elements from `start` on.
    ///
    /// # Panics
    /// If there are fewer.
    fn part(&self, start: usize, length: usize) -> Self;

    /// The item at `index`.
    ///
    /// # Panics
    /// If there is none.
    fn at(&self, index: usize) -> Self::Item;
}

/// The same item for every element.
///
/// ```
/// use lobe::batch::{Fixed, Ggx, Isotropic};
/// // One viewer and one light, four materials.
/// let (wo, wi) = (Fixed([0.6_f32, 0.0, 0.8]), Fixed([-0.6, 0.0, 0.8]));
/// let mut brdf = [0.0; 4];
/// Ggx::new(Isotropic([0.1, 0.2, 0.3, 0.4].as_slice())).brdf(wo, wi, &mut brdf)?;
/// assert!(brdf.is_sorted_by(|a, b| a > b));
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fixed<T>(pub T);

impl<T: Copy> Columns for Fixed<T> {
    type Item = T;

    #[inline(always)]
    fn check(&self, _: usize) -> Result<(), Error> {
        Ok(())
    }
    #[inline(always)]
    fn part(&self, _: usize, _: usize) -> Self {
        *self
    }
    #[inline(always)]
    fn at(&self, _: usize) -> T {
        self.0
    }
}

impl<T: Copy> Columns for &[T] {
    type Item = T;

    #[inline(always)]
    fn check(&self, length: usize) -> Result<(), Error> {
        same_length(length, self.len())
    }
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        &self[start..][..length]
    }
    #[inline(always)]
    fn at(&self, index: usize) -> T {
        self[index]
    }
}

impl<C: Columns, const N: usize> Columns for [C; N] {
    type Item = [C::Item; N];

    #[inline(always)]
    fn check(&self, length: usize) -> Result<(), Error> {
        self.iter().try_for_each(|column| column.check(length))
    }
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        core::array::from_fn(
            #[inline(always)]
            |n| self[n].part(start, length),
        )
    }
    #[inline(always)]
    fn at(&self, index: usize) -> [C::Item; N] {
        core::array::from_fn(
            #[inline(always)]
            |n| self[n].at(index),
        )
    }
}

/// Columns of tuples.
macro_rules! tuples {
    ($(($($column:ident $n:tt),*))*) => { $(
        impl<$($column: Columns),*> Columns for ($($column,)*) {
            type Item = ($($column::Item,)*);

            #[inline(always)]
            fn check(&self, length: usize) -> Result<(), Error> {
                $(self.$n.check(length)?;)*
                Ok(())
            }
            #[inline(always)]
            fn part(&self, start: usize, length: usize) -> Self {
                ($(self.$n.part(start, length),)*)
            }
            #[inline(always)]
            fn at(&self, index: usize) -> Self::Item {
                ($(self.$n.at(index),)*)
            }
        }
    )* };
}

tuples! {
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D 3)
}
