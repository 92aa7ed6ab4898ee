//! Which pixels are judged: those whose 3 x 3 neighborhood the surface covers.
//!
//! Silhouettes inside a pixel are no specular filter's business. The pixels just inside of them
//! are, and there the view grazes the surface.

use rayon::prelude::*;

use crate::camera::Size;
use crate::scene::Scene;

/// Samples along each side of a pixel.
const SAMPLES: usize = 8;

/// True for every judged pixel of a picture.
pub(crate) fn judged(scene: &Scene<f64>, size: Size) -> Vec<bool> {
    let whole = size.grown(1);
    let covered: Vec<bool> = (0..whole.pixels())
        .into_par_iter()
        .map(|index| {
            let corner = [index % whole.width, index / whole.width].map(|k| k as f64 - 1.0);
            is_covered(scene, corner)
        })
        .collect();
    (0..size.pixels())
        .map(|index| {
            let (x, y) = (index % size.width, index / size.width);
            (0..3).all(|row| {
                covered[(y + row) * whole.width + x..][..3].iter().all(|covered| *covered)
            })
        })
        .collect()
}

/// Whether the surface is behind a grid of points that includes the pixel's corners.
fn is_covered(scene: &Scene<f64>, corner: [f64; 2]) -> bool {
    let at = |k: usize| k as f64 / (SAMPLES - 1) as f64;
    let mut points = (0..SAMPLES).flat_map(|row| (0..SAMPLES).map(move |column| (column, row)));
    points.all(|(column, row)| scene.covers(corner[0] + at(column), corner[1] + at(row)))
}

#[cfg(test)]
mod tests {
    use super::judged;
    use crate::camera::Size;
    use crate::light::LightKind;
    use crate::scene::Subject;

    #[test]
    fn planes_are_judged_everywhere_and_balls_inside_their_silhouette() {
        let size = Size::of_width(64);
        let all = judged(&Subject::water(size).lit(LightKind::Distant).exact, size);
        assert!(all.iter().all(|judged| *judged));

        let subject = Subject::balls(size);
        let scene = subject.lit(LightKind::Distant).exact;
        let mask = judged(&scene, size);
        let (mut inside, mut rim) = (0, 0);
        for (index, judged) in mask.into_iter().enumerate() {
            let (x, y) = ((index % size.width) as f64 + 0.5, (index / size.width) as f64 + 0.5);
            // A circle of points through the neighbors.
            let around = (0..32).all(|k| {
                let (sin, cos) = (0.19635 * f64::from(k)).sin_cos();
                scene.covers(x + 1.49 * cos, y + 1.49 * sin)
            });
            assert!(around || !judged, "{x} {y}");
            inside += i32::from(judged);
            rim += i32::from(scene.covers(x, y) && !judged);
        }
        assert!(inside > 100 && rim > 20, "{inside} {rim}");
    }
}
