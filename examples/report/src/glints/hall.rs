//! A hall without an end, seen from steep to grazing: the cells of each of its pixels.

use lobe::Error;
use lobe::material::cells::Patch;
use rayon::prelude::*;

use super::cells::{cut, whole};
use super::material::snow;
use super::model::Made;
use crate::camera::{Camera, Ray, Size};
use crate::vector::{Vector, add, dot, scaled, sub};

/// Pictures of the hall; what is not hit has 0 cells.
pub(crate) struct Hall {
    pub(crate) size: Size,
    /// Of the default model.
    pub(crate) cells: Vec<f64>,
    /// Share of each pixel that the published loops leave out.
    pub(crate) lost: Vec<f64>,
}

/// Half the width of the floor, and where the eye is above it.
const HALF: f64 = 4.0;
const EYE: Vector<f64> = [-0.8, 0.0, 1.7];

/// Columns: rows at both sides, their first, the distance of their axes, their radius.
const ROW: f64 = 2.7;
const FIRST: f64 = 5.0;
const EVERY: f64 = 4.5;
const COLUMNS: u32 = 40;
const THICK: f64 = 0.4;

/// A ball on the floor.
const BALL: Vector<f64> = [0.8, 3.6, 0.8];
const RADIUS: f64 = 0.8;

/// Where a ray meets a surface: how far, its normal, its texture coordinates and their gradients.
#[derive(Clone, Copy)]
struct Hit {
    distance: f64,
    normal: Vector<f64>,
    uv: [f64; 2],
    gradients: [Vector<f64>; 2],
}

impl Hall {
    /// A picture of this width.
    pub(super) fn seen(width: usize) -> Result<Self, Error> {
        let size = Size::of_width(width);
        let target = add(EYE, [0.08, 1.0, -0.34]);
        let camera = Camera::looking(size, EYE, target, 0.46 * width as f64);
        // As many details as there need be for no cell to be as small as one.
        let made = Made::new(&snow("", 1e12), 1.0, 0)?;
        let pixels: Vec<_> = (0..size.pixels())
            .into_par_iter()
            .map(|index| {
                let (x, y) = (index % size.width, index / size.width);
                match patch(&camera, x as f64 + 0.5, y as f64 + 0.5) {
                    Some(patch) => [whole(&made, &patch), cut(&made, &patch)[1]],
                    None => [0.0; 2],
                }
            })
            .collect();
        let picture = |k: usize| pixels.iter().map(|pixel| pixel[k]).collect();
        Ok(Self { size, cells: picture(0), lost: picture(1) })
    }
}

/// Texture coordinates of a pixel and how they change to the next ones.
fn patch(camera: &Camera<f64>, x: f64, y: f64) -> Option<Patch<f64>> {
    let ray = camera.ray(x, y);
    let hit = nearest(&ray)?;
    let steps = camera.differentials(&ray, hit.distance, hit.normal);
    let [right, up] = steps.map(|step| hit.gradients.map(|gradient| dot(gradient, step)));
    Some(Patch::new(hit.uv, right, up))
}

/// The first surface in front of the eye.
fn nearest(ray: &Ray<f64>) -> Option<Hit> {
    let walls = [-1.0, 1.0].map(|side| wall(ray, side));
    let columns = (0..COLUMNS).flat_map(|k| [-ROW, ROW].map(|x| (x, FIRST + EVERY * f64::from(k))));
    let columns = columns.map(|(x, y)| column(ray, [x, y]));
    let hits = [floor(ray), ball(ray)].into_iter().chain(walls).chain(columns).flatten();
    hits.min_by(|a, b| a.distance.total_cmp(&b.distance))
}

fn floor(ray: &Ray<f64>) -> Option<Hit> {
    let distance = -ray.eye[2] / ray.direction[2];
    let [x, y, _] = ray.at(distance);
    let hit = Hit {
        distance,
        normal: [0.0, 0.0, 1.0],
        uv: [x, y],
        gradients: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    };
    // Beyond, a pixel is longer than the hall is wide.
    (distance > 0.0 && x.abs() <= HALF && y < 1e3).then_some(hit)
}

