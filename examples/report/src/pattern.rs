//! Points in the unit square: a net for the methods, jittered strata for the reference.

/// The `index`-th of `count` points of a centered Hammersley net, `count` a power of two.
///
/// Every dyadic box of area 1/count holds one point, and the mean of all points is the center: one
/// point is the pixel's center, four are the rotated grid of multisampling.
pub(crate) fn hammersley(index: u32, count: u32) -> [f32; 2] {
    let step = 1.0 / count as f32;
    let reversed = index.reverse_bits() as f32 / 4_294_967_296.0;
    [(index as f32 + 0.5) * step, reversed + 0.5 * step]
}

/// A stream of uniform pairs: SplitMix64, one stream per seed.
pub(crate) struct Jitter(u64);

impl Jitter {
    /// The stream of a seed; neighboring seeds give unrelated streams.
    pub(crate) fn new(seed: u64) -> Self {
        Self(mix(seed.wrapping_add(1).wrapping_mul(GOLDEN)))
    }

    /// The next point of the unit square.
    pub(crate) fn next(&mut self) -> [f64; 2] {
        self.0 = self.0.wrapping_add(GOLDEN);
        let bits = mix(self.0);
        [bits >> 32, bits & 0xFFFF_FFFF].map(|half| (half as f64 + 0.5) / 4_294_967_296.0)
    }
}

const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::{Jitter, hammersley};

    #[test]
    fn every_dyadic_box_holds_one_point_and_the_mean_is_the_center() {
        assert_eq!(hammersley(0, 1), [0.5, 0.5]);
        for log in [2_u32, 4, 6, 8] {
            let count = 1 << log;
            let points: Vec<_> = (0..count).map(|k| hammersley(k, count)).collect();
            for split in 0..=log {
                let (columns, rows) = ((1 << split) as f32, (1 << (log - split)) as f32);
                let mut boxes: Vec<_> = points
                    .iter()
                    .map(|p| ((p[0] * columns) as i32, (p[1] * rows) as i32))
                    .collect();
                boxes.sort_unstable();
                boxes.dedup();
                assert_eq!(boxes.len(), points.len());
            }
            let mean = points.iter().map(|p| p[1]).sum::<f32>() / count as f32;
            assert!((mean - 0.5).abs() < 1e-6);
        }
    }

    #[test]
    fn jitter_is_uniform_in_both_coordinates() {
        let mut jitter = Jitter::new(3);
        let mut sum = [0.0; 3];
        for _ in 0..20_000 {
            let [x, y] = jitter.next();
            assert!(x > 0.0 && x < 1.0 && y > 0.0 && y < 1.0);
            sum = [sum[0] + x, sum[1] + y, sum[2] + x * y];
        }
        // Five standard deviations.
        for (sum, mean) in sum.into_iter().zip([0.5, 0.5, 0.25]) {
            assert!((sum / 20_000.0 - mean).abs() < 0.011);
        }
    }
}
