//! What engines ship, as the table in the documentation of `lobe::filter::engine`.
//!
//! `cargo run --example engines > src/filter/engine.md`; tests/texts/documents.rs holds the file to
//! it.

use lobe::filter::engine::{AddedVariance, Engine};

fn main() -> Result<(), lobe::Error> {
    print!("{}", table()?);
    Ok(())
}

/// The surface that the last columns are of: alpha 0.01, squared derivatives that sum to 0.1.
const ALPHA: f64 = 0.01;
const SQUARES: f64 = 0.1;

/// The table, in Markdown.
pub(crate) fn table() -> Result<String, lobe::Error> {
    let head = format!(
        "The last two columns are for alpha = {ALPHA} and t = {SQUARES}, both axes alike: the \
            alpha that is shaded \
         with, and how much brighter than Tokuyoshi 2017, Eq. 13, its peak is (`cargo run \
         --example engines`).\n\n\
         | Engine | As shipped | Differentiates | $\\sigma_{{px}}^2$ | c | Cap | alpha' | Peak | \
         What to know |\n\
         |---|---|---|---|---|---|---|---|---|\n"
    );
    let step = (0.5 * SQUARES).sqrt();
    let (dn_u, dn_v) = ([step, 0.0, 0.0], [0.0, step, 0.0]);
    let meant = Engine::O3de.alpha(ALPHA, dn_u, dn_v)?;
    let mut lines = vec![head];
    for engine in Engine::ALL {
        let units = engine.added().map_or(
            ["\u{2013}".into(), "\u{2013}".into(), "\u{2013}".into()],
            |added| {
                let AddedVariance { coefficient, cap } = added;
                [added.filter().variance(), coefficient, cap].map(|x| format!("{x:.3}"))
            },
        );
        let alpha = engine.alpha(ALPHA, dn_u, dn_v)?;
        let cells = [
            engine.name().into(),
            engine.formula().replace('|', "\\|"),
            engine.normal().into(),
            units.join(" | "),
            format!("{alpha:.3}"),
            format!("{:.1}x", (meant / alpha).powi(2)),
            engine.shortcoming().into(),
        ];
        lines.push(format!("| {} |\n", cells.join(" | ")));
    }
    Ok(lines.concat())
}
