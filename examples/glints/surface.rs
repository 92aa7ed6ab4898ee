//! A surface: where a ray meets it, its frame, and its texture coordinates' derivatives.

use super::camera::Ray;
use glam::DVec3;
use lobe::SlopeMoments;

/// An analytic surface, known by its texture coordinates.
pub(crate) trait Surface: Sync {
    /// The texture coordinates where a ray meets it first.
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]>;

    /// The place of texture coordinates.
    fn spot(&self, uv: [f64; 2]) -> Spot;

    /// The shading frame at a spot: of its tangents, unless the surface has a normal map.
    fn frame(&self, spot: &Spot) -> Frame {
        Frame::of(spot.tangents)
    }

    /// What a pixel sees of a normal map in that frame, from the direction `wo` of it; `steps` are
    /// the texture coordinates' derivatives.
    fn bumps(&self, _uv: [f64; 2], _steps: [[f64; 2]; 2], _wo: DVec3) -> SlopeMoments<f32> {
        SlopeMoments::default()
    }
}

/// A point and its derivatives by u and by v; their cross product points outwards.
#[derive(Clone, Copy)]
pub(crate) struct Spot {
    pub(crate) point: DVec3,
    pub(crate) tangents: [DVec3; 2],
}

impl Spot {
    /// The texture coordinates' change for a step along the surface: least squares, exact in its
    /// tangent plane.
    pub(crate) fn change(&self, step: DVec3) -> [f64; 2] {
        let [u, v] = self.tangents;
        let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
        let (a, b) = (step.dot(u), step.dot(v));
        let det = (uu * vv - uv * uv).max(f64::MIN_POSITIVE);
        [(a * vv - b * uv) / det, (b * uu - a * uv) / det]
    }

    /// The unit normal.
    pub(crate) fn normal(&self) -> DVec3 {
        self.tangents[0].cross(self.tangents[1]).normalize()
    }
}

/// An orthonormal frame: x along u, z outwards.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    pub(crate) x: DVec3,
    pub(crate) y: DVec3,
    pub(crate) z: DVec3,
}

impl Frame {
    /// From the derivatives by u and v: x is that by u, as grooves along v must be crossed by it.
    pub(crate) fn of([u, v]: [DVec3; 2]) -> Self {
        let (x, z) = (u.normalize(), u.cross(v).normalize());
        Self { x, y: z.cross(x), z }
    }

    /// The world's own, z up.
    pub(crate) const WORLD: Self = Self { x: DVec3::X, y: DVec3::Y, z: DVec3::Z };

    /// A vector of the world in this frame.
    pub(crate) fn local(&self, v: DVec3) -> DVec3 {
        DVec3::new(v.dot(self.x), v.dot(self.y), v.dot(self.z))
    }
}
