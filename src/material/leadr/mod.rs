//! LEADR: displaced surfaces as lobes, under lights and environments (feature `leadr`).
//!
//! What a displacement map leaves of a surface is a mean slope and a covariance, as with a normal
//! map; but the relief is really there. Facets that turn away are not seen, those that face the eye
//! are seen larger. So every mean here is weighted by the area that a facet shows, $\langle m, w_o
//! \rangle / m_z$, and normalized by that of the relief, $\sigma(w_o)$ (in closed form, where the
//! paper sums), or by the mean plane's with masking.
//!
//! [`Leadr`] is the surface: [`Leadr::brdf_cos`] for a light at a point, [`Leadr::environment`] for
//! light from everywhere, given as a function or a [`CubeMap`], [`Leadr::diffuse`] for rough matt
//! relief. Nothing is allocated per sample. Frames are tangent frames of the undisplaced surface;
//! the caller turns directions.
//!
//! Source: Dupuy et al. 2013 and its supplement (equation and algorithm numbers are of the
//! supplement).

mod cube;
mod diffuse;
mod environment;
mod harmonics;
mod lod;
mod quadrature;
mod surface;

pub use cube::CubeMap;
pub use environment::{Light, Normalization};
pub use harmonics::Irradiance;
pub use lod::{cube_lod, dupuy_cube_lod};
pub use quadrature::Quadrature;
pub use surface::{Facet, Leadr, Node, Shadowing};
