#!/usr/bin/env bash
# Everything that must hold before a change is merged. Needs Rust 1.89 or newer with rustup and a C
# compiler's linker; rustfmt, clippy and, through apt-get, a Vulkan driver for the CPU are installed
# where they are missing. With node and npm, Chrome's WGSL compiler checks the shaders, too.
#
#   ./test.sh          all of it, laws and twins on a share of their cases
#   ./test.sh --fast   formatting, lints, laws, texts, tools, twins in exact mode: after each edit
#   ./test.sh --long   all of it at full size, with release builds: about an hour
#
# Before the last line stands what each step took, the slowest first. The last line is the sum over
# all test binaries: "N passed, 0 failed".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

size=ordinary
for argument in "$@"; do
    case "$argument" in
    --fast | --long) size=${argument#--} ;;
    -h | --help)
        sed -n '2,11s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    *)
        echo "test.sh: unknown option $argument (there are --fast and --long)" >&2
        exit 2
        ;;
    esac
done
# Laws and twins read it: tests/common/size.rs.
if [[ $size == long ]]; then export LOBE_LONG=1; fi

# The packages outside the workspace build next to the others, not in folders of their own.
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
log=$(mktemp)
tests=$(mktemp)
times=$(mktemp)
sets=$(mktemp)
beside=
tidy() {
    rm -f "$log" "$tests" "$times" "$sets"
    [[ -z $beside ]] || kill "$beside" 2>/dev/null || true
}
trap tidy EXIT

# step NAME: ends the step before it and begins one.
current=
began=0
step() {
    if [[ -n $current ]]; then printf '%5d s  %s\n' $((SECONDS - began)) "$current" >>"$times"; fi
    current=$*
    began=$SECONDS
    if [[ -n $current ]]; then printf '\n== %s\n' "$current"; fi
}
skip() { printf '\n-- skipped: %s\n' "$*"; }
fail() {
    printf '\ntest.sh: %s\n' "$*" >&2
    exit 1
}

