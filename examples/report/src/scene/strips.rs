//! Thin, gently bent strips at grazing angles: the trims and window frames that flicker first.

use lobe::slope::direction::normalize;

use super::balls::Ball;
use super::surface::{Hit, Shape, world_x};
use crate::camera::{Camera, Ray, Size};
use crate::frame::Turn;
use crate::scalar::Scalar;
use crate::vector::{Vector, add, along, cast, cross, dot, scaled, sub};

/// Width and height of the part of the picture that belongs to one strip, in pixels.
const CELL: [f64; 2] = [64.0, 30.0];

/// Half the length of a strip, in pixels.
const HALF_LENGTH: f64 = 28.0;

/// Widths of the strips on the picture, in pixels, in turn.
const WIDTHS: [f64; 5] = [15.0, 6.0, 12.0, 8.0, 10.0];

/// The view's angle above the strip's middle less and plus this is that above its ends, in degrees.
const HALF_BEND: f64 = 2.0;

/// One strip: part of a large ball between two pairs of planes.
#[derive(Clone, Copy)]
struct Strip<R> {
    ball: Ball<R>,
    middle: Vector<R>,
    /// Away from the eye and across, unit, both tangents of the middle.
    tangents: [Vector<R>; 2],
    /// Half extents along them.
    reach: [R; 2],
}

/// A grid of strips, each in its own part of the picture.
pub(super) struct Strips<R> {
    parts: Vec<Strip<R>>,
    /// Columns and rows.
    grid: [i32; 2],
    /// From a ray's direction to the grid: the picture's axes over the size of a cell, and the
    /// view's.
    picture: [Vector<R>; 3],
}

impl Strips<f64> {
    /// As many as the picture holds, and a caption. `unit` is a pixel's width at the origin, which
    /// the camera looks at along +y. `aim` is the direction from a place to a light, for the even
    /// and for the odd fields of the grid's checkerboard: the middle of each strip reflects its
    /// light to the eye.
    pub(super) fn seen_by(
        camera: &Camera<f64>,
        size: Size,
        unit: f64,
        distance: f64,
        aim: impl Fn(bool, Vector<f64>) -> Vector<f64>,
    ) -> (Self, String) {
        let counts = [size.width, size.height].map(|side| side as f64 / unit);
        let grid = [0, 1].map(|k| ((counts[k] / CELL[k]).round() as i32).max(1));
        let cell = CELL.map(|side| side * unit);
        let (mut strips, mut lowest, mut highest) = (Vec::new(), 90.0_f64, 0.0_f64);
        for row in 0..grid[1] {
            for column in 0..grid[0] {
                let index = strips.len();
                let x = (f64::from(column) + 0.5 - 0.5 * f64::from(grid[0])) * cell[0];
                let z = -(f64::from(row) + 0.5 - 0.5 * f64::from(grid[1])) * cell[1];
                let middle = [x, 0.0, z];
                let view = normalize(sub(middle, [0.0, -distance, 0.0]));
                let normal = normalize(sub(aim((row + column) % 2 != 0, middle), view));
                let angle = (-dot(normal, view)).asin();
                let bend = HALF_BEND.to_radians();
                // On the picture the ball's slice is r (cos(angle - bend) - cos(angle + bend))
                // high.
                let width = WIDTHS[index % WIDTHS.len()] * unit;
                let radius = width / ((angle - bend).cos() - (angle + bend).cos());
                lowest = lowest.min((angle - bend).to_degrees());
                highest = highest.max((angle + bend).to_degrees());
                let away = normalize(along(view, -dot(view, normal), normal));
                strips.push(Strip {
                    ball: Ball { center: along(middle, -radius, normal), radius },
                    middle,
                    tangents: [away, cross(normal, away)],
                    reach: [radius * bend.sin(), HALF_LENGTH * unit],
                });
            }
        }
        let caption = format!(
            "{} thin strips of gently bent sheet, 6 to 15 pixels wide, seen at {lowest:.1} to \
                {highest:.1} \
             degrees; half of them are turned to reflect the distant light, half the point light.",
            strips.len(),
        );
        let picture = [
            scaled(distance / cell[0], normalize(camera.right)),
            scaled(distance / cell[1], normalize(camera.down)),
            [0.0, 1.0, 0.0],
        ];
        (Self { parts: strips, grid, picture }, caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Strips<R> {
        let strip = |strip: &Strip<f64>| Strip {
            ball: strip.ball.cast(),
            middle: cast(strip.middle),
            tangents: strip.tangents.map(cast),
            reach: strip.reach.map(R::lit),
        };
        Strips {
            parts: self.parts.iter().map(strip).collect(),
            grid: self.grid,
            picture: self.picture.map(cast),
        }
    }
}

impl<R: Scalar> Shape<R> for Strips<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let view = dot(ray.direction, self.picture[2]);
        let cell = [0, 1].map(|axis| {
            let count = self.grid[axis];
            let at = dot(ray.direction, self.picture[axis]) / view;
            let (index, _) = (at + R::HALF * R::lit(f64::from(count))).split();
            (0..count).contains(&index).then_some(index)
        });
        let [Some(column), Some(row)] = cell else { return None };
        let part = (row * self.grid[0] + column).unsigned_abs() as usize;
        let strip = &self.parts[part];
        let (_, normal) = strip.ball.enter(ray)?;
        let point = along(strip.ball.center, strip.ball.radius, normal);
        let from = sub(point, strip.middle);
        let within = |axis: usize| dot(from, strip.tangents[axis]).abs() <= strip.reach[axis];
        (within(0) && within(1)).then(|| Hit {
            point,
            geometric: normal,
            normal,
            tangent: world_x(),
            part,
        })
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let normal = scaled(R::ONE / self.parts[hit.part].ball.radius, step);
        Turn { normal, tangent: [R::ZERO; 3] }
    }
}

/// Direction from a point to a place.
pub(super) fn towards(from: Vector<f64>, to: Vector<f64>) -> Vector<f64> {
    normalize(add(to, scaled(-1.0, from)))
}
