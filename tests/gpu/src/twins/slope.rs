//! Twins of `src/slope`.

use lobe::slope::direction::{from_disk, half_vector, normal_of, normalize, reflect, slope_of};
use lobe::slope::jacobian::{
    apply, disk_to_slope, reflection_per_normal, slope_per_normal, sphere_to_disk, sphere_to_slope,
};
use lobe::slope::{Whiten, ray};
use lobe::{
    Anisotropic, AxisAligned, Footprint, Isotropic, Lobe, LobeShape, NonCentered, Path, Real,
    Roughness, SlopeMoments, Vertex,
};

use super::value::{Columns, Reader};

/// A path: two positions and a curvature.
fn path<R: Real>(x: &mut Reader<'_>) -> Path<R> {
    let vertex = |position: [R; 3]| Vertex::at(position).expect("a drawn position has a length");
    Path { eye: vertex(x.vec()), light: vertex(x.vec()), curvature: x.vec() }
}

fn isotropic<R: Real>(x: &mut Reader<'_>) -> Isotropic<R> {
    Isotropic::new(x.f()).expect("a drawn alpha is in range")
}

fn axis_aligned<R: Real>(x: &mut Reader<'_>) -> AxisAligned<R> {
    let [alpha_x, alpha_y] = x.vec();
    AxisAligned::new(alpha_x, alpha_y).expect("drawn alphas are in range")
}

fn non_centered<R: Real>(x: &mut Reader<'_>) -> NonCentered<Anisotropic<R>> {
    x.lobe().shape()
}

pub(super) fn moments<R: Real>(x: &mut Reader<'_>) -> SlopeMoments<R> {
    let mean = x.vec::<R, 2>();
    SlopeMoments::new(mean, x.psd()).expect("a drawn mean is in range")
}

