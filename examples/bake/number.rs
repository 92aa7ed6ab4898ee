//! Numbers of the command line, which messages repeat as they were written.

use std::fmt;
use std::str::FromStr;

/// A finite number, and how it was written.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    pub(crate) single: f32,
    pub(crate) double: f64,
    given: String,
}

impl FromStr for Number {
    type Err = &'static str;

    fn from_str(given: &str) -> Result<Self, Self::Err> {
        let number = |_| "not a number";
        let (single, double) =
            (given.parse::<f32>().map_err(number)?, given.parse().map_err(number)?);
        if single.is_finite() {
            Ok(Self { single, double, given: given.to_owned() })
        } else {
            Err("not a finite number of 32 bits")
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.given)
    }
}
