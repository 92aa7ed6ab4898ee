//! Builds the C++ twin of the bench, where there is a C++ compiler for this machine.
//!
//! Without one the bench has no rows of C++ (no cfg `cpp`), and all others.

use std::env;
use std::process::Command;

/// The flags of the twin's build, beside `-O3`.
///
/// Engines build with at least these. With errno a square root is a call; with traps GCC masks
/// every quotient by the select behind it. Neither changes a result. GCC fuses a * b + c where the
/// machine can, which Rust does not.
const FLAGS: [&str; 3] = ["-march=native", "-fno-math-errno", "-fno-trapping-math"];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=cpp/ggx.cpp");
    println!("cargo::rustc-check-cfg=cfg(cpp)");
    match twin() {
        Ok(compiler) => {
            println!("cargo::rustc-cfg=cpp");
            println!("cargo::rustc-env=LOBE_BENCH_CPP={compiler}");
        }
        Err(reason) => println!("cargo::warning=the bench has no rows of C++: {reason}"),
    }
}

/// Compiles the twin; the compiler's first line about itself, and the flags.
fn twin() -> Result<String, String> {
    if env::var_os("HOST") != env::var_os("TARGET") {
        return Err("it is built for another machine".to_owned());
    }
    let mut build = cc::Build::new();
    // The twin calls nothing of C++'s library.
    build.cpp(true).cpp_link_stdlib(None).opt_level(3).file("cpp/ggx.cpp");
    for flag in FLAGS {
        build.flag_if_supported(flag);
    }
    let one_line = |error: cc::Error| error.to_string().replace('\n', " ");
    build.try_compile("lobe_bench_ggx").map_err(one_line)?;
    let path = build.try_get_compiler().map_err(one_line)?.path().to_owned();
    let said = Command::new(&path).arg("--version").output().ok();
    let said = said.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    let name = said.as_deref().and_then(|text| text.lines().next()).unwrap_or("unknown").trim();
    Ok(format!("{name}, -O3 {}", FLAGS.join(" ")))
}
