//! A mistake on the command line, in one line.

use super::say::say;
use clap::error::ErrorKind;
use std::process::ExitCode;

/// Says what is wrong, in one line after the program's name, or prints the help that was asked for;
/// the exit code.
pub(crate) fn told(program: &str, error: &clap::Error) -> ExitCode {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        // Readers that have seen enough (`| head`) are no error.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    let text = error.to_string();
    let first: Vec<&str> =
        text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
    let line = first.join(" ");
    say(&format!("{program}: {}", line.strip_prefix("error: ").unwrap_or(&line)));
    ExitCode::from(2)
}
