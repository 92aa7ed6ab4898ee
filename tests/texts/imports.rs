//! No two files import from each other, directly or through others: a file can be read after those
//! that it imports from. A type whose methods stand in several files says in which.

use crate::source::{Tree, defined, tree, used};
use std::collections::{BTreeMap, BTreeSet};
use syn::{Item, Type};

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
        let above = text.split(&format!("\npub struct {name}")).next().unwrap_or_default();
        let comments = above.lines().rev().take_while(|line| line.starts_with(['#', '/']));
        let mut comments = comments.filter_map(|line| line.strip_prefix("// Further methods: "));
        let stated: BTreeSet<String> = comments.next().map_or_else(BTreeSet::new, |list| {
            list.trim_end_matches('.').split(", ").map(str::to_owned).collect()
        });
        assert_eq!(stated, files, "src/{file}, {name}: `// Further methods: FILE, FILE.`");
        count += files.len();
    }
    assert!(count > 15, "only {count} files with further methods found");
}
