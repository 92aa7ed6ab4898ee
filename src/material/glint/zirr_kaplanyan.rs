//! Zirr & Kaplanyan's glints as they were published: the paper with what only its authors' code
//! says.
//!
//! Layer 4. To reproduce figures and to compare; [`Glints`](super::Glints) is what to shade with.
#![allow(clippy::cast_sign_loss, reason = "words of a hash have no sign")]

use super::biscale::Biscale;
use super::grid::Grid;
use super::level::{ANISOTROPY_LIMIT, CoveredCell};
use crate::error::Error;
use crate::material::cells::Patch;
use crate::ndf::Beckmann;
use crate::scalar::Real;
use crate::scalar::hash::{hash, uniform};
use crate::scalar::quantile::normal_quantile;
use crate::slope::Anisotropic;

/// Columns of cells of one level, and cells of a pixel, beyond which the code stops.
const COLUMNS: u32 = 18;
const CELLS: u32 = 60;

/// Patterns of random numbers along one axis.
const PATTERNS: f64 = 533.0;

/// Means above this are drawn from a normal distribution; below, so many steps of the inversion are
/// taken.
const NORMAL_FROM: f64 = 5.0;
const STEPS: u32 = 17;

/// The model of the 2016 paper, with the choices of its authors' shader.
///
/// It differs from [`Glints`](super::Glints) in what follows; tests/laws/zirr_kaplanyan.rs shows
/// each but the patterns.
///
/// - $1/h_z^4$ stands inside the probability, which is cut at 1: the mean is too low at grazing
///   half vectors.
/// - A light of radius $\gamma$ adds $\gamma^2/(4 (w_i \cdot h) h_z)$ to the probability at every
///   half vector: a haze.
/// - The normal branch of the binomial draw has half its variance (no $\sqrt 2$), and it jumps
///   where it begins.
/// - Sizes are drawn with one number of details and divided by another: the mean grows, 3.6 times
///   at a variation of 1.
/// - Indices are shifted right along each axis by itself: distant cells repeat, and coordinates
///   start at +100 to hide it.
/// - Random numbers know the angular bin and one of 533 x 533 offsets, not the cell.
/// - Columns of cells lie along the longer of the pixel's medians, beyond its ends, too: it jumps
///   where they change.
/// - Loops end after 18 columns a level and 60 cells: long pixels are cut short.
/// - A cell of less than one detail is brighter than a detail.
///
/// What is not of the model is not reproduced: its hash by sines, whose bits depend on the GPU, is
/// ours; the shader's masking (Smith's of GGX, and a second division by 4) is left to the caller.
///
/// Source: Zirr & Kaplanyan 2016 and the shader its authors published with it.
///
/// ```
/// use lobe::material::cells::Patch;
/// use lobe::material::glint::{Biscale, ZirrKaplanyan};
/// let snow = ZirrKaplanyan::new(Biscale::from_fractions([0.6_f32, 0.6], [0.024, 0.024])?, 5e8)?;
/// let d = snow.d(&Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 1e-3]), [0.0, 0.0, 1.0], 1.0, 0.01);
/// assert!(d >= 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZirrKaplanyan<R> {
    biscale: Biscale<R>,
    /// Details per unit area of the texture.
    pub density: R,
    /// Deviation of the number of details in a cell, against it; 0 by default, 100 in the shader's
    /// snow.
    pub variation: R,
    /// Most of what a cell's share of reflecting details may be, against the probability; 5e4 in
    /// the shader.
    pub dynamic_range: R,
}

impl<R: Real> ZirrKaplanyan<R> {
    /// From roughness along the axes and the number of details per unit area, with a dynamic range
    /// of 5e4.
    ///
    /// # Errors
    /// [`Error::Density`] unless in $[10^{-18}, 10^{18}]$.
    pub fn new(biscale: Biscale<R>, density: R) -> Result<Self, Error> {
        let most = R::LARGEST * R::LARGEST;
        if !(density >= R::ONE / most && density <= most) {
            return Err(Error::Density(density.into()));
        }
        Ok(Self { biscale, density, variation: R::ZERO, dynamic_range: R::lit(5e4) })
    }

