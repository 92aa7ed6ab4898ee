//! No two files import from each other, directly or through others: a file can be read after those
//! that it imports from. A type whose methods stand in several files says in which.

use crate::source::{Module, Tree, absolute, defined, tree, used};
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};
use syn::{Item, ItemUse, Path, Type};

/// All that a file names: in `use`, and by paths from the root or from the module above.
struct Named<'a> {
    home: &'a [String],
    paths: Vec<Vec<String>>,
}

impl<'a> Visit<'a> for Named<'_> {
    fn visit_item_use(&mut self, item: &'a ItemUse) {
        for (path, given) in used(&item.tree, self.home) {
            assert!(!path.is_empty(), "the root under another name, `{given}`, hides imports");
            self.paths.push(path);
        }
    }

    fn visit_path(&mut self, path: &'a Path) {
        let words: Vec<String> = path.segments.iter().map(|part| part.ident.to_string()).collect();
        if ["crate", "super"].contains(&words[0].as_str()) {
            self.paths.push(absolute(&words, self.home));
        }
        visit::visit_path(self, path);
    }
}

/// What a file names.
fn named(module: &Module, home: &[String]) -> Vec<Vec<String>> {
    let mut named = Named { home, paths: Vec::new() };
    module.items.iter().for_each(|item| named.visit_item(item));
    named.paths
}

/// The file of what a path leads to: a module, an item, or what belongs to an item.
fn file_of(tree: &Tree, path: &[String]) -> Option<String> {
    (1..=path.len()).rev().find_map(|length| {
        let path = &path[..length];
        let home = if tree.contains_key(path) {
            Some(path.to_vec())
        } else {
            defined(tree, path).map(|(home, _)| home)
        };
        home.map(|home| tree[&home].file.clone())
    })
}

/// The files that a file imports from. A folder's `mod.rs` lists its files, so it does not count.
fn imports(tree: &Tree) -> BTreeMap<String, BTreeSet<String>> {
    let lists = |file: &str| file.ends_with("mod.rs") || ["lib.rs", "prelude.rs"].contains(&file);
    let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (home, module) in tree.iter().filter(|(_, module)| !lists(&module.file)) {
        let files = named(module, home).into_iter().filter_map(|path| file_of(tree, &path));
        let others = files.filter(|file| *file != module.file && !lists(file));
        graph.entry(module.file.clone()).or_default().extend(others);
    }
    graph
}

/// A circle of files, each of which imports from the next, if there is one.
fn circle(graph: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn walk(
        graph: &BTreeMap<String, BTreeSet<String>>,
        file: &str,
        path: &mut Vec<String>,
        done: &mut BTreeSet<String>,
    ) -> Option<Vec<String>> {
        if let Some(at) = path.iter().position(|other| other == file) {
            return Some(path[at..].to_vec());
        }
        if !done.insert(file.to_owned()) {
            return None;
        }
        path.push(file.to_owned());
        let next = graph.get(file).into_iter().flatten();
        let found = next.into_iter().find_map(|other| walk(graph, other, path, done));
        path.pop();
        found
    }
    let mut done = BTreeSet::new();
    graph.keys().find_map(|file| walk(graph, file, &mut Vec::new(), &mut done))
}

#[test]
fn no_files_import_from_each_other() {
    let graph = imports(&tree());
    let edges: usize = graph.values().map(BTreeSet::len).sum();
    assert!(edges > 200, "only {edges} imports found");
    let found = circle(&graph);
    assert!(found.is_none(), "a circle of imports: {}", found.unwrap_or_default().join(" -> "));
}

#[test]
fn the_law_notices_a_circle() {
    let of = |pairs: &[(&str, &str)]| {
        let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (from, to) in pairs {
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        circle(&graph)
    };
    assert_eq!(of(&[("a", "b"), ("b", "c"), ("a", "c")]), None);
    let found = of(&[("a", "b"), ("b", "c"), ("c", "b")]);
    assert_eq!(found, Some(vec!["b".to_owned(), "c".to_owned()]));
}

/// The files that have methods of each type, by its file and name.
fn methods(tree: &Tree) -> BTreeMap<(String, String), BTreeSet<String>> {
    let mut found: BTreeMap<(String, String), BTreeSet<String>> = BTreeMap::new();
    for (path, module) in tree {
        for item in &module.items {
            let Item::Impl(item) = item else { continue };
            let Type::Path(of) = &*item.self_ty else { continue };
            let name = of.path.segments.last().map(|segment| segment.ident.to_string());
            let from = [path.as_slice(), &name.into_iter().collect::<Vec<_>>()].concat();
            if item.trait_.is_none()
                && let Some((home, name)) = defined(tree, &from)
            {
                let key = (tree[&home].file.clone(), name);
                found.entry(key).or_default().insert(module.file.clone());
            }
        }
    }
    found
}

#[test]
fn types_say_where_their_further_methods_are() {
    let mut count = 0;
    for ((file, name), mut files) in methods(&tree()) {
        files.remove(&file);
        let src = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let text = std::fs::read_to_string(src.join(&file)).expect("a readable file");
        // The enum of items is made by a macro.
        if !text.contains(&format!("\npub struct {name}")) {
            continue;
        }
        let above = text.split(&format!("\npub struct {name}")).next().unwrap_or_default();
        let comments = above.lines().rev().take_while(|line| line.starts_with(['#', '/']));
        let stated: BTreeSet<String> = comments
            .filter_map(|line| line.strip_prefix("// Further methods: "))
            .flat_map(|list| list.trim_end_matches('.').split(", ").map(str::to_owned))
            .collect();
        assert_eq!(stated, files, "src/{file}, {name}: `// Further methods: FILE, FILE.`");
        count += files.len();
    }
    assert!(count > 15, "only {count} files with further methods found");
}
