//! What usual scenes ask for.
//!
//! Layer 0.

use super::item::Item;
use super::text::source;
use alloc::string::String;

/// A usual scene, and the items that its shaders need.
///
/// ```
/// use lobe::wgsl::Preset;
/// let sizes: Vec<usize> = Preset::ALL.iter().map(|preset| preset.source().len()).collect();
/// assert!(sizes[0] < sizes[1]); // no filter, then one
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Preset {
    /// Isotropic GGX, no filter: what every other preset adds to.
    Plain,
    /// A G-buffer's one roughness from the quad's normals, then isotropic GGX.
    IsotropicDeferred,
    /// A G-buffer's two roughnesses from the quad's shading frames, then GGX along the axes.
    AnisotropicDeferred,
    /// Forward GGX, widened by the quad's kernel on the slope plane.
    ForwardVariance,
    /// Forward GGX, widened by the quad's kernel on the projected disk.
    ForwardProjected,
    /// Forward GGX, widened to the right peak.
    ForwardPeak,
    /// Forward GGX, averaged over the quad's parallelogram.
    ForwardExact,
    /// Forward GGX, averaged over the quad's parallelogram by estimates without a branch, which add
    /// to [`Preset::Plain`] about a fortieth of what [`Preset::ForwardExact`] adds in instructions.
    ForwardLanes,
    /// Forward Beckmann, widened by the quad's kernel.
    ForwardBeckmann,
    /// A ray tracer's GGX: ray cones, positions and curvature instead of quads.
    RayTraced,
    /// A plane with LEAN moments in textures, Beckmann, widened by the quad's kernel.
    LeanPlane,
    /// A displaced surface with LEAN moments in unorm textures: LEADR for lights at points, and the
    /// facets of a grid.
    Displaced,
    /// GGX under a spherical Gaussian light and the quad's kernel.
    AreaLight,
    /// The facade with Schlick's reflectance: isotropic GGX, widened by the quad's kernel.
    Facade,
    /// Forward glints, in the quad's patch and widened by its kernel.
    #[cfg(feature = "glint")]
    Glints,
    /// Forward shading of a surface of facets, in the quad's patch and under its kernel on the
    /// projected disk.
    #[cfg(feature = "glint")]
    ManyLobes,
}

