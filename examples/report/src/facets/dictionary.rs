//! The library's dictionary of its default recipe, in both precisions.

use std::sync::LazyLock;

use lobe::material::multilobe::{Dictionary, Recipe};
use lobe::{Error, Real};

/// A precision with a dictionary that is generated once: generating one takes longer than most
/// trials.
pub(super) trait Precision: Real {
    fn dictionary() -> Result<&'static Dictionary<Self>, Error>;
}

type Once<R> = LazyLock<Result<Dictionary<R>, Error>>;

impl Precision for f32 {
    fn dictionary() -> Result<&'static Dictionary<Self>, Error> {
        static ONCE: Once<f32> = LazyLock::new(|| Dictionary::new(&Recipe::default()));
        ONCE.as_ref().map_err(|error| *error)
    }
}

impl Precision for f64 {
    fn dictionary() -> Result<&'static Dictionary<Self>, Error> {
        static ONCE: Once<f64> = LazyLock::new(|| Dictionary::new(&Recipe::default()));
        ONCE.as_ref().map_err(|error| *error)
    }
}
