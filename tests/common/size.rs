//! How much a test run takes: laws at full size in `./test.sh --long`, a share of their cases
//! otherwise.

/// An ordinary run takes one case in this many of a law that counts its cases.
///
/// The share still finds the mutations that the laws are there for.
const SHARE: u32 = 5;

/// True in a long run: `./test.sh --long` sets the environment variable `LOBE_LONG`.
pub fn is_long() -> bool {
    std::env::var_os("LOBE_LONG").is_some()
}

/// The size of a test in an ordinary run and in a long one.
pub fn size<T>(ordinary: T, long: T) -> T {
    if is_long() { long } else { ordinary }
}

/// How many of a law's `full` cases are run: all in a long run, and not fewer than 100 (or all) in
/// an ordinary one.
pub fn cases(full: u32) -> u32 {
    size((full / SHARE).max(full.min(100)), full)
}