# refuses REASON COMMAND...: the command must fail and say REASON.
refuses() {
    local reason=$1 said
    shift
    if said=$("$@" 2>&1); then fail "should not have built: $*"; fi
    [[ $said == *"$reason"* ]] || {
        echo "$said"
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

# Mesa's Vulkan driver for the CPU and the loader that finds it, by their files alone: a package
# manager is asked only where one is missing.
lavapipe=
find_lavapipe() {
    local icd library folder
    local loaders=(/usr/lib/"$(uname -m)"-linux-gnu /usr/lib64 /usr/lib /usr/local/lib)
    for icd in {/usr/share,/usr/local/share,/etc}/vulkan/icd.d/lvp_icd{".$(uname -m)",}.json; do
        [[ -r $icd ]] || continue
        library=$(sed -n 's/.*"library_path" *: *"\([^"]*\)".*/\1/p' "$icd")
        # Absolute, next to the description, or where the loader looks.
        for folder in "" "${icd%/*}/" "${loaders[@]/%//}"; do
            [[ -n $library && -e $folder$library ]] && lavapipe=$icd
        done
    done
    [[ -n $lavapipe ]] || return 1
    for folder in "${loaders[@]}"; do
        if [[ -e $folder/libvulkan.so.1 ]]; then return; fi
    done
    return 1
}

# install_packages PACKAGE...: through apt-get, as root or by sudo without a password; fails where
# it cannot.
install_packages() {
    local root=() try
    command -v apt-get >/dev/null || return 1
    if ((EUID != 0)); then
        sudo -n true 2>/dev/null || return 1
        root=(sudo -n)
    fi
    local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq
        -o DPkg::Lock::Timeout=120)
    for try in 1 2 3; do
        # Lists may be missing or old; one broken source among them need not matter.
        "${apt[@]}" update || true
        if "${apt[@]}" install -y --no-install-recommends "$@" >"$log"; then return; fi
        cat "$log"
        echo "$*: try $try of 3 failed" >&2
    done
    return 1
}

real_gpu() { compgen -G "/dev/nvidia0" >/dev/null || compgen -G "/dev/dri/renderD*" >/dev/null; }

# Lavapipe first, then Chromium's SwiftShader as a second opinion, then real GPUs if there are any.
vulkan_drivers() {
    local icd drivers=$lavapipe
    for icd in /usr/lib{,64}/chromium{,-browser}/vk_swiftshader_icd.json \
        /opt/google/chrome/vk_swiftshader_icd.json; do
        if [[ -e $icd && -e ${icd%/*}/libvk_swiftshader.so ]]; then drivers+=:$icd && break; fi
    done
    if real_gpu; then
        for icd in {/usr/share,/etc}/vulkan/icd.d/*.json; do
            if [[ -e $icd && $icd != *lvp_icd* && $icd != *.i686.json ]]; then drivers+=:$icd; fi
        done
    fi
    echo "$drivers"
}

step "Vulkan driver"
if [[ -z ${VK_DRIVER_FILES:-} ]]; then
    # GPU tests that skip themselves prove nothing, so a driver is installed, or this fails.
    find_lavapipe || { install_packages libvulkan1 mesa-vulkan-drivers && find_lavapipe; } ||
        fail "the GPU tests need a Vulkan driver: as root, or with sudo, install libvulkan1 and \
mesa-vulkan-drivers (Debian, Ubuntu), or elsewhere the Vulkan loader and Mesa's lavapipe"
    VK_DRIVER_FILES=$(vulkan_drivers)
fi
# The second name is for loaders before 1.3.207; the last one keeps a layer of Mesa's from
# complaining where there is no desktop.
export VK_DRIVER_FILES VK_ICD_FILENAMES=$VK_DRIVER_FILES NODEVICE_SELECT=1
echo "   $VK_DRIVER_FILES"
[[ $VK_DRIVER_FILES == *swiftshader* ]] ||
    skip "a second driver: Chromium's SwiftShader is not installed"
real_gpu || skip "real GPUs: there is none"
for checks in "spirv-val spirv-tools" "glslangValidator glslang-tools" "c++ g++" "clang++ clang"; do
    read -r tool package <<<"$checks"
    command -v "$tool" >/dev/null || install_packages "$package" ||
        skip "checks by $tool: $package could not be installed"
done

step "Format"
cargo fmt --all -- --check
rustfmt --edition 2024 --check tests/no_std/src/lib.rs fuzz/fuzz_targets/*.rs

# Lints check every target: benches, examples and tools need no build of their own.
step "Lints: workspace, all targets"
cargo clippy --workspace --all-targets -- -D warnings

failures=()
# run_tests ARGUMENTS...: cargo test, its output kept for the sum.
run_tests() { cargo test "$@" 2>&1 | tee -a "$tests" || failures+=("cargo test $*"); }

# Sets of features that build without warnings, and the empty one, which must refuse.
feature_sets() {
    local features
    export CARGO_TARGET_DIR=$CARGO_TARGET_DIR/features
    for features in std libm std,libm std,probe std,glam libm,glam std,libm,glam \
        std,dispatch std,avx512 \
        std,serde libm,serde,lean,leadr,glint std,bytemuck,wgsl \
        std,published std,wgsl std,lean std,leadr std,glint libm,glint,wgsl libm,lean libm,leadr \
        libm,wgsl libm,published,wgsl libm,lean,leadr,published,wgsl; do
        echo "features: $features"
        cargo clippy --quiet --package lobe --no-default-features --features "$features" \
            -- -D warnings || return
    done
    refuses "lobe needs one of the features" cargo check --package lobe --no-default-features
}

# The tools' tests run the examples. All packages are selected in every call: another selection
# would compile dependencies with other features.
all=(--workspace --features probe,serde,bytemuck)
step "Tests build"
if [[ $size == fast ]]; then
    suites=(--test laws --test texts --test tools --test cli)
    cargo build --quiet "${all[@]}" --examples "${suites[@]}" --test drivers
    step "Tests: laws, golden tables, corpus, texts, tools"
    run_tests "${all[@]}" "${suites[@]}" --no-fail-fast
    step "Tests: twins in exact mode"
    run_tests "${all[@]}" --test drivers exact_mode_equals_rust
    skip "other tests of the GPU and the report, documentation and its examples, sets of" \
        "features, no_std, Tint, fuzz targets (--fast)"
else
    cargo build --quiet "${all[@]}" --lib --bins --examples --tests
    step "Tests: laws, golden tables, corpus, texts, tools, twins"
    run_tests "${all[@]}" --lib --bins --tests --no-fail-fast

    # One crate at a time is compiled for these: they run beside the steps that follow, in a target
    # folder of their own.
    feature_sets >"$sets" 2>&1 &
    beside=$!

    step "Tests: examples in the documentation"
    run_tests "${all[@]}" --no-fail-fast --doc

    step "Documentation"
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet
    RUSTDOCFLAGS="-D warnings" cargo doc --package lobe --all-features --no-deps --quiet

    step "no_std: a static library without std, and the proof that std would be noticed"
    cargo build --quiet --manifest-path tests/no_std/Cargo.toml
    cargo build --quiet --manifest-path tests/no_std/Cargo.toml --features glam
    refuses "E0152" cargo build --manifest-path tests/no_std/Cargo.toml --features std

    # Chrome's WGSL compiler refuses what naga accepts: derivatives that not every pixel of a quad
    # reaches.
    tint=tests/gpu/tint
    tint_installed() {
        [[ $tint/node_modules/.package-lock.json -nt $tint/package-lock.json ]] ||
            npm ci --prefix "$tint" --no-audit --no-fund >"$log" 2>&1
    }
    if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
        skip "Tint on the WGSL: node and npm are not installed"
    elif ! tint_installed; then
        skip "Tint on the WGSL: npm could not install it: $(grep -i -m 1 'npm err' "$log")"
    else
        step "Tint on the WGSL"
        node "$tint/check.mjs" "$CARGO_TARGET_DIR/debug/examples/wgsl" || failures+=("Tint")
    fi

    # libFuzzer itself, in C++, is left to cargo-fuzz: a check links nothing.
    step "Fuzz targets"
    CUSTOM_LIBFUZZER_PATH=/dev/null cargo check --quiet --manifest-path fuzz/Cargo.toml

    step "Features: sets that build without warnings, beside the steps before this one"
    wait "$beside" || {
        cat "$sets"
        fail "a set of features does not build: $(grep '^features:' "$sets" | tail -n 1)"
    }
fi

if [[ $size == long ]]; then
    step "validate: the library against its golden tables, as a user runs it"
    cargo run --quiet --release --example validate || failures+=("validate")

    step "WGSL without the feature published: its items are named, the rest is whole"
    run_tests --package lobe --no-default-features --features std,wgsl --test texts

    step "Benches build"
    cargo bench --workspace --no-run --quiet
fi

step ""
printf '\n== What each step took\n'
sort -rn "$times"
printf '%5d s  in all\n\n' "$SECONDS"
awk '/^test result:/ { passed += $4; failed += $6 }
    END { printf "%d passed, %d failed\n", passed, failed; exit passed == 0 }' "$tests" ||
    failures+=("no test ran")
if ((${#failures[@]})); then
    IFS=,
    fail "FAILED: ${failures[*]}"
fi
