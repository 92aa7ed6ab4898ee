//! What shaders hold, and how much they compute: static SPIR-V instructions as naga writes them,
//! one call of each function asked for, calls written out. No driver runs here.

use lobe::wgsl::{Item, Preset, source};
use lobe_report::spirv::{self, Instructions};

/// Instructions that compute, at most so many more than in isotropic shading without a filter by
/// the same BRDF: the budget of each way to filter.
const BUDGETS: [(Preset, Item, usize); 5] = [
    (Preset::ForwardVariance, Item::GgxBrdf, 90),
    (Preset::ForwardBeckmann, Item::BeckmannBrdf, 150),
    (Preset::ForwardProjected, Item::GgxBrdf, 150),
    (Preset::IsotropicDeferred, Item::GgxBrdf, 40),
    (Preset::ForwardLanes, Item::GgxBrdf, 700),
];

/// Presets in the order of what they promise: one that took less than the one before it would make
/// that one pointless.
const LADDERS: [&[Preset]; 7] = [
    &[
        Preset::Plain,
        Preset::ForwardVariance,
        Preset::ForwardPeak,
        Preset::ForwardLanes,
        Preset::ForwardExact,
    ],
    &[Preset::Plain, Preset::IsotropicDeferred, Preset::AnisotropicDeferred],
    &[Preset::ForwardVariance, Preset::ForwardProjected],
    &[Preset::ForwardVariance, Preset::ForwardBeckmann],
    &[Preset::ForwardVariance, Preset::Facade],
    &[Preset::ForwardVariance, Preset::RayTraced],
    &[Preset::ForwardVariance, Preset::AreaLight],
];

/// What a number is made by of a shape's answers at a pair of directions.
const SHADING: [Item; 4] =
    [Item::GgxBrdf, Item::BeckmannBrdf, Item::GgxEvaluate, Item::BeckmannEvaluate];

/// Means in lanes, and what ends the name of the answers that each takes.
const LANES: [(Item, &str); 2] =
    [(Item::GgxParallelogramMeanInLanes, "slope_over"), (Item::GgxBrdfOverInLanes, "pair_over")];

/// Shapes as their functions are called, and what they are built on. The first four, which means
/// in lanes take, begin with the simplest.
const SHAPES: [(&str, &[&str]); 5] = [
    ("isotropic", &[]),
    ("axis_aligned", &[]),
    ("anisotropic", &[]),
    ("non_centered", &["anisotropic"]),
    ("widened", &["isotropic"]),
];

/// The functions of a shader.
fn functions(items: &[Item]) -> Vec<Instructions> {
    let words = spirv::assembled(&source(items)).expect("valid WGSL");
    spirv::instructions(&words)
}

/// One call of each item: instructions, and those that compute.
fn count(items: &[Item]) -> [usize; 2] {
    spirv::called(&functions(items), items)
}

fn item(name: &str) -> Item {
    Item::from_name(name).unwrap_or_else(|error| panic!("{error}"))
}

/// Isotropic shading without a filter.
fn unfiltered(brdf: Item) -> [Item; 3] {
    [Item::IsotropicNew, Item::IsotropicPair, brdf]
}

/// What makes a shape, its answers at a pair of directions, and a number of them.
fn shading(shape: &str, brdf: Item) -> Vec<Item> {
    let made: &[Item] = match shape {
        "non_centered" => &[Item::RoughnessFromAlpha, Item::LobeCentered, Item::LobeShape],
        "anisotropic" => &[Item::RoughnessFromAlpha, Item::AnisotropicNew],
        "widened" => &[Item::IsotropicNew, Item::KernelWiden],
        "axis_aligned" => &[Item::AxisAlignedNew],
        _ => &[Item::IsotropicNew],
    };
    [made, &[item(&format!("{shape}_pair")), brdf]].concat()
}

/// The shapes that a shader has functions of, in the order of [`SHAPES`].
fn held(items: &[Item]) -> Vec<&'static str> {
    let functions = functions(items);
    let of = |shape: &str| {
        let prefix = format!("lobe_{shape}_");
        functions.iter().any(|function| function.name.starts_with(&prefix))
    };
    SHAPES.iter().map(|(shape, _)| *shape).filter(|shape| of(shape)).collect()
}

/// A shape and all that it is built on, in the order of [`SHAPES`].
fn built(shape: &str) -> Vec<&'static str> {
    let found = SHAPES.iter().find(|(name, _)| *name == shape);
    let (_, parts) = found.unwrap_or_else(|| panic!("no shape {shape}"));
    let names = SHAPES.iter().map(|(name, _)| *name);
    names.filter(|name| *name == shape || parts.contains(name)).collect()
}

