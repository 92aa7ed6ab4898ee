//! Which channels of a picture hold a normal, and where they are in a texel's bytes.

use super::picture::Texel;
use std::fmt;
use std::str::FromStr;

/// Two or three channels by name: x and y, and z unless it is left to unit length.
///
/// `rgb` is the usual order; `ag` the one of DXT5nm (x in alpha, y in green); `rg` that of BC5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Channels {
    /// Places of the channels read as x, y and z among red, green, blue and alpha; the first
    /// `count` are used.
    roles: [usize; 3],
    count: usize,
}

/// The names of the channels.
const NAMES: &str = "rgba";
/// The role of alpha.
pub(crate) const ALPHA: usize = 3;

impl Channels {
    /// Red, green and blue.
    pub(crate) const RGB: Self = Self { roles: [0, 1, 2], count: 3 };

    /// The channels, of red, green, blue, alpha as 0 to 3.
    pub(crate) fn roles(&self) -> &[usize] {
        &self.roles[..self.count]
    }

    /// Whether x, y or z is in alpha.
    pub(crate) fn use_alpha(&self) -> bool {
        self.roles().contains(&ALPHA)
    }

    /// Where x, y and z are in such a texel; z is y's place where there are two.
    pub(crate) fn places(&self, texel: Texel) -> Result<[usize; 3], String> {
        if self.use_alpha() && !texel.has_alpha() {
            return Err(format!("has no alpha channel, which --channels {self} reads"));
        }
        let last = self.roles[self.count - 1];
        let roles = if self.count == 3 { self.roles } else { [self.roles[0], last, last] };
        Ok(roles.map(|role| place(role, texel)))
    }
}

/// Where red, green, blue or alpha is in a texel; grays have one channel for three.
pub(crate) fn place(role: usize, texel: Texel) -> usize {
    match role {
        ALPHA => texel.channels - 1,
        _ if texel.channels < 3 => 0,
        role => role,
    }
}

impl FromStr for Channels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let refused = || {
            "must be two or three different letters of r, g, b, a: the channels of x, y and z"
                .to_owned()
        };
        let roles: Option<Vec<_>> = text.chars().map(|letter| NAMES.find(letter)).collect();
        let roles = roles.ok_or_else(refused)?;
        let twice = (1..roles.len()).any(|k| roles[..k].contains(&roles[k]));
        match *roles.as_slice() {
            [x, y] if !twice => Ok(Self { roles: [x, y, y], count: 2 }),
            [x, y, z] if !twice => Ok(Self { roles: [x, y, z], count: 3 }),
            _ => Err(refused()),
        }
    }
}

impl fmt::Display for Channels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.roles().iter().try_for_each(|&role| f.write_str(&NAMES[role..=role]))
    }
}
