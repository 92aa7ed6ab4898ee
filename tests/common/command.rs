//! What a program said: its result, or one line of complaint.

use std::fs;
use std::path::Path;
use std::process::Output;

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

/// Everything in a folder, in the order of the alphabet.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<_> = entries
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .collect();
    names.sort();
    names
}
