//! A cube map on the CPU: what a GPU's sampler gives, for callers without one.
//!
//! Layer 4.

use super::environment::Light;
use super::lod::cube_lod;
use crate::error::Error;
use crate::scalar::Real;
use core::marker::PhantomData;

/// Six square faces with their mip chain; a [`Light`].
///
/// Over any storage of texels: a `Vec`, an array, a borrowed slice. Faces in the order of GPUs, +x,
/// -x, +y, -y, +z, -z, each by rows, oriented as theirs. Filtering is trilinear and takes texels
/// beyond an edge from the neighboring face; at the eight corners, where three faces meet, what
/// takes the place of a fourth differs from face to face. Directions are the map's own: to turn a
/// tangent frame, wrap the map in a function.
///
/// ```
/// use lobe::material::leadr::{CubeMap, Light};
/// // Bright above: face +z, here of two texels a side, and room for the level of one.
/// let mut texels = vec![[0.0_f64; 3]; CubeMap::<f64, Vec<[f64; 3]>>::texels(2)];
/// texels[4 * 4..5 * 4].fill([1.0; 3]);
/// let sky = CubeMap::new(2, texels)?;
/// assert_eq!(sky.radiance([0.0, 0.0, 1.0], 0.1), [1.0; 3]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeMap<R, T> {
    face: usize,
    last: usize,
    texels: T,
    scalar: PhantomData<R>,
}

impl<R: Real, T: AsRef<[[R; 3]]>> CubeMap<R, T> {
    /// How many texels a map of `face` texels a side has with its mip chain: 8 `face`^2 - 2.
    pub const fn texels(face: usize) -> usize {
        face.saturating_mul(face).saturating_mul(8).saturating_sub(2)
    }

    /// From `face` texels a side, a power of two, and [`CubeMap::texels`] texels: the first 6
    /// `face`^2 are the map, the rest is room for its levels, which are built by boxes.
    ///
    /// # Errors
    /// [`Error::CubeMap`].
    pub fn new(face: usize, mut texels: T) -> Result<Self, Error>
    where
        T: AsMut<[[R; 3]]>,
    {
        let all = texels.as_mut();
        if !face.is_power_of_two() || all.len() != Self::texels(face) {
            return Err(Error::CubeMap { face, texels: all.len() });
        }
        let (mut side, mut rest) = (face, all);
        let mut last = 0;
        while side > 1 {
            let (finer, coarser) = rest.split_at_mut(6 * side * side);
            let half = side / 2;
            // Rows of all faces follow each other, and a face has an even number of them.
            for (place, out) in coarser[..6 * half * half].iter_mut().enumerate() {
                let first = 2 * (place / half) * side + 2 * (place % half);
                let four = [first, first + 1, first + side, first + side + 1];
                *out = [0, 1, 2].map(|k: usize| {
                    four.iter().fold(R::ZERO, |sum, &p| sum + finer[p][k]) * R::lit(0.25)
                });
            }
            rest = coarser;
            side = half;
            last += 1;
        }
        Ok(Self { face, last, texels, scalar: PhantomData })
    }

    /// Texels a side of the finest level.
    pub const fn face(&self) -> usize {
        self.face
    }

    /// Radiance from `direction` (any length) at a level of detail, which is kept between the first
    /// level and the last.
    pub fn lookup(&self, direction: impl Into<[R; 3]>, lod: R) -> [R; 3] {
        let direction = direction.into();
        let last = self.last;
        let lod = lod.max(R::ZERO).min(R::lit(last as f64));
        let level = (0..last).rev().find(|&k| R::lit(k as f64 + 1.0) <= lod).map_or(0, |k| k + 1);
        let t = lod - R::lit(level as f64);
        let (fine, coarse) =
            (self.bilinear(direction, level), self.bilinear(direction, (level + 1).min(last)));
        mix(fine, coarse, t)
    }

    fn bilinear(&self, direction: [R; 3], level: usize) -> [R; 3] {
        let side = self.face >> level;
        let (face, [u, v]) = project(direction);
        let texels = R::lit(side as f64);
        let split = |u: R| {
            let x = R::HALF * (u + R::ONE) * texels - R::HALF;
            let below = if x < R::ZERO { -1 } else { x.to_f64() as i64 };
            (below, (x - R::lit(below as f64)).min(R::ONE))
        };
        let ((column, right), (row, down)) = (split(u), split(v));
        let line = |row: i64| {
            let [a, b] = [column, column + 1].map(|column| self.texel(level, face, column, row));
            mix(a, b, right)
        };
        mix(line(row), line(row + 1), down)
    }

    /// A texel, from the neighboring face where column or row lie one beyond this one.
    fn texel(&self, level: usize, face: usize, column: i64, row: i64) -> [R; 3] {
        let side = self.face >> level;
        let inside = |k: i64| usize::try_from(k).is_ok_and(|k| k < side);
        if inside(column) && inside(row) {
            return self.at(level, face, column, row);
        }
        // The direction of the texel's center, on the plane of this face; at the cube's corners,
        // where three faces meet, there is none, and the nearest is as good as any.
        let center = |k: i64| R::lit((2 * k + 1) as f64 / side as f64 - 1.0);
        let (face, [u, v]) = project(unproject(face, [center(column), center(row)]));
        let place = |u: R| (R::HALF * (u + R::ONE)).to_f64() * side as f64;
        self.at(level, face, place(u) as i64, place(v) as i64)
    }

    fn at(&self, level: usize, face: usize, column: i64, row: i64) -> [R; 3] {
        let side = self.face >> level;
        let [column, row] =
            [column, row].map(|k| usize::try_from(k).unwrap_or_default().min(side - 1));
        // Finer levels have 8 (face^2 - side^2) texels in all.
        let before = 8 * (self.face * self.face - side * side);
        self.texels.as_ref()[before + (face * side + row) * side + column]
    }
}

impl<R: Real, T: AsRef<[[R; 3]]>> Light<R> for CubeMap<R, T> {
    fn radiance(&self, wi: [R; 3], solid_angle: R) -> [R; 3] {
        self.lookup(wi, cube_lod(solid_angle, R::lit(self.face as f64)))
    }
}

/// The face that a direction meets, and where on it, in [-1, 1], as GPUs have it.
fn project<R: Real>([x, y, z]: [R; 3]) -> (usize, [R; 2]) {
    let [a, b, c] = [x, y, z].map(R::abs);
    let (face, u, v, along) = if a >= b && a >= c {
        if x >= R::ZERO { (0, -z, -y, a) } else { (1, z, -y, a) }
    } else if b >= c {
        if y >= R::ZERO { (2, x, z, b) } else { (3, x, -z, b) }
    } else if z >= R::ZERO {
        (4, x, -y, c)
    } else {
        (5, -x, -y, c)
    };
    // 0 and NaN have no direction: the middle of the face.
    let on = |u: R| (u / along.max(R::MIN_POSITIVE)).max(-R::ONE).min(R::ONE);
    (face, [on(u), on(v)])
}

/// The direction of a point on a face's plane.
fn unproject<R: Real>(face: usize, [u, v]: [R; 2]) -> [R; 3] {
    let one = R::ONE;
    match face {
        0 => [one, -v, -u],
        1 => [-one, -v, u],
        2 => [u, one, v],
        3 => [u, -one, -v],
        4 => [u, -v, one],
        _ => [-u, -v, -one],
    }
}

fn mix<R: Real>(a: [R; 3], b: [R; 3], t: R) -> [R; 3] {
    [0, 1, 2].map(|k: usize| a[k] + t * (b[k] - a[k]))
}
