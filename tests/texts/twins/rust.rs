//! Functions and constants of a Rust file, read without a parser: rustfmt has put each where it can
//! be found.

/// A function: where it lives, whether callers of the crate see it, and its names in WGSL.
#[derive(Clone, Debug)]
pub(crate) struct Function {
    /// `Type::name`, `Trait::name`, or `name`.
    pub(crate) path: String,
    pub(crate) public: bool,
    /// Of a trait, declared or implemented: as public as the trait.
    pub(crate) of_trait: bool,
    /// Its documentation aliases that begin with `lobe_`.
    pub(crate) aliases: Vec<String>,
}

impl Function {
    /// True if a twin of the WGSL port that names `twin` means it. Distributions and shapes stand
    /// for their trait.
    pub(crate) fn is(&self, twin: &str) -> bool {
        const TRAITS: [(&str, &[&str]); 3] = [
            ("Distribution", &["GgxDistribution", "BeckmannDistribution"]),
            ("LobeShape", &["Isotropic", "AxisAligned", "Anisotropic", "Widened", "NonCentered"]),
            ("Whiten", &["Anisotropic", "NonCentered"]),
        ];
        let of_trait = |name: &str, types: &[&str]| {
            let (home, method) = twin.split_once("::").unwrap_or_default();
            types.contains(&home) && self.path == format!("{name}::{method}")
        };
        self.path == twin || TRAITS.iter().any(|(name, types)| of_trait(name, types))
    }
}

/// The type or trait that an `impl` or `trait` line is about, and whether its methods are public by
/// themselves.
fn home(line: &str) -> Option<(String, bool)> {
    let words = |text: &str| -> Option<String> {
        let name: String =
            text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        (!name.is_empty()).then_some(name)
    };
    if let Some(rest) = line.strip_prefix("pub trait ") {
        let name = words(rest)?;
        // The trait that seals `Real` can be named by no caller.
        let public = name != "Internal";
        return Some((name, public));
    }
    let rest = line.strip_prefix("impl")?;
    // Past the generics.
    let mut depth = 0;
    let end = rest.char_indices().find(|&(_, c)| {
        match c {
            '<' => depth += 1,
            '>' => depth -= 1,
            _ => {}
        }
        depth == 0 && (c == ' ' || c == '>')
    })?;
    let rest = &rest[end.0 + 1..];
    let name = rest.split(" for ").last()?;
    Some((words(name)?, false))
}

/// The name in WGSL that an attribute gives as an alias.
fn alias(attribute: &str) -> Option<String> {
    let name = attribute.strip_prefix("#[doc(alias = \"")?.strip_suffix("\")]")?;
    ["lobe_", "Lobe"].iter().any(|prefix| name.starts_with(prefix)).then(|| name.to_owned())
}

/// All names in WGSL that a file gives as aliases: those of operators stand at their types.
pub(crate) fn aliases(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| alias(line.trim())).collect()
}

/// The functions of a file, tests left out.
pub(crate) fn functions(text: &str) -> Vec<Function> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let (mut found, mut place) = (Vec::new(), (String::new(), false));
    let (mut aliases, mut hidden, mut implements) = (Vec::new(), false, false);
    for line in text.lines() {
        let bare = line.trim_start();
        let indented = line.len() - bare.len();
        if bare.starts_with("///") {
            continue;
        }
        if bare.starts_with("#[") {
            hidden |= bare.contains("doc(hidden)");
            aliases.extend(alias(bare).filter(|name| name.starts_with("lobe_")));
            continue;
        }
        if indented == 0 {
            if let Some(new) = home(line) {
                place = new;
                implements = line.starts_with("impl") && line.contains(" for ");
            } else if bare.starts_with('}') {
                place = (String::new(), false);
            }
        }
        let stated = bare.strip_prefix("pub ");
        let rest = stated.unwrap_or(bare);
        let rest = rest.strip_prefix("const ").unwrap_or(rest);
        let rest = match rest.strip_prefix("pub(") {
            Some(scoped) => scoped.split_once(") ").map_or(rest, |(_, rest)| rest),
            None => rest,
        };
        if let Some(rest) = rest.strip_prefix("fn ")
            && indented <= 4
        {
            let name: String =
                rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let within = indented > 0 && !place.0.is_empty();
            let path = if within { format!("{}::{name}", place.0) } else { name };
            let public = (stated.is_some() || (within && place.1)) && !hidden;
            let of_trait = within && (place.1 || implements);
            found.push(Function { path, public, of_trait, aliases: std::mem::take(&mut aliases) });
        }
        aliases.clear();
        hidden = false;
    }
    found
}

/// The numbers of a constant, in f32: products and quotients of literals, or every literal of an
/// array.
pub(crate) fn value(text: &str, name: &str) -> Option<Vec<f32>> {
    let base = name.trim_start_matches("Self::");
    let start = text.find(&format!("const {base}: "))?;
    let stated = &text[start..];
    let after = stated[stated.find(" =")? + 2..].trim_start();
    let body = &after[..after.find(';')?];
    let literal = |word: &str| -> Option<f64> {
        let word = word.trim().trim_end_matches("_f32").replace('_', "");
        match word.rsplit("::").next()? {
            "FRAC1PI" => Some(core::f64::consts::FRAC_1_PI),
            "FRACPI2" => Some(f64::from(core::f32::consts::FRAC_PI_2)),
            "PI" => Some(f64::from(core::f32::consts::PI)),
            number => number.parse().ok(),
        }
    };
    if body.contains('[') {
        let words = body.split(|c: char| "[]{},".contains(c) || c.is_whitespace());
        return Some(words.filter_map(literal).map(|x| x as f32).collect());
    }
    let mut product = 1.0;
    for (k, factor) in body.split(" * ").enumerate() {
        for (n, part) in factor.split(" / ").enumerate() {
            let x = literal(part)?;
            product = if k == 0 && n == 0 {
                x
            } else if n == 0 {
                product * x
            } else {
                product / x
            };
        }
    }
    Some(vec![product as f32])
}
