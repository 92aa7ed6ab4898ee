//! A dictionary as bytes: it comes back as it was, and what is damaged, cut or forged says so.
#![cfg(feature = "glint")]

use lobe::Error;
use lobe::material::multilobe::{Dictionary, LobeMeans, Recipe};

/// Bytes come back as they were; damaged, they say how.
#[test]
fn damaged_bytes_are_refused() {
    let recipe = Recipe {
        marginals: 3,
        levels: 4,
        intervals: 64,
        means: LobeMeans::Chermain,
        seed: 5,
        ..Recipe::default()
    };
    let dictionary = Dictionary::<f32>::new(&recipe).expect("valid");
    let bytes = dictionary.to_bytes();
    assert_eq!(bytes.len(), 44 + dictionary.bytes());
    assert_eq!(Dictionary::from_bytes(&bytes), Ok(dictionary));
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        let got = Dictionary::from_bytes(&damaged).expect_err("damaged");
        let named = match at {
            0..8 => got == Error::DictionaryMagic,
            8..12 => matches!(got, Error::DictionaryVersion(version) if version != 1),
            // Sizes of other dictionaries, or of none; the rest is the checksum's.
            12..28 | 32..40 => true,
            _ => matches!(got, Error::DictionaryChecksum { expected, found } if expected != found),
        };
        assert!(named, "byte {at}: {got:?}");
    }
    for length in 0..bytes.len() {
        let got = Dictionary::from_bytes(&bytes[..length]).expect_err("cut");
        let short = matches!(got, Error::DictionaryLength { found, .. } if found == length);
        assert!(
            if length < 8 { got == Error::DictionaryMagic } else { short },
            "{length}: {got:?}"
        );
    }
    let longer: Vec<u8> = bytes.iter().copied().chain([0]).collect();
    assert!(matches!(Dictionary::from_bytes(&longer), Err(Error::DictionaryLength { .. })));
}

/// A checksum can be made anew: what is no density is refused for all that.
#[test]
fn forged_bytes_are_refused() {
    let recipe = Recipe { marginals: 2, levels: 3, ..Recipe::default() };
    let dictionary = Dictionary::<f32>::new(&recipe).expect("valid");
    let forged = |of: &dyn Fn(usize, [f32; 2]) -> [f32; 2]| {
        let mut bytes = dictionary.to_bytes();
        for (k, node) in dictionary.nodes().iter().enumerate() {
            let node = of(k, *node).map(f32::to_le_bytes).concat();
            bytes[44 + 8 * k..52 + 8 * k].copy_from_slice(&node);
        }
        let summed = bytes[..40].iter().chain(&bytes[44..]);
        let sum = summed
            .fold(0x811c_9dc5_u32, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193));
        bytes[40..44].copy_from_slice(&sum.to_le_bytes());
        Dictionary::from_bytes(&bytes)
    };
    assert_eq!(forged(&|_, node| node), Ok(dictionary.clone()));
    let forgeries: [&dyn Fn(usize, [f32; 2]) -> [f32; 2]; 6] = [
        &|_, [p, c]| [3.0 * p, c],
        &|_, [p, c]| [p, 3.0 * c],
        &|k, [p, c]| [if k == 70 { f32::MAX } else { p }, c],
        &|k, [p, c]| [if k == 70 { f32::NAN } else { p }, c],
        &|k, [p, c]| [if k == 70 { -p - 1e-6 } else { p }, c],
        &|k, [p, c]| [p, if k == 40 { c + 1e-5 } else { c }],
    ];
    for (k, forgery) in forgeries.iter().enumerate() {
        assert!(matches!(forged(forgery), Err(Error::DictionaryDensity { .. })), "forgery {k}");
    }
}
