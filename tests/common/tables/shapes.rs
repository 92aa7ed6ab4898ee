//! The two kinds of shapes that a table's matrix entries make, one for each promise.

use lobe::slope::Compensated;
use lobe::{Anisotropic, Error, LobeShape, NonCentered, Psd, Real, Roughness};

/// What a result is judged by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Promise {
    /// The relative error, inputs taken as exact: of compensated shapes where matrix entries make a
    /// shape, and of every other quantity.
    Forward,
    /// The number of roundings by which inputs and result must be moved for the result to be exact:
    /// of densities, areas, masking and BRDFs by the default shapes of matrix entries.
    Backward,
}

impl Promise {
    /// The promise's name in tables and messages.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
        }
    }
}

/// Shapes of entries `[a_xx, a_xy, a_yy]`.
pub(crate) trait Shapes<R: Real> {
    /// A shape of mean 0.
    type Centered: LobeShape<Scalar = R>;
    /// A shape of any mean.
    type Moved: LobeShape<Scalar = R>;

    fn centered(entries: [R; 3]) -> Result<Self::Centered, Error>;
    fn moved(mean: [R; 2], entries: [R; 3]) -> Result<Self::Moved, Error>;
}

/// Compensated shapes, which take entries as exact.
pub(crate) struct Exact;

impl<R: Real> Shapes<R> for Exact {
    type Centered = Compensated<R>;
    type Moved = Compensated<R>;

    fn centered(entries: [R; 3]) -> Result<Compensated<R>, Error> {
        Compensated::new([R::ZERO; 2], entries)
    }
    fn moved(mean: [R; 2], entries: [R; 3]) -> Result<Compensated<R>, Error> {
        Compensated::new(mean, entries)
    }
}

/// The default shapes, which round entries to a Cholesky factor.
pub(crate) struct Factored;

impl<R: Real> Shapes<R> for Factored {
    type Centered = Anisotropic<R>;
    type Moved = NonCentered<Anisotropic<R>>;

    fn centered([xx, xy, yy]: [R; 3]) -> Result<Anisotropic<R>, Error> {
        Ok(Anisotropic::new(Roughness::from_matrix(Psd::new(xx, xy, yy)?)))
    }
    fn moved(mean: [R; 2], entries: [R; 3]) -> Result<Self::Moved, Error> {
        NonCentered::new(<Self as Shapes<R>>::centered(entries)?, mean)
    }
}
