//! The report's scenes in fragment shaders: their numbers as buffers, and what is drawn of them.

use lobe_gpu::{Gpu, Painter, needed};
use lobe_report::shot::Shot;

/// A picture of four floats a pixel, of the shot's size.
pub(crate) type Picture = Vec<[f32; 4]>;

/// What every shader reads: the layout of [`pixels`] and [`traces`].
const SCENE: &str = "
struct Pixel { wo: vec3f, strength: f32, wi: vec3f, alpha: f32, normal: vec3f, unused: f32 }
struct Trace { eye: vec3f, unused: f32, curvature: vec3f, across: f32, steps: vec4f, spins: vec4f }
@group(0) @binding(0) var<storage, read> pixels: array<Pixel>;
@group(0) @binding(1) var<storage, read> traces: array<Trace>;
fn index_of(at: vec4f) -> u32 { return u32(at.y) * WIDTH + u32(at.x); }

fn by_matrix(p: Pixel, t: Trace) -> LobeFootprint {
    let path = LobePath(lobe_vertex_at(t.eye), lobe_vertex_distant(p.wi), t.curvature);
    var u = lobe_path_motion(path, t.steps.xy);
    var v = lobe_path_motion(path, t.steps.zw);
    // The frame follows a field of tangents.
    u.spin = t.spins.x;
    v.spin = t.spins.y;
    return lobe_footprint_from_motion(lobe_path_half_vector(path), u, v);
}
fn sides(footprint: LobeFootprint) -> vec4f { return vec4f(footprint.u, footprint.v); }
";

/// Unfiltered, widened, averaged over the footprint.
pub(crate) const SHADED: &str = "
    let footprint = lobe_fragment_footprint(lobe_half_vector(p.wo, p.wi));
    let roughness = lobe_roughness_from_alpha(p.alpha);
    let plain = lobe_ggx_brdf(lobe_isotropic_pair(lobe_isotropic_new(p.alpha), p.wo, p.wi));
    let kernel = lobe_kernel_of(footprint, LOBE_PIXEL_FILTER_BOX);
    let wider = lobe_anisotropic_new(lobe_roughness_widened(roughness, kernel));
    let widened = lobe_ggx_brdf(lobe_anisotropic_pair(wider, p.wo, p.wi));
    let mean = lobe_ggx_brdf_over(lobe_lobe_shape(lobe_lobe_centered(roughness)), p.wo, p.wi, \
    footprint);
    return vec4f(plain, widened, mean, 0.0) * p.wi.z * p.strength;";

/// The footprint from the quad: u, then v.
pub(crate) const QUAD: &str = "
    return sides(lobe_fragment_footprint(lobe_half_vector(p.wo, p.wi)));";

/// The same from plain derivatives, which a driver may take from another row or column of the quad.
pub(crate) const PLAIN_QUAD: &str = "
    let slope = lobe_slope_of(lobe_half_vector(p.wo, p.wi));
    return vec4f(dpdx(slope), dpdy(slope));";

/// What the kernel on the projected disk adds: entries xx, xy, yy and the root of the determinant.
pub(crate) const DISK: &str = "
    let variance = LOBE_PIXEL_FILTER_TOKUYOSHI_KAPLANYAN;
    let kernel = lobe_fragment_disk_kernel(lobe_half_vector(p.wo, p.wi), variance);
    let columns = kernel.as_slopes;
    let u = columns.u;
    let v = columns.v;
    return vec4f(
        u.x * u.x + v.x * v.x, u.x * u.y + v.x * v.y, u.y * u.y + v.y * v.y,
        abs(u.x * v.y - u.y * v.x)
    );";

/// Alpha from the normals of the quad.
pub(crate) const DEFERRED: &str = "
    let variance = LOBE_PIXEL_FILTER_TOKUYOSHI_KAPLANYAN;
    let limit = LOBE_KERNEL_ALPHA_SQUARED_LIMIT;
    return vec4f(lobe_fragment_deferred_alpha(p.alpha, p.normal, variance, limit));";

