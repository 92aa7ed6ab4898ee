//! The crate's sources: as files, and as a tree of modules that `syn` parses, for what imports what
//! and what callers see.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Attribute, Item, Meta, UseTree, Visibility};

/// All files of this extension below `folder`; none if there is no such folder.
pub(crate) fn files_below(folder: &Path, wanted: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() && !path.ends_with("node_modules") {
            files.extend(files_below(&path, wanted));
        } else if path.extension().is_some_and(|extension| extension == wanted) {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Every file under src, by its path relative to src, with its text.
pub(crate) fn sources() -> Vec<(String, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let read = |path: PathBuf| {
        let name = path.strip_prefix(&src).expect("below src").to_string_lossy().replace('\\', "/");
        (name, fs::read_to_string(&path).expect("a readable file"))
    };
    files_below(&src, "rs").into_iter().map(read).collect()
}

/// A module: the file that has it, and its items.
pub(crate) struct Module {
    /// Relative to `src`.
    pub(crate) file: String,
    pub(crate) items: Vec<Item>,
}

/// Modules by their paths, without `crate`: the root is the empty path.
pub(crate) type Tree = BTreeMap<Vec<String>, Module>;

/// The tree of `src`, tests left out.
pub(crate) fn tree() -> Tree {
    let mut tree = Tree::new();
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut open = vec![(Vec::new(), "lib.rs".to_owned())];
    while let Some((path, file)) = open.pop() {
        let text = fs::read_to_string(src.join(&file)).unwrap_or_else(|e| panic!("{file}: {e}"));
        let parsed = syn::parse_file(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
        let items: Vec<Item> = parsed.items.into_iter().filter(|item| !is_test(item)).collect();
        // Modules of `mod.rs` and of `lib.rs` lie beside them, those of another file below it.
        let beside = file.strip_suffix("mod.rs").or(file.strip_suffix("lib.rs"));
        let home = beside.map_or_else(|| file.replace(".rs", "/"), str::to_owned);
        for item in &items {
            if let Item::Mod(module) = item
                && module.content.is_none()
            {
                let name = module.ident.to_string();
                let places = [format!("{home}{name}.rs"), format!("{home}{name}/mod.rs")];
                let found = places.into_iter().find(|place| src.join(place).exists());
                let below = [path.as_slice(), &[name]].concat();
                open.push((below, found.expect("a file of the module")));
            }
        }
        tree.insert(path, Module { file, items });
    }
    tree
}

/// The attributes of an item that `use` or a name may refer to.
pub(crate) fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(item: &Item) -> bool {
    attributes(item).iter().any(|attribute| match &attribute.meta {
        Meta::List(list) => ["test", "doctest"].contains(&list.tokens.to_string().as_str()),
        _ => false,
    })
}

/// The name and the visibility of an item that has both.
pub(crate) fn named(item: &Item) -> Option<(String, &Visibility)> {
    let (ident, visibility) = match item {
        Item::Const(item) => (&item.ident, &item.vis),
        Item::Enum(item) => (&item.ident, &item.vis),
        Item::Fn(item) => (&item.sig.ident, &item.vis),
        Item::Mod(item) => (&item.ident, &item.vis),
        Item::Static(item) => (&item.ident, &item.vis),
        Item::Struct(item) => (&item.ident, &item.vis),
        Item::Trait(item) => (&item.ident, &item.vis),
        Item::Type(item) => (&item.ident, &item.vis),
        _ => return None,
    };
    Some((ident.to_string(), visibility))
}

/// The paths that a `use` names, from the root, each with the name that it gives.
pub(crate) fn used(tree: &UseTree, home: &[String]) -> Vec<(Vec<String>, String)> {
    fn walk(tree: &UseTree, path: &[String], found: &mut Vec<(Vec<String>, String)>) {
        match tree {
            UseTree::Path(part) => {
                walk(&part.tree, &[path, &[part.ident.to_string()]].concat(), found);
            }
            UseTree::Group(group) => group.items.iter().for_each(|item| walk(item, path, found)),
            UseTree::Name(name) if name.ident == "self" => {
                found.push((path.to_vec(), path.last().cloned().unwrap_or_default()));
            }
            UseTree::Name(name) => {
                let name = name.ident.to_string();
                found.push(([path, std::slice::from_ref(&name)].concat(), name));
            }
            UseTree::Rename(part) => {
                let path = [path, &[part.ident.to_string()]].concat();
                found.push((path, part.rename.to_string()));
            }
            UseTree::Glob(_) => panic!("a glob hides what it imports: {}", path.join("::")),
        }
    }
    let mut found = Vec::new();
    walk(tree, &[], &mut found);
    for (path, _) in &mut found {
        *path = absolute(path, home);
    }
    found
}

/// A path from the root: `crate`, `super` and `self` resolved, others as children of `home`.
pub(crate) fn absolute(path: &[String], home: &[String]) -> Vec<String> {
    let mut base = home.to_vec();
    let mut rest = path;
    while let Some((first, after)) = rest.split_first() {
        match first.as_str() {
            "crate" => base.clear(),
            "super" => drop(base.pop()),
            "self" => {}
            _ => break,
        }
        rest = after;
    }
    base.extend_from_slice(rest);
    base
}

/// The enum that a call of a macro makes.
fn made_by(call: &syn::ItemMacro) -> Option<&'static str> {
    const MADE: [(&str, &str); 2] = [("errors", "Error"), ("items", "Item")];
    MADE.iter().find(|(by, _)| call.mac.path.is_ident(by)).map(|&(_, name)| name)
}

/// Where an item is defined, through any number of re-exports: its module's path, and its name.
pub(crate) fn defined(tree: &Tree, path: &[String]) -> Option<(Vec<String>, String)> {
    let (name, home) = path.split_last()?;
    let module = tree.get(home)?;
    let has = |item: &Item| match item {
        Item::Macro(made) => made.ident.is_none() && made_by(made).is_some_and(|own| own == name),
        _ => named(item).is_some_and(|(own, _)| own == *name),
    };
    if module.items.iter().any(|item| !matches!(item, Item::Mod(_)) && has(item)) {
        return Some((home.to_vec(), name.clone()));
    }
    let uses = module.items.iter().filter_map(|item| match item {
        Item::Use(item) => Some(&item.tree),
        _ => None,
    });
    let found = uses.flat_map(|tree| used(tree, home)).find(|(_, given)| given == name);
    let (path, _) = found.filter(|(from, _)| from != path)?;
    defined(tree, &path)
}
