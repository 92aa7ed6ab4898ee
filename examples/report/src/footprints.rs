//! How much the footprint of a quad's differences departs from the one of analytic derivatives.

use crate::camera::Size;
use crate::method::{MovingPixel, Pixel, QuadPixel};
use crate::scene::Scene;

/// Relative differences over the judged pixels of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disagreement {
    pub(crate) mean: f64,
    pub(crate) median: f64,
}

impl Disagreement {
    /// In the methods' precision, at pixel centres. `None` without a judged pixel.
    ///
    /// Per pixel $|M_a - M_q| / \max(|M_a|, |M_q|)$ in the Frobenius norm, the columns of M the derivative
    /// vectors and their signs brought to agree: of the order of the area of non-overlap over the larger
    /// area (Kaplanyan et al. 2016, Fig. 7), and 0 and about 1 in the same cases.
    pub(crate) fn on(scene: &Scene<f32>, size: Size, judged: &[bool]) -> Option<Self> {
        let centre = |k: usize| k as f32 + 0.5;
        let pixels = judged.iter().enumerate().filter(|(_, judged)| **judged);
        let mut differences: Vec<f64> = pixels
            .map(|(index, _)| {
                let (x, y) = (index % size.width, index / size.width);
                let (here, motions) = scene.sample_in_motion(centre(x), centre(y));
                let beside = scene.sample(centre(x ^ 1), centre(y));
                let below = scene.sample(centre(x), centre(y ^ 1));
                // The fourth pixel is nobody's difference.
                let quad =
                    QuadPixel { here: &here, beside: &beside, below: &below, across: &below };
                let quad = quad.footprint();
                let analytic = MovingPixel { here: &here, motions: &motions }.footprint();
                difference([quad.u, quad.v], [analytic.u, analytic.v])
            })
            .collect();
        differences.sort_by(f64::total_cmp);
        let median = *differences.get(differences.len() / 2)?;
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        Some(Self { mean, median })
    }
}

/// Of two pairs of vectors, each of which may point either way.
fn difference(a: [[f32; 2]; 2], b: [[f32; 2]; 2]) -> f64 {
    let square = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
    let (mut apart, mut largest) = (0.0, [0.0_f64; 2]);
    for (a, b) in a.into_iter().zip(b) {
        let (a, b) = (a.map(f64::from), b.map(f64::from));
        apart += square([a[0] - b[0], a[1] - b[1]]).min(square([a[0] + b[0], a[1] + b[1]]));
        largest = [largest[0] + square(a), largest[1] + square(b)];
    }
    let largest = largest[0].max(largest[1]);
    if largest > 0.0 { (apart / largest).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{Disagreement, difference};
    use crate::camera::Size;
    use crate::coverage::judged;
    use crate::light::LightKind;
    use crate::scene::Subject;

    #[test]
    fn differences_do_not_ask_for_signs() {
        let a = [[1.0, 0.0], [0.0, 2.0]];
        assert_eq!(difference(a, a), 0.0);
        assert_eq!(difference(a, [[-1.0, 0.0], [0.0, 2.0]]), 0.0);
        assert_eq!(difference(a, [[0.0; 2]; 2]), 1.0);
        assert_eq!(difference([[0.0; 2]; 2], [[0.0; 2]; 2]), 0.0);
    }

    #[test]
    fn a_smooth_scene_s_footprints_nearly_agree() {
        let size = Size::of_width(64);
        let lit = Subject::water(size).lit(LightKind::Distant);
        let on = Disagreement::on(&lit.engine, size, &judged(&lit.exact, size)).unwrap();
        assert!(on.median > 0.0 && on.median < 0.5, "{on:?}");
        assert_eq!(Disagreement::on(&lit.engine, size, &vec![false; size.pixels()]), None);
    }
}