    /// Density of normals at the unit half vector `h`, under a light of radius `gamma` with
    /// `cosine` $= w_i \cdot h$.
    pub fn d(&self, patch: &Patch<R>, h: impl Into<[R; 3]>, cosine: R, gamma: R) -> R {
        let h = h.into();
        if !(h[2] > R::ZERO) {
            return R::ZERO;
        }
        let probability = self.probability(h, cosine, gamma);
        let pixel = Pixel { model: self, h, gamma, probability };
        let (grid, _) = self.grid(patch);
        let (mut sums, mut shares) = ([R::ZERO; 2], [R::MIN_POSITIVE; 2]);
        self.visit(patch, |CoveredCell { index, exponent, share }| {
            let level = usize::from(exponent != grid.exponent());
            sums[level] = sums[level] + share * pixel.ratio(index, exponent);
            shares[level] = shares[level] + share;
        });
        let [finer, coarser] = [sums[0] / shares[0], sums[1] / shares[1]];
        let mean = finer + grid.coarser() * (coarser - finer);
        let peak = R::ONE / (R::PI * self.biscale.local().matrix().root_det().max(R::MIN_POSITIVE));
        (mean * peak).min(R::MAX)
    }

    /// Calls `f` with every cell that the loops reach. Shares of a pixel that they cut short do not
    /// sum to 1: of each level, they count against each other.
    pub fn visit(&self, patch: &Patch<R>, mut f: impl FnMut(CoveredCell<R>)) {
        let mut left = CELLS;
        let (grid, median) = self.grid(patch);
        let weights = [R::ONE - grid.coarser(), grid.coarser()];
        for (level, weight) in grid.levels().into_iter().zip(weights) {
            let [across, along] = if level.along_v { median } else { [median[1], median[0]] };
            // `max` drops the NaN of a pixel without extent.
            let skew = (across / along).max(-R::MAX).min(R::MAX);
            for n in 0..level.count.min(COLUMNS) {
                let y = level.midpoint[1] + skew * (level.place(n) - level.midpoint[0]);
                let column = level.column_at(n, y);
                for (step, share) in (0..).zip(column.shares.map(|share| share * weight)) {
                    if left > 0 && share > R::ZERO {
                        left -= 1;
                        let index = level.index(n, column.first + step);
                        f(CoveredCell { index, exponent: level.exponent, share });
                    }
                }
            }
        }
    }

    /// Probability that a detail reflects: D over that of one detail along its normal, at most 1,
    /// and the light's share.
    pub fn probability(&self, h: impl Into<[R; 3]>, cosine: R, gamma: R) -> R {
        let (h, zero, one) = (h.into(), R::ZERO, R::ONE);
        let local = self.biscale.local().matrix().root_det();
        let d = Beckmann::new(Anisotropic::new(self.biscale.global())).d(h);
        let probability = (d * (R::PI * local)).min(one);
        let light = gamma * gamma / (R::lit(4.0) * cosine * h[2]).max(R::MIN_POSITIVE);
        probability + light.max(zero).min(one) * (one - probability)
    }

    /// Compression of the coordinates for anisotropic details.
    fn stretch(&self) -> [R; 2] {
        let [xx, _, yy] = self.biscale.spread().matrix().entries();
        let floor = R::lit(1e-12);
        let (xx, yy) = (xx.max(floor), yy.max(floor));
        [(xx / yy).sqrt().min(R::ONE), (yy / xx).sqrt().min(R::ONE)]
    }

    /// The two grids, by the width of the pixel as it is and its length with the coordinates
    /// compressed; and its longer median.
    fn grid(&self, patch: &Patch<R>) -> (Grid<R>, [R; 2]) {
        let factors = self.stretch();
        let moved = Patch { uv: patch.uv.map(|x| x + R::lit(100.0)), ..*patch };
        let stretched = moved.stretched(factors);
        let ([a, b], whole) = (stretched.extents(), patch.extents());
        let (long, across) = if b > a { (b, whole[1]) } else { (a, whole[0]) };
        let width = patch.area() / across;
        let longer = usize::from(b > a);
        let (right, up) = (stretched.right, stretched.up);
        let median = if right[longer].abs() > up[longer].abs() { right } else { up };
        let size = width.max(long / R::lit(f64::from(ANISOTROPY_LIMIT)));
        // Columns over all of the length.
        (Grid::of_size(stretched, R::ZERO, size), median)
    }
}

/// What all cells of a pixel share.
struct Pixel<'a, R> {
    model: &'a ZirrKaplanyan<R>,
    h: [R; 3],
    gamma: R,
    probability: R,
}

