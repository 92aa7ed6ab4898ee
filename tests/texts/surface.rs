//! The list of public items: a change of what callers see is a change of `surface.txt`.

use crate::source::{Tree, attributes, defined, named, tree, used};
use crate::written::written;
use quote::ToTokens;
use std::collections::BTreeMap;
use syn::{Attribute, Fields, ImplItem, Item, ItemImpl, Meta, TraitItem, Type, Visibility};

/// Tokens as rustfmt spaces them, nearly.
fn plain(tokens: &impl ToTokens) -> String {
    let mut text = tokens.to_token_stream().to_string();
    let tight = [
        (" :: ", "::"),
        (":: ", "::"),
        (" ::", "::"),
        (" < ", "<"),
        ("< ", "<"),
        (" >", ">"),
        (" ,", ","),
        ("( ", "("),
        (" )", ")"),
        (" (", "("),
        ("[ ", "["),
        (" ]", "]"),
        (" ;", ";"),
        (" : ", ": "),
        ("& ", "&"),
        ("->", "-> "),
        ("  ", " "),
        (" & ", " &"),
        (",)", ")"),
        (", >", ">"),
        (" !", "!"),
        ("= [", "= ["),
    ];
    for (loose, close) in tight {
        text = text.replace(loose, close);
    }
    text.replace("- >", "->").replace("->", " -> ").replace("  ", " ").replace("fn(", "fn (")
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The condition under which an item is there, and what is derived for it.
fn notes(attributes: &[Attribute]) -> String {
    let told = |attribute: &Attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => {
            Some(format!(" [{}]", plain(&list.tokens)))
        }
        Meta::List(list) if list.path.is_ident("derive") => {
            Some(format!(" derive({})", plain(&list.tokens)))
        }
        Meta::List(list) if list.path.is_ident("cfg_attr") => {
            Some(format!(" [{}]", plain(&list.tokens)))
        }
        Meta::Path(path) if path.is_ident("non_exhaustive") => Some(" non_exhaustive".to_owned()),
        _ => None,
    };
    attributes.iter().filter_map(told).collect()
}

fn fields(fields: &Fields) -> Vec<String> {
    let public = fields.iter().filter(|field| is_public(&field.vis));
    let shown = public.map(|field| match &field.ident {
        Some(name) => format!("{name}: {}", plain(&field.ty)),
        None => plain(&field.ty),
    });
    shown.collect()
}

/// The name that an `impl` is for, if it is for a type of a plain path.
fn self_name(of: &ItemImpl) -> Option<String> {
    let Type::Path(path) = &*of.self_ty else { return None };
    path.path.segments.last().map(|segment| segment.ident.to_string())
}

/// The generics of an `impl`, with their bounds.
fn bounds(of: &ItemImpl) -> String {
    format!("{}{}", plain(&of.generics), plain(&of.generics.where_clause))
}

/// What a method, constant or type of a trait or of an `impl` looks like to callers.
fn member(item: &ImplItem) -> Option<String> {
    match item {
        ImplItem::Fn(item) if is_public(&item.vis) => {
            Some(format!("{}{}", plain(&item.sig), notes(&item.attrs)))
        }
        ImplItem::Const(item) if is_public(&item.vis) => {
            Some(format!("const {}: {}", item.ident, plain(&item.ty)))
        }
        _ => None,
    }
}

/// The arguments of a macro that makes an enum: they end with semicolons, or with commas in braces.
fn arguments(text: &str) -> Vec<String> {
    let (mut parts, mut depth, mut quoted) = (vec![String::new()], 0, false);
    for c in text.chars() {
        quoted ^= c == '"';
        match c {
            _ if quoted => {}
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        let ends = !quoted && (c == ';' && depth < 2 || c == ',' && depth == 1);
        if ends || c == '{' && depth == 1 {
            parts.push(String::new());
        } else if !(c == '}' && depth == 0) {
            parts.last_mut().expect("one at least").push(c);
        }
    }
    parts
}

struct Surface<'a> {
    tree: &'a Tree,
    lines: Vec<String>,
    /// The first path of each item, by where it is defined.
    known: BTreeMap<(Vec<String>, String), String>,
}

