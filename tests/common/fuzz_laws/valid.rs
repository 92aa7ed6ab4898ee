//! What makes a constructed value valid.

use super::bytes::Bytes;
use core::fmt::Debug;
use lobe::{
    Beckmann, Distribution, Ggx, Kernel, Lobe, LobeShape, Ndf, Psd, Real, Roughness, SlopeMoments,
};

/// Zero, or in the range of roughness that the library answers for.
pub(crate) fn in_domain<R: Real>(alpha: R) -> bool {
    alpha == R::ZERO || (R::lit(1e-9)..=R::lit(1e9)).contains(&alpha)
}

/// A slope that the library answers for.
pub(crate) fn moderate<R: Real>(slope: R) -> bool {
    slope.abs() <= R::lit(1e9)
}

/// Entries finite, eigenvalues not negative, axis of unit length. `from`: what it was made of.
pub(crate) fn psd<R: Real>(matrix: &Psd<R>, from: &dyn Debug) {
    let [xx, xy, yy] = matrix.entries();
    let finite = xx.is_finite() && xy.is_finite() && yy.is_finite();
    assert!(finite && matrix.root_det().is_finite(), "{matrix:?} is not finite, from {from:?}");
    assert!(
        xx >= R::ZERO && yy >= R::ZERO && matrix.root_det() >= R::ZERO,
        "{matrix:?} is not positive, from {from:?}"
    );
    // Beyond, the larger eigenvalue of finite entries need not be finite.
    if matrix.trace() <= R::lit(0.25) * R::MAX {
        let eigen = matrix.eigen();
        let slack = R::lit(16.0) * R::EPSILON;
        // Below alpha = 1e-9 the determinant underflows in f32, and with it the order.
        let ordered = eigen.minor <= eigen.major * (R::ONE + slack);
        let underflows = eigen.major < R::lit(1e-18);
        assert!(
            eigen.minor >= R::ZERO && (ordered || underflows) && eigen.major.is_finite(),
            "{eigen:?} of {matrix:?}, from {from:?}"
        );
        let [x, y] = eigen.axis;
        assert!(
            (x * x + y * y - R::ONE).abs() <= slack,
            "axis of {eigen:?} of {matrix:?}, from {from:?}"
        );
    }
}

/// The matrix is valid, and so is what is read back from it.
pub(crate) fn roughness<R: Real>(value: &Roughness<R>, from: &dyn Debug) {
    psd(&value.matrix(), from);
    psd(&value.covariance(), from);
    if value.matrix().trace() <= R::lit(0.25) * R::MAX {
        let alphas = value.alphas();
        assert!(
            alphas.major.is_finite()
                && alphas.minor >= R::ZERO
                && alphas.angle.abs() <= R::HALF * R::PI,
            "{alphas:?} of {value:?}, from {from:?}"
        );
    }
}

/// Mean finite, roughness valid, and both distributions over it.
pub(crate) fn lobe<R: Real>(value: &Lobe<R>, input: &mut Bytes, from: &dyn Debug) {
    let mean = value.mean();
    assert!(mean[0].is_finite() && mean[1].is_finite(), "{value:?} from {from:?}");
    roughness(&value.roughness(), from);
    let alphas = value.roughness().alphas();
    let known =
        in_domain(alphas.major) && in_domain(alphas.minor) && mean.iter().all(|&x| moderate(x));
    shape(value.shape(), known, input, &(value, from));
}

/// Moments with a finite mean and a valid covariance.
pub(crate) fn moments<R: Real>(value: &SlopeMoments<R>, from: &dyn Debug) {
    let mean = value.mean();
    assert!(mean[0].is_finite() && mean[1].is_finite(), "{value:?} from {from:?}");
    psd(&value.covariance(), from);
}

/// A kernel with a valid covariance, capped ones within their limit.
pub(crate) fn kernel<R: Real>(value: &Kernel<R>, input: &mut Bytes, from: &dyn Debug) {
    psd(&value.covariance(), from);
    let limit = input.number::<R>().abs();
    if limit >= R::ZERO && value.covariance().trace() <= R::lit(0.25) * R::MAX {
        let capped = value.capped(limit);
        psd(&capped.covariance(), &(value, limit, from));
        let major = capped.covariance().eigen().major;
        assert!(
            major <= R::HALF * limit * (R::ONE + R::lit(16.0) * R::EPSILON) + R::MIN_POSITIVE,
            "{capped:?} exceeds {limit}, from {value:?}, {from:?}"
        );
    }
}

/// Both distributions over a shape, at slopes and directions from the input. Never NaN and never
/// negative; finite too if the shape is `known` to lie in the documented domain.
pub(crate) fn shape<S: LobeShape>(shape: S, known: bool, input: &mut Bytes, from: &dyn Debug) {
    let slope = [0; 2].map(|_| {
        let size = S::Scalar::lit(input.log_between(1e-9, 1e9));
        [size, -size, S::Scalar::ZERO][usize::from(input.byte() % 3)]
    });
    let (wo, wi) = (direction(input), direction(input));
    distribution(Ggx::new(shape), slope, wo, wi, known, &("GGX", from));
    distribution(Beckmann::new(shape), slope, wo, wi, known, &("Beckmann", from));
}

/// Unit up to rounding, in either hemisphere, the horizon and the axes included.
pub(crate) fn direction<R: Real>(input: &mut Bytes) -> [R; 3] {
    let z = input.log_between(1e-6, 1.0);
    let z = [z, -z, 0.0][usize::from(input.byte() % 3)];
    let angle = input.between(0.0, core::f64::consts::TAU);
    let radius = (1.0 - z * z).sqrt();
    [radius * angle.cos(), radius * angle.sin(), z].map(R::lit)
}

fn distribution<D: Distribution, S: LobeShape>(
    ndf: Ndf<D, S>,
    slope: [S::Scalar; 2],
    wo: [S::Scalar; 3],
    wi: [S::Scalar; 3],
    known: bool,
    from: &dyn Debug,
) {
    let one = S::Scalar::ONE;
    let results = [
        ("slope_pdf", ndf.slope_pdf(slope), None),
        ("d", ndf.d(wo), None),
        ("brdf", ndf.brdf(wo, wi), None),
        ("projected_area", ndf.projected_area(wo), None),
        ("lambda", ndf.lambda(wo), None),
        ("g1", ndf.g1(wo), Some(one)),
        ("g2", ndf.g2(wo, wi), Some(one)),
        ("visibility", ndf.visibility(wo, wi), None),
    ];
    for (name, value, limit) in results {
        let valid = value >= S::Scalar::ZERO
            && (value.is_finite() || !known)
            && limit.is_none_or(|limit| value <= limit);
        assert!(valid, "{name} = {value} at {slope:?}, wo = {wo:?}, wi = {wi:?}; {from:?}");
    }
}
