//! Other people's validators, where they are installed.

use std::io::Write;
use std::process::{Command, Stdio};

/// Feeds `input` to a program: what it prints, as an error if it fails; `None` where it is missing.
///
/// # Panics
///
/// If the program starts but cannot be talked to.
pub fn ask(program: &str, arguments: &[&str], input: &[u8]) -> Option<Result<String, String>> {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().ok()?;
    // A validator may refuse before it has read everything; its exit status tells.
    let _ = child.stdin.take().expect("piped above").write_all(input);
    let output = child.wait_with_output().expect("the program ends");
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    Some(if output.status.success() { Ok(said) } else { Err(format!("{program}: {said}")) })
}

/// The reference validator of SPIR-V, with the rules of Vulkan 1.1.
pub fn spirv_val(words: &[u32]) -> Option<Result<String, String>> {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    ask("spirv-val", &["--target-env", "vulkan1.1", "-"], &bytes)
}
