//! Matrices, roughness, shapes, moments and lobes.
//!
//! Layer 6.

use crate::error::Error;
use crate::scalar::{Psd, Real};
use crate::slope::{AxisAligned, Isotropic, Lobe, Roughness, SlopeMoments};

data!("Psd", Psd<R> {
    #[serde(skip_serializing_if = "Option::is_none")]
    entries: Option<[R; 3]> = None,
    #[serde(skip_serializing_if = "Option::is_none")]
    cholesky: Option<[R; 3]> = Some(psd.cholesky()),
} |psd| => checked(entries, cholesky));

/// The matrix of its factor, as it is written, or of its entries, as people write them.
///
/// Sums and products may leave the range of [`Psd::from_cholesky`], so any finite factor passes.
fn checked<R: Real>(entries: Option<[R; 3]>, factor: Option<[R; 3]>) -> Result<Psd<R>, Error> {
    match (entries, factor) {
        (None, Some(factor)) => Psd::of_factor(factor),
        (Some([xx, xy, yy]), None) => Psd::new(xx, xy, yy),
        _ => Err(Error::MatrixGiven),
    }
}

data!("Roughness", Roughness<R> {
    matrix: Psd<R> = roughness.matrix(),
} |roughness| => Ok(Self::from_matrix(matrix)));

data!("Isotropic", Isotropic<R> { alpha: R = shape.alpha() } |shape| => Self::new(alpha));

data!("AxisAligned", AxisAligned<R> {
    alpha_x: R = shape.alphas()[0],
    alpha_y: R = shape.alphas()[1],
} |shape| => Self::new(alpha_x, alpha_y));

data!("SlopeMoments", SlopeMoments<R> {
    mean: [R; 2] = moments.mean(),
    covariance: Psd<R> = moments.covariance(),
} |moments| => Self::new(mean, covariance));

data!("Lobe", Lobe<R> {
    mean: [R; 2] = lobe.mean(),
    roughness: Roughness<R> = lobe.roughness(),
} |lobe| => Self::new(mean, roughness));
