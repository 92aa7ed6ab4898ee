//! Twins of `src/material/multilobe`, `src/shade/multilobe.rs`, `src/ndf/cavity.rs` and
//! `src/slope/mean_frame.rs`.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex};

use lobe::material::Fresnel;
use lobe::material::multilobe::{Dictionary, DirectionSample, LobeMeans, PatchNdf, Recipe};
use lobe::ndf::{cavity_masking, cavity_masking_shadowing};
use lobe::shade::MultiLobeMaterial;
use lobe::slope::MeanFrame;
use lobe::{Kernel, Real};

use super::glint::SIZES;
use super::slope::moments;
use super::value::{Flat, Reader};

/// What the shaders' buffer holds: small enough for every driver, with every level that matters.
const RECIPE: Recipe = Recipe {
    marginals: 48,
    levels: 8,
    intervals: 64,
    width: 0.0625,
    means: LobeMeans::Stratified,
    seed: 1,
};

/// How often a pixel has a cell that decides otherwise.
///
/// A cell decides its level, by the floor of a sum: a deviation of 1.6 in the mean after some 30
/// roundings, and a logarithm of a density, up to 60 after 4, on either machine: (1.6 * 30 +
/// 60 * 4) * 2 * 2^-24 = 3.5e-5. A pixel has 15 cells if it is square, 30 in the mean over these
/// inputs.
const LEVELS: f64 = 30.0 * 3.5e-5;

/// The same of one that is drawn: a cell by a sum of up to 60 shares, a piece of a kernel and a
/// side by a few numbers each.
const DRAWN: f64 = LEVELS + (60.0 + 20.0) * 2.0 * 6e-8;

/// The dictionary in any precision, made once.
pub(super) fn dictionary<R: Real>() -> &'static Dictionary<R> {
    type Made = HashMap<TypeId, &'static (dyn Any + Send + Sync)>;
    static MADE: LazyLock<Mutex<Made>> = LazyLock::new(Mutex::default);
    let mut made = MADE.lock().expect("no thread has panicked here");
    let one = made.entry(TypeId::of::<R>()).or_insert_with(|| {
        Box::leak(Box::new(Dictionary::<R>::new(&RECIPE).expect("a recipe in range")))
    });
    one.downcast_ref().expect("of the type that it is listed under")
}

/// A surface under a pixel.
fn pixel<R: Real>(x: &mut Reader<'_>) -> PatchNdf<'static, R> {
    let facets = x.facets::<R>();
    facets.ndf(dictionary(), &x.patch())
}

impl<R: Real> Flat<R> for PatchNdf<'_, R> {
    const WGSL: &'static str = "put(0u, f32(r.cells.exponent)); put(1u, r.cells.coarser);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend([R::lit(f64::from(self.exponent())), self.coarser()]);
    }
}

/// Without the pdf, which has a twin of its own: of a direction that is off by a rounding it has no
/// bound.
impl<R: Real> Flat<R> for Option<DirectionSample<R>> {
    const WGSL: &'static str =
        "put(0u, r.wi.x); put(1u, r.wi.y); put(2u, r.wi.z); put(3u, r.weight);";
    fn flat(self, out: &mut Vec<R>) {
        let (wi, weight) =
            self.map_or(([R::ZERO; 3], R::ZERO), |sampled| (sampled.wi, sampled.weight));
        out.extend(wi.into_iter().chain([weight]));
    }
}