impl Surface<'_> {
    fn line(&mut self, path: &[String], text: &str) {
        self.lines.push(format!("{}: {text}", path.join("::")));
    }

    /// Everything public of the module at `home`, under the path by which callers name it.
    fn module(&mut self, home: &[String], path: &[String]) {
        let tree = self.tree;
        for item in &tree[home].items {
            match item {
                Item::Use(item) if is_public(&item.vis) => {
                    for (from, given) in used(&item.tree, home) {
                        let path = [path, &[given]].concat();
                        if tree.contains_key(&from) {
                            self.line(&path, &format!("mod{}", notes(&item.attrs)));
                            self.module(&from, &path);
                        } else {
                            self.item(&from, &path, &notes(&item.attrs));
                        }
                    }
                }
                Item::Mod(item) if is_public(&item.vis) => {
                    let name = [item.ident.to_string()];
                    let path = [path, &name].concat();
                    self.line(&path, &format!("mod{}", notes(&item.attrs)));
                    if item.content.is_none() {
                        self.module(&[home, &name].concat(), &path);
                    }
                }
                _ => {
                    if let Some((name, visibility)) = named(item)
                        && is_public(visibility)
                    {
                        let name = [name];
                        self.item(&[home, &name].concat(), &[path, &name].concat(), "");
                    }
                }
            }
        }
    }

    /// The item that `from` leads to, and what is implemented for it.
    fn item(&mut self, from: &[String], path: &[String], condition: &str) {
        let Some((home, name)) = defined(self.tree, from) else {
            return self.line(path, &format!("made by a macro{condition}"));
        };
        // Re-exports list an item again: its members stand at its first path.
        let key = (home.clone(), name.clone());
        if let Some(first) = self.known.get(&key) {
            return self.line(path, &format!("re-export of {first}{condition}"));
        }
        self.known.insert(key, path.join("::"));
        let items = &self.tree[&home].items;
        let found = items.iter().find(|item| named(item).is_some_and(|(own, _)| own == name));
        let Some(found) = found else {
            self.line(path, &format!("enum made by a macro{condition}"));
            self.made(items, path);
            return self.implemented(&home, &name, path);
        };
        let told = notes(attributes(found)) + condition;
        match found {
            Item::Fn(item) => self.line(path, &format!("{}{told}", plain(&item.sig))),
            Item::Const(item) => self.line(path, &format!("const {}{told}", plain(&item.ty))),
            Item::Static(item) => self.line(path, &format!("static {}{told}", plain(&item.ty))),
            Item::Type(item) => {
                self.line(path, &format!("type {}{told}", plain(&item.ty)));
            }
            Item::Struct(item) => {
                self.line(path, &format!("struct{}{told}", plain(&item.generics)));
                for field in fields(&item.fields) {
                    self.line(path, &format!("field {field}"));
                }
            }
            Item::Enum(item) => {
                self.line(path, &format!("enum{}{told}", plain(&item.generics)));
                for variant in &item.variants {
                    let text = format!("{}{}", variant.ident, plain(&variant.fields));
                    self.line(path, &format!("variant {text}{}", notes(&variant.attrs)));
                }
            }
            Item::Trait(item) => {
                let bounds = plain(&item.supertraits);
                self.line(path, &format!("trait{} of {bounds}{told}", plain(&item.generics)));
                for member in &item.items {
                    match member {
                        TraitItem::Fn(member) => self.line(path, &plain(&member.sig)),
                        TraitItem::Const(member) => {
                            let text = format!("const {}: {}", member.ident, plain(&member.ty));
                            self.line(path, &text);
                        }
                        TraitItem::Type(member) => {
                            self.line(path, &format!("type {}", member.ident));
                        }
                        _ => {}
                    }
                }
            }
            _ => {}
        }
        self.implemented(&home, &name, path);
    }

    /// The arguments of a macro that makes an enum, one line each, comments left out.
    fn made(&mut self, items: &[Item], path: &[String]) {
        let calls = items.iter().filter_map(|item| match item {
            Item::Macro(item) if item.ident.is_none() => Some(item.mac.tokens.to_string()),
            _ => None,
        });
        for tokens in calls.collect::<Vec<_>>() {
            let mut text = String::new();
            for part in tokens.split('#') {
                let doc = part.trim_start().strip_prefix("[doc = ");
                let code =
                    doc.map_or(part, |rest| rest.split_once("\"]").map_or("", |(_, code)| code));
                text.push_str(code);
            }
            for part in arguments(&text) {
                let part = part.split_whitespace().collect::<Vec<_>>().join(" ");
                if part.len() > 1 {
                    self.line(path, &part);
                }
            }
        }
    }

    /// What macros add to types: calls by their arguments, definitions by what they declare.
    fn macros(&mut self) {
        for module in self.tree.values() {
            let home = [module.file.clone()];
            for item in &module.items {
                let Item::Macro(item) = item else { continue };
                let text = plain(&item.mac.tokens);
                let exported = item.attrs.iter().any(|a| a.path().is_ident("macro_export"));
                if let Some(name) = &item.ident {
                    let words: Vec<&str> = text.split("pub ").skip(1).collect();
                    for word in words {
                        let end = word.find([':', '(', '{', ';', '=']).unwrap_or(word.len());
                        self.line(&home, &format!("macro {name}: pub {}", word[..end].trim()));
                    }
                    if exported {
                        self.line(&home, &format!("macro_export {name}"));
                    }
                } else {
                    let short: String = text.chars().take(60).collect();
                    self.line(&home, &format!("{}! {short}", plain(&item.mac.path)));
                }
            }
        }
    }

    /// Methods and traits of a type, wherever they are implemented.
    fn implemented(&mut self, home: &[String], name: &str, path: &[String]) {
        let tree = self.tree;
        for (place, module) in tree {
            for item in &module.items {
                let Item::Impl(item) = item else { continue };
                let Some(of) = self_name(item).filter(|of| of == name) else { continue };
                let from = [place.as_slice(), &[of]].concat();
                if defined(tree, &from).is_none_or(|(other, _)| other != home) {
                    continue;
                }
                if let Some((_, of, _)) = &item.trait_ {
                    let (of, ty) = (plain(of), plain(&item.self_ty));
                    let text = format!("impl{} {of} for {ty}", bounds(item));
                    self.line(path, &format!("{text}{}", notes(&item.attrs)));
                } else {
                    let told = bounds(item) + &notes(&item.attrs);
                    for text in item.items.iter().filter_map(member) {
                        self.line(path, &format!("{text} of impl{told}"));
                    }
                }
            }
        }
    }
}

#[test]
fn public_items_are_listed() {
    let tree = tree();
    let mut surface = Surface { tree: &tree, lines: Vec::new(), known: BTreeMap::new() };
    surface.module(&[], &["lobe".to_owned()]);
    surface.macros();
    let mut lines = surface.lines;
    assert!(lines.len() > 600, "only {} public items found", lines.len());
    lines.push(String::new());
    written("tests/texts/surface.txt", &lines.join("\n"));
}
