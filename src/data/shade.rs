//! Materials of the facade.
//!
//! Layer 6.

use crate::error::Error;
use crate::material::Fresnel;
#[cfg(feature = "glint")]
use crate::material::{glint::Glints, multilobe::MultiLobe};
use crate::ndf::Distribution;
use crate::shade::Material;
#[cfg(feature = "glint")]
use crate::shade::{GlintMaterial, MultiLobeMaterial};
use crate::slope::Lobe;
use serde::{Deserialize, Serialize};

/// The names of distributions.
#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Name {
    Ggx,
    Beckmann,
}

impl Name {
    fn of<N: Distribution>() -> Self {
        if N::DATA_NAME == "ggx" { Self::Ggx } else { Self::Beckmann }
    }
}

data!("Material", Material<N, R>, N {
    distribution: Name = Name::of::<N>(),
    lobe: Lobe<R> = material.lobe,
    fresnel: Fresnel<R> = material.fresnel,
} |material| => {
    let own = distribution == Name::of::<N>();
    if own {
        Ok(Self::new(lobe, fresnel))
    } else {
        Err(Error::Distribution { expected: N::DATA_NAME })
    }
});

#[cfg(feature = "glint")]
data!("GlintMaterial", GlintMaterial<R> {
    glints: Glints<R> = material.glints,
    fresnel: Fresnel<R> = material.fresnel,
} |material| => Ok(Self { glints, fresnel }));

#[cfg(feature = "glint")]
data!("MultiLobeMaterial", MultiLobeMaterial<R> {
    facets: MultiLobe<R> = material.facets,
    fresnel: Fresnel<R> = material.fresnel,
} |material| => Ok(Self { facets, fresnel }));
