//! Matrices, roughness, shapes, moments and lobes.
//!
//! Layer 6.

use crate::error::{Error, Value};
use crate::scalar::exact::difference_of_products;
use crate::scalar::{Psd, Real};
use crate::slope::{AxisAligned, Isotropic, Lobe, Roughness, SlopeMoments};

data!("Psd", Psd<R> {
    entries: [R; 3] = psd.entries(),
    root_det: Option<R> = Some(psd.root_det()),
} |psd| => checked(entries, root_det));

/// The matrix; its determinant, where it is known better than by the entries, is theirs up to their
/// rounding.
///
/// Sums and products may leave the range of [`Psd::new`], so any finite entries pass.
fn checked<R: Real>(entries: [R; 3], root_det: Option<R>) -> Result<Psd<R>, Error> {
    let [xx, xy, yy] = entries;
    let Some(root_det) = root_det else { return Psd::new(xx, xy, yy) };
    if let Some(&entry) = entries.iter().find(|entry| !entry.is_finite()) {
        return Err(Error::MatrixEntry(entry.into()));
    }
    // In units of the larger diagonal entry, so that no product leaves the range of the precision.
    let scale = xx.max(yy);
    let [a, b, c, root] = [xx, xy, yy, root_det].map(|x| (x / scale.max(R::MIN_POSITIVE)).kept());
    let det = difference_of_products(a, c, b, b);
    let rounding = R::lit(64.0) * R::EPSILON * (a * c + b * b);
    if !(xx >= R::ZERO && yy >= R::ZERO && det >= -rounding) {
        return Err(Error::MatrixNotPositive(entries.map(Value::from)));
    }
    // A quotient below the smallest normal number has no digits.
    if root >= R::ZERO && (root * root - det).abs() <= rounding + R::MIN_POSITIVE {
        Ok(Psd::with_root_det(entries, root_det))
    } else {
        let entries = entries.map(Value::from);
        Err(Error::RootDet { root_det: root_det.into(), entries })
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
