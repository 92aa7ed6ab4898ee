//! A map's mip chain of means and covariances.
//!
//! Layer 4.

use super::level::{Finer, Stored, halved, loaded, minus};
use super::texel::{ClippedTexels, NormalTexel, SlopeCap};
use super::weight;
use crate::error::Error;
use crate::scalar::{Psd, Real};
use crate::slope::SlopeMoments;
use alloc::vec;
use alloc::vec::Vec;

/// What lies beyond a map's edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Border {
    /// The map again.
    Wrap,
    /// Its outermost texels.
    Clamp,
}

/// A slope map with its mip chain: level 0 are the slopes, each further level their means and
/// covariances.
///
/// A side of n texels has n/2 on the next level, rounded down and at least 1, as on a GPU, each the
/// box of its exact extent: of odd sides three texels in part. Level n is the merge of its texels
/// on level n - 1, and the last one, of one texel, that of the whole map. Positive semi-definite by
/// construction. A covariance errs by what rounding moves its texels' means: relative to it about
/// $2^{-23} |\mu| / \sigma$ in f32, with $\mu$ counted from the middle of the map's slopes where
/// all of them lie far from 0. (Raw moments err by the square of that, and $\mu$ counts from 0: a
/// deviation of 4e-4 of the mean is lost.)
///
/// Memory: two numbers a texel of the map and six of each level above it, in all twice the map's
/// slopes (four times of a map one texel wide). Weights ([`MomentMap::from_weighted_slopes`]) take
/// another number a texel.
///
/// ```
/// use lobe::material::lean::{Border, MomentMap, SlopeCap};
/// use lobe::Roughness;
///
/// // A 2 x 2 normal map: a groove along y.
/// let texels = [[219_u8, 128, 219], [37, 128, 219], [219, 128, 219], [37, 128, 219]];
/// let (map, clipped) =
///     MomentMap::from_normals([2, 2], &texels, SlopeCap::new(10.0_f32)?, Border::Wrap)?;
/// assert_eq!((map.levels(), clipped.fraction()), (2, 0.0));
/// let whole = map.texel(1, 0, 0);
/// assert!(whole.mean()[0].abs() < 0.01 && (whole.covariance().entries()[0] - 1.0).abs() < 0.02);
/// // From far away: a brushed lobe.
/// let lobe = whole.lobe(Roughness::from_alpha(0.1)?);
/// assert!(lobe.roughness().alphas().major > 10.0 * lobe.roughness().alphas().minor);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: material/lean/sample.rs, material/lean/weighted.rs.
#[derive(Clone, Debug, PartialEq)]
pub struct MomentMap<R> {
    size: [usize; 2],
    border: Border,
    pub(super) slopes: Vec<[R; 2]>,
    /// What levels' means are relative to: of a map of nearly equal slopes their middle, else 0.
    origin: [R; 2],
    pub(super) levels: Vec<Vec<Stored<R>>>,
    /// The texels' weights of each level, the map itself included; empty if every texel counts the
    /// same.
    pub(super) weights: Vec<Vec<R>>,
}

/// Merges a level's rows from the given one on, as many as fit into the slice.
pub(super) type Rows<'a, R> = &'a (dyn Fn(usize, &mut [Stored<R>]) + Sync);

/// Deals a level's rows to threads; `size` is the finer level's.
#[cfg(feature = "std")]
pub(super) fn deal<R: Real>(
    size: [usize; 2],
    workers: usize,
    out: &mut [Stored<R>],
    rows: Rows<'_, R>,
) {
    // A thread costs more than a few thousand merges.
    const LEAST: usize = 1 << 14;
    let [columns, count] = halved(size);
    let workers = workers.min(out.len() / LEAST).max(1);
    if workers == 1 {
        return rows(0, out);
    }
    let band = count.div_ceil(workers);
    std::thread::scope(|scope| {
        for (k, out) in out.chunks_mut(band * columns).enumerate() {
            scope.spawn(move || rows(k * band, out));
        }
    });
}

