//! How much the footprint of a quad's differences departs from the one of analytic derivatives, and
//! what methods cost on them.

use lobe::Error;
use serde::Serialize;

use crate::camera::Size;
use crate::method::{CountedPixels, MovingPixel, Pixel, QuadPixel};
use crate::overlap::non_overlap;
use crate::scene::{Motions, Sample, Scene};

/// Area of non-overlap of the two footprints over the larger area, over the judged pixels of a
/// picture (Kaplanyan et al. 2016, Fig. 7): 0 where they are one, 1 where one is nothing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Disagreement {
    pub(crate) mean: f64,
    pub(crate) median: f64,
    /// Of every pixel, rows from the top; 0 where it is not judged.
    #[serde(skip)]
    pub(crate) map: Vec<f64>,
}

/// A pixel of a scene with the others of its quad: this one, beside, below and across; and its
/// motions.
fn quad(scene: &Scene<f32>, size: Size, index: usize) -> ([Sample<f32>; 4], Motions<f32>) {
    let (x, y) = (index % size.width, index / size.width);
    let center = |k: usize| k as f32 + 0.5;
    let (here, motions) = scene.sample_in_motion(center(x), center(y));
    let at = |x: usize, y: usize| scene.sample(center(x), center(y));
    ([here, at(x ^ 1, y), at(x, y ^ 1), at(x ^ 1, y ^ 1)], motions)
}

impl Disagreement {
    /// In the methods' precision, at pixel centers. `None` without a judged pixel.
    pub(crate) fn on(scene: &Scene<f32>, size: Size, judged: &[bool]) -> Option<Self> {
        let of = |(index, &judged): (usize, &bool)| {
            judged.then(|| {
                let ([here, beside, below, across], motions) = quad(scene, size, index);
                let (here, beside, below, across) = (&here, &beside, &below, &across);
                let in_quad = QuadPixel { here, beside, below, across }.footprint();
                non_overlap(&in_quad, &MovingPixel { here, motions: &motions }.footprint())
            })
        };
        let differences: Vec<Option<f64>> = judged.iter().enumerate().map(of).collect();
        let mut sorted: Vec<f64> = differences.iter().filter_map(|x| *x).collect();
        sorted.sort_by(f64::total_cmp);
        let median = *sorted.get(sorted.len() / 2)?;
        let mean = sorted.iter().sum::<f64>() / sorted.len() as f64;
        let map = differences.into_iter().map(Option::unwrap_or_default).collect();
        Some(Self { mean, median, map })
    }
}

/// Pixels to count a method's operations on.
const COUNTED: usize = 512;

/// Judged pixels spread over the picture, in counting numbers, with an isotropic material.
pub(crate) fn counted(
    scene: &Scene<f32>,
    size: Size,
    judged: &[bool],
    alpha: f64,
) -> Result<CountedPixels, Error> {
    let chosen: Vec<_> = (0..judged.len()).filter(|&index| judged[index]).collect();
    // An odd step: both pixels of a quad have their turn.
    let step = chosen.len().div_ceil(COUNTED).max(1) | 1;
    let quads = chosen.into_iter().step_by(step).map(|index| quad(scene, size, index));
    CountedPixels::new(alpha, quads)
}

#[cfg(test)]
mod tests {
    use super::Disagreement;
    use crate::camera::Size;
    use crate::coverage::judged;
    use crate::light::LightKind;
    use crate::scene::Subject;

    #[test]
    fn a_smooth_scene_s_footprints_nearly_agree() {
        let size = Size::of_width(64);
        let lit = Subject::water(size).lit(LightKind::Distant);
        let judged = judged(&lit.exact, size);
        let on = Disagreement::on(&lit.engine, size, &judged).unwrap();
        assert!(on.median > 0.0 && on.median < 0.5, "{} {}", on.median, on.mean);
        assert_eq!(on.map.len(), size.pixels());
        assert_eq!(Disagreement::on(&lit.engine, size, &vec![false; size.pixels()]), None);
    }
}
