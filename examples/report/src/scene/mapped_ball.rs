//! A ball with a normal map: curvature and texture at once, minified towards the silhouette.

use std::sync::Arc;

use lobe::slope::direction::normalize;

use super::balls::Ball;
use super::chart::Lambert;
use super::map::NormalMap;
use super::surface::{Hit, Shape};
use crate::camera::{Ray, Size};
use crate::frame::{Comb, Turn};
use crate::scalar::Scalar;
use crate::texture::Texture;
use crate::vector::{Vector, add, along, scaled};

/// Radius over the picture's height: 100 pixels at a width of 400.
const RADIUS: f64 = 0.444;

/// Texels per pixel where the ball faces the eye.
const DENSITY: f64 = 1.0;

/// The ball; its map is laid on by Lambert's equal-area projection from the point that faces the
/// eye.
pub(super) struct MappedBall<R> {
    ball: Ball<R>,
    /// In texels.
    chart: Lambert<R>,
    texture: Arc<Texture>,
}

impl MappedBall<f64> {
    /// The ball around the origin, facing the eye along +y, and a caption; the unit of length is a
    /// pixel.
    pub(super) fn seen_in(size: Size, map: &NormalMap) -> (Self, String) {
        let radius = RADIUS * size.height as f64;
        let caption = format!(
            "A ball of {radius:.0} pixels radius with {}, bilinear and repeating, {DENSITY:.0} \
                texel per pixel \
             in the middle and the more the nearer to the silhouette; light from the upper right.",
            map.name,
        );
        let ball = Self {
            ball: Ball { center: [0.0; 3], radius },
            chart: Lambert { comb: Comb::around([0.0, -1.0, 0.0]), density: DENSITY * radius },
            texture: Arc::clone(&map.texture),
        };
        (ball, caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> MappedBall<R> {
        MappedBall {
            ball: self.ball.cast(),
            chart: self.chart.cast(),
            texture: Arc::clone(&self.texture),
        }
    }
}

impl<R: Scalar> MappedBall<R> {
    /// The map's axes on the ball: two tangents and the normal.
    #[inline]
    fn axes(&self, normal: Vector<R>) -> [Vector<R>; 3] {
        [self.chart.comb.tangent(0, normal), self.chart.comb.tangent(1, normal), normal]
    }

    /// Texel coordinates of a point, by its normal. The map's rows count down.
    #[inline]
    fn texel(&self, normal: Vector<R>) -> [R; 2] {
        let [x, y] = self.chart.at(normal);
        [x, -y]
    }

    /// Change of the texel coordinates where the normal changes by `turn`.
    #[inline]
    fn texel_change(&self, normal: Vector<R>, turn: Vector<R>) -> [R; 2] {
        let [x, y] = self.chart.change(normal, turn);
        [x, -y]
    }
}

/// The vector of components along three axes.
#[inline]
fn combined<R: Scalar>(axes: [Vector<R>; 3], m: Vector<R>) -> Vector<R> {
    along(along(scaled(m[0], axes[0]), m[1], axes[1]), m[2], axes[2])
}

impl<R: Scalar> Shape<R> for MappedBall<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let (_, geometric) = self.ball.enter(ray)?;
        let [x, y] = self.texel(geometric);
        let normal = combined(self.axes(geometric), normalize(self.texture.lookup(x, y)));
        Some(Hit {
            point: along(self.ball.center, self.ball.radius, geometric),
            geometric,
            normal,
            tangent: self.chart.comb.tangent(0, normal),
            part: 0,
        })
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let turn = scaled(R::ONE / self.ball.radius, step);
        let at = self.texel(hit.geometric);
        let local = normalize(self.texture.lookup(at[0], at[1]));
        let local_turn = self.texture.turn(at, self.texel_change(hit.geometric, turn));
        let axes_turn = [0, 1].map(|side| self.chart.comb.turn(side, hit.geometric, turn));
        let normal = add(
            combined(self.axes(hit.geometric), local_turn),
            combined([axes_turn[0], axes_turn[1], turn], local),
        );
        Turn { normal, tangent: self.chart.comb.turn(0, hit.normal, normal) }
    }
}

#[cfg(test)]
mod tests {
    use super::super::map::carried_maps;
    use super::MappedBall;
    use crate::camera::Size;
    use crate::vector::{add, cross, scaled};
    use lobe::slope::direction::normalize;

    #[test]
    fn the_projection_keeps_areas() {
        let maps = carried_maps(false).unwrap();
        let (ball, _) = MappedBall::seen_in(Size::of_width(400), &maps[0]);
        for k in 0..20 {
            let tilt = 0.07 * f64::from(k);
            let n = normalize([tilt.sin() * 0.8, -tilt.cos(), tilt.sin() * 0.6]);
            let u = normalize(cross(n, [0.3, 0.2, 0.9]));
            let [a, b] = [u, cross(n, u)].map(|step| ball.texel_change(n, step));
            let area = (a[0] * b[1] - a[1] * b[0]).abs();
            assert!((area / (ball.chart.density * ball.chart.density) - 1.0).abs() < 1e-12);
            let h = 1e-6;
            let [after, before] = [h, -h].map(|t| ball.texel(normalize(add(n, scaled(t, u)))));
            for axis in 0..2 {
                let difference = (after[axis] - before[axis]) / (2.0 * h);
                assert!((difference - a[axis]).abs() < 1e-6 * ball.chart.density);
            }
        }
    }
}