impl<R: Real> MomentMap<R> {
    /// The chain over a map of slopes, by rows.
    ///
    /// # Errors
    /// [`Error::MapSize`] unless the slopes are as many as the size says, and more than none;
    /// [`Error::Mean`] if one is beyond $10^9$ or NaN.
    pub fn from_slopes(
        size: [usize; 2],
        slopes: Vec<[R; 2]>,
        border: Border,
    ) -> Result<Self, Error> {
        Self::built(size, slopes, None, border, |_, out, rows| rows(0, out))
    }

    /// The same with the rows of each level dealt to `workers` threads (feature `std`): the result
    /// is the same to the bit for any number of them; 0 counts as 1.
    ///
    /// # Errors
    /// As [`MomentMap::from_slopes`].
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// let slopes: Vec<[f32; 2]> = (0..64).map(|k| [(k % 7) as f32, (k % 5) as f32]).collect();
    /// let two = MomentMap::from_slopes_by([8, 8], slopes.clone(), Border::Wrap, 2)?;
    /// assert_eq!(two, MomentMap::from_slopes([8, 8], slopes, Border::Wrap)?);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[cfg(feature = "std")]
    pub fn from_slopes_by(
        size: [usize; 2],
        slopes: Vec<[R; 2]>,
        border: Border,
        workers: usize,
    ) -> Result<Self, Error> {
        Self::built(size, slopes, None, border, |size, out, rows| deal(size, workers, out, rows))
    }

    /// The chain over a normal map's texels, by rows, and how many of them the cap touched.
    ///
    /// # Errors
    /// As [`MomentMap::from_slopes`].
    pub fn from_normals<T: NormalTexel>(
        size: [usize; 2],
        texels: &[T],
        cap: SlopeCap<R>,
        border: Border,
    ) -> Result<(Self, ClippedTexels), Error> {
        let mut slopes = vec![[R::ZERO; 2]; texels.len()];
        let clipped = cap.slopes(texels, &mut slopes)?;
        Ok((Self::from_slopes(size, slopes, border)?, clipped))
    }

