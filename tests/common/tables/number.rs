//! Numbers of a table: decimal, or hexadecimal as C99 writes them.

/// A number other than 0, to which 0 is the nearest f64.
pub(crate) const SMALLER: &str = "is smaller than any f64";

/// The finite f64 nearest to a number, or why there is none.
pub(crate) fn number(text: &str) -> Result<f64, &'static str> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let digits = unsigned.strip_prefix("0x").or_else(|| unsigned.strip_prefix("0X"));
    let value = match digits {
        Some(digits) => hexadecimal(digits).map(|x| if text.starts_with('-') { -x } else { x }),
        None => text.parse().ok(),
    };
    let value = value.ok_or("is not a number")?;
    if value.is_nan() || (value.is_infinite() && !unsigned.contains(|c: char| c.is_ascii_digit())) {
        return Err("is not a finite number");
    }
    if value.is_infinite() {
        return Err("is larger than any f64");
    }
    let (mantissa, ends): (&str, &[char]) =
        digits.map_or((text, &['e', 'E']), |text| (text, &['p', 'P']));
    let mantissa = mantissa.split(ends).next().unwrap_or_default();
    if value == 0.0 && mantissa.contains(|c: char| c.is_ascii_hexdigit() && c != '0') {
        return Err(SMALLER);
    }
    Ok(value)
}

/// The f64 nearest to hexadecimal digits with a point and a binary exponent, either of which may be
/// missing; ties to even.
fn hexadecimal(digits: &str) -> Option<f64> {
    let (mantissa, exponent) = match digits.split_once(['p', 'P']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    // 60 bits, the last of which says whether anything follows: more than any rounding to 53 looks
    // at.
    let (mut bits, mut exponent) = (0_u64, i64::from(exponent));
    exponent -= 4 * i64::try_from(fraction.len()).ok()?;
    for digit in whole.chars().chain(fraction.chars()) {
        let digit = u64::from(digit.to_digit(16)?);
        if bits < 1 << 56 {
            bits = 16 * bits + digit;
        } else {
            bits |= u64::from(digit != 0);
            exponent += 4;
        }
    }
    Some(scaled(bits, exponent))
}

/// The f64 nearest to `bits` times a power of two, rounded once.
fn scaled(bits: u64, exponent: i64) -> f64 {
    let width = i64::from(64 - bits.leading_zeros());
    if bits == 0 || width + exponent < -1100 {
        return 0.0;
    }
    if width + exponent > -1022 {
        // The first factor rounds to 53 bits, the others are powers of two that leave a normal
        // number, or infinity.
        let half = (exponent / 2).min(1000) as i32;
        let rest = (exponent - i64::from(half)).min(1000) as i32;
        return bits as f64 * f64::powi(2.0, half) * f64::powi(2.0, rest);
    }
    // In quarters of the smallest number, of which the last says whether anything is cut.
    let quarters = if exponent >= -1076 {
        bits << (exponent + 1076)
    } else {
        let cut = bits >> (-1076 - exponent);
        cut | u64::from(bits != cut << (-1076 - exponent))
    };
    let (whole, rest) = (quarters >> 2, quarters & 3);
    let up = rest == 3 || (rest == 2 && whole & 1 == 1);
    f64::from_bits(whole + u64::from(up))
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn hexadecimal_numbers_are_read_to_the_bit() {
        for (text, want) in [
            ("0x1.8p-3", 0.1875),
            ("-0X1.8P-3", -0.1875),
            ("+0x18", 24.0),
            ("0x.8p1", 1.0),
            ("0x8.p0", 8.0),
            ("0x1.999999999999ap-4", 0.1),
            ("0x0.00000000000000000001999999999999ap76", 0.1),
            ("0x0p0", 0.0),
            ("0x0.0p-5000", 0.0),
            ("0x1.fffffffffffffp1023", f64::MAX),
            ("0x1p-1022", f64::MIN_POSITIVE),
            ("0x1p-1074", f64::from_bits(1)),
            ("0x0.0000000000001p-1022", f64::from_bits(1)),
            // Ties to even, and just above a tie.
            ("0x1.00000000000008p0", 1.0),
            ("0x1.0000000000000800000000001p0", 1.0 + f64::EPSILON),
            ("0x1.00000000000018p0", 1.0 + 2.0 * f64::EPSILON),
            ("0x1.8p-1074", f64::from_bits(2)),
            ("0x2.8p-1074", f64::from_bits(2)),
            ("0x2.800000000000000000001p-1074", f64::from_bits(3)),
            ("0x0.8000000000000001p-1074", f64::from_bits(1)),
            ("0x0.fffffffffffffcp-1022", f64::MIN_POSITIVE),
        ] {
            assert_eq!(number(text).map(f64::to_bits), Ok(f64::to_bits(want)), "{text}");
        }
    }

    /// Every f64, as C's `%a` writes it.
    #[test]
    fn hexadecimal_numbers_go_there_and_back() {
        let mut bits = 1_u64;
        for _ in 0..100_000 {
            bits = bits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let x = f64::from_bits(bits ^ (bits >> 33));
            if !x.is_finite() {
                continue;
            }
            let (exponent, fraction) = ((x.to_bits() >> 52) & 0x7ff, x.to_bits() & ((1 << 52) - 1));
            let sign = if x.is_sign_negative() { "-" } else { "" };
            let text = match exponent {
                0 => format!("{sign}0x0.{fraction:013x}p-1022"),
                _ => format!(
                    "{sign}0x1.{fraction:013x}p{}",
                    i64::try_from(exponent).expect("11 bits") - 1023
                ),
            };
            assert_eq!(number(&text).map(f64::to_bits), Ok(x.to_bits()), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_says_why() {
        for text in [
            "", "zero", "1,5", "1.5f", "0x", "0x.", "0x1p", "0x1.2.3", "0xg", "0x-1", "1e", "--1",
            "1 2",
        ] {
            assert_eq!(number(text), Err("is not a number"), "{text}");
        }
        for text in ["inf", "-inf", "NaN", "Infinity"] {
            assert_eq!(number(text), Err("is not a finite number"), "{text}");
        }
        for text in ["1e400", "-1e400", "0x1p1024", "0x1.fffffffffffff8p1023", "0x1p2000000000"] {
            assert_eq!(number(text), Err("is larger than any f64"), "{text}");
        }
        for text in ["1e-400", "-1e-400", "0x1p-1076", "0x0.8p-1074", "0x1p-2000000000"] {
            assert_eq!(number(text), Err(super::SMALLER), "{text}");
        }
        assert_eq!(number("0e-400"), Ok(0.0));
        assert_eq!(number("4.9e-324"), Ok(f64::from_bits(1)));
    }
}
