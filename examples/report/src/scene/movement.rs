//! Movements: the object turns about the vertical axis, or the camera goes sideways.

use serde::Serialize;

use super::subject::{Lit, Subject};
use super::surface::{Shape, on_shape};
use crate::light::LightKind;
use crate::vector::{dot, scaled, sub};

/// How a scene changes with time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) enum Movement {
    /// The object turns about the world's z axis, what faces the eye to the right; the light stays.
    Turn,
    /// The camera goes to its right.
    Pan,
}

impl Subject {
    /// The scene once the movement has shifted what is at the picture's center by `pixels`.
    ///
    /// A turn shifts what comes to the center by as much at every time, whatever has passed by
    /// before. Where the center shows nothing, or the axis itself, nothing turns.
    pub(crate) fn lit_after(&self, light: LightKind, movement: Movement, pixels: f64) -> Lit {
        let [x, y] = [self.size.width, self.size.height].map(|side| 0.5 * side as f64);
        let ray = self.camera.ray(x, y);
        let hit = on_shape!(&self.surface, shape => shape.hit(&ray));
        let point = hit.map_or([0.0; 3], |hit| hit.point);
        // Towards the center a ray's direction has length 1.
        let depth = dot(sub(point, ray.eye), ray.direction);
        let shift = scaled(pixels * depth, self.camera.right);
        let light = &self.lights[light as usize];
        match movement {
            Movement::Pan => self.seen(self.camera.moved(shift), light.clone()),
            Movement::Turn => {
                let radius = point[0].hypot(point[1]);
                let arc = pixels.signum() * dot(shift, shift).sqrt();
                let angle = if radius > 0.0 { arc / radius } else { 0.0 };
                // An object that turns one way looks as if eye and light turned the other way.
                self.seen(self.camera.turned(-angle), light.turned(-angle))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::map::carried_maps;
    use super::super::surface::{Shape, on_shape};
    use super::{Movement, Subject};
    use crate::camera::Size;
    use crate::light::LightKind;
    use crate::vector::{Vector, dot, sub};

    const SIZE: Size = Size { width: 160, height: 90 };

    /// The surface's point at the picture's center, and where it is seen so many pixels later.
    fn followed(subject: &Subject, movement: Movement, from: f64, to: f64) -> [f64; 2] {
        let [before, after] =
            [from, to].map(|at| subject.lit_after(LightKind::Distant, movement, at).exact);
        let ray = before.camera.ray(80.0, 45.0);
        let hit = on_shape!(&before.surface, shape => shape.hit(&ray)).unwrap();
        after.camera.place(hit.point)
    }

    #[test]
    fn the_point_at_the_center_moves_by_as_many_pixels_as_stated() {
        let ball = Subject::mapped_ball(SIZE, &carried_maps(false).unwrap()[0]);
        let water = Subject::water(SIZE);
        for from in [-7.0, 0.0, 3.3] {
            for step in [0.05, 0.2, 0.3] {
                // A turn moves along an arc of 40 pixels radius, seen from 1000 pixels away: 0.3
                // pixels are 7.5e-3 radians, and sin is less than its angle by a part of 1e-5.
                let [x, y] = followed(&ball, Movement::Turn, from, from + step);
                assert!(
                    ((x - 80.0) / step - 1.0).abs() < 2e-5 && (y - 45.0).abs() < 1e-9,
                    "{x} {y}"
                );
                let [x, y] = followed(&water, Movement::Pan, from, from + step);
                assert!(
                    ((x - 80.0) / step + 1.0).abs() < 1e-9 && (y - 45.0).abs() < 1e-9,
                    "{x} {y}"
                );
            }
        }
    }

    #[test]
    fn a_turn_moves_neither_silhouette_nor_light_and_a_pan_shows_what_was_beside() {
        let ball = Subject::mapped_ball(SIZE, &carried_maps(false).unwrap()[0]);
        let rest = ball.lit(LightKind::Distant).exact;
        let turned = ball.lit_after(LightKind::Distant, Movement::Turn, 5.0).exact;
        let angle = |v: Vector<f64>, w: Vector<f64>| dot(v, w);
        for (x, y) in [(50.0, 20.0), (39.0, 45.0), (80.0, 4.8), (110.0, 70.0)] {
            assert_eq!(rest.covers(x, y), turned.covers(x, y), "{x} {y}");
            // Between view and light nothing changes; between both and the map it does.
            let (before, after) = (rest.sample(x, y), turned.sample(x, y));
            if before.hit {
                let cosines = [before, after].map(|s| angle(s.wo, s.wi));
                assert!((cosines[0] - cosines[1]).abs() < 1e-12);
                let changed = sub(before.half, after.half);
                assert!(dot(changed, changed) > 1e-12);
            }
        }
        // The camera keeps its direction: under a distant light a pan is another part of the same
        // picture along a row of constant depth, by as many pixels as that depth makes of the step.
        let water = Subject::water(SIZE);
        let rest = water.lit(LightKind::Distant).exact;
        let panned = water.lit_after(LightKind::Distant, Movement::Pan, 2.0).exact;
        let hit = |scene: &super::super::Scene<f64>, x: f64| {
            let ray = scene.camera.ray(x, 45.0);
            on_shape!(&scene.surface, shape => shape.hit(&ray)).unwrap()
        };
        let (before, after) = (hit(&rest, 62.0), hit(&panned, 60.0));
        for k in 0..3 {
            assert!((before.point[k] - after.point[k]).abs() < 1e-12);
            assert!((before.normal[k] - after.normal[k]).abs() < 1e-12);
        }
    }
}
