//! What the numbers hold for: the machine, one core of it, and how the code was built.

use std::fs;

/// Keeps this thread, and those it starts, on the last core that it may use: interrupts mostly go
/// to the first. The core's number, where the system lets it be chosen.
pub(crate) fn pin() -> Option<usize> {
    let core = core_affinity::get_core_ids()?.into_iter().max_by_key(|core| core.id)?;
    core_affinity::set_for_current(core).then_some(core.id)
}

/// The CPU's name, with family and model where the name does not tell one from another.
pub(crate) fn name() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |wanted: &str| {
        let mut pairs = text.lines().filter_map(|line| line.split_once(':'));
        pairs.find(|(key, _)| key.trim() == wanted).map(|(_, value)| value.trim())
    };
    match (field("model name"), field("cpu family"), field("model")) {
        (Some(name), Some(family), Some(model)) => {
            format!("{name} (family {family}, model {model})")
        }
        (Some(name), ..) => name.to_owned(),
        _ => format!("unknown {}", std::env::consts::ARCH),
    }
}

/// Those of the features that decide how wide loops are which Rust was allowed to use.
pub(crate) fn features() -> String {
    let known = [
        ("avx512f", cfg!(target_feature = "avx512f")),
        ("avx2", cfg!(target_feature = "avx2")),
        ("fma", cfg!(target_feature = "fma")),
        ("sse2", cfg!(target_feature = "sse2")),
        ("neon", cfg!(target_feature = "neon")),
    ];
    let present: Vec<&str> = known.iter().filter(|(_, has)| *has).map(|(name, _)| *name).collect();
    if present.is_empty() { "none known".to_owned() } else { present.join(" ") }
}

/// The compiler and the flags of the C++ twin.
pub(crate) fn cpp() -> &'static str {
    option_env!("LOBE_BENCH_CPP").unwrap_or("none")
}

/// All of it, a line each.
pub(crate) fn lines(core: Option<usize>) -> [String; 4] {
    let core = core.map_or_else(|| "not pinned".to_owned(), |core| format!("core {core}"));
    [
        format!("Machine: {}", name()),
        format!("Core: {core}"),
        format!("Target features of Rust: {}", features()),
        format!("C++ twin: {}", cpp()),
    ]
}
