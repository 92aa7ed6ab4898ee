//! What the shaders of usual scenes weigh, and what filtering adds, beside what Kaplanyan et al.
//! counted.

use lobe::wgsl::{Item, Preset, source};
use serde::Serialize;

use crate::spirv::{assembled, called, instructions};

/// The text of some items and what becomes of it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Size {
    pub(crate) name: String,
    /// Of WGSL.
    pub(crate) bytes: usize,
    pub(crate) functions: usize,
    /// SPIR-V instructions of all functions.
    pub(crate) instructions: usize,
    /// The same of one call of each function asked for, calls written out.
    pub(crate) inlined: usize,
    /// Those of them that compute.
    pub(crate) arithmetic: usize,
}

impl Size {
    fn of(name: &str, items: &[Item]) -> Result<Self, String> {
        let text = source(items);
        let words = assembled(&text).map_err(|error| format!("{name}: {error}"))?;
        let functions = instructions(&words);
        let [inlined, arithmetic] = called(&functions, items);
        Ok(Self {
            name: name.to_owned(),
            bytes: text.len(),
            functions: functions.len(),
            instructions: functions.iter().map(|function| function.own).sum(),
            inlined,
            arithmetic,
        })
    }
}

/// What a way of filtering adds to a shader.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Overhead {
    pub(crate) name: &'static str,
    /// SPIR-V instructions more than without a filter, calls written out.
    pub(crate) instructions: usize,
    /// Those of them that compute.
    pub(crate) arithmetic: usize,
    /// Instructions for NVIDIA of the nearest of his methods: Kaplanyan et al. 2016, Table 3,
    /// vertex normals or LEAN.
    pub(crate) kaplanyan: Option<usize>,
}

/// Both tables.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Sizes {
    pub(crate) presets: Vec<Size>,
    pub(crate) overheads: Vec<Overhead>,
}

/// Shading of an isotropic material without a filter.
fn base(brdf: Item) -> Vec<Item> {
    vec![Item::IsotropicNew, Item::IsotropicPair, brdf]
}

impl Sizes {
    /// Measured on the texts that the library gives out.
    pub(crate) fn measured() -> Result<Self, String> {
        let presets = Preset::ALL.iter().map(|preset| Size::of(preset.name(), preset.items()));
        let (ggx, beckmann) = (base(Item::GgxBrdf), base(Item::BeckmannBrdf));
        let lean: Vec<Item> = Preset::LeanPlane
            .items()
            .iter()
            .copied()
            .filter(|item| {
                ![Item::FragmentFootprint, Item::KernelOf, Item::LobeWidened].contains(item)
            })
            .collect();
        let cases: [Case; 9] = [
            ("Beckmann, forward", Preset::ForwardBeckmann.items(), &beckmann, Some(19)),
            ("Beckmann, forward, LEAN", Preset::LeanPlane.items(), &lean, Some(11)),
            (
                "Beckmann or GGX, deferred",
                Preset::IsotropicDeferred.items(),
                Preset::Plain.items(),
                Some(24),
            ),
            ("GGX, forward, exact", Preset::ForwardExact.items(), &ggx, Some(272)),
            ("GGX, forward, exact in lanes", Preset::ForwardLanes.items(), &ggx, Some(272)),
            ("GGX, forward, his rectangle", &RECTANGLE, &ggx, Some(272)),
            ("GGX, forward, variance added", Preset::ForwardVariance.items(), &ggx, Some(22)),
            ("GGX, forward, right peak", Preset::ForwardPeak.items(), &ggx, None),
            ("GGX, forward, on the projected disk", Preset::ForwardProjected.items(), &ggx, None),
        ];
        let overheads = cases.into_iter().map(|(name, with, without, kaplanyan)| {
            let (with, without) = (Size::of(name, with)?, Size::of(name, without)?);
            let more = |with: usize, without: usize| {
                let more = with.checked_sub(without);
                more.ok_or(format!("{name}: a filter that adds less than nothing"))
            };
            Ok(Overhead {
                name,
                instructions: more(with.inlined, without.inlined)?,
                arithmetic: more(with.arithmetic, without.arithmetic)?,
                kaplanyan,
            })
        });
        Ok(Self {
            presets: presets.collect::<Result<_, _>>()?,
            overheads: overheads.collect::<Result<_, String>>()?,
        })
    }
}

/// A name, the items with a filter and those without, and what Kaplanyan et al. counted.
type Case<'a> = (&'static str, &'a [Item], &'a [Item], Option<usize>);

/// Kaplanyan's Appendix A in place of the density, and the rest of the BRDF.
const RECTANGLE: [Item; 7] = [
    Item::FragmentFootprint,
    Item::FootprintExtents,
    Item::SlopeOf,
    Item::KaplanyanRectangleMean,
    Item::IsotropicNew,
    Item::IsotropicView,
    Item::GgxVisibility,
];

#[cfg(test)]
mod tests {
    use super::Sizes;

    #[test]
    fn what_a_scene_does_not_need_is_not_there() {
        let sizes = Sizes::measured().expect("valid shaders");
        let of =
            |name: &str| sizes.presets.iter().find(|size| size.name == name).expect("a preset");
        let (plain, exact) = (of("plain"), of("forward_exact"));
        assert!(plain.bytes * 5 < exact.bytes && plain.inlined * 5 < exact.inlined);
        // Kaplanyan's order, but for our exact sums, which make a kernel as long as his rectangle:
        // widening is cheap, the exact GGX is not.
        let added = |name: &str| {
            let found = sizes.overheads.iter().find(|overhead| overhead.name == name);
            found.expect("a case").instructions
        };
        assert!(3 * added("GGX, forward, variance added") < added("GGX, forward, exact"));
        let (his, exact) = (added("GGX, forward, his rectangle"), added("GGX, forward, exact"));
        assert!(3 * his < exact, "{his} {exact}");
        assert!(added("Beckmann or GGX, deferred") < added("GGX, forward, variance added"));
    }
}
