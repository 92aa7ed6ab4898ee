//! Filters make lobes of lobes, and numbers of directions, whatever the kernel.

use super::bytes::Bytes;
use super::valid;
use lobe::filter::engine::Engine;
use lobe::filter::{
    DiskKernel, SphericalGaussian, box_peak_alpha, gaussian_peak_alpha, projected_alpha,
};
use lobe::slope::Motion;
use lobe::{Anisotropic, Footprint, Ggx, Kernel, PixelFilter, Real, Roughness};

/// One filter on a lobe in the documented domain.
pub(super) fn widening<R: Real>(input: &mut Bytes) {
    let alpha = |input: &mut Bytes| match input.byte() % 8 {
        0 => R::ZERO,
        1 => R::ONE,
        _ => R::lit(input.log_between(1e-9, 1e9)),
    };
    let (x, y, angle) = (alpha(input), alpha(input), R::lit(input.between(-4.0, 4.0)));
    let base = Roughness::from_alphas(x, y, angle).expect("in range");
    let (u, v) = (input.pair::<R>(), input.pair::<R>());
    if !u.iter().chain(&v).all(|&x| valid::moderate(x)) {
        return;
    }
    let footprint = Footprint::from_slopes(u, v);
    let kernel = Kernel::of(&footprint, PixelFilter::KAPLANYAN);
    let disk = DiskKernel::of(u, v, PixelFilter::KAPLANYAN);
    let from = (x, y, angle, u, v);
    let widened = match input.byte() % 6 {
        0 => base.widened(&kernel),
        1 => base.peak_fitted(&kernel),
        2 => base.peak_matched(&kernel),
        3 => base.peak_matched_over(&footprint),
        4 => base.widened(&Kernel::of(&kernel.footprint(PixelFilter::BOX), PixelFilter::BOX)),
        _ => base.widened_on_disk(&disk),
    };
    valid::roughness(&widened, &from);
    let slack = R::ONE - R::lit(64.0) * R::EPSILON;
    let [before, after] = [base, widened].map(|r| r.matrix().trace());
    assert!(after >= before * slack, "{widened:?} is narrower than {base:?}, from {from:?}");
}

/// A light and a path: kernels and footprints of numbers.
pub(super) fn light<R: Real>(input: &mut Bytes) {
    let (wo, wi, sharpness) = (input.triple::<R>(), input.triple::<R>(), input.number::<R>());
    let unit = lobe::slope::direction::normalize;
    if let Ok(light) = SphericalGaussian::new(wi, sharpness) {
        let wo = unit(wo);
        valid::kernel(&light.kernel(wo), input, &(wo, light));
        valid::psd(&light.disk_kernel(wo).covariance(), &(wo, light));
        let integral = light.integral();
        assert!(integral > R::ZERO && integral <= R::lit(12.6), "{integral} of {light:?}");
    }
    let motion = |input: &mut Bytes| Motion {
        half_vector: input.triple(),
        normal: input.pair(),
        spin: input.number::<R>(),
    };
    let (across, down) = (motion(input), motion(input));
    if let Ok(footprint) = Footprint::from_motion(wi, &across, &down) {
        let finite = footprint.u.iter().chain(&footprint.v).all(|x| x.is_finite());
        assert!(finite, "{footprint:?} from {wi:?}, {across:?}, {down:?}");
    }
}

/// Alphas in, alphas out: never less, never NaN.
pub(super) fn alphas<R: Real>(input: &mut Bytes) {
    let (alpha, added) = (input.number::<R>(), input.number::<R>());
    let results = [
        ("box", box_peak_alpha(alpha, added)),
        ("gaussian", gaussian_peak_alpha(alpha, added)),
        ("projected", projected_alpha(alpha, added)),
    ];
    let known = valid::in_domain(alpha);
    let lowest = alpha * (R::ONE - R::lit(16.0) * R::EPSILON);
    for (name, result) in results {
        if let Ok(wider) = result {
            let sound = wider.is_finite() && (wider >= lowest || !known);
            assert!(sound, "{name}: {wider} from {alpha} and {added}");
        }
    }
    let (u, v) = (input.triple::<R>(), input.triple::<R>());
    let engine = Engine::ALL[usize::from(input.byte()) % Engine::ALL.len()];
    if let Ok(shipped) = engine.alpha(alpha, u, v) {
        assert!(
            shipped.is_finite() && shipped >= R::ZERO,
            "{engine:?}: {shipped} from {alpha}, {u:?}, {v:?}"
        );
    }
}

/// The BRDF over a footprint: not negative, and a number.
pub(super) fn shaded<R: Real>(input: &mut Bytes) {
    let alpha = |input: &mut Bytes| R::lit(input.log_between(1e-9, 1e3));
    let base = Roughness::from_alphas(alpha(input), alpha(input), R::lit(input.between(-4.0, 4.0)));
    let ggx = Ggx::new(Anisotropic::new(base.expect("in range")));
    let (wo, wi) = (valid::direction::<R>(input), valid::direction::<R>(input));
    let footprint = Footprint::from_slopes(input.pair::<R>(), input.pair::<R>());
    let brdf = ggx.brdf_over(wo, wi, &footprint);
    assert!(
        brdf >= R::ZERO && brdf.is_finite(),
        "{brdf} of {base:?} for {wo:?}, {wi:?}, {footprint:?}"
    );
}
