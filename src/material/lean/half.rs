//! IEEE half precision, as textures store it.
//!
//! Layer 4.

/// The smallest half above 0, 2^-24.
const SMALLEST: f32 = f32::EPSILON * 0.5;

/// The nearest half, ties to even; beyond the largest, 65504, that one; 0 for NaN.
pub(super) fn to_half(x: f32) -> u16 {
    let sign = (x.to_bits() >> 16) & 0x8000;
    let magnitude = if x.is_nan() { 0.0 } else { x.abs().min(65504.0) };
    let bits = if magnitude < 6.103_515_6e-5 {
        // Below 2^-14 halves are whole numbers of 2^-24, the spacing of f32 at 1/2: a sum rounds to
        // them.
        (magnitude + 0.5).to_bits() - 0.5_f32.to_bits()
    } else {
        let bits = magnitude.to_bits();
        // Half of the last place that stays, less one where that is even; the exponents' zero
        // differs by 112.
        ((bits + 0xFFF + ((bits >> 13) & 1)) >> 13) - (112 << 10)
    };
    // Both parts have 16 bits.
    (sign | bits) as u16
}

/// The number of a half, exactly.
pub(super) fn from_half(h: u16) -> f32 {
    let (sign, magnitude) = (u32::from(h & 0x8000) << 16, u32::from(h & 0x7FFF));
    let value = match magnitude {
        0..0x400 => magnitude as f32 * SMALLEST,
        0x400..0x7C00 => f32::from_bits((magnitude << 13) + (112 << 23)),
        0x7C00 => f32::INFINITY,
        _ => f32::NAN,
    };
    f32::from_bits(value.to_bits() | sign)
}

#[cfg(test)]
mod tests {
    use super::{from_half, to_half};

    /// By the standard's definition.
    fn defined(h: u16) -> f64 {
        let (exponent, fraction) = (i32::from((h >> 10) & 31), f64::from(h & 0x3FF));
        let magnitude = match exponent {
            0 => fraction * 2.0_f64.powi(-24),
            _ => (1024.0 + fraction) * 2.0_f64.powi(exponent - 25),
        };
        if h >> 15 == 1 { -magnitude } else { magnitude }
    }

    #[test]
    fn every_half_is_read_as_defined_and_written_back() {
        for h in (0..0x7C00_u16).chain(0x8000..0xFC00) {
            assert_eq!(f64::from(from_half(h)), defined(h), "{h:04x}");
            assert_eq!(to_half(from_half(h)), h, "{h:04x}");
        }
        assert!(from_half(0x7C00) == f32::INFINITY && from_half(0x7E00).is_nan());
    }

    #[test]
    fn numbers_between_halves_go_to_the_nearer_and_ties_to_even() {
        for h in 0..0x7BFF_u16 {
            let (low, high) = (defined(h), defined(h + 1));
            let middle = (0.5 * (low + high)) as f32;
            assert_eq!(f64::from(middle), 0.5 * (low + high));
            assert_eq!(to_half(middle), h + (h & 1), "{h:04x}");
            assert_eq!(to_half(middle.next_down()), h, "{h:04x}");
            assert_eq!(to_half(middle.next_up()), h + 1, "{h:04x}");
        }
        assert_eq!([f32::MAX, f32::INFINITY, 65519.0].map(to_half), [0x7BFF; 3]);
        assert_eq!([f32::NAN, 0.0, 1e-30].map(to_half), [0; 3]);
        assert_eq!(to_half(f32::NEG_INFINITY), 0xFBFF);
    }
}