super::twins! {
    "half_vector" (Pair) "lobe_half_vector($0)" => |x| {
        half_vector::<R>(x.vec::<R, 3>(), x.vec::<R, 3>())
    };
    "normalize" (Position) "lobe_normalize($0)" => |x| normalize::<R>(x.vec::<R, 3>());
    "slope_of" (Direction) "lobe_slope_of($0)" => |x| slope_of::<R>(x.vec::<R, 3>());
    "normal_of" (Slope) "lobe_normal_of($0)" => |x| normal_of::<R>(x.vec::<R, 2>());
    "from_disk" (Disk) "lobe_from_disk($0)" => |x| from_disk::<R>(x.vec::<R, 2>());
    "reflect" (Pair) "lobe_reflect($0)" => |x| reflect::<R>(x.vec::<R, 3>(), x.vec::<R, 3>());
    "sphere_to_slope" (Direction) "lobe_sphere_to_slope($0)" => |x| {
        sphere_to_slope::<R>(x.vec::<R, 3>())
    };
    "sphere_to_disk" (Direction) "lobe_sphere_to_disk($0)" => |x| {
        sphere_to_disk::<R>(x.vec::<R, 3>())
    };
    "disk_to_slope" (Direction) "lobe_disk_to_slope($0)" => |x| disk_to_slope::<R>(x.vec::<R, 3>());
    "slope_per_normal" (Direction) "lobe_slope_per_normal($0)" => |x| {
        slope_per_normal::<R>(x.vec::<R, 3>())
    };
    "reflection_per_normal" (Pair) "lobe_reflection_per_normal($0)" => |x| {
        reflection_per_normal::<R>(x.vec::<R, 3>(), x.vec::<R, 3>())
    };
    "jacobian_apply" (Direction, Slope) "lobe_jacobian_apply(lobe_disk_to_slope($0), $1)" => |x| {
        let matrix = disk_to_slope::<R>(x.vec::<R, 3>());
        apply(matrix, x.vec::<R, 2>())
    };
    "footprint_from_slopes" (Footprint) "$0" => |x| {
        Footprint::from_slopes(x.vec::<R, 2>(), x.vec())
    };
    "footprint_rectangle" (Widths) "lobe_footprint_rectangle($0)" => |x| {
        Footprint::rectangle(x.vec::<R, 2>())
    };
    "footprint_from_disk" (Direction, Footprint) "lobe_footprint_from_disk($0, $1.u, $1.v)" => |x| {
        Footprint::from_disk(x.vec::<R, 3>(), x.vec(), x.vec())
    };
    "footprint_from_disk_narrowed" (Footprint) "lobe_footprint_from_disk_narrowed($0.u, \
        $0.v)" => |x| {
        Footprint::from_disk_narrowed(x.vec::<R, 2>(), x.vec())
    };
    "footprint_from_half_vectors" (Halves) "lobe_footprint_from_half_vectors($0)" => |x| {
        Footprint::from_half_vectors(x.vec::<R, 3>(), x.vec(), x.vec()).unwrap_or_default()
    };
    "footprint_from_positions" (Direction, Footprint)
        "lobe_footprint_from_positions(lobe_disk_to_slope($0), $1.u, $1.v)" => |x| {
        let matrix = disk_to_slope::<R>(x.vec::<R, 3>());
        Footprint::from_positions(matrix, x.vec(), x.vec())
    };
    "footprint_extents" (Footprint) "lobe_footprint_extents($0)" => |x| {
        x.footprint::<R>().extents()
    };
    "footprint_bounding" (Footprint) "lobe_footprint_bounding($0)" => |x| {
        x.footprint::<R>().bounding()
    };
    "footprint_bounding_within" (Footprint, Size) "lobe_footprint_bounding_within($0, $1)" => |x| {
        let footprint = x.footprint::<R>();
        footprint.bounding_within(x.f())
    };
    "footprint_diameter" (Footprint) "lobe_footprint_diameter($0)" => |x| {
        x.footprint::<R>().diameter()
    };
    "footprint_capped" (Footprint, Size) "lobe_footprint_capped($0, $1)" => |x| {
        let footprint = x.footprint::<R>();
        footprint.capped(x.f())
    };
    "footprint_mul" (Footprint, Any) "lobe_footprint_mul($0, $1)" => |x| {
        let footprint = x.footprint::<R>();
        footprint * x.f()
    };
    "footprint_area" (Footprint) "lobe_footprint_area($0)" => |x| x.footprint::<R>().area();
    "footprint_from_motion" (Position, Position, Curvature, Slope, Slope)
        "lobe_footprint_from_motion(lobe_path_half_vector(LobePath(lobe_vertex_at($0), \
            lobe_vertex_at($1), $2)),
            lobe_path_motion(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), $2), $3),
            lobe_path_motion(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), $2), $4))" => |x| {
        let path = path::<R>(x);
        let (u, v) = (path.motion(x.vec()), path.motion(x.vec()));
        Footprint::from_motion(path.half_vector(), &u, &v).unwrap_or_default()
    };
    "vertex_at" (Position) "lobe_vertex_at($0)" => |x| {
        Vertex::at(x.vec::<R, 3>()).expect("a length")
    };
    "vertex_distant" (Position) "lobe_vertex_distant($0)" => |x| {
        Vertex::distant(x.vec::<R, 3>()).expect("a length")
    };
    "path_plane_point" (Position, Position, Curvature)
        "lobe_path_plane_point(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), \
            $2))" => |x| path::<R>(x).plane_point();
    "path_half_vector" (Position, Position, Curvature)
        "lobe_path_half_vector(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), \
            $2))" => |x| path::<R>(x).half_vector();
    "path_motion" (Position, Position, Curvature, Slope)
        "lobe_path_motion(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), $2), $3)" => |x| {
        let path = path::<R>(x);
        path.motion(x.vec())
    };
    "path_slope_jacobian" (Position, Position, Curvature)
        "lobe_path_slope_jacobian(LobePath(lobe_vertex_at($0), lobe_vertex_at($1), $2))" => |x| {
        path::<R>(x).slope_jacobian()
    };
    "ray_step" (Direction, Position, Direction, Size) "lobe_ray_step($0, $1, $2, $3)" => |x| {
        ray::step(x.vec::<R, 3>(), x.vec::<R, 3>(), x.vec::<R, 3>(), x.f::<R>())
    };
    "ray_cone_steps" (Direction, Size) "lobe_ray_cone_steps($0, $1)" => |x| {
        Columns(ray::cone_steps(x.vec::<R, 3>(), x.f()))
    };
    "roughness_from_alpha" (Alpha) "lobe_roughness_from_alpha($0)" => |x| {
        Roughness::from_alpha(x.f::<R>()).expect("in range")
    };
    "roughness_from_perceptual" (Unit) "lobe_roughness_from_perceptual($0)" => |x| {
        Roughness::from_perceptual(x.f::<R>()).expect("in range")
    };
    "roughness_from_matrix" (Roughness) "$0" => |x| x.roughness::<R>();
    "roughness_from_covariance" (Psd) "lobe_roughness_from_covariance($0)" => |x| {
        Roughness::from_covariance(x.psd::<R>())
    };
    "roughness_from_sigma_rho" (Alphas, Cosine) "lobe_roughness_from_sigma_rho($0.x, $0.y, \
        $1)" => |x| {
        Roughness::from_sigma_rho(x.f::<R>(), x.f(), x.f()).expect("in range")
    };
    "roughness_covariance" (Roughness) "lobe_roughness_covariance($0)" => |x| {
        x.roughness::<R>().covariance()
    };
    "roughness_alphas" (Roughness) "lobe_roughness_alphas($0)" => |x| x.roughness::<R>().alphas();
    "roughness_add" (Roughness, Roughness) "lobe_roughness_add($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness + x.roughness()
    };
    "roughness_chermain_matrix" (Roughness, Alpha) "lobe_roughness_chermain_matrix($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness.chermain_matrix(x.f())
    };
    "isotropic_new" (Alpha) "lobe_isotropic_new($0).alpha" => |x| {
        let a = x.f::<R>();
        Isotropic::new(a).map(|_| a).expect("in range")
    };
    "isotropic_new" (Alpha) "lobe_isotropic_new($0).alpha" => |x| isotropic::<R>(x).alpha();
    "isotropic_extent" (Alpha) "lobe_isotropic_extent(lobe_isotropic_new($0))" => |x| {
        isotropic::<R>(x).extent()
    };
    "isotropic_form" (Direction) "lobe_isotropic_form($0)" => |x| {
        let shape = Isotropic::new(R::ONE).expect("in range");
        shape.form(x.vec())
    };
    "isotropic_stretch_squared" (Alpha, Direction)
        "lobe_isotropic_stretch_squared(lobe_isotropic_new($0), $1)" => |x| {
        let shape = isotropic::<R>(x);
        shape.stretch_squared(x.vec())
    };
    "axis_aligned_new" (Alphas) "lobe_axis_aligned_new($0.x, $0.y).alphas" => |x| {
        axis_aligned::<R>(x).alphas()
    };
    "axis_aligned_extent" (Alphas) "lobe_axis_aligned_extent(lobe_axis_aligned_new($0.x, \
        $0.y))" => |x| {
        axis_aligned::<R>(x).extent()
    };
    "axis_aligned_form" (Alphas, Direction) "lobe_axis_aligned_form(lobe_axis_aligned_new($0.x, \
        $0.y), $1)" => |x| {
        let shape = axis_aligned::<R>(x);
        shape.form(x.vec())
    };
    "axis_aligned_stretch_squared" (Alphas, Direction)
        "lobe_axis_aligned_stretch_squared(lobe_axis_aligned_new($0.x, $0.y), $1)" => |x| {
        let shape = axis_aligned::<R>(x);
        shape.stretch_squared(x.vec())
    };
    "anisotropic_new" (Roughness, Direction)
        "vec3f(lobe_anisotropic_new($0).root_det, lobe_anisotropic_form(lobe_anisotropic_new($0), \
            $1.xy), lobe_anisotropic_stretch_squared(lobe_anisotropic_new($0), $1))"
        => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        let m = x.vec();
        [shape.root_det(), shape.form(m), shape.stretch_squared(m)]
    };
    "anisotropic_extent" (Roughness) "lobe_anisotropic_extent(lobe_anisotropic_new($0))" => |x| {
        Anisotropic::new(x.roughness::<R>()).extent()
    };
    "anisotropic_form" (Roughness, Direction) "lobe_anisotropic_form(lobe_anisotropic_new($0), \
        $1.xy)" => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        shape.form(x.vec())
    };
    "anisotropic_whiten" (Roughness, Slope) "lobe_anisotropic_whiten(lobe_anisotropic_new($0), \
        $1, vec2f(0.0, 0.0))" => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        shape.whiten(x.vec(), [R::ZERO; 2])
    };
    "anisotropic_major" (Groove)
        "lobe_anisotropic_major(lobe_anisotropic_new(($0).roughness))" => |x| {
        let (axis, alpha) = Anisotropic::new(x.lobe::<R>().roughness()).major();
        [axis[0], axis[1], alpha]
    };
    "anisotropic_stretch_squared" (Roughness, Direction)
        "lobe_anisotropic_stretch_squared(lobe_anisotropic_new($0), $1)" => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        shape.stretch_squared(x.vec())
    };
    "non_centered_new" (Roughness, Mean, Direction)
        "lobe_non_centered_mean_area(
            lobe_non_centered_new(lobe_anisotropic_new($0), $1), $2
        )" => |x| {
        let anisotropic = Anisotropic::new(x.roughness::<R>());
        let shape = NonCentered::new(anisotropic, x.vec::<R, 2>()).expect("in range");
        shape.mean_area(x.vec())
    };
    "widened_new" (Widened, Direction) "lobe_widened_form($0, $1.xy)" => |x| {
        let shape = x.widened::<R>();
        shape.form(x.vec())
    };
    "widened_extent" (Widened) "lobe_widened_extent($0)" => |x| {
        x.widened::<R>().extent()
    };
    "widened_form" (Widened, Slope) "lobe_widened_form($0, $1)" => |x| {
        let shape = x.widened::<R>();
        shape.adjugate_form(x.vec())
    };
    "widened_stretch_squared" (Widened, Direction)
        "lobe_widened_stretch_squared($0, $1)" => |x| {
        let shape = x.widened::<R>();
        shape.stretch_squared(x.vec())
    };
    "non_centered_form" (Lobe, Direction) "lobe_non_centered_form(lobe_lobe_shape($0), \
        $1)" => |x| {
        let shape = non_centered::<R>(x);
        shape.form(x.vec())
    };
    "non_centered_offset" (Lobe, Slope) "four(lobe_non_centered_offset(lobe_lobe_shape($0), \
        $1))" => |x| {
        let shape = non_centered::<R>(x);
        let (high, low) = shape.offset(x.vec());
        [high, low]
    };
    "non_centered_mean_area" (Lobe, Direction) "lobe_non_centered_mean_area(lobe_lobe_shape($0), \
        $1)" => |x| {
        let shape = non_centered::<R>(x);
        shape.mean_area(x.vec())
    };
    "lobe_new" (Lobe) "$0" => |x| x.lobe::<R>();
    "lobe_centered" (Roughness) "lobe_lobe_centered($0)" => |x| Lobe::centered(x.roughness::<R>());
    "lobe_shape" (Lobe, Direction) "lobe_non_centered_form(lobe_lobe_shape($0), $1)" => |x| {
        let shape = non_centered::<R>(x);
        shape.form(x.vec())
    };
    "slope_moments_new" (Mean, Psd) "lobe_slope_moments_new($0, $1)" => |x| moments::<R>(x);
    "slope_moments_of_slope" (Slope) "lobe_slope_moments_of_slope($0)" => |x| {
        SlopeMoments::of_slope(x.vec::<R, 2>()).expect("in range")
    };
    "slope_moments_from_raw" (Mean, Second) "lobe_slope_moments_from_raw($0, $1)" => |x| {
        SlopeMoments::from_raw(x.vec::<R, 2>(), x.vec()).expect("in range")
    };
    "slope_moments_merged" (Mean, Psd, Mean, Psd, Unit, Alpha)
        "lobe_slope_moments_merged(lobe_slope_moments_new($0, $1), $4, lobe_slope_moments_new($2, \
            $3), $5)" => |x| {
        let (one, other) = (moments::<R>(x), moments(x));
        let (weight, other_weight) = (x.f(), x.f());
        one.merged(weight, &other, other_weight).expect("in range")
    };
    "slope_moments_lobe" (Mean, Psd, Roughness)
        "lobe_slope_moments_lobe(lobe_slope_moments_new($0, $1), $2)" => |x| {
        let moments = moments::<R>(x);
        moments.lobe(x.roughness())
    };
}