impl Preset {
    /// Every preset, without a filter first; those of features last.
    pub const ALL: &'static [Self] = &[
        Self::Plain,
        Self::IsotropicDeferred,
        Self::AnisotropicDeferred,
        Self::ForwardVariance,
        Self::ForwardProjected,
        Self::ForwardPeak,
        Self::ForwardExact,
        Self::ForwardLanes,
        Self::ForwardBeckmann,
        Self::RayTraced,
        Self::LeanPlane,
        Self::Displaced,
        Self::AreaLight,
        Self::Facade,
        #[cfg(feature = "glint")]
        Self::Glints,
        #[cfg(feature = "glint")]
        Self::ManyLobes,
    ];

    /// The preset's name, as a command line takes it.
    ///
    /// ```
    /// assert_eq!(lobe::wgsl::Preset::LeanPlane.name(), "lean_plane");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::IsotropicDeferred => "isotropic_deferred",
            Self::AnisotropicDeferred => "anisotropic_deferred",
            Self::ForwardVariance => "forward_variance",
            Self::ForwardProjected => "forward_projected",
            Self::ForwardPeak => "forward_peak",
            Self::ForwardExact => "forward_exact",
            Self::ForwardLanes => "forward_lanes",
            Self::ForwardBeckmann => "forward_beckmann",
            Self::RayTraced => "ray_traced",
            Self::LeanPlane => "lean_plane",
            Self::Displaced => "displaced",
            Self::AreaLight => "area_light",
            Self::Facade => "facade",
            #[cfg(feature = "glint")]
            Self::Glints => "glints",
            #[cfg(feature = "glint")]
            Self::ManyLobes => "many_lobes",
        }
    }

    /// The items.
    ///
    /// ```
    /// use lobe::wgsl::{Item, Preset};
    /// assert!(Preset::ForwardExact.items().contains(&Item::GgxBrdfOver));
    /// ```
    #[allow(clippy::too_many_lines, reason = "a table")]
    pub const fn items(self) -> &'static [Item] {
        use Item as I;
        match self {
            Self::Plain => &[I::IsotropicNew, I::IsotropicPair, I::GgxBrdf],
            Self::IsotropicDeferred => &[
                I::FragmentDeferredAlpha,
                I::PixelFilterTokuyoshiKaplanyan,
                I::KernelAlphaSquaredLimit,
                I::IsotropicNew,
                I::IsotropicPair,
                I::GgxBrdf,
            ],
            Self::AnisotropicDeferred => &[
                I::QuadNormalFootprint,
                I::KaplanyanDeferredAlphas,
                I::PixelFilterKaplanyan,
                I::KernelAlphaSquaredLimit,
                I::AxisAlignedNew,
                I::AxisAlignedPair,
                I::GgxBrdf,
            ],
            Self::ForwardVariance => &[
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::IsotropicNew,
                I::KernelWiden,
                I::WidenedPair,
                I::GgxBrdf,
            ],
            Self::ForwardProjected => &[
                I::FragmentDiskKernel,
                I::PixelFilterTokuyoshiKaplanyan,
                I::IsotropicNew,
                I::DiskKernelWiden,
                I::WidenedPair,
                I::GgxBrdf,
            ],
            Self::ForwardPeak => &[
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::IsotropicNew,
                I::KernelWidenToPeak,
                I::WidenedPair,
                I::GgxBrdf,
            ],
            Self::ForwardExact => &[
                I::FragmentFootprint,
                I::RoughnessFromAlpha,
                I::LobeCentered,
                I::LobeShape,
                I::GgxBrdfOver,
            ],
            Self::ForwardLanes => &[
                I::FragmentFootprint,
                I::IsotropicNew,
                I::IsotropicPairOver,
                I::GgxBrdfOverInLanes,
            ],
            Self::ForwardBeckmann => &[
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::IsotropicNew,
                I::KernelWiden,
                I::WidenedPair,
                I::BeckmannBrdf,
            ],
            Self::RayTraced => &[
                I::VertexAt,
                I::RayConeSteps,
                I::PathMotion,
                I::PathHalfVector,
                I::FootprintFromMotion,
                I::KernelOf,
                I::PixelFilterBox,
                I::IsotropicNew,
                I::KernelWiden,
                I::WidenedPair,
                I::GgxBrdf,
            ],
            Self::LeanPlane => &[
                I::SlopeMomentsFromRaw,
                I::SlopeMomentsLobe,
                I::RoughnessFromAlpha,
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::LobeWidened,
                I::LobeShape,
                I::NonCenteredPair,
                I::BeckmannBrdf,
            ],
            Self::Displaced => &[
                I::SlopeMomentsFromUnorm,
                I::SlopeMomentsLobe,
                I::RoughnessFromAlpha,
                I::LeadrNew,
                I::LeadrBrdfCos,
                I::LeadrFacet,
                I::LeadrArtificialFacet,
                I::CubeLod,
            ],
            Self::AreaLight => &[
                I::SphericalGaussianNew,
                I::SphericalGaussianIntegral,
                I::SphericalGaussianKernel,
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::KernelAdd,
                I::IsotropicNew,
                I::KernelWiden,
                I::WidenedPair,
                I::GgxBrdf,
            ],
            Self::Facade => &[
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::IsotropicNew,
                I::KernelWiden,
                I::WidenedPair,
                I::HalfCosine,
                I::FresnelSchlick,
                I::GgxEvaluate,
            ],
            #[cfg(feature = "glint")]
            Self::Glints => &[
                I::BiscaleFromFractions,
                I::GlintsNew,
                I::FragmentPatch,
                I::GlintsNdf,
                I::FragmentFootprint,
                I::KernelOf,
                I::PixelFilterBox,
                I::GlintNdfWidened,
                I::GlintNdfBrdf,
            ],
            #[cfg(feature = "glint")]
            Self::ManyLobes => &[
                I::RoughnessFromAlpha,
                I::MultiLobeNew,
                I::FragmentPatch,
                I::MultiLobeNdf,
                I::FragmentDiskKernel,
                I::PixelFilterBox,
                I::PatchNdfWidened,
                I::PatchNdfBrdf,
            ],
        }
    }

    /// The text of the items and of all they use.
    ///
    /// ```
    /// use lobe::wgsl::{Preset, source};
    /// assert_eq!(Preset::Plain.source(), source(Preset::Plain.items()));
    /// ```
    pub fn source(self) -> String {
        source(self.items())
    }
}
