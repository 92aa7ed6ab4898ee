#!/usr/bin/env bash
# Everything that must hold before a change is merged. Needs Rust 1.89 or newer with rustup and a C
# compiler's linker; rustfmt and clippy are installed where they are missing.
#
#   ./test.sh          all of it
#   ./test.sh --fast   without release builds: no validate, no benches, no fuzz targets
#
# The last line is the sum over all test binaries: "N passed, 0 failed".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

fast=false
for argument in "$@"; do
    case "$argument" in
    --fast) fast=true ;;
    -h | --help)
        sed -n '2,8s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    *)
        echo "test.sh: unknown option $argument (there is --fast)" >&2
        exit 2
        ;;
    esac
done

# The packages outside the workspace build next to the others, not in folders of their own.
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

step() { printf '\n== %s (%ss)\n' "$*" "$SECONDS"; }
skip() { printf '\n-- skipped: %s\n' "$*"; }
fail() {
    printf '\ntest.sh: %s\n' "$*" >&2
    exit 1
}

# refuses REASON COMMAND...: the command must fail and say REASON.
refuses() {
    local reason=$1
    shift
    if "$@" >"$log" 2>&1; then fail "should not have built: $*"; fi
    grep -qF "$reason" "$log" || {
        cat "$log"
        fail "failed, but not with '$reason': $*"
    }
}

command -v cargo >/dev/null || fail "cargo not found: install Rust 1.89 or newer, https://rustup.rs"
for component in rustfmt clippy; do
    if ! cargo "${component/rustfmt/fmt}" --version >/dev/null 2>&1; then
        step "Installing the component $component"
        rustup component add "$component"
    fi
done

step "Format"
cargo fmt --all -- --check
rustfmt --edition 2024 --check tests/no_std/src/lib.rs fuzz/fuzz_targets/*.rs

step "Lints: workspace, all targets"
cargo clippy --workspace --all-targets -- -D warnings

step "Features: every combination builds without warnings"
for features in std libm std,libm std,count std,glam libm,glam std,libm,glam; do
    echo "   $features"
    cargo clippy --quiet --package lobe --no-default-features --features "$features" -- -D warnings
done
echo "   none: must refuse"
refuses "lobe needs one of the features" cargo check --package lobe --no-default-features

step "no_std: a static library without std, and the proof that std would be noticed"
cargo build --quiet --manifest-path tests/no_std/Cargo.toml
cargo build --quiet --manifest-path tests/no_std/Cargo.toml --features glam
refuses "E0152" cargo build --manifest-path tests/no_std/Cargo.toml --features std

step "Documentation"
RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet
RUSTDOCFLAGS="-D warnings" cargo doc --package lobe --all-features --no-deps --quiet

step "Tests: laws, golden tables, corpus, doc tests"
tests=$(mktemp)
trap 'rm -f "$log" "$tests"' EXIT
failures=()
cargo test --workspace --features count --no-fail-fast 2>&1 | tee "$tests" || failures+=("tests")

if $fast; then
    skip "validate, benches, fuzz targets (--fast)"
else
    step "validate: the library against its golden tables, as a user runs it"
    cargo run --quiet --release --example validate || failures+=("validate")

    step "Benches build"
    cargo bench --workspace --no-run --quiet

    if command -v c++ >/dev/null || command -v clang++ >/dev/null; then
        step "Fuzz targets build"
        cargo check --quiet --manifest-path fuzz/Cargo.toml
    else
        skip "fuzz targets: libFuzzer needs a C++ compiler, and there is none"
    fi
fi

step "Summary"
grep '^test result:' "$tests" || true
awk '/^test result:/ { passed += $4; failed += $6 }
    END { printf "%d passed, %d failed\n", passed, failed; exit passed == 0 }' "$tests" ||
    failures+=("no test ran")
if ((${#failures[@]})); then
    IFS=,
    fail "FAILED: ${failures[*]}"
fi
