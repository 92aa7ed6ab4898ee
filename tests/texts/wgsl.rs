//! The WGSL port's texts as a compiler sees them: valid, and nothing in them that was not asked
//! for.
#![cfg(feature = "wgsl")]

use crate::common::arbitrary::Source;
use crate::common::size::size;
use crate::entry::{declared, names, parse};
use lobe::wgsl::{Error, Item, Module, Preset, source};
use naga::Span;
use naga::valid::ShaderStages;
use std::collections::BTreeSet;

/// A valid text's module.
#[track_caller]
fn valid(text: &str, what: &str) -> naga::Module {
    parse(text).unwrap_or_else(|error| panic!("{what}: {error}")).0
}

/// Every declaration with its place in the text, by the compiler's account.
fn declarations(module: &naga::Module) -> Vec<(&str, Span)> {
    let functions = module.functions.iter().map(|(h, f)| (&f.name, module.functions.get_span(h)));
    let constants = module.constants.iter().map(|(h, c)| (&c.name, module.constants.get_span(h)));
    let types = module.types.iter().map(|(h, t)| (&t.name, module.types.get_span(h)));
    let globals = &module.global_variables;
    let buffers = globals.iter().map(|(h, g)| (&g.name, globals.get_span(h)));
    let all = functions.chain(constants).chain(types).chain(buffers);
    all.filter_map(|(name, span)| Some((name.as_deref()?, span))).collect()
}

/// The items' names, in any order.
fn asked(items: &[Item]) -> BTreeSet<String> {
    items.iter().flat_map(|item| declared(*item)).collect()
}

#[test]
fn single_items_are_valid_and_need_all_that_comes_with_them() {
    for (index, item) in Item::ALL.iter().enumerate() {
        let text = source(&[*item]);
        let module = valid(&text, item.name());
        let all = declarations(&module);
        assert_eq!(all.len(), names(&text).count(), "{}", item.name());
        let asked = asked(&[*item]);
        for name in &asked {
            assert!(all.iter().any(|(other, _)| other == name), "{} lacks {name}", item.name());
        }
        // The text is compiled again without each of its declarations: an ordinary run does so for
        // some of the items.
        if index % size(4, 1) != 0 {
            continue;
        }
        for (name, span) in all.into_iter().filter(|(name, _)| !asked.contains(*name)) {
            let range = span.to_range().expect("a place in the text");
            assert!(names(&text[range.clone()]).eq([name]), "{}", &text[range]);
            // There is no recursion: of all that is not needed, one declaration at least could go.
            let without = format!("{}{}", &text[..range.start], &text[range.end..]);
            let refused = naga::front::wgsl::parse_str(&without).is_err();
            assert!(refused, "{} does not need {name}", item.name());
        }
    }
}

#[test]
fn sets_of_items_are_their_union_in_any_order() {
    for seed in 0..500 {
        let mut random = Source::from_seed(seed);
        let mut draw = |below: usize| random.pick(below as u64) as usize;
        let count = 1 + draw(12);
        let mut items: Vec<Item> = (0..count).map(|_| Item::ALL[draw(Item::ALL.len())]).collect();
        let text = source(&items);
        valid(&text, &format!("{items:?}"));
        let singles: Vec<String> = items.iter().map(|item| source(&[*item])).collect();
        let union: BTreeSet<&str> = singles.iter().flat_map(|single| names(single)).collect();
        let once: Vec<&str> = names(&text).collect();
        assert_eq!(once.len(), union.len(), "{items:?}");
        assert!(once.iter().all(|name| union.contains(name)), "{items:?}");
        for k in (1..items.len()).rev() {
            items.swap(k, draw(k + 1));
        }
        items.push(items[0]);
        assert_eq!(source(&items), text, "{items:?}");
    }
}

#[test]
fn presets_are_their_items() {
    for preset in Preset::ALL {
        let text = preset.source();
        let module = valid(&text, preset.name());
        assert_eq!(text, source(preset.items()));
        println!("{}: {} functions, {} bytes", preset.name(), module.functions.len(), text.len());
    }
}

#[test]
fn the_whole_is_every_declaration_of_every_file() {
    let text = source(Item::ALL);
    valid(&text, "all items");
    let files: Vec<&str> = Module::ALL.iter().flat_map(|module| names(module.body())).collect();
    assert!(names(&text).eq(files.iter().copied()));
    assert_eq!(files.iter().collect::<BTreeSet<_>>().len(), files.len(), "a name twice");
    let concatenated: String = Module::ALL.iter().map(Module::body).collect();
    valid(&concatenated, "all files");
}

#[test]
fn derivatives_are_the_fragment_files_alone() {
    let text = source(Item::ALL);
    let (module, info) = parse(&text).expect("valid");
    let fragment = Module::ALL.iter().filter(|module| module.path().starts_with("fragment"));
    let fragment: BTreeSet<&str> = fragment.flat_map(|module| names(module.body())).collect();
    assert!(!fragment.is_empty());
    for (handle, function) in module.functions.iter() {
        let name = function.name.as_deref().expect("a name");
        let anywhere = info[handle].available_stages.contains(ShaderStages::COMPUTE);
        assert_eq!(!anywhere, fragment.contains(name), "{name}");
    }
}

#[test]
fn no_items_give_no_text_and_unknown_names_are_named() {
    assert!(source(&[]).is_empty());
    for name in ["", "lobe_ggx_e", "ggx_D", "ggx_d ", "pi"] {
        assert_eq!(Item::from_name(name), Err(Error::Unknown(name.to_owned())));
        let message = Item::from_name(name).unwrap_err().to_string();
        assert!(message.contains(&format!("`{name}`")), "{message}");
    }
}

/// An item of a feature, which is on or off.
fn gated(name: &str, feature: &'static str, is_on: bool) {
    let found = Item::from_name(name);
    assert_eq!(source(Item::ALL).contains(&format!("lobe_{name}(")), is_on);
    if is_on {
        assert_eq!(found.map(Item::name), Ok(name));
    } else {
        assert_eq!(found, Err(Error::Off { name: name.into(), feature }));
    }
}

#[test]
fn items_behind_a_feature_name_it() {
    gated("engine_alpha", "published", cfg!(feature = "published"));
    gated("glint_ndf_sparkle", "glint", cfg!(feature = "glint"));
    gated("marginal_mean", "glint", cfg!(feature = "glint"));
}