super::twins! {
    "mean_frame_of" (Mean, Direction) "lobe_mean_frame_to_local(lobe_mean_frame_of($0), \
        $1)" => |x| {
        let frame = MeanFrame::of(x.vec::<R, 2>());
        frame.to_local(x.vec::<R, 3>())
    };
    "mean_frame_to_local" (Mean, Direction) "lobe_mean_frame_to_local(lobe_mean_frame_of($0), \
        $1)" => |x| {
        let frame = MeanFrame::of(x.vec::<R, 2>());
        frame.to_local(x.vec::<R, 3>())
    };
    "mean_frame_to_tangent" (Mean, Direction) "lobe_mean_frame_to_tangent(lobe_mean_frame_of($0), \
        $1)" => |x| {
        let frame = MeanFrame::of(x.vec::<R, 2>());
        frame.to_tangent(x.vec::<R, 3>())
    };
    "mean_frame_jacobian" (Mean) "lobe_mean_frame_jacobian(lobe_mean_frame_of($0))" => |x| {
        MeanFrame::of(x.vec::<R, 2>()).jacobian()
    };
    "mean_frame_moments" (Mean, Mean, Psd)
        "lobe_mean_frame_moments(lobe_mean_frame_of($0), lobe_slope_moments_new($1, $2))" => |x| {
        let frame = MeanFrame::of(x.vec::<R, 2>());
        frame.moments(&moments(x))
    };
    "cavity_masking" (Pair) "lobe_cavity_masking($0)" => |x| {
        let (w, m) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        cavity_masking(w, m)
    };
    "cavity_masking_shadowing" (Pair, Direction) "lobe_cavity_masking_shadowing($0, $1)" => |x| {
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        cavity_masking_shadowing(wo, wi, x.vec::<R, 3>())
    };
    "dictionary_marginal" (Marginal, Slope)
        "lobe_marginal_density(lobe_dictionary_marginal(LobeDictionary(48u, 8u, 64u), $0), \
            $1.x)" => |x| {
        let marginal = dictionary::<R>().marginal(x.word(), x.word());
        marginal.density(x.f())
    };
    "marginal_density" (Marginal, Deviation)
        "lobe_marginal_density(lobe_dictionary_marginal(LobeDictionary(48u, 8u, 64u), $0), \
            $1)" => |x| {
        let marginal = dictionary::<R>().marginal(x.word(), x.word());
        marginal.density(x.f())
    };
    "marginal_mean" (Marginal, Deviation, Size)
        "lobe_marginal_mean(lobe_dictionary_marginal(LobeDictionary(48u, 8u, 64u), $0), $1, \
            $2)" => |x| {
        let marginal = dictionary::<R>().marginal(x.word(), x.word());
        marginal.mean(x.f(), x.f())
    };
    "marginal_quantile" (Marginal, Unit)
        "lobe_marginal_quantile(lobe_dictionary_marginal(LobeDictionary(48u, 8u, 64u), $0), \
            $1)" => |x| {
        let marginal = dictionary::<R>().marginal(x.word(), x.word());
        marginal.quantile(x.f())
    };
    "multi_lobe_new" flips SIZES (Facets, Patch)
        "lobe_multi_lobe_ndf(lobe_multi_lobe_new($0.roughness, $0.density), LobeDictionary(48u, \
            8u, 64u), $1)" => |x| {
        pixel::<R>(x)
    };
    "multi_lobe_facet_size" (Facets) "lobe_multi_lobe_facet_size($0)" => |x| {
        x.facets::<R>().facet_size()
    };
    "multi_lobe_ndf" flips SIZES (Facets, Patch)
        "lobe_multi_lobe_ndf($0, LobeDictionary(48u, 8u, 64u), $1)" => |x| pixel::<R>(x);
    "patch_ndf_over" flips LEVELS (Facets, Patch, Mean, Psd, Slope)
        "lobe_patch_ndf_slope_pdf(lobe_patch_ndf_over(patched($0, $1), lobe_slope_moments_new($2, \
            $3)), $4)"
        => |x| {
        let pixel = pixel::<R>(x);
        pixel.over(&moments(x)).slope_pdf(x.vec::<R, 2>())
    };
    "patch_ndf_widened" flips LEVELS (Facets, Patch, Blurring, Slope)
        "lobe_patch_ndf_slope_pdf(lobe_patch_ndf_widened(patched($0, $1), $2), $3)"
        => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        pixel.slope_pdf(x.vec::<R, 2>())
    };
    "patch_ndf_smooth" (Facets, Patch, Kernel, Slope)
        "lobe_beckmann_slope_pdf(lobe_anisotropic_normal(
            lobe_patch_ndf_smooth(lobe_patch_ndf_widened(patched($0, $1), $2)), vec3f(-$3, 1.0)
        ))"
        => |x| {
        let pixel = pixel::<R>(x);
        pixel.widened(&x.kernel()).smooth().slope_pdf(x.vec::<R, 2>())
    };
    "patch_ndf_slope_pdf" flips LEVELS (Facets, Patch, Slope)
        "lobe_patch_ndf_slope_pdf(patched($0, $1), $2)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.slope_pdf(x.vec::<R, 2>())
    };
    "patch_ndf_d" flips LEVELS (Facets, Patch, Half)
        "lobe_patch_ndf_d(patched($0, $1), $2)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.d(x.vec::<R, 3>())
    };
    "patch_ndf_brdf" flips LEVELS (Facets, Patch, Blurring, Mirrored)
        "lobe_patch_ndf_brdf(lobe_patch_ndf_widened(patched($0, $1), $2), $3)"
        => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        pixel.brdf(x.vec::<R, 3>(), x.vec::<R, 3>())
    };
    "patch_ndf_pdf" flips LEVELS (Facets, Patch, Blurring, Mirrored)
        "lobe_patch_ndf_pdf(lobe_patch_ndf_widened(patched($0, $1), $2), $3)" => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        pixel.pdf(x.vec::<R, 3>(), x.vec::<R, 3>())
    };
    "patch_ndf_sample_slope" flips DRAWN (Facets, Patch, Blurring, Numbers)
        "lobe_patch_ndf_sample_slope(lobe_patch_ndf_widened(patched($0, $1), $2), $3)" => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        pixel.sample_slope([0; 7].map(|_| x.f()))
    };
    "patch_ndf_sample" flips DRAWN (Facets, Patch, Blurring, Direction, Numbers)
        "lobe_patch_ndf_sample(lobe_patch_ndf_widened(patched($0, $1), $2), $3, $4)" => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        let wo = x.vec::<R, 3>();
        pixel.sample(wo, [0; 7].map(|_| x.f()))
    };
    "multi_lobe_shading_evaluate" flips LEVELS (Facets, Patch, Tilt, Relief, Mirrored, Reflectance)
        "lobe_multi_lobe_shading_evaluate(
            lobe_patch_ndf_over(patched($0, $1), lobe_slope_moments_new($2, $3)),
            lobe_mean_frame_of($2), $4, lobe_fresnel_schlick($5, lobe_half_cosine($4)))" => |x| {
        let (facets, patch) = (x.facets::<R>(), x.patch());
        let moments = moments(x);
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        let fresnel = Fresnel::schlick(x.vec()).expect("in range");
        let material = MultiLobeMaterial { facets, fresnel };
        material.bake(dictionary(), &patch, &moments, &Kernel::default()).evaluate(wo, wi)
    };
}
