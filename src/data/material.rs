//! Fresnel terms, maps' limits, glittering materials.
//!
//! Layer 6.

use crate::material::Fresnel;
#[cfg(feature = "glint")]
use crate::material::glint::{Biscale, Glints};
#[cfg(feature = "lean")]
use crate::material::lean::SlopeCap;
#[cfg(feature = "glint")]
use crate::material::multilobe::MultiLobe;
use crate::scalar::Real;
#[cfg(feature = "glint")]
use crate::slope::Roughness;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// The two kinds of Fresnel terms, by the arguments of their constructors.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Fresnel", rename_all = "snake_case", deny_unknown_fields)]
enum Term<R> {
    Schlick([R; 3]),
    Conductor { eta: [R; 3], k: [R; 3] },
}

impl<R: Real + Serialize> Serialize for Fresnel<R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.parts() {
            Ok(normal) => Term::Schlick(normal),
            Err([eta, k]) => Term::Conductor { eta, k },
        }
        .serialize(serializer)
    }
}

impl<'de, R: Real + Deserialize<'de>> Deserialize<'de> for Fresnel<R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Term::<R>::deserialize(deserializer)? {
            Term::Schlick(normal) => Self::schlick(normal),
            Term::Conductor { eta, k } => Self::conductor(eta, k),
        }
        .map_err(de::Error::custom)
    }
}

#[cfg(feature = "lean")]
data!("SlopeCap", SlopeCap<R> { steepest: R = cap.steepest() } |cap| => Self::new(steepest));

#[cfg(feature = "glint")]
data!("Biscale", Biscale<R> {
    spread: Roughness<R> = biscale.spread(),
    local: Roughness<R> = biscale.local(),
} |biscale| => Ok(Self::new(spread, local)));

#[cfg(feature = "glint")]
data!("Glints", Glints<R> {
    biscale: Biscale<R> = glints.biscale(),
    density: R = glints.numbers().0[0],
    variation: R = glints.numbers().0[1],
    share: R = glints.numbers().0[2],
    seed: u32 = glints.numbers().3,
} |glints| => {
    let varied = Self::new(biscale, density).and_then(|glints| glints.with_variation(variation));
    varied.and_then(|glints| glints.with_share(share)).map(|glints| glints.with_seed(seed))
});

#[cfg(feature = "glint")]
data!("MultiLobe", MultiLobe<R> {
    roughness: Roughness<R> = facets.roughness(),
    density: R = facets.numbers().0[0],
    variation: R = facets.numbers().0[1],
    share: R = facets.numbers().0[2],
    seed: u32 = facets.numbers().1,
} |facets| => {
    let varied = Self::new(roughness, density).and_then(|facets| facets.with_variation(variation));
    varied.and_then(|facets| facets.with_share(share)).map(|facets| facets.with_seed(seed))
});