/// A wall as high as it is seen.
fn wall(ray: &Ray<f64>, side: f64) -> Option<Hit> {
    let distance = (side * HALF - ray.eye[0]) / ray.direction[0];
    let [_, y, z] = ray.at(distance);
    let hit = Hit {
        distance,
        normal: [-side, 0.0, 0.0],
        uv: [y, z],
        gradients: [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };
    (distance > 0.0 && (0.0..5.0).contains(&z) && y < 1e3).then_some(hit)
}

/// An upright column: u around it, v up.
fn column(ray: &Ray<f64>, [x, y]: [f64; 2]) -> Option<Hit> {
    let flat = |[a, b, _]: Vector<f64>| [a, b, 0.0];
    let distance = first(flat(sub(ray.eye, [x, y, 0.0])), flat(ray.direction), THICK)?;
    let point = sub(ray.at(distance), [x, y, 0.0]);
    let normal = scaled(1.0 / THICK, flat(point));
    let around = [-normal[1], normal[0], 0.0];
    let hit = Hit {
        distance,
        normal,
        uv: [THICK * normal[1].atan2(normal[0]), point[2]],
        gradients: [around, [0.0, 0.0, 1.0]],
    };
    (0.0..4.0).contains(&point[2]).then_some(hit)
}

/// A ball: u around its axis, v from pole to pole; u is squeezed at the poles.
fn ball(ray: &Ray<f64>) -> Option<Hit> {
    let distance = first(sub(ray.eye, BALL), ray.direction, RADIUS)?;
    let normal = scaled(1.0 / RADIUS, sub(ray.at(distance), BALL));
    let ring = normal[0].hypot(normal[1]).max(1e-9);
    let around = [-normal[1] / ring, normal[0] / ring, 0.0];
    let upwards = [-normal[0] * normal[2] / ring, -normal[1] * normal[2] / ring, ring];
    Some(Hit {
        distance,
        normal,
        uv: [RADIUS * normal[1].atan2(normal[0]), RADIUS * normal[2].asin()],
        gradients: [scaled(1.0 / ring, around), upwards],
    })
}

/// Where a ray from `offset`, seen from the center, enters a sphere.
fn first(offset: Vector<f64>, direction: Vector<f64>, radius: f64) -> Option<f64> {
    let (a, b) = (dot(direction, direction), dot(offset, direction));
    let discriminant = b * b - a * (dot(offset, offset) - radius * radius);
    let distance = (-b - discriminant.max(0.0).sqrt()) / a;
    (discriminant > 0.0 && distance > 0.0).then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::{EYE, patch};
    use crate::camera::{Camera, Size};
    use crate::vector::add;

    #[test]
    fn derivatives_are_the_differences_of_small_pixels() {
        let size = Size::of_width(64);
        let camera = Camera::looking(size, EYE, add(EYE, [0.08, 1.0, -0.34]), 30.0);
        let step = 1e-5;
        let mut compared = 0;
        for index in 0..size.pixels() {
            let (x, y) = ((index % 64) as f64 + 0.5, (index / 64) as f64 + 0.5);
            let at = |x: f64, y: f64| patch(&camera, x, y);
            let (Some(here), Some(right), Some(up)) = (at(x, y), at(x + step, y), at(x, y - step))
            else {
                continue;
            };
            for (next, derivative) in [(right, here.right), (up, here.up)] {
                let moved = [0, 1].map(|k| (next.uv[k] - here.uv[k]) / step);
                let size = derivative[0].hypot(derivative[1]);
                let off = (moved[0] - derivative[0]).hypot(moved[1] - derivative[1]);
                // But at edges, and where columns begin anew.
                compared += u32::from(off < 1e-2 * size);
            }
        }
        assert!(compared > 3600, "{compared}");
    }
}
