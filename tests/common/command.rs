//! What a program said: its result, or one line of complaint.

use std::fs;
use std::path::Path;
use std::process::Output;
#[cfg(unix)]
use std::process::{Command, Stdio};

/// What it printed, as it succeeded and complained of nothing.
#[track_caller]
pub(crate) fn said(output: Output) -> String {
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{complaint}");
    assert!(complaint.is_empty(), "{complaint}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// One line that begins with the program's name and says all of `parts`, and nothing printed.
#[track_caller]
pub(crate) fn complains(program: &str, output: &Output, parts: &[&str]) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(output.stdout.is_empty());
    assert_eq!(said.lines().count(), 1, "{said}");
    let all = parts.iter().all(|part| said.contains(part));
    assert!(said.starts_with(&format!("{program}: ")) && all, "{parts:?}: {said}");
}

/// A program whose files may not grow beyond 8 KiB, as on a disk that fills.
#[cfg(target_os = "linux")]
pub(crate) fn limited(program: &Path) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' XFSZ; ulimit -f 16; exec \"$0\" \"$@\""]).arg(program);
    command
}

/// Ctrl-C, and what ends programs politely.
#[cfg(unix)]
pub(crate) const SIGNALS: [&str; 2] = ["-INT", "-TERM"];

/// Sends the signal to a program that makes the folder `out`, as soon as the program is `ready`:
/// the program ends with one line, and the exit code of signals. Where the program had made the
/// folder before the signal came, another run is tried.
#[cfg(unix)]
#[track_caller]
pub(crate) fn interrupted(
    program: &str,
    command: &mut Command,
    signal: &str,
    out: &Path,
    ready: impl Fn() -> bool,
) {
    for _ in 0..20 {
        let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
        let mut child = child.expect("the example runs");
        while !ready() && child.try_wait().expect("a child").is_none() {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        // The exit status says whether the signal found the program.
        let _ = Command::new("kill").args([signal, &child.id().to_string()]).output();
        let output = child.wait_with_output().expect("it ends");
        if output.status.success() {
            fs::remove_dir_all(out).expect("a folder that was made");
            continue;
        }
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{said}");
        assert!(said.starts_with(&format!("{program}: ")) && said.lines().count() == 1, "{said}");
        return;
    }
    panic!("{program} ended before each of twenty signals");
}

/// Everything in a folder, in the order of the alphabet.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<_> = entries
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .collect();
    names.sort();
    names
}
