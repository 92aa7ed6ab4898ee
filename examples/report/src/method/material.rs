//! The material under the filter: one alpha, or one along and one across a brushed surface's
//! grooves.

use lobe::slope::Whiten;
use lobe::{AxisAligned, Error, Isotropic, Roughness};

use crate::scene::ACROSS;

/// What a scene's material is like, apart from its alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finish {
    /// The same in all directions.
    Isotropic,
    /// Alpha along the shading frame's first axis, [`ACROSS`] times as much across.
    Brushed,
}

impl Finish {
    /// Roughness along the shading frame's axes.
    pub(crate) fn alphas(self, alpha: f64) -> [f64; 2] {
        match self {
            Self::Isotropic => [alpha; 2],
            Self::Brushed => [alpha, ACROSS * alpha],
        }
    }
}

/// A material of a shape, with what the filters need of it.
pub(crate) struct Material<S: Whiten> {
    /// Roughness along the shading frame's axes.
    pub(super) alphas: [S::Scalar; 2],
    pub(super) shape: S,
    pub(super) roughness: Roughness<S::Scalar>,
}

/// A scene's material in the shape that costs least.
pub(crate) enum Surfacing {
    Isotropic(Material<Isotropic<f32>>),
    Brushed(Material<AxisAligned<f32>>),
}

impl Surfacing {
    pub(crate) fn new(finish: Finish, alpha: f64) -> Result<Self, Error> {
        let alphas = finish.alphas(alpha).map(|alpha| alpha as f32);
        let roughness = Roughness::from_alphas(alphas[0], alphas[1], 0.0)?;
        Ok(match finish {
            Finish::Isotropic => {
                Self::Isotropic(Material { alphas, shape: Isotropic::new(alphas[0])?, roughness })
            }
            Finish::Brushed => {
                let shape = AxisAligned::new(alphas[0], alphas[1])?;
                Self::Brushed(Material { alphas, shape, roughness })
            }
        })
    }
}
