//! A sphere seen from afar: for each pixel the direction of the viewer in the frame of its tangent
//! plane.

use crate::scalar::Scalar;
use crate::vector::{Vector, cast, cross, dot};

/// The direction to the viewer: the sphere's pole is upright, the picture's columns are in its
/// plane.
const VIEWER: Vector<f64> = [0.0, -1.0, 0.0];

/// A square picture that the sphere fills, an even number of pixels wide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub(super) side: usize,
}

/// What a pixel's center sees: its tangent frame and the viewer in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot<R> {
    /// Along the angle from the pole, along that around the axis, outwards.
    frame: [Vector<R>; 3],
    pub(super) wo: Vector<R>,
}

impl Ball {
    /// Pixels whose center lies on the sphere, as columns and rows.
    pub(super) fn pixels(self) -> impl Iterator<Item = [usize; 2]> {
        let all = (0..self.side).flat_map(move |y| (0..self.side).map(move |x| [x, y]));
        all.filter(move |&pixel| self.normal(pixel).is_some())
    }

    /// The pixel mirrored at the picture's middle column, its middle row, both or none.
    pub(super) fn mirrored(self, [x, y]: [usize; 2], [over, under]: [bool; 2]) -> [usize; 2] {
        let last = self.side - 1;
        [if over { last - x } else { x }, if under { last - y } else { y }]
    }

    pub(super) fn spot(self, pixel: [usize; 2]) -> Option<Spot<f64>> {
        let normal = self.normal(pixel)?;
        let ring = normal[0].hypot(normal[1]);
        let around = [-normal[1] / ring, normal[0] / ring, 0.0];
        let frame = [cross(around, normal), around, normal];
        Some(Spot { frame, wo: frame.map(|axis| dot(axis, VIEWER)) })
    }

    /// The sphere's normal at the pixel's center.
    fn normal(self, pixel: [usize; 2]) -> Option<Vector<f64>> {
        let [x, down] = pixel.map(|k| (2.0 * k as f64 + 1.0) / self.side as f64 - 1.0);
        let depth2 = 1.0 - x * x - down * down;
        (depth2 > 0.0).then(|| [x, -depth2.sqrt(), -down])
    }
}

impl Spot<f64> {
    pub(super) fn cast<R: Scalar>(&self) -> Spot<R> {
        Spot { frame: self.frame.map(cast), wo: cast(self.wo) }
    }
}

impl<R: Scalar> Spot<R> {
    /// A direction of the tangent frame in the world.
    #[inline]
    pub(super) fn world(&self, w: Vector<R>) -> Vector<R> {
        let [a, b, c] = &self.frame;
        [0, 1, 2].map(|k| w[0] * a[k] + w[1] * b[k] + w[2] * c[k])
    }

    /// A direction of the world in the tangent frame.
    #[inline]
    pub(super) fn local(&self, w: Vector<R>) -> Vector<R> {
        self.frame.map(|axis| dot(axis, w))
    }
}

#[cfg(test)]
mod tests {
    use super::{Ball, VIEWER};
    use crate::vector::{cross, dot};

    #[test]
    fn frames_are_right_handed_and_see_the_viewer_above() {
        let ball = Ball { side: 10 };
        for pixel in ball.pixels() {
            let spot = ball.spot(pixel).unwrap();
            let [a, b, c] = spot.frame;
            let product = cross(a, b);
            assert!((0..3).all(|k| (product[k] - c[k]).abs() < 1e-12));
            // From the pole down, and around from +x to +y.
            assert!(a[2] <= 0.0 && b[2] == 0.0 && dot(b, cross([0.0, 0.0, 1.0], c)) > 0.0);
            assert!(spot.wo[2] > 0.0 && (dot(spot.wo, spot.wo) - 1.0).abs() < 1e-12);
            let back = spot.world(spot.wo);
            assert!((0..3).all(|k| (back[k] - VIEWER[k]).abs() < 1e-12));
            assert_eq!(spot.local(VIEWER), spot.wo);
        }
        assert_eq!(ball.pixels().count(), 80);
    }

    #[test]
    fn mirrored_pixels_see_mirrored_viewers() {
        let ball = Ball { side: 12 };
        for pixel in ball.pixels() {
            let wo = ball.spot(pixel).unwrap().wo;
            for (flips, signs) in [
                ([true, false], [1.0, -1.0]),
                ([false, true], [-1.0, 1.0]),
                ([true, true], [-1.0, -1.0]),
            ] {
                let other = ball.spot(ball.mirrored(pixel, flips)).unwrap().wo;
                assert!((other[0] - signs[0] * wo[0]).abs() < 1e-12);
                assert!((other[1] - signs[1] * wo[1]).abs() < 1e-12);
            }
        }
    }
}