/// The shape of a preset's material, under its filter.
fn shape_of(preset: Preset) -> &'static str {
    match preset {
        Preset::Plain | Preset::IsotropicDeferred | Preset::ForwardLanes => "isotropic",
        Preset::AnisotropicDeferred => "axis_aligned",
        // Moments of maps, tilted planes, and the tree, which takes any lobe.
        Preset::ForwardExact | Preset::LeanPlane | Preset::Displaced | Preset::Glints => {
            "non_centered"
        }
        Preset::ManyLobes => "anisotropic",
        Preset::ForwardVariance
        | Preset::ForwardProjected
        | Preset::ForwardPeak
        | Preset::ForwardBeckmann
        | Preset::RayTraced
        | Preset::AreaLight
        | Preset::Facade => "widened",
        other => panic!("no shape is stated for {}", other.name()),
    }
}

/// Each step of a ladder is at most the next one, in all instructions and in those that compute.
#[track_caller]
fn grows(steps: &[(String, [usize; 2])]) {
    for (name, [all, computing]) in steps {
        println!("{name}: {all} instructions, {computing} compute");
    }
    for pair in steps.windows(2) {
        let ((lower, less), (higher, more)) = (&pair[0], &pair[1]);
        let is_more = less.iter().zip(more).all(|(less, more)| less <= more);
        assert!(is_more, "{lower} has {less:?} instructions, {higher} {more:?}");
    }
}

#[test]
fn filters_stay_within_their_budgets() {
    for (preset, brdf, budget) in BUDGETS {
        let ([_, with], [_, without]) = (count(preset.items()), count(&unfiltered(brdf)));
        let added = with.checked_sub(without).expect("a filter adds to shading");
        println!("{}: {added} of {budget}", preset.name());
        assert!(added <= budget, "{} adds {added}, of {budget}", preset.name());
        // A shader whose filter went missing is within any budget.
        assert!(added > 0, "{} adds nothing", preset.name());
    }
}

#[test]
fn counts_grow_along_the_ladder_of_filters() {
    for ladder in LADDERS {
        let step = |preset: &Preset| (preset.name().to_owned(), count(preset.items()));
        grows(&ladder.iter().map(step).collect::<Vec<_>>());
    }
}

#[test]
fn counts_grow_along_the_ladder_of_shapes() {
    for brdf in SHADING {
        let step = |(shape, _): &(&str, _)| {
            (format!("{shape} {}", brdf.name()), count(&shading(shape, brdf)))
        };
        let [isotropic, .., widened] = SHAPES.each_ref().map(step);
        grows(&SHAPES[..4].iter().map(step).collect::<Vec<_>>());
        grows(&[isotropic, widened]);
    }
    for (over, ending) in LANES {
        let step = |(shape, _): &(&str, _)| {
            let answers = item(&format!("{shape}_{ending}"));
            (format!("{shape} {}", over.name()), count(&[answers, over]))
        };
        grows(&SHAPES[..4].iter().map(step).collect::<Vec<_>>());
    }
}

#[test]
fn a_preset_holds_the_functions_of_its_shape_alone() {
    for preset in Preset::ALL {
        assert_eq!(held(preset.items()), built(shape_of(*preset)), "{}", preset.name());
    }
}

#[test]
fn a_scene_holds_the_functions_of_its_shape_alone() {
    for (shape, _) in SHAPES {
        for brdf in SHADING {
            assert_eq!(held(&shading(shape, brdf)), built(shape), "{shape} {}", brdf.name());
        }
    }
    for (shape, _) in &SHAPES[..4] {
        for (over, ending) in LANES {
            let items = [item(&format!("{shape}_{ending}")), over];
            assert_eq!(held(&items), built(shape), "{shape} {}", over.name());
        }
    }
}

/// The comment at [`Preset::ForwardLanes`] states it.
#[test]
fn the_lanes_add_a_fortieth_of_what_the_tree_adds() {
    let added = |preset: Preset| count(preset.items())[0] - count(Preset::Plain.items())[0];
    let (lanes, tree) = (added(Preset::ForwardLanes), added(Preset::ForwardExact));
    println!("{lanes} and {tree} instructions");
    assert!((36..=44).contains(&(tree / lanes)), "{tree} over {lanes}");
}
