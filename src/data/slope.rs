//! Matrices, roughness, shapes, moments and lobes.
//!
//! Layer 6.

use crate::error::Error;
use crate::scalar::{Psd, Real};
use crate::slope::{AxisAligned, Isotropic, Lobe, Roughness, SlopeMoments};

data!("Psd", Psd<R> {
    entries: [R; 3] = psd.entries(),
    root_det: R = psd.root_det(),
} |psd| => checked(entries, root_det));

/// The matrix, if the determinant is that of the entries up to their rounding.
fn checked<R: Real>([xx, xy, yy]: [R; 3], root_det: R) -> Result<Psd<R>, Error> {
    let det = Psd::new(xx, xy, yy)?.det();
    let rounding = R::lit(8.0) * R::EPSILON * xx * yy + R::MIN_POSITIVE;
    if root_det >= R::ZERO && (root_det * root_det - det).abs() <= rounding {
        Ok(Psd::with_root_det([xx, xy, yy], root_det))
    } else {
        Err(Error::RootDet(root_det.into()))
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
