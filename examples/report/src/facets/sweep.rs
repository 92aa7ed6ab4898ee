//! The published filter's scales over roughness and facets: where a narrow kernel is right, and
//! where a wide one is.

use lobe::Error;
use serde::Serialize;

use super::method::{FILTERS, Method, name};
use super::scenes::bent;
use super::speed::Load;
use super::trial::{SURE, Setting, Trial};

/// What is compared.
pub(crate) const SWEPT: [&str; 4] = [name::NONE, name::HALF, name::ONE, name::BOX];

/// Roughnesses, and powers of ten of facets in a pixel.
const ALPHAS: [f64; 2] = [0.1, 0.25];
const DECADES: [i32; 5] = [1, 2, 3, 4, 6];

/// One roughness and one number of facets.
#[derive(Serialize)]
pub(crate) struct Swept {
    pub(crate) alpha: f64,
    pub(crate) facets: f64,
    /// Standard error of the reference, in means.
    pub(crate) noise: f64,
    /// Root mean square errors of [`SWEPT`], in means.
    pub(crate) errors: [f64; 4],
    /// How surely s_K 0.5 is nearer than 1 ([`Trial::lead`]).
    pub(crate) lead: f64,
}

impl Swept {
    /// Whether s_K 0.5 is nearer than 1, as published; none where that may be chance.
    pub(crate) fn is_ordered(&self) -> Option<bool> {
        (self.lead.abs() > SURE).then_some(self.lead > 0.0)
    }
}

/// All of them, in pictures of this width.
pub(super) fn swept(width: usize, side: u32) -> Result<Vec<Swept>, Error> {
    let stage = bent(width);
    let methods: Vec<Method> =
        FILTERS.into_iter().filter(|method| SWEPT.contains(&method.name)).collect();
    let load = Load { pixels: 0, rounds: 0 };
    let pairs = ALPHAS.iter().flat_map(|&alpha| DECADES.map(|power| (alpha, 10.0_f64.powi(power))));
    let swept = pairs.map(|(alpha, facets)| {
        let trial = Trial::of(&stage, &methods, &Setting { alpha, facets, side, load })?;
        let errors = SWEPT.map(|name| trial.rmse(name));
        let lead = trial.lead(name::HALF, name::ONE);
        Ok(Swept { alpha, facets, noise: trial.noise, errors, lead })
    });
    swept.collect()
}
