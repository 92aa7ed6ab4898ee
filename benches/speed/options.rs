//! The bench's own options, told apart from criterion's.

use clap::{CommandFactory, Parser};
use std::path::{Path, PathBuf};

/// Cost per sample, as ratios within one run. All other options and the filter are criterion's.
#[derive(Parser, Default)]
#[command(name = "speed", disable_version_flag = true)]
#[command(after_help = "Relative paths count from the root of the workspace.")]
pub(crate) struct Options {
    /// Write every row of the table as {"name", "ns", "over", "ratio"}, where it has a limit with
    /// "limit_ns" and "fraction".
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Write what each step from a round lobe to any costs, as a table in Markdown.
    #[arg(long, value_name = "FILE")]
    pub(crate) ladder: Option<PathBuf>,
    /// Measure the table alone, without criterion's runs.
    #[arg(long)]
    pub(crate) rows_only: bool,
}

impl Options {
    /// The files to be written.
    pub(crate) fn files(&self) -> impl Iterator<Item = &Path> {
        [&self.json, &self.ladder].into_iter().flatten().map(PathBuf::as_path)
    }

    /// True if nothing is asked for that criterion does not know.
    pub(crate) fn is_empty(&self) -> bool {
        self.files().next().is_none() && !self.rows_only
    }
}

/// Splits a command line in two: our options, and what is left for criterion, which refuses options
/// that it does not know.
pub(crate) fn split(arguments: impl Iterator<Item = String>) -> (Vec<String>, Vec<String>) {
    let (mut own, mut other) = (vec!["speed".to_owned()], Vec::new());
    let mut arguments = arguments.peekable();
    while let Some(argument) = arguments.next() {
        let name = argument.split('=').next().unwrap_or_default();
        let takes_file = ["--json", "--ladder"].contains(&name);
        if takes_file && name == argument {
            // Without its file the option is clap's to complain of.
            let file = arguments.next_if(|next| !next.starts_with('-'));
            own.push(argument);
            own.extend(file);
        } else if takes_file || argument == "--rows-only" {
            own.push(argument);
        } else {
            other.push(argument);
        }
    }
    (own, other)
}

/// Our options of a command line, files counted from the root of the workspace.
pub(crate) fn parse(own: &[String]) -> Result<Options, clap::Error> {
    // Cargo runs a bench in the folder of its package, wherever the user stands.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let mut options = Options::try_parse_from(own)?;
    for file in [&mut options.json, &mut options.ladder].into_iter().flatten() {
        *file = root.join(&file);
    }
    Ok(options)
}

/// Prints the help on our options; criterion's follows.
pub(crate) fn help() -> std::io::Result<()> {
    Options::command().print_help()
}
