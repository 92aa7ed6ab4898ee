//! The table of items.
//!
//! Floor 0. One line an item: variant, kind, name, and the Rust item that it is the twin of. `tests/mirror.rs` holds the
//! table to the texts.

/// Expands the table: the enum, its list, the entries, and the names behind a feature that is off.
macro_rules! items {
    (
        $($variant:ident: $kind:tt $name:literal $(, $twin:literal)?;)*
        #[feature($feature:literal)]
        $($gated:ident: $gated_kind:tt $gated_name:literal $(, $gated_twin:literal)?;)*
    ) => {
        /// A function or constant of the mirror, or a whole file of it, to ask [`source`](super::source) for.
        ///
        /// A file stands for all that it declares. Structures come with what uses them.
        ///
        /// ```
        /// use lobe::wgsl::Item;
        /// assert!(Item::ALL.iter().all(|item| Item::from_name(item.name()) == Ok(*item)));
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Item {
            $(#[doc = concat!("The ", stringify!($kind), " `", $name, "`" $(, ", twin of `", $twin, "`")?, ".")] $variant,)*
            $(
                #[cfg(feature = $feature)]
                #[doc = concat!("The ", stringify!($gated_kind), " `", $gated_name, "`" $(, ", twin of `", $gated_twin, "`")?, ".")]
                $gated,
            )*
        }

        impl Item {
            /// Every item, in the order of the files.
            pub const ALL: &'static [Self] = &[
                $(Self::$variant,)*
                $(#[cfg(feature = $feature)] Self::$gated,)*
            ];

            /// Kind, name and twin; no twin is an empty one.
            pub(super) fn entry(self) -> (Kind, &'static str, &'static str) {
                match self {
                    $(Self::$variant => (kind!($kind), $name, concat!($($twin)?)),)*
                    $(
                        #[cfg(feature = $feature)]
                        Self::$gated => (kind!($gated_kind), $gated_name, concat!($($gated_twin)?)),
                    )*
                }
            }
        }

        /// Names behind a feature, and the feature.
        #[cfg(not(feature = $feature))]
        pub(super) const OFF: &[(&str, &str)] = &[$(($gated_name, $feature),)*];
        #[cfg(feature = $feature)]
        pub(super) const OFF: &[(&str, &str)] = &[];
    };
}

/// What an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Function,
    Constant,
    File,
}

/// The kind of a keyword.
macro_rules! kind {
    (fn) => {
        Kind::Function
    };
    (const) => {
        Kind::Constant
    };
    (file) => {
        Kind::File
    };
}

