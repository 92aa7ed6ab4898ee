//! Ways to shade a sample, as WGSL over names that a compute and a fragment shader fill in
//! differently.

/// Shading of one sample, with a filter or without.
pub(crate) struct Method {
    pub(crate) name: &'static str,
    /// The method without a filter that it is compared with, by name.
    pub(crate) base: &'static str,
    /// Statements that leave the BRDF in `r`; they know `wo`, `wi`, `h`, `alpha`, `$footprint` (of
    /// slopes), `$hu` and `$hv` (derivatives of h.xy), `$nu` and `$nv` (of the normal), and
    /// `$brdf`.
    body: &'static str,
    brdf: &'static str,
    /// Milliseconds that the nearest of his methods adds at 3840 x 2160 on a Quadro `M6000` in
    /// Sponza with normal maps: Kaplanyan et al. 2016, Table 2.
    pub(crate) kaplanyan: Option<f64>,
}

const ISOTROPIC: &str = "let r = $brdf(lobe_isotropic_pair(lobe_isotropic_new(alpha), wo, wi));";

const MATRIX: &str = "let shape = lobe_anisotropic_new(lobe_roughness_from_alpha(alpha));
    let r = $brdf(lobe_anisotropic_pair(shape, wo, wi));";

/// The roughness of a G-buffer's texel, then as without a filter.
const DEFERRED: &str = "let wide = lobe_tokuyoshi_kaplanyan_deferred_alpha(
    alpha, $nu, $nv, LOBE_PIXEL_FILTER_TOKUYOSHI_KAPLANYAN, LOBE_KERNEL_ALPHA_SQUARED_LIMIT
);
let r = $brdf(lobe_isotropic_pair(lobe_isotropic_new(wide), wo, wi));";

const DEFERRED_TWO: &str = "let wide = lobe_kaplanyan_deferred_alphas(
    vec2f(alpha, alpha), $footprint, LOBE_PIXEL_FILTER_KAPLANYAN, LOBE_KERNEL_ALPHA_SQUARED_LIMIT
);
let r = $brdf(lobe_axis_aligned_pair(lobe_axis_aligned_new(wide.x, wide.y), wo, wi));";

const VARIANCE: &str = "let kernel = lobe_kernel_of($footprint, LOBE_PIXEL_FILTER_BOX);
let shape = lobe_kernel_widen(kernel, lobe_isotropic_new(alpha));
let r = $brdf(lobe_widened_pair(shape, wo, wi));";

/// Any base, as LEAN has it.
const VARIANCE_OF_ANY: &str = "let kernel = lobe_kernel_of($footprint, LOBE_PIXEL_FILTER_BOX);
let wide = lobe_roughness_widened(lobe_roughness_from_alpha(alpha), kernel);
let r = $brdf(lobe_anisotropic_pair(lobe_anisotropic_new(wide), wo, wi));";

const PEAK: &str = "let kernel = lobe_kernel_of($footprint, LOBE_PIXEL_FILTER_BOX);
let shape = lobe_kernel_widen_to_peak(kernel, lobe_isotropic_new(alpha));
let r = $brdf(lobe_widened_pair(shape, wo, wi));";

const DISK: &str =
    "let kernel = lobe_disk_kernel_of($hu, $hv, LOBE_PIXEL_FILTER_TOKUYOSHI_KAPLANYAN);
let shape = lobe_disk_kernel_widen(kernel, lobe_isotropic_new(alpha));
let r = $brdf(lobe_widened_pair(shape, wo, wi));";

const RECTANGLE: &str = "let widths = lobe_footprint_extents($footprint);
let mean = lobe_kaplanyan_rectangle_mean(vec2f(alpha, alpha), lobe_slope_of(h), widths);
let shape = lobe_isotropic_new(alpha);
let visibility = lobe_ggx_visibility(lobe_isotropic_view(shape, wo), lobe_isotropic_view(shape, \
wi));
let r = mean / (h.z * h.z * h.z * h.z) * visibility;";

const EXACT: &str =
    "let shape = lobe_lobe_shape(lobe_lobe_centered(lobe_roughness_from_alpha(alpha)));
let r = lobe_ggx_brdf_over(shape, wo, wi, $footprint);";

const LANES: &str = "let shape = lobe_isotropic_new(alpha);
let r = lobe_ggx_brdf_over_in_lanes(lobe_isotropic_pair_over(shape, wo, wi, $footprint));";

const GGX_BASE: &str = "GGX, isotropic, no filter";
const BECKMANN_BASE: &str = "Beckmann, isotropic, no filter";