    /// The chain, by weights if there are any; `deal` gives the rows of a level to the function
    /// that merges them, in bands of any height, `size` being the finer level's.
    pub(super) fn built(
        size: [usize; 2],
        slopes: Vec<[R; 2]>,
        weights: Option<Vec<R>>,
        border: Border,
        deal: impl Fn([usize; 2], &mut [Stored<R>], Rows<'_, R>),
    ) -> Result<Self, Error> {
        if slopes.is_empty() || size[0].checked_mul(size[1]) != Some(slopes.len()) {
            return Err(Error::MapSize { size, texels: slopes.len() });
        }
        let origin = origin(&slopes)?;
        let mut levels: Vec<Vec<Stored<R>>> = Vec::new();
        let mut weights: Vec<Vec<R>> = weights.into_iter().collect();
        let mut finer = size;
        while finer != [1, 1] {
            let [width, height] = halved(finer);
            let mut level = vec![[R::ZERO; 6]; width * height];
            let source = match levels.last() {
                None => Finer::Slopes(&slopes, origin),
                Some(moments) => Finer::Moments(moments),
            };
            match weights.last() {
                None => deal(finer, &mut level, &|row, out| source.merge_rows(finer, row, out)),
                Some(weights) => deal(finer, &mut level, &|row, out| {
                    weight::merge_rows(&source, weights, finer, row, out);
                }),
            }
            let coarser = weights.last().map(|weights| weight::coarser(weights, finer));
            weights.extend(coarser);
            levels.push(level);
            finer = [width, height];
        }
        Ok(Self { size, border, slopes, origin, levels, weights })
    }

    /// How many levels there are, the map itself included.
    pub fn levels(&self) -> usize {
        1 + self.levels.len()
    }

    /// Width and height of a level; of levels beyond the last, the last one's.
    pub fn size(&self, level: usize) -> [usize; 2] {
        let level = level.min(self.levels.len());
        self.size.map(|n| (n >> level).max(1))
    }

    /// What lies beyond the edges.
    pub const fn border(&self) -> Border {
        self.border
    }

    /// The map itself, by rows: the slopes of level 0.
    pub fn slopes(&self) -> &[[R; 2]] {
        &self.slopes
    }

    /// The moments of a texel; level, column and row beyond the last count as the last.
    #[inline]
    pub fn texel(&self, level: usize, column: usize, row: usize) -> SlopeMoments<R> {
        match level {
            // As it is: away from the origin and back it may have been rounded.
            0 => SlopeMoments::unchecked(self.slopes[self.place(0, column, row)], Psd::zero()),
            level => self.absolute(self.relative(level, column, row)),
        }
    }

    /// Where a texel stands in its level.
    #[inline]
    pub(super) fn place(&self, level: usize, column: usize, row: usize) -> usize {
        let [width, height] = self.size(level);
        row.min(height - 1) * width + column.min(width - 1)
    }

    /// The same with the mean relative to the origin.
    #[inline]
    pub(super) fn relative(&self, level: usize, column: usize, row: usize) -> SlopeMoments<R> {
        let place = self.place(level, column, row);
        match level.min(self.levels.len()) {
            0 => SlopeMoments::unchecked(minus(self.slopes[place], self.origin), Psd::zero()),
            level => loaded(&self.levels[level - 1][place]),
        }
    }

    /// Moments whose mean is relative to the origin, as they are.
    #[inline]
    pub(super) fn absolute(&self, relative: SlopeMoments<R>) -> SlopeMoments<R> {
        let [x, y] = relative.mean();
        let kept = |x: R| x.max(-R::LARGEST).min(R::LARGEST);
        let mean = [kept(x + self.origin[0]), kept(y + self.origin[1])];
        SlopeMoments::unchecked(mean, relative.covariance())
    }

    /// The moments of a level's texels, by rows: what a [`Storage`](super::Storage) encodes.
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap, Storage, Unorm16};
    /// let map = MomentMap::from_slopes([2, 1], vec![[0.0_f32, 0.0], [1.0, 0.0]], Border::Clamp)?;
    /// let layout = Unorm16::new(map.range())?;
    /// let level: Vec<[u16; 5]> = map.level(1).map(|moments| layout.encode(&moments)).collect();
    /// assert_eq!(level.len(), 1);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn level(&self, level: usize) -> impl Iterator<Item = SlopeMoments<R>> + '_ {
        let [width, height] = self.size(level);
        (0..width * height).map(move |place| self.texel(level, place % width, place / width))
    }

    /// The largest magnitude of a slope's component: what a stored range must hold.
    ///
    /// One steep texel sets it, and with it the alpha floor of all: a lower cap may lose less.
    pub fn range(&self) -> R {
        self.slopes.iter().flatten().fold(R::ZERO, |most, x| x.abs().max(most))
    }

    /// Bytes of the slopes, of all levels and of weights.
    pub fn bytes(&self) -> usize {
        core::mem::size_of_val(&self.slopes[..])
            + self.levels.iter().map(|level| core::mem::size_of_val(&level[..])).sum::<usize>()
            + self.weights.iter().map(|level| core::mem::size_of_val(&level[..])).sum::<usize>()
    }
}

/// What means are best kept relative to, for each axis: the middle of the slopes if they all lie
/// within a quarter of it around it, else 0, from which slopes are exact.
fn origin<R: Real>(slopes: &[[R; 2]]) -> Result<[R; 2], Error> {
    let (mut low, mut high) = ([R::MAX; 2], [-R::MAX; 2]);
    let mut bad = None;
    for slope in slopes {
        for axis in 0..2 {
            let x = slope[axis];
            bad = if x.is_slope() { bad } else { Some(x) };
            low[axis] = low[axis].min(x);
            high[axis] = high[axis].max(x);
        }
    }
    if let Some(x) = bad {
        return Err(Error::Mean(x.into()));
    }
    Ok([0, 1].map(|axis: usize| {
        let middle = R::HALF * (low[axis] + high[axis]);
        let reach = R::HALF * (high[axis] - low[axis]);
        if middle.abs() > R::lit(4.0) * reach { middle } else { R::ZERO }
    }))
}
