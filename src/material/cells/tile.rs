//! Tiles: the whole part of a texture coordinate, of which cells are counted in integers.
//!
//! Layer 4.
#![cfg_attr(test, allow(clippy::cast_possible_wrap, reason = "bits of a tile's number"))]

use crate::scalar::Real;
use crate::scalar::exact::two_product;

/// Outside of tile 0 no cell is smaller than $2^{-31}$ of a tile: indices of tiles of 32 bits then
/// fit into 64.
pub(super) const FINEST: i32 = -31;

/// The smallest cell of a tile: none in tile 0, whose indices count from the origin.
#[inline]
pub(in crate::material) fn finest<R: Real>(tile: [i32; 2]) -> R {
    if tile == [0; 2] { R::ZERO } else { R::power_of_two(FINEST) }
}

/// The index that cells of size $2^k$ are counted from, k being `exponent`: that of the tile's
/// corner, or, if cells are larger than a tile, that of the last cell center not after it. It is 0
/// for cells above $2^{30}$, of which a few hold all tiles.
#[inline]
pub(in crate::material) fn corner(tile: i32, exponent: i32) -> i64 {
    if exponent <= 0 {
        // Finer cells are those of tile 0, where this is 0.
        i64::from(tile) << (-exponent).min(-FINEST)
    } else if exponent <= 30 {
        i64::from(tile >> exponent)
    } else {
        0
    }
}

/// How far a coordinate lies from its [`corner`], in cells of size $2^k$.
#[inline]
pub(in crate::material) fn place<R: Real>(tile: i32, fraction: R, exponent: i32) -> R {
    let whole = match exponent {
        ..=0 => 0,
        1..=30 => tile & ((1 << exponent) - 1),
        _ => tile,
    };
    let from_corner = if whole == 0 { fraction } else { number::<R>(whole) + fraction };
    from_corner * R::power_of_two(-exponent)
}

/// A coordinate times a factor in [0, 1], as a tile and a fraction again. In f32 the fraction is
/// off by $2^{-22}$ at most for fractions in [-1, 1], however far the tile is.
#[inline]
pub(super) fn compressed<R: Real>(tile: i32, fraction: R, factor: R) -> (i32, R) {
    let unit = R::power_of_two(16);
    // Halves of the tile's number have 16 bits, so their products with the factor are exact as
    // pairs.
    let (upper, upper_rest) = two_product(number(tile >> 16), factor);
    let (lower, lower_rest) = two_product(number(tile & 0xffff), factor);
    let (a, part) = split(upper);
    let (b, p) = split(exact(part * unit));
    let (c, q) = split(exact(exact(upper_rest) * unit));
    let (d, r) = split(lower);
    let (e, part) = split((p + q) + (r + exact(lower_rest)));
    let whole = a.wrapping_shl(16).wrapping_add(b).wrapping_add(c).wrapping_add(d).wrapping_add(e);
    (whole, part + fraction * factor)
}

/// The whole number next to x towards 0, and the fraction that is left. Rounded away from 0, a
/// fraction could need more bits than x has.
#[inline]
fn split<R: Real>(x: R) -> (i32, R) {
    let size = x.abs().floor();
    let whole = if x < R::ZERO { -size } else { size };
    (whole, exact(x - number(whole)))
}

/// Marks a result as exact, for precisions that count roundings (`probe::Rounded`).
#[inline]
fn exact<R: Real>(x: R) -> R {
    let (x, _) = x.with_rest(R::ZERO);
    x
}

/// A whole number, rounded once.
#[inline]
fn number<R: Real>(whole: i32) -> R {
    R::lit(f64::from(whole))
}

#[cfg(test)]
mod tests {
    use super::{compressed, corner, place};
    use crate::scalar::hash::hash;

    /// Any tile, small ones as often as large ones.
    fn tile(words: [u32; 4]) -> i32 {
        words[0] as i32 >> (words[1] % 32)
    }

    /// Corner and place sum to the coordinate: exactly in f64, where no bit of a fraction of 20
    /// bits is lost.
    #[test]
    fn corners_and_places_are_coordinates() {
        for k in 0..100_000 {
            let words = hash([k, 0, 0, 1]);
            let tile = tile(words);
            let fraction = f64::from(words[2] >> 12) * 2.0_f64.powi(-20);
            let exponent = (words[3] % 72) as i32 - 31;
            let (corner, place) = (corner(tile, exponent), place(tile, fraction, exponent));
            // In units of 2^-20, and of 2^-31 for the corner's sake.
            let want = i128::from(tile) << 51 | integer(fraction * 2.0_f64.powi(51));
            let whole = i128::from(corner) << (exponent + 51);
            let part = integer(place * 2.0_f64.powi(exponent + 51));
            assert_eq!(whole + part, want, "{tile} and {fraction} in cells of 2^{exponent}");
            assert!(exponent > 30 || place >= 0.0 && place < 2.0_f64.powi(exponent.min(0).abs()));
        }
    }

    fn integer(x: f64) -> i128 {
        assert!(x.fract() == 0.0, "{x}");
        x as i128
    }

    /// A product's tile and fraction against integers of 128 bits: floats are odd numbers times
    /// powers of two.
    #[test]
    fn compressed_tiles_keep_their_fraction() {
        let mut largest = 0.0_f64;
        for k in 0..200_000 {
            let words = hash([k, 1, 0, 1]);
            let tile = tile(words);
            // Factors in (0, 1] of any 24 bits, and fractions in [-1, 1).
            let (shift, bits) = (words[1] / 32 % 12, 1 + (words[2] >> 8));
            let factor = f64::from(bits) * 2.0_f64.powi(-24 - shift as i32);
            let offset = (words[3] >> 8) as i32 - (1 << 23);
            let fraction = f64::from(offset) * 2.0_f64.powi(-23);
            let (whole, part) = compressed(tile, fraction as f32, factor as f32);
            // In units of 2^-59.
            let want = (((i128::from(tile) << 23) + i128::from(offset)) * i128::from(bits))
                << (12 - shift);
            let got = (i128::from(whole) << 59) + integer(f64::from(part) * 2.0_f64.powi(59));
            largest = largest.max((got - want).unsigned_abs() as f64 * 2.0_f64.powi(-59));
            assert!(part.abs() <= 2.0, "{part}");
        }
        assert!(largest <= 2.0_f64.powi(-22), "{largest:e}");
    }

    #[test]
    fn whole_factors_change_nothing() {
        for tile in [0, 1, -1, 77, -1_000_003, i32::MAX, i32::MIN] {
            for fraction in [0.0_f32, 0.7, -0.3, 1.5] {
                assert_eq!(compressed(tile, fraction, 1.0), (tile, fraction));
                assert_eq!(compressed(tile, fraction, 0.0), (0, 0.0));
            }
        }
    }
}
