//! The command `lobe-report`; everything it does is in the library beside it.

use std::process::ExitCode;

fn main() -> ExitCode {
    lobe_report::run()
}
