//! A dictionary as bytes, for a file of the caller's.
//!
//! Layer 4.

use alloc::vec::Vec;

use super::dictionary::Dictionary;
use super::generate::REACH;
use super::recipe::{LobeMeans, Recipe};
use crate::error::Error;

/// What bytes of a dictionary begin with.
const MAGIC: [u8; 8] = *b"lobe dct";

/// The layout's number: of others, none is read.
const VERSION: u32 = 1;

/// Bytes before the nodes.
const HEADER: usize = 44;

impl Dictionary<f32> {
    /// The dictionary as bytes.
    ///
    /// Little-endian: 8 bytes `lobe dct`; u32 version, 1; u32 marginals, levels, intervals; u32
    /// means, 0 for [`LobeMeans::Stratified`] and 1 for [`LobeMeans::Chermain`]; u32 seed; f64
    /// width; u32 checksum, FNV-1a of all other bytes; then f32 density and f32 cumulative of each
    /// node, in the order of [`Dictionary::nodes`].
    ///
    /// ```
    /// use lobe::Error;
    /// use lobe::material::multilobe::{Dictionary, Recipe};
    /// let recipe = Recipe { marginals: 4, levels: 3, ..Recipe::default() };
    /// let dictionary = Dictionary::<f32>::new(&recipe)?;
    /// let mut bytes = dictionary.to_bytes();
    /// assert_eq!(Dictionary::from_bytes(&bytes)?, dictionary);
    /// bytes[100] ^= 1;
    /// assert!(matches!(Dictionary::from_bytes(&bytes), Err(Error::DictionaryChecksum { .. })));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn to_bytes(&self) -> Vec<u8> {
        let Recipe { marginals, levels, intervals, width, means, seed } = *self.recipe();
        let means = match means {
            LobeMeans::Stratified => 0_u32,
            LobeMeans::Chermain => 1,
        };
        let mut bytes = Vec::with_capacity(HEADER + 8 * self.nodes().len());
        bytes.extend(MAGIC);
        for word in [VERSION, marginals, levels, intervals, means, seed] {
            bytes.extend(word.to_le_bytes());
        }
        bytes.extend(width.to_le_bytes());
        bytes.extend([0; 4]);
        for number in self.nodes().iter().flatten() {
            bytes.extend(number.to_le_bytes());
        }
        let sum = checksum(&bytes);
        bytes[HEADER - 4..HEADER].copy_from_slice(&sum.to_le_bytes());
        bytes
    }

    /// The dictionary of such bytes.
    ///
    /// # Errors
    /// [`Error::DictionaryMagic`] of what are no bytes of a dictionary;
    /// [`Error::DictionaryVersion`] of another layout; those of [`Dictionary::new`] and
    /// [`Error::LobeMeans`] of a recipe out of range; [`Error::DictionaryLength`] of too few bytes
    /// or too many; [`Error::DictionaryChecksum`] of damaged ones; [`Error::DictionaryDensity`] of
    /// nodes that are no densities of integral 1.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        if bytes.len() < MAGIC.len() || bytes[..MAGIC.len()] != MAGIC {
            return Err(Error::DictionaryMagic);
        }
        let short = Error::DictionaryLength { expected: HEADER, found: bytes.len() };
        let word = |at: usize| {
            let four = bytes.get(at..at + 4).and_then(|four| four.try_into().ok());
            four.map(u32::from_le_bytes).ok_or(short)
        };
        let version = word(8)?;
        if version != VERSION {
            return Err(Error::DictionaryVersion(version));
        }
        let width = bytes.get(32..40).and_then(|eight| eight.try_into().ok());
        let means = match word(24)? {
            0 => LobeMeans::Stratified,
            1 => LobeMeans::Chermain,
            other => return Err(Error::LobeMeans(other)),
        };
        let recipe = Recipe {
            marginals: word(12)?,
            levels: word(16)?,
            intervals: word(20)?,
            width: width.map(f64::from_le_bytes).ok_or(short)?,
            means,
            seed: word(28)?,
        };
        recipe.check()?;
        let stored = word(HEADER - 4)?;
        let length = recipe.nodes().saturating_mul(8).saturating_add(HEADER);
        if bytes.len() != length {
            return Err(Error::DictionaryLength { expected: length, found: bytes.len() });
        }
        let found = checksum(bytes);
        if found != stored {
            return Err(Error::DictionaryChecksum { expected: stored, found });
        }
        let number = |at: &[u8]| at.try_into().map_or(0.0, f32::from_le_bytes);
        let nodes = bytes[HEADER..].chunks_exact(8).map(|b| [number(&b[..4]), number(&b[4..])]);
        let nodes: Vec<_> = nodes.collect();
        let stride = recipe.intervals as usize + 1;
        let step = REACH / f64::from(recipe.intervals);
        match nodes.chunks_exact(stride).position(|table| !is_density(table, step)) {
            Some(table) => Err(Error::DictionaryDensity { table }),
            None => Ok(Self::from_nodes(recipe, nodes)),
        }
    }
}

/// Whether nodes are those of half a density: not negative, with its integral up to each, which
/// ends at 1/2.
fn is_density(table: &[[f32; 2]], step: f64) -> bool {
    // What rounding two integrals of up to 1/2 and the densities between them leaves.
    const ROUNDING: f64 = 1.0 / (1 << 24) as f64;
    let ends = table[0][1] == 0.0 && table[table.len() - 1][1] == 0.5;
    // NaN is not.
    let holds = table.windows(2).all(|pair| {
        let ([p, before], [q, after]) = (pair[0].map(f64::from), pair[1].map(f64::from));
        let mass = 0.5 * step * (p + q);
        p >= 0.0 && q >= 0.0 && before <= after && (after - before - mass).abs() <= ROUNDING
    });
    ends && holds
}

/// FNV-1a, of all bytes but its own.
fn checksum(bytes: &[u8]) -> u32 {
    let whole = bytes[..HEADER - 4].iter().chain(&bytes[HEADER..]);
    whole.fold(0x811c_9dc5, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193))
}
