//! Command lines of the examples, as a user runs them: what they print and write, mistakes in one
//! line, exit codes.

#[path = "../common/command.rs"]
mod command;
#[path = "../common/example.rs"]
mod program;

mod bake;
mod glints;
mod validate;
mod wgsl;
