//! A level of a texture: texels that repeat, looked up by their nearest or by four, and halved.

use crate::scalar::Scalar;

/// Texels of N numbers, rows first.
pub(crate) struct Level<const N: usize> {
    size: [usize; 2],
    /// The same: what repeats has signs.
    period: [i32; 2],
    texels: Vec<[f32; N]>,
}

impl<const N: usize> Level<N> {
    /// As many texels as the sides say.
    pub(crate) fn new(size: [usize; 2], texels: Vec<[f32; N]>) -> Self {
        debug_assert_eq!(size[0] * size[1], texels.len());
        // Sides are at most 16,384.
        let period = size.map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        Self { size, period, texels }
    }

    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    pub(crate) fn texels(&self) -> &[[f32; N]] {
        &self.texels
    }

    /// In texels, of texture coordinates.
    #[inline]
    fn scaled<R: Scalar>(&self, uv: [R; 2]) -> [R; 2] {
        let [width, height] = self.size.map(|side| R::lit(side as f64));
        [uv[0] * width, uv[1] * height]
    }

    /// The texel that holds a point, in texture coordinates.
    #[inline]
    pub(crate) fn nearest<R: Scalar>(&self, uv: [R; 2]) -> [f32; N] {
        let [x, y] = self.scaled(uv).map(|t| t.split().0);
        let [[column, _], [row, _]] = [neighbors(x, self.period[0]), neighbors(y, self.period[1])];
        self.texels[row * self.size[0] + column]
    }

    /// The four texels around a point, rows first, and the point's fractions between them;
    /// coordinates count texels, and texel (i, j) has its center at (i + 1/2, j + 1/2), as on a
    /// GPU.
    #[inline]
    pub(crate) fn corners<R: Scalar>(&self, at: [R; 2]) -> ([[[R; N]; 2]; 2], [R; 2]) {
        let [(column, fx), (row, fy)] = at.map(|t| (t - R::HALF).split());
        let columns = neighbors(column, self.period[0]);
        let rows = neighbors(row, self.period[1]);
        let texel = |column: usize, row: usize| {
            self.texels[row * self.size[0] + column].map(|c| R::lit(f64::from(c)))
        };
        (rows.map(|row| columns.map(|column| texel(column, row))), [fx, fy])
    }

    /// Between the four texels around a point, whose coordinates count texels.
    #[inline]
    pub(crate) fn between<R: Scalar>(&self, at: [R; 2]) -> [R; N] {
        let ([above, below], [fx, fy]) = self.corners(at);
        mix(mix(above[0], above[1], fx), mix(below[0], below[1], fx), fy)
    }

    /// The same in texture coordinates.
    #[inline]
    pub(crate) fn bilinear<R: Scalar>(&self, uv: [R; 2]) -> [R; N] {
        self.between(self.scaled(uv))
    }

    /// The next coarser level: means by area, so that odd sides lose nothing.
    fn halved(&self) -> Self {
        let size = self.size.map(|side| (side / 2).max(1));
        let [columns, rows] = [0, 1].map(|axis| shares(self.size[axis], size[axis]));
        let texel = |row: &[(usize, f32)], column: &[(usize, f32)]| {
            let mut mean = [0.0; N];
            for &(y, of_row) in row {
                for &(x, of_column) in column {
                    let texel = &self.texels[y * self.size[0] + x];
                    mean.iter_mut().zip(texel).for_each(|(m, t)| *m += of_row * of_column * t);
                }
            }
            mean
        };
        let texels = rows.iter().flat_map(|row| columns.iter().map(move |c| texel(row, c)));
        Self::new(size, texels.collect())
    }
}

/// A level and all its coarser ones.
pub(crate) struct Chain<const N: usize>(Vec<Level<N>>);

impl<const N: usize> Chain<N> {
    pub(crate) fn of(finest: Level<N>) -> Self {
        let mut levels = vec![finest];
        while let Some(last) = levels.last()
            && last.size != [1, 1]
        {
            levels.push(last.halved());
        }
        Self(levels)
    }

    /// Bilinear on the two levels around `lod`, and between them.
    #[inline]
    pub(crate) fn trilinear<R: Scalar>(&self, uv: [R; 2], lod: R) -> [R; N] {
        let last = self.0.len() - 1;
        let (level, between) = lod.max(R::ZERO).min(R::lit(last as f64)).split();
        let level = level.unsigned_abs() as usize;
        let [finer, coarser] = [level, (level + 1).min(last)].map(|k| self.0[k].bilinear(uv));
        mix(finer, coarser, between)
    }
}

/// Which texels of `many` make each of `few`, and their shares of it.
fn shares(many: usize, few: usize) -> Vec<Vec<(usize, f32)>> {
    // In units of a part 1/few of a texel: whole numbers, no rounding.
    let of = |k: usize| {
        let (from, to) = (k * many, (k + 1) * many);
        let within = from / few..to.div_ceil(few);
        let share = |j: usize| (to.min((j + 1) * few) - from.max(j * few)) as f32 / many as f32;
        within.map(|j| (j, share(j))).collect()
    };
    (0..few).map(of).collect()
}

/// From `a` at 0 to `b` at 1.
#[inline]
pub(crate) fn mix<R: Scalar, const N: usize>(a: [R; N], b: [R; N], t: R) -> [R; N] {
    std::array::from_fn(|k| a[k] + t * (b[k] - a[k]))
}

/// A texel index and the next one, repeated with the given period.
#[inline]
fn neighbors(index: i32, period: i32) -> [usize; 2] {
    let first = index.rem_euclid(period).unsigned_abs() as usize;
    let second = first + 1;
    [first, if second == period.unsigned_abs() as usize { 0 } else { second }]
}

#[cfg(test)]
mod tests {
    use super::{Chain, Level};

    #[test]
    fn centers_give_their_texels_and_halves_their_means() {
        let level = Level::new([2, 2], vec![[0.0], [1.0], [4.0], [9.0]]);
        assert_eq!(level.nearest([0.3_f32, 0.9]), [4.0]);
        assert_eq!(level.nearest([-0.3_f32, 1.2]), [1.0]);
        assert_eq!(level.bilinear([0.75_f64, 0.75]), [9.0]);
        assert_eq!(level.bilinear([0.5_f64, 0.25]), [0.5]);
        // Beyond the border is the other side.
        assert_eq!(level.bilinear([1.0_f64, 0.25]), [0.5]);
        let chain = Chain::of(level);
        assert_eq!(chain.trilinear([0.1_f64, 0.8], 7.0), [3.5]);
        assert_eq!(chain.trilinear([0.75_f64, 0.75], 0.5), [0.5 * (9.0 + 3.5)]);
        assert_eq!(chain.trilinear([0.75_f64, 0.75], -1.0), [9.0]);
    }

    #[test]
    fn odd_sides_keep_their_mean() {
        let texels: Vec<_> = (0..35_u16).map(|k| [f32::from(k * k % 11)]).collect();
        let mean = texels.iter().map(|t| t[0]).sum::<f32>() / 35.0;
        let chain = Chain::of(Level::new([7, 5], texels));
        assert!((chain.trilinear([0.4_f32, 0.4], 9.0)[0] - mean).abs() < 1e-6);
    }
}
