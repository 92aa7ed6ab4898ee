//! Materials of the facade.
//!
//! Layer 6.

use crate::material::Fresnel;
#[cfg(feature = "glint")]
use crate::material::{glint::Glints, multilobe::MultiLobe};
use crate::shade::Material;
#[cfg(feature = "glint")]
use crate::shade::{GlintMaterial, MultiLobeMaterial};
use crate::slope::Lobe;

data!("Material", Material<N, R>, N {
    lobe: Lobe<R> = material.lobe,
    fresnel: Fresnel<R> = material.fresnel,
} |material| => Ok(Self::new(lobe, fresnel)));

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
