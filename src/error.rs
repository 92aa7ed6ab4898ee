//! Why a constructor refused its arguments.
//!
//! Layer 0: imports nothing. The hot path has no errors: only constructors return them.

use core::fmt;

/// The parameter that a constructor refused, one variant each.
///
/// ```
/// use lobe::{Error, Roughness};
/// assert_eq!(Roughness::from_alpha(-0.1_f32), Err(Error::Alpha));
/// assert_eq!(Error::Alpha.to_string(), "alpha must lie in [0, 1e9]");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// `alpha` is outside `[0, 1e9]` or NaN.
    Alpha,
    /// `alpha_x` is outside `[0, 1e9]` or NaN.
    AlphaX,
    /// `alpha_y` is outside `[0, 1e9]` or NaN.
    AlphaY,
    /// `angle` is infinite or NaN.
    Angle,
    /// `perceptual` is outside `[0, 1]` or NaN.
    Perceptual,
    /// `sigma_x` is outside `[0, 1e9]` or NaN.
    SigmaX,
    /// `sigma_y` is outside `[0, 1e9]` or NaN.
    SigmaY,
    /// `sigma` is outside `[0, 1e9]` or NaN.
    Sigma,
    /// `width` is outside `[0, 1e9]` or NaN.
    Width,
    /// `sharpness` is outside `[1e-9, 1e18]` or NaN.
    Sharpness,
    /// `radius` is outside `[2e-9, 6e4]` or NaN.
    Radius,
    /// `rho` is outside `[-1, 1]` or NaN.
    Rho,
    /// `matrix` has an entry beyond 1e18 in magnitude, or NaN.
    MatrixEntry,
    /// `matrix` has a negative eigenvalue.
    MatrixNotPositive,
    /// `mean` has a component beyond 1e9 in magnitude, or NaN.
    Mean,
    /// `variance` is outside `[0, 1e9]` or NaN.
    Variance,
    /// `limit` is negative or NaN.
    Limit,
    /// `weight` is negative, infinite or NaN, or the weights sum to zero.
    Weight,
    /// A reflectance at normal incidence is outside `[0, 1]` or NaN.
    Reflectance,
    /// `eta` is outside `(0, 1e9]`, `k` outside `[0, 1e9]`, or one is NaN.
    Index,
    /// Slices that belong together differ in length.
    Length,
    /// A half vector is not finite or does not point above the surface, so it has no slope.
    HalfVector,
    /// A position or direction has no length, or is infinite or NaN.
    Direction,
    /// A slope cap is outside `(0, 1e9]` or NaN.
    Cap,
    /// A map's size and the number of its texels differ, or it has none.
    MapSize,
    /// The distance of a height map's texels is outside `[1e-9, 1e9]`, of either sign, or NaN.
    Texel,
    /// `displacement` is beyond 1e9 in magnitude, or NaN.
    Displacement,
    /// The length of a mean normal is outside `(0, 1 + sqrt(3)/254]` or NaN.
    MeanLength,
    /// `exponent` is outside `[0, 1e9]` or NaN.
    Exponent,
    /// A grid's spacing is outside `(0, 10]` or NaN, or it has no node.
    Spacing,
    /// The range of a storage is outside `(1e-9, 1e9]`, of halves `(1e-9, 255]`, or NaN.
    Range,
    /// A share of roughness is outside `(0, 1]` or NaN.
    Fraction,
    /// `density` is outside `[1e-18, 1e18]` or NaN.
    Density,
    /// `variation` is outside `[0, 4]` or NaN.
    Variation,
    /// `share` is outside `[0, 1]` or NaN.
    Share,
    /// The number of facets per unit area is outside `[1e-18, 1e30]` or NaN.
    Facets,
    /// A size, the means or the lobes' width of a recipe for a dictionary is out of range.
    Recipe,
    /// Bytes are not a dictionary's.
    DictionaryMagic,
    /// Bytes are a dictionary's, of another version of the layout.
    DictionaryVersion,
    /// Bytes of a dictionary are fewer or more than its header says.
    DictionaryLength,
    /// Bytes of a dictionary are damaged.
    DictionaryChecksum,
    /// Bytes of a dictionary are undamaged, and hold what are no densities.
    DictionaryDensity,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Alpha => "alpha must lie in [0, 1e9]",
            Self::AlphaX => "alpha_x must lie in [0, 1e9]",
            Self::AlphaY => "alpha_y must lie in [0, 1e9]",
            Self::Angle => "angle must be finite",
            Self::Perceptual => "perceptual roughness must lie in [0, 1]",
            Self::SigmaX => "sigma_x must lie in [0, 1e9]",
            Self::SigmaY => "sigma_y must lie in [0, 1e9]",
            Self::Sigma => "sigma must lie in [0, 1e9]",
            Self::Width => "width must lie in [0, 1e9]",
            Self::Sharpness => "sharpness must lie in [1e-9, 1e18]",
            Self::Radius => "radius must lie in [2e-9, 6e4]",
            Self::Rho => "rho must lie in [-1, 1]",
            Self::MatrixEntry => "matrix entries must lie in [-1e18, 1e18]",
            Self::MatrixNotPositive => "matrix must be positive semi-definite",
            Self::Mean => "mean slope must lie in [-1e9, 1e9]",
            Self::Variance => "variance must lie in [0, 1e9]",
            Self::Limit => "limit must not be negative",
            Self::Weight => "weights must be finite and not negative, and not all zero",
            Self::Reflectance => "reflectance at normal incidence must lie in [0, 1]",
            Self::Index => "index of refraction: eta must lie in (0, 1e9], k in [0, 1e9]",
            Self::Length => "slices must have one length",
            Self::HalfVector => "half vector must be finite and point above the surface",
            Self::Direction => "direction or position must be finite and have a length",
            Self::Cap => "slope cap must lie in (0, 1e9]",
            Self::MapSize => "a map must have as many texels as its size says, and at least one",
            Self::Texel => "distances of texels must lie in [1e-9, 1e9], of either sign",
            Self::Displacement => "displacement must lie in [-1e9, 1e9]",
            Self::MeanLength => "length of a mean normal must lie in (0, 1 + sqrt(3)/254]",
            Self::Exponent => "exponent must lie in [0, 1e9]",
            Self::Spacing => "spacing of a grid must lie in (0, 10], and it needs a node",
            Self::Range => "range of stored slopes must lie in (1e-9, 1e9], of halves (1e-9, 255]",
            Self::Fraction => "fractions of roughness must lie in (0, 1]",
            Self::Density => "density of details must lie in [1e-18, 1e18]",
            Self::Variation => "variation must lie in [0, 4]",
            Self::Share => "share must lie in [0, 1]",
            Self::Facets => "density of facets must lie in [1e-18, 1e30]",
            Self::Recipe => {
                "a recipe needs 1 to 65536 marginals, 1 to 20 levels, intervals of a power of two from 8 to 4096, \
                 a width from 2/intervals to 0.5, and means that it knows"
            }
            Self::DictionaryMagic => "not the bytes of a dictionary",
            Self::DictionaryVersion => "bytes of a dictionary have another version than 1",
            Self::DictionaryLength => "bytes of a dictionary must be as many as its header says",
            Self::DictionaryChecksum => "bytes of a dictionary are damaged: their checksum differs",
            Self::DictionaryDensity => "nodes of a dictionary must be densities with an integral of 1",
        })
    }
}

impl core::error::Error for Error {}
