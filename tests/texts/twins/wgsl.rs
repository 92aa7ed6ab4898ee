//! What a file of the WGSL port declares, with what the comments say of its twins.

/// A declaration of the WGSL port.
#[derive(Clone, Debug)]
pub(crate) struct Declared {
    pub(crate) name: String,
    /// The Rust names after `Rust: ` and `then` in its comment.
    pub(crate) twins: Vec<String>,
    /// True if it says that it is WGSL's alone.
    pub(crate) alone: bool,
    /// The numbers of a constant.
    pub(crate) numbers: Vec<f32>,
}

/// The declarations of a file, in its order.
pub(crate) fn declared(text: &str) -> Vec<Declared> {
    let (mut found, mut comment) = (Vec::new(), String::new());
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        if let Some(said) = line.strip_prefix("//") {
            comment.push_str(said);
            continue;
        }
        let kind = ["fn ", "const ", "struct "].iter().find_map(|kind| line.strip_prefix(kind));
        let Some(rest) = kind else {
            comment.clear();
            continue;
        };
        let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        let mut numbers = Vec::new();
        if line.starts_with("const ") {
            let mut value = line.split(" = ").nth(1).unwrap_or_default().to_owned();
            while !value.ends_with(';') {
                value.push_str(lines.next().expect("a constant ends with a semicolon").trim());
            }
            let value = value.split_once('(').map_or(value.as_str(), |(_, arguments)| arguments);
            let words = value.split(|c: char| "(),;".contains(c) || c.is_whitespace());
            numbers = words.filter_map(|word| word.trim_end_matches('u').parse().ok()).collect();
        }
        let twins = comment.split('`').collect::<Vec<_>>();
        let named = |k: usize| {
            let before = twins[k - 1].trim_end();
            before.ends_with("Rust:") || before.ends_with(", then")
        };
        let twins = (1..twins.len())
            .step_by(2)
            .filter(|&k| named(k))
            .map(|k| twins[k].to_owned())
            .collect();
        let alone = comment.contains("WGSL only:");
        found.push(Declared { name, twins, alone, numbers });
        comment.clear();
    }
    found
}