const fn ggx(name: &'static str, body: &'static str, kaplanyan: Option<f64>) -> Method {
    Method { name, base: GGX_BASE, body, brdf: "lobe_ggx_brdf", kaplanyan }
}

const fn beckmann(name: &'static str, body: &'static str, kaplanyan: Option<f64>) -> Method {
    Method { name, base: BECKMANN_BASE, body, brdf: "lobe_beckmann_brdf", kaplanyan }
}

pub(crate) const METHODS: [Method; 14] = [
    ggx(GGX_BASE, ISOTROPIC, None),
    ggx("GGX, any matrix, no filter", MATRIX, None),
    ggx("GGX, deferred, one alpha", DEFERRED, Some(0.93)),
    ggx("GGX, deferred, two alphas", DEFERRED_TWO, Some(0.93)),
    ggx("GGX, variance added", VARIANCE, Some(0.53)),
    ggx("GGX, any matrix, variance added", VARIANCE_OF_ANY, None),
    ggx("GGX, right peak", PEAK, None),
    ggx("GGX, on the projected disk", DISK, None),
    ggx("GGX, Kaplanyan's rectangle", RECTANGLE, Some(2.74)),
    ggx("GGX, exact parallelogram", EXACT, Some(2.74)),
    ggx("GGX, parallelogram in lanes", LANES, Some(2.74)),
    beckmann(BECKMANN_BASE, ISOTROPIC, None),
    beckmann("Beckmann, deferred, one alpha", DEFERRED, Some(0.49)),
    beckmann("Beckmann, variance added", VARIANCE, Some(0.64)),
];

/// Floats that a compute shader reads for a sample: wo, wi, three half vectors, two derivatives of
/// the normal.
pub(crate) const FLOATS: usize = 21;

impl Method {
    fn filled(&self, footprint: &str, half: [&str; 2], normal: [&str; 2]) -> String {
        self.body
            .replace("$brdf", self.brdf)
            .replace("$footprint", footprint)
            .replace("$hu", half[0])
            .replace("$hv", half[1])
            .replace("$nu", normal[0])
            .replace("$nv", normal[1])
    }

    /// The statements of a compute shader, whose item holds all that a quad would know.
    pub(crate) fn compute(&self, alpha: f64) -> String {
        let vector = |k: usize| format!("vec3f(at({k}u), at({}u), at({}u))", k + 1, k + 2);
        let body = self.filled(
            "lobe_footprint_from_half_vectors(h, right, up)",
            ["(right.xy - h.xy)", "(up.xy - h.xy)"],
            ["nu", "nv"],
        );
        format!(
            "let alpha = {alpha:?}f; let wo = {}; let wi = {}; let h = {};\nlet right = {}; let \
                up = {}; let nu = {}; \
             let nv = {};\n{body}\nput(0u, r);",
            vector(0),
            vector(3),
            vector(6),
            vector(9),
            vector(12),
            vector(15),
            vector(18),
        )
    }

    /// A fragment shader over a rippled plane: cheap to trace, and half vectors of all kinds.
    pub(crate) fn fragment(&self, alpha: f64) -> String {
        let body = self.filled("footprint", ["hu", "hv"], ["nu", "nv"]);
        // What a method does not use, the driver leaves out.
        let footprint = if body.contains("footprint") {
            "let footprint = lobe_fragment_footprint(h);"
        } else {
            ""
        };
        format!(
            "
@fragment fn fragment(@builtin(position) place: vec4f) -> @location(0) vec4f {{
    let alpha = {alpha:?}f;
    let p = 0.02 * place.xy;
    let normal = normalize(vec3f(0.2 * sin(p.x + sin(p.y)), 0.2 * sin(p.y), 1.0));
    let eye = normalize(vec3f(0.3 - 1e-4 * place.x, 0.2, 1.0));
    let lamp = normalize(vec3f(-0.2, 0.1 + 1e-4 * place.y, 1.0));
    let tangent = normalize(vec3f(normal.z, 0.0, -normal.x));
    let frame = transpose(mat3x3f(tangent, cross(normal, tangent), normal));
    let wo = frame * eye;
    let wi = frame * lamp;
    let h = normalize(wo + wi);
    let hu = dpdx(h.xy);
    let hv = dpdy(h.xy);
    let nu = dpdx(normal);
    let nv = dpdy(normal);
    {footprint}
    {body}
    return vec4f(vec3f(r * wi.z), 1.0);
}}
"
        )
    }
}