impl<R: Real> Pixel<'_, R> {
    /// Share of a cell's details that reflect.
    fn ratio(&self, index: [i64; 2], exponent: i32) -> R {
        let ZirrKaplanyan { biscale, density, variation, dynamic_range } = *self.model;
        let shifted = index.map(|i| if i == 0 { 0 } else { i >> i.trailing_zeros() } as u32);
        let [a, b, c, _] = hash([shifted[0], shifted[1], 0, 0]);
        let jitter = [uniform::<R>(a), uniform(b)];
        let [xx, _, yy] = biscale.local().matrix().entries();
        let (alphas, stretch) = ([xx.sqrt(), yy.sqrt()], self.model.stretch());
        let seed = [0, 1].map(|k| {
            let q = self.h[k] / (self.h[2] + R::ONE) * R::lit(0.75);
            let bin = (q * stretch[k] / (alphas[k] + self.gamma) + jitter[k]).floor();
            bin.wrapping_add((jitter[k] * R::lit(PATTERNS)).floor()) as u32
        });
        let size = R::power_of_two(exponent);
        let n = density * size * size;
        let [count, ..] = hash([seed[0], seed[1], 1, 0]);
        let larger = R::ONE + variation * erf_inverse(uniform::<R>(c));
        let folded = if larger > R::ZERO {
            larger
        } else {
            (larger - R::lit(f64::from(larger.floor()))) / (R::ONE - larger)
        };
        let drawn = (n * folded).max(n.min(R::ONE));
        let reflecting = zirr_kaplanyan_count(uniform(count), drawn, self.probability);
        let share = reflecting / (n * folded).max(R::MIN_POSITIVE);
        share.min(dynamic_range * self.probability)
    }
}

/// The inverse error function of 2u - 1.
fn erf_inverse<R: Real>(u: R) -> R {
    normal_quantile(R::ONE - u) / R::TWO.sqrt()
}

/// The binomial draw of the shader: the number of `n` details of probability `p`, grows with `u` in
/// [0, 1).
///
/// Source: Zirr & Kaplanyan 2016, section 4.3, and their shader: means above 5 are drawn from a
/// normal distribution of half the variance; below, the lattice $0.9^k$ is inverted by at most 17
/// steps and an exponential tail.
///
/// ```
/// use lobe::material::glint::{Binomial, zirr_kaplanyan_count};
/// // At a mean of 10 the quantile of one in a thousand: 21 details, and 16.9 as published.
/// assert!((Binomial::new(1e4_f64, 1e-3).draw(1e-3) - 21.0).abs() < 1.0);
/// assert!((zirr_kaplanyan_count(0.999_f64, 1e4, 1e-3) - 16.9).abs() < 0.1);
/// ```
pub fn zirr_kaplanyan_count<R: Real>(u: R, n: R, p: R) -> R {
    let (zero, one) = (R::ZERO, R::ONE);
    if p >= one {
        return n;
    }
    if !(p > R::lit(1e-10)) {
        return zero;
    }
    let mean = n * p;
    if mean > R::lit(NORMAL_FROM) {
        return (mean + (mean * (one - p)).sqrt() * erf_inverse(u)).max(zero).min(n);
    }
    let trials = -R::lit(f64::from((-n).floor()));
    let ln_lattice = R::lit(0.9).ln();
    let place = (p * (n / trials)).ln() / ln_lattice;
    let below = R::lit(f64::from(place.floor()));
    let at = |k: R| inverted(u, trials, (k * ln_lattice).exp());
    let (few, many) = (at(below + one), at(below));
    many + (place - below) * (few - many)
}

/// The count by inversion, with the tail that replaces it after 17 steps.
fn inverted<R: Real>(u: R, trials: R, p: R) -> R {
    let (zero, one) = (R::ZERO, R::ONE);
    if p >= one {
        return trials;
    }
    let mut pmf = (trials * (one - p).ln()).exp();
    let (mut cdf, mut count) = (pmf, zero);
    for _ in 0..STEPS {
        if u < cdf || count >= trials {
            return count.min(trials);
        }
        count = count + one;
        pmf = pmf * ((trials + one - count) / count * (p / (one - p)));
        cdf = cdf + pmf;
    }
    if u < cdf {
        return count.min(trials);
    }
    let left = ((u - cdf) / (one - cdf)).max(zero).min(one);
    let most = one - ((trials - count - one).max(zero) * p.ln()).exp();
    let further = (one - most * left).max(R::MIN_POSITIVE).ln() / p.ln();
    (count + one + further).min(trials)
}
