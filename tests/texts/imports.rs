//! No two files import from each other, directly or through others: a file can be read after those
//! that it imports from.

use crate::source::{Tree, defined, tree, used};
use std::collections::{BTreeMap, BTreeSet};
use syn::Item;

/// The files that a file imports from. A folder's `mod.rs` lists its files, so it does not count.
fn imports(tree: &Tree) -> BTreeMap<String, BTreeSet<String>> {
    let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (path, module) in tree {
        let listed = module.file.ends_with("mod.rs") || module.file == "lib.rs";
        for item in module.items.iter().filter(|_| !listed) {
            let Item::Use(item) = item else { continue };
            for (from, _) in used(&item.tree, path) {
                // A module, as of functions that callers name by it, or an item.
                let home = if tree.contains_key(&from) {
                    Some(from)
                } else {
                    defined(tree, &from).map(|(home, _)| home)
                };
                let file = home.map(|home| tree[&home].file.clone());
                let other = file.filter(|file| *file != module.file && !file.ends_with("mod.rs"));
                graph.entry(module.file.clone()).or_default().extend(other);
            }
        }
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