items! {
    Pi: const "PI", "Real::PI";
    Epsilon: const "EPSILON", "Real::EPSILON";
    MinPositive: const "MIN_POSITIVE", "Real::MIN_POSITIVE";
    MaxConstant: const "MAX", "Real::MAX";
    Largest: const "LARGEST", "Real::LARGEST";
    Min: fn "min", "Real::min";
    Max: fn "max", "Real::max";
    IsFinite: fn "is_finite", "Real::is_finite";
    ScalarReal: file "scalar_real";
    Exp: fn "exp", "Real::exp";
    ScalarExp: file "scalar_exp";
    Ln: fn "ln", "Real::ln";
    ScalarLn: file "scalar_ln";
    Atan: fn "atan", "Real::atan";
    AtanOf: fn "atan_of", "Real::atan2";
    ScalarAtan: file "scalar_atan";
    Erfcx: fn "erfcx", "Real::erfcx";
    Ierfcx: fn "ierfcx", "Real::ierfcx";
    Erfc: fn "erfc", "Real::erfc";
    ScalarErfc: file "scalar_erfc";
    ScalarExpint: file "scalar_expint";
    ScalarExact: file "scalar_exact";
    ScalarQuadrature: file "scalar_quadrature";
    PsdNew: fn "psd_new", "Psd::new";
    PsdNearest: fn "psd_nearest", "Psd::nearest";
    PsdOuterSum: fn "psd_outer_sum", "Psd::outer_sum";
    PsdDet: fn "psd_det", "Psd::det";
    PsdTrace: fn "psd_trace", "Psd::trace";
    PsdIsSingular: fn "psd_is_singular", "Psd::is_singular";
    PsdScaled: fn "psd_scaled", "Psd::scaled";
    PsdPlus: fn "psd_plus", "Psd::plus";
    PsdQuadratic: fn "psd_quadratic", "Psd::quadratic";
    PsdCholesky: fn "psd_cholesky", "Psd::cholesky";
    PsdEigen: fn "psd_eigen", "Psd::eigen";
    PsdCapped: fn "psd_capped", "Psd::capped";
    ScalarPsd: file "scalar_psd";
    HalfVector: fn "half_vector", "half_vector";
    Normalize: fn "normalize", "normalize";
    SlopeOf: fn "slope_of", "slope_of";
    NormalOf: fn "normal_of", "normal_of";
    FromDisk: fn "from_disk", "from_disk";
    Reflect: fn "reflect", "reflect";
    SlopeDirection: file "slope_direction";
    SphereToSlope: fn "sphere_to_slope", "sphere_to_slope";
    SphereToDisk: fn "sphere_to_disk", "sphere_to_disk";
    DiskToSlope: fn "disk_to_slope", "disk_to_slope";
    SlopePerNormal: fn "slope_per_normal", "slope_per_normal";
    ReflectionPerNormal: fn "reflection_per_normal", "reflection_per_normal";
    Apply: fn "apply", "apply";
    SlopeJacobian: file "slope_jacobian";
    FootprintWidthLimit: const "FOOTPRINT_WIDTH_LIMIT", "Footprint::WIDTH_LIMIT";
    FootprintFromSlopes: fn "footprint_from_slopes", "Footprint::from_slopes";
    FootprintRectangle: fn "footprint_rectangle", "Footprint::rectangle";
    FootprintFromDisk: fn "footprint_from_disk", "Footprint::from_disk";
    FootprintFromDiskNarrowed: fn "footprint_from_disk_narrowed", "Footprint::from_disk_narrowed";
    FootprintFromHalfVectors: fn "footprint_from_half_vectors", "Footprint::from_half_vectors";
    FootprintFromPositions: fn "footprint_from_positions", "Footprint::from_positions";
    FootprintExtents: fn "footprint_extents", "Footprint::extents";
    FootprintBounding: fn "footprint_bounding", "Footprint::bounding";
    FootprintBoundingWithin: fn "footprint_bounding_within", "Footprint::bounding_within";
    FootprintDiameter: fn "footprint_diameter", "Footprint::diameter";
    FootprintRescaled: fn "footprint_rescaled", "Footprint::rescaled";
    FootprintScaled: fn "footprint_scaled", "Footprint::scaled";
    FootprintArea: fn "footprint_area", "Footprint::area";
    SlopeFootprint: file "slope_footprint";
    FootprintFromMotion: fn "footprint_from_motion", "Footprint::from_motion";
    SlopeMotion: file "slope_motion";
    VertexAt: fn "vertex_at", "Vertex::at";
    VertexDistant: fn "vertex_distant", "Vertex::distant";
    PathPlanePoint: fn "path_plane_point", "Path::plane_point";
    PathHalfVector: fn "path_half_vector", "Path::half";
    PathMotion: fn "path_motion", "Path::motion";
    PathSlopeJacobian: fn "path_slope_jacobian", "Path::slope_jacobian";
    SlopePath: file "slope_path";
    RayStep: fn "ray_step", "step";
    RayConeSteps: fn "ray_cone_steps", "cone_steps";
    SlopeRay: file "slope_ray";
    RoughnessFromAlpha: fn "roughness_from_alpha", "Roughness::from_alpha";
    RoughnessFromPerceptual: fn "roughness_from_perceptual", "Roughness::from_perceptual";
    RoughnessFromMatrix: fn "roughness_from_matrix", "Roughness::from_matrix";
    RoughnessFromCovariance: fn "roughness_from_covariance", "Roughness::from_covariance";
    RoughnessFromSigmaRho: fn "roughness_from_sigma_rho", "Roughness::from_sigma_rho";
    RoughnessCovariance: fn "roughness_covariance", "Roughness::covariance";
    RoughnessAlphas: fn "roughness_alphas", "Roughness::alphas";
    RoughnessPlus: fn "roughness_plus", "Roughness::plus";
    RoughnessChermainMatrix: fn "roughness_chermain_matrix", "Roughness::chermain_matrix";
    SlopeRoughness: file "slope_roughness";
    IsotropicNew: fn "isotropic_new", "Isotropic::new";
    IsotropicRootDet: fn "isotropic_root_det", "Isotropic::root_det";
    IsotropicForm: fn "isotropic_form", "Isotropic::form";
    IsotropicStretchSquared: fn "isotropic_stretch_squared", "Isotropic::stretch_squared";
    IsotropicNormal: fn "isotropic_normal";
    IsotropicView: fn "isotropic_view";
    IsotropicPair: fn "isotropic_pair";
    AxisAlignedNew: fn "axis_aligned_new", "AxisAligned::new";
    AxisAlignedRootDet: fn "axis_aligned_root_det", "AxisAligned::root_det";
    AxisAlignedForm: fn "axis_aligned_form", "AxisAligned::form";
    AxisAlignedStretchSquared: fn "axis_aligned_stretch_squared", "AxisAligned::stretch_squared";
    AxisAlignedNormal: fn "axis_aligned_normal";
    AxisAlignedView: fn "axis_aligned_view";
    AxisAlignedPair: fn "axis_aligned_pair";
    FullNew: fn "full_new", "Full::new";
    FullForm: fn "full_form", "Full::form";
    FullWhiten: fn "full_whiten", "Full::whiten";
    FullStretchSquared: fn "full_stretch_squared", "Full::stretch_squared";
    FullNormal: fn "full_normal";
    FullView: fn "full_view";
    FullPair: fn "full_pair";
    SlopeShape: file "slope_shape";
    TiltedNew: fn "tilted_new", "Tilted::new";
    TiltedForm: fn "tilted_form", "Tilted::form";
    TiltedOffset: fn "tilted_offset", "Tilted::offset";
    TiltedMeanArea: fn "tilted_mean_area", "Tilted::mean_area";
    TiltedNormal: fn "tilted_normal";
    TiltedView: fn "tilted_view";
    TiltedPair: fn "tilted_pair";
    SlopeTilted: file "slope_tilted";
    New: fn "new", "Lobe::new";
    Centred: fn "centred", "Lobe::centred";
    Shape: fn "shape", "Lobe::shape";
    SlopeLobe: file "slope_lobe";
    SlopeMomentsNew: fn "slope_moments_new", "SlopeMoments::new";
    SlopeMomentsOfSlope: fn "slope_moments_of_slope", "SlopeMoments::of_slope";
    SlopeMomentsFromRaw: fn "slope_moments_from_raw", "SlopeMoments::from_raw";
    SlopeMomentsMerged: fn "slope_moments_merged", "SlopeMoments::merged";
    SlopeMomentsLobe: fn "slope_moments_lobe", "SlopeMoments::lobe";
    SlopeMoments: file "slope_moments";
    NdfDistribution: file "ndf_distribution";
    NdfMasking: file "ndf_masking";
    GgxDensity: fn "ggx_density", "GgxDistribution::density";
    GgxExcess: fn "ggx_excess", "GgxDistribution::excess";
    GgxEvenArea: fn "ggx_even_area", "GgxDistribution::even_area";
    GgxSlopePdf: fn "ggx_slope_pdf", "Ndf::slope_pdf";
    GgxD: fn "ggx_d", "Ndf::d";
    GgxBrdf: fn "ggx_brdf", "Ndf::brdf";
    GgxProjectedArea: fn "ggx_projected_area", "Ndf::projected_area";
    GgxLambda: fn "ggx_lambda", "Ndf::lambda";
    GgxMasking: fn "ggx_masking", "Ndf::g1";
    GgxMaskingShadowing: fn "ggx_masking_shadowing", "Ndf::g2";
    GgxVisibility: fn "ggx_visibility", "Ndf::visibility";
    NdfGgx: file "ndf_ggx";
    BeckmannDensity: fn "beckmann_density", "BeckmannDistribution::density";
    BeckmannExcess: fn "beckmann_excess", "BeckmannDistribution::excess";
    BeckmannEvenArea: fn "beckmann_even_area", "Distribution::even_area";
    BeckmannSlopePdf: fn "beckmann_slope_pdf", "Ndf::slope_pdf";
    BeckmannD: fn "beckmann_d", "Ndf::d";
    BeckmannBrdf: fn "beckmann_brdf", "Ndf::brdf";
    BeckmannProjectedArea: fn "beckmann_projected_area", "Ndf::projected_area";
    BeckmannLambda: fn "beckmann_lambda", "Ndf::lambda";
    BeckmannMasking: fn "beckmann_masking", "Ndf::g1";
    BeckmannMaskingShadowing: fn "beckmann_masking_shadowing", "Ndf::g2";
    BeckmannVisibility: fn "beckmann_visibility", "Ndf::visibility";
    BeckmannLambdaWalter: fn "beckmann_lambda_walter", "Ndf::lambda_walter";
    NdfBeckmann: file "ndf_beckmann";
    PixelFilterBox: const "PIXEL_FILTER_BOX", "PixelFilter::BOX";
    PixelFilterKaplanyan: const "PIXEL_FILTER_KAPLANYAN", "PixelFilter::KAPLANYAN";
    PixelFilterTokuyoshiKaplanyan: const "PIXEL_FILTER_TOKUYOSHI_KAPLANYAN", "PixelFilter::TOKUYOSHI_KAPLANYAN";
    PixelFilterKaplanyanProxy: const "PIXEL_FILTER_KAPLANYAN_PROXY", "PixelFilter::KAPLANYAN_PROXY";
    KernelOf: fn "kernel_of", "Kernel::of";
    KernelTokuyoshiForward: fn "kernel_tokuyoshi_forward", "Kernel::tokuyoshi_forward";
    KernelFromCovariance: fn "kernel_from_covariance", "Kernel::from_covariance";
    KernelThen: fn "kernel_then", "Kernel::then";
    KernelFootprint: fn "kernel_footprint", "Kernel::footprint";
    KernelCapped: fn "kernel_capped", "Kernel::capped";
    KernelAlphaSquaredLimit: const "KERNEL_ALPHA_SQUARED_LIMIT", "Kernel::ALPHA_SQUARED_LIMIT";
    FilterKernel: file "filter_kernel";
    RoughnessWidened: fn "roughness_widened", "Roughness::widened";
    Widened: fn "widened", "Lobe::widened";
    GgxGaussianMean: fn "ggx_gaussian_mean", "ggx_gaussian_mean";
    FilterGaussian: file "filter_gaussian";
    DiskKernelOf: fn "disk_kernel_of", "DiskKernel::of";
    DiskKernelOfBounding: fn "disk_kernel_of_bounding", "DiskKernel::of_bounding";
    DiskKernelFromCovariance: fn "disk_kernel_from_covariance", "DiskKernel::from_covariance";
    DiskKernelThen: fn "disk_kernel_then", "DiskKernel::then";
    DiskKernelCapped: fn "disk_kernel_capped", "DiskKernel::capped";
    RoughnessWidenedOnDisk: fn "roughness_widened_on_disk", "Roughness::widened_on_disk";
    ProjectedAlpha: fn "projected_alpha", "projected_alpha";
    FilterProjected: file "filter_projected";
    SphericalGaussianNew: fn "spherical_gaussian_new", "SphericalGaussian::new";
    SphericalGaussianFromAngularRadius: fn "spherical_gaussian_from_angular_radius", "SphericalGaussian::from_angular_radius";
    SphericalGaussianIntegral: fn "spherical_gaussian_integral", "SphericalGaussian::integral";
    SphericalGaussianKernel: fn "spherical_gaussian_kernel", "SphericalGaussian::kernel";
    SphericalGaussianDiskKernel: fn "spherical_gaussian_disk_kernel", "SphericalGaussian::disk_kernel";
    SphericalGaussianFootprint: fn "spherical_gaussian_footprint", "SphericalGaussian::footprint";
    FilterLight: file "filter_light";
    FilterSegment: file "filter_segment";
    FilterStrip: file "filter_strip";
    FilterFrame: file "filter_frame";
    FilterThin: file "filter_thin";
    FilterEdges: file "filter_edges";
    FilterSecant: file "filter_secant";
    GgxParallelogramMean: fn "ggx_parallelogram_mean", "Ndf::parallelogram_mean";
    GgxRectangleMean: fn "ggx_rectangle_mean", "Ndf::rectangle_mean";
    GgxBrdfOver: fn "ggx_brdf_over", "Ndf::brdf_over";
    FilterPolygon: file "filter_polygon";
    BoxPeakAlpha: fn "box_peak_alpha", "box_peak_alpha";
    GaussianPeakAlpha: fn "gaussian_peak_alpha", "gaussian_peak_alpha";
    RoughnessPeakMatched: fn "roughness_peak_matched", "Roughness::peak_matched";
    RoughnessPeakFitted: fn "roughness_peak_fitted", "Roughness::peak_fitted";
    RoughnessPeakMatchedOver: fn "roughness_peak_matched_over", "Roughness::peak_matched_over";
    FilterProxy: file "filter_proxy";
    BeckmannRectangleMean: fn "beckmann_rectangle_mean", "beckmann_rectangle_mean";
    FilterBeckmann: file "filter_beckmann";
    TokuyoshiDeferredAlpha: fn "tokuyoshi_deferred_alpha", "tokuyoshi_deferred_alpha";
    TokuyoshiKaplanyanDeferredAlpha: fn "tokuyoshi_kaplanyan_deferred_alpha", "tokuyoshi_kaplanyan_deferred_alpha";
    LargestDeferredAlpha: fn "largest_deferred_alpha", "largest_deferred_alpha";
    KaplanyanDeferredAlphas: fn "kaplanyan_deferred_alphas", "kaplanyan_deferred_alphas";
    KaplanyanDeferredAlpha: fn "kaplanyan_deferred_alpha", "kaplanyan_deferred_alpha";
    QuadNormalFootprint: fn "quad_normal_footprint", "quad_normal_footprint";
    FilterDeferred: file "filter_deferred";
    FresnelSchlick: fn "fresnel_schlick", "Fresnel::schlick";
    FresnelConductor: fn "fresnel_conductor", "Fresnel::conductor";
    MaterialFresnel: file "material_fresnel";
    Bake: fn "bake", "Material::bake";
    HalfCosine: fn "half_cosine";
    GgxEvaluate: fn "ggx_evaluate", "Shading::evaluate";
    BeckmannEvaluate: fn "beckmann_evaluate", "Shading::evaluate";
    GgxEvaluateOver: fn "ggx_evaluate_over", "Shading::evaluate_over";
    Shade: file "shade";
    FragmentFootprint: fn "fragment_footprint";
    FragmentDiskKernel: fn "fragment_disk_kernel";
    FragmentDeferredAlpha: fn "fragment_deferred_alpha";
    Fragment: file "fragment";
    #[feature("published")]
    EngineFilament: const "ENGINE_FILAMENT", "Engine::Filament";
    EngineUnityHdrp: const "ENGINE_UNITY_HDRP", "Engine::UnityHdrp";
    EngineGodot: const "ENGINE_GODOT", "Engine::Godot";
    EngineOThreeDe: const "ENGINE_O_THREE_DE", "Engine::O3de";
    EngineThreeJs: const "ENGINE_THREE_JS", "Engine::ThreeJs";
    EngineBabylonJs: const "ENGINE_BABYLON_JS", "Engine::BabylonJs";
    EngineBevyProposal: const "ENGINE_BEVY_PROPOSAL", "Engine::BevyProposal";
    EngineAlpha: fn "engine_alpha", "Engine::alpha";
    FilterPreset: file "filter_preset";
    KaplanyanRectangleMean: fn "kaplanyan_rectangle_mean", "kaplanyan_rectangle_mean";
    KaplanyanRectangleMeanAsPrinted: fn "kaplanyan_rectangle_mean_as_printed", "kaplanyan_rectangle_mean_as_printed";
    KaplanyanProxyAlpha: fn "kaplanyan_proxy_alpha", "kaplanyan_proxy_alpha";
    FilterPublished: file "filter_published";
}
