//! What a program prints, and what it ends with.

use super::say::say;
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

/// Prints a text. A reader that has seen enough (`| head`) is no error.
pub(crate) fn print(text: &str) -> Result<(), String> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("cannot write standard output: {error}"))
        }
        _ => Ok(()),
    }
}

/// Says why it failed, in one line after the program's name; the exit code, that of a signal if one
/// stopped it.
pub(crate) fn failed(program: &str, message: &str, stopped: bool) -> ExitCode {
    say(&format!("{program}: {message}"));
    ExitCode::from(if stopped { 130 } else { 2 })
}