/// Sides of the patch whose coordinates are two components of `wo`: to the right, then to the next
/// row.
pub(crate) const PATCH: &str = "
    let place = lobe_fragment_patch(p.wo.xy);
    return vec4f(place.right, place.up);";

/// The footprint from Kaplanyan's matrix M.
pub(crate) const MATRIX: &str = "
    return sides(by_matrix(p, traces[index_of(at)]));";

/// Of the footprint from the quad and the one from M: root of the squared differences, over that of
/// M's squares.
pub(crate) const DIFFERENCE: &str = "
    let quad = sides(lobe_fragment_footprint(lobe_half_vector(p.wo, p.wi)));
    let matrix = sides(by_matrix(p, traces[index_of(at)]));
    return vec4f(length(quad - matrix) / max(length(matrix), 1e-30));";

/// A scene on a driver.
pub(crate) struct Stage<'a> {
    pub(crate) shot: &'a Shot,
    pub(crate) gpu: &'static Gpu,
}

impl Stage<'_> {
    /// The picture of a fragment shader's statements: `p` is the pixel, `at` its position.
    ///
    /// # Errors
    ///
    /// Wrong WGSL, with naga's pointed message.
    pub(crate) fn picture(&self, statements: &str) -> Result<Picture, String> {
        let [width, height] = self.shot.quad_size();
        let fragment = format!(
            "const WIDTH: u32 = {width}u;{SCENE}
@fragment fn fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {{
    let p = pixels[index_of(at)];{statements}
}}"
        );
        let buffers = [pixels(self.shot), traces(self.shot)];
        let buffers = buffers.each_ref().map(Vec::as_slice);
        let [columns, rows] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let library = needed(&fragment);
        let painter = Painter::new(self.gpu, &library, &fragment, &buffers, columns, rows)?;
        let whole = painter.draw();
        let rows = whole.chunks(width).take(self.shot.height);
        Ok(rows.flat_map(|row| &row[..self.shot.width]).copied().collect())
    }
}

/// How a quantity is spread over pixels.
pub(crate) struct Spread {
    /// Half of the pixels have less.
    pub(crate) median: f64,
    /// 99 % of the pixels have less.
    pub(crate) high: f64,
    /// The largest.
    pub(crate) most: f64,
    /// How much of the pixels have more than a tenth.
    pub(crate) share: f64,
}

impl Spread {
    /// Over the judged pixels; all zero without any.
    pub(crate) fn of(values: &[f64], judged: &[bool]) -> Self {
        let judged = values.iter().zip(judged).filter(|(_, judged)| **judged);
        let mut sorted: Vec<f64> = judged.map(|(value, _)| *value).collect();
        sorted.sort_by(f64::total_cmp);
        let at = |percent: usize| sorted.get(sorted.len() * percent / 100).copied();
        let above = sorted.iter().filter(|&&value| value > 0.1).count();
        Self {
            median: at(50).unwrap_or_default(),
            high: at(99).unwrap_or_default(),
            most: sorted.last().copied().unwrap_or_default(),
            share: above as f64 / sorted.len().max(1) as f64,
        }
    }
}

/// The sides of a footprint as it was drawn.
pub(crate) fn sides([a, b, c, d]: [f32; 4]) -> [[f32; 2]; 2] {
    [[a, b], [c, d]]
}

/// Twelve floats a pixel.
fn pixels(shot: &Shot) -> Vec<f32> {
    let floats = shot.seen.iter().flat_map(|seen| {
        let ([a, b, c], [d, e, f], [x, y, z]) = (seen.wo, seen.wi, seen.normal);
        [a, b, c, seen.strength, d, e, f, shot.alpha as f32, x, y, z, 0.0]
    });
    floats.collect()
}

/// Sixteen floats a pixel.
fn traces(shot: &Shot) -> Vec<f32> {
    let floats = shot.traced.iter().flat_map(|trace| {
        let ([a, b, c], [d, e, f]) = (trace.eye, trace.curvature);
        let ([[g, h], [i, j]], [k, l]) = (trace.steps, trace.spins);
        [a, b, c, 0.0, d, e, f, 0.0, g, h, i, j, k, l, 0.0, 0.0]
    });
    floats.collect()
}
