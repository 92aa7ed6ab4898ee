//! Every function of the WGSL port as compilers make it that assume numbers: no NaN, no infinity,
//! sums in any order.
//!
//! Metal's and Direct3D's compilers do so by default. Here naga writes Metal's language, and the
//! system's C++ compilers build it with `-ffast-math` (see [`lobe_gpu::cpp`]): a guard that waits
//! for a NaN or an infinity does not fire there, and a sum whose rounding matters is folded. The
//! program without `-ffast-math` is equal to Rust to the bit, so that whatever differs is the
//! compiler's doing.
//!
//! Inputs that are NaN or infinite are left out: a compiler that was promised numbers owes nothing
//! for them.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use std::path::Path;
use std::sync::LazyLock;

use lobe::probe::Rounded;
use lobe_gpu::cpp::{Program, compilers};
use lobe_gpu::twins::{Input, Twin, all};

/// Inputs per function.
const COUNT: usize = 2000;

/// How many scales a result may be off.
///
/// A scale counts one rounding, half an ulp, for each operation, and Rust's result is within one
/// scale. Quotients and roots by an estimate and a step of Newton's method, which `-ffast-math`
/// allows, are within the 2.5 ulp that WebGPU asks of drivers, 5 roundings in place of one; and a
/// sum in another order rounds numbers of up to twice the size. That is 1 + 2 *
/// 5. Measured where no branch falls otherwise: 2.0 by GCC 12, 3.8 by Clang 14.
const K: f64 = 11.0;

/// The largest share of inputs whose result may be off by more than `K` scales, in functions that
/// state no share: rounding may decide a branch the other way (is a matrix singular?), and the
/// scale knows only the branch that Rust took.
const FLIPS: f64 = 0.002;

/// Compilers, each with the twins as a program with and without `-ffast-math`.
struct Built {
    twins: Vec<Twin>,
    programs: Vec<(String, Result<[Program; 2], String>)>,
}

static BUILT: LazyLock<Built> = LazyLock::new(|| {
    let twins = all();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let build = |compiler: String| {
        let build = |flags: &[&str]| Program::new(&compiler, flags, &twins, folder);
        let strict = build(&["-O1", "-ffp-contract=off"]);
        let fast = strict.and_then(|strict| Ok([strict, build(&["-O2", "-ffast-math"])?]));
        (compiler, fast)
    };
    let programs = compilers().into_iter().map(build).collect();
    Built { twins, programs }
});

/// Runs `law` on the twins with the answers of both programs, strict and fast, of each compiler,
/// and collects what it complains of.
fn each(
    inputs: impl Fn(&Twin) -> Vec<f32>,
    law: impl Fn(&Twin, &[f32], [&[f32]; 2]) -> Result<(), String>,
) {
    let Built { twins, programs } = &*BUILT;
    if programs.is_empty() {
        assert!(std::env::var_os("CI").is_none(), "no C++ compiler: neither $CXX, c++ nor clang++");
        println!("skipped: no C++ compiler, neither $CXX, c++ nor clang++");
    }
    let inputs: Vec<Vec<f32>> = twins.iter().map(inputs).collect();
    for (compiler, programs) in programs {
        let programs = programs.as_ref().unwrap_or_else(|error| panic!("{error}"));
        let [strict, fast] = programs.each_ref().map(|program| program.run(twins, &inputs));
        let (strict, fast) = (strict.expect("answers"), fast.expect("answers"));
        let answers = strict.iter().zip(&fast).map(|(strict, fast)| [strict.as_slice(), fast]);
        let complaints: Vec<String> = twins
            .iter()
            .zip(&inputs)
            .zip(answers)
            .filter_map(|((twin, floats), answers)| {
                let error = law(twin, floats, answers).err()?;
                Some(format!("{} {}: {error}", twin.name, twin.by))
            })
            .collect();
        let count = complaints.len();
        assert!(complaints.is_empty(), "{compiler}: {count} twins:\n{}", complaints.join("\n"));
    }
}

/// The items of a twin with the answers to them.
fn items<'a>(
    twin: &Twin,
    floats: &'a [f32],
    answers: [&'a [f32]; 2],
) -> impl Iterator<Item = (&'a [f32], [&'a [f32]; 2])> {
    let [strict, fast] = answers.map(|answers| answers.chunks(twin.writes()));
    floats.chunks(twin.reads()).zip(strict.zip(fast)).map(|(item, (a, b))| (item, [a, b]))
}

#[test]
fn without_fast_math_the_program_equals_rust_to_the_bit() {
    let same = |got: f32, want: f32| got.to_bits() == want.to_bits() || (got == 0.0 && want == 0.0);
    each(
        |twin| twin.draw(COUNT),
        |twin, floats, answers| {
            for (item, [strict, _]) in items(twin, floats, answers) {
                let want = twin.single(item);
                if !strict.iter().zip(&want).all(|(&got, &want)| same(got, want)) {
                    return Err(format!("{item:?}: {strict:?} for {want:?}"));
                }
            }
            Ok(())
        },
    );
}

/// The results of a twin within `K` scales.
fn within(twin: &Twin, floats: &[f32], answers: [&[f32]; 2]) -> Result<(), String> {
    let (mut off, mut worst, mut first) = (0, 0.0_f64, None);
    for (item, [_, fast]) in items(twin, floats, answers) {
        let want = twin.rounded(item);
        // A branch that hands an argument on has no scale; its neighbor rounds.
        let scale = |want: &Rounded| {
            want.bound().max(f64::from(want.value().abs()) * 0.5 * f64::from(f32::EPSILON))
        };
        let share = |(got, want): (&f32, &Rounded)| {
            // Where Rust has no number, any is as good: a slope at the horizon, a form of a mirror.
            if !want.value().is_finite() {
                return if got.is_nan() { f64::NAN } else { 0.0 };
            }
            let distance = (f64::from(*got) - f64::from(want.value())).abs();
            // Subnormal results may be 0.
            distance / (K * scale(want) + f64::from(f32::MIN_POSITIVE))
        };
        let shares = || fast.iter().zip(&want).map(share);
        if shares().any(f64::is_nan) {
            return Err(format!("{item:?}: {fast:?} for {want:?}"));
        }
        let most = shares().fold(0.0, f64::max);
        if most > 1.0 {
            off += 1;
            first.get_or_insert_with(|| format!("{item:?}: {fast:?} for {want:?}"));
        }
        worst = worst.max(most);
    }
    let allowed = twin.flips.max(FLIPS) * (floats.len() / twin.reads()) as f64;
    match first {
        Some(first) if f64::from(off) > allowed => {
            Err(format!("{off}, by up to {worst:.1e}: {first}"))
        }
        _ => Ok(()),
    }
}

#[test]
fn ordinary_inputs_within_the_tolerance() {
    each(|twin| twin.draw(COUNT), within);
}

/// How many floats of a group, from its first, may be 0 in Rust: a mirror, a kernel or footprint
/// without extent, the zero vector.
fn may_vanish(twin: &Twin, input: Input) -> usize {
    match input {
        // Alphas, before shares of them.
        Input::Biscale | Input::Glints => 2,
        // A roughness, before numbers of facets. A mirror's kernel is cut into thousands of pieces:
        // which of them is drawn is said by the last bit.
        Input::Facets if !twin.name.contains("_sample") => 3,
        // Of two weights that are 0 there is no mean.
        Input::Unit | Input::Alpha if twin.name == "slope_moments_merged" => 0,
        Input::Unit
        | Input::Cosine
        | Input::Alpha
        | Input::Size
        | Input::Deviation
        | Input::Limit
        | Input::Vector
        | Input::Slope
        | Input::Mean
        | Input::Tilt
        | Input::Alphas
        | Input::Widths
        | Input::Derivative
        | Input::Curvature
        | Input::Psd
        | Input::Roughness
        | Input::Lobe
        | Input::Footprint
        | Input::Kernel
        | Input::Blurring
        | Input::Patch
        | Input::Blur => input.floats(),
        _ => 0,
    }
}

/// Ordinary inputs of which one group is 0, or all of them.
fn vanishing(twin: &Twin) -> Vec<f32> {
    let mut floats = twin.draw(COUNT / 10);
    let places = twin.inputs.iter().scan(0, |base, input| {
        let place = *base..*base + may_vanish(twin, *input);
        *base += input.floats();
        Some(place)
    });
    let places: Vec<_> = places.filter(|place| !place.is_empty()).collect();
    for (k, item) in floats.chunks_mut(twin.reads()).enumerate() {
        let which = k % (places.len() + 1);
        for (n, place) in places.iter().enumerate() {
            if n == which || which == places.len() {
                item[place.clone()].fill(0.0);
            }
        }
    }
    floats
}

#[test]
fn mirrors_and_zero_kernels_within_the_tolerance() {
    each(vanishing, within);
}

/// An alpha of 0 is a mirror, whose density and BRDF are 0 everywhere. A Beckmann guarded by the
/// NaN of its exponent had 3.4e38 here.
#[test]
fn a_mirror_is_dark() {
    let mirror = |twin: &Twin| {
        let of_lobes = [Input::Alpha, Input::Alphas, Input::Roughness, Input::Lobe];
        let dark = ["_d", "_brdf", "_slope_pdf", "_unshadowed_brdf_cos"]
            .iter()
            .any(|end| twin.name.ends_with(end));
        let first = twin.inputs[0];
        (dark && of_lobes.contains(&first)).then_some(first.floats())
    };
    let mut count = 0;
    for twin in all() {
        count += usize::from(mirror(&twin).is_some());
    }
    assert!(count >= 32, "only {count} densities");
    each(
        |twin| {
            let mut floats = twin.draw(COUNT / 10);
            if let Some(zeros) = mirror(twin) {
                floats.chunks_mut(twin.reads()).for_each(|item| item[..zeros].fill(0.0));
            }
            floats
        },
        |twin, floats, answers| {
            let mut items = items(twin, floats, answers);
            let lit = items
                .find(|(_, [_, fast])| mirror(twin).is_some() && fast.iter().any(|x| *x != 0.0));
            lit.map_or(Ok(()), |(item, [_, fast])| Err(format!("{item:?}: {fast:?}")))
        },
    );
}

/// Adversarial inputs, with the largest numbers for infinities and 0 for NaN.
fn hostile(twin: &Twin) -> Vec<f32> {
    let mut floats = twin.draw_hostile(COUNT);
    for x in &mut floats {
        *x = if x.is_nan() { 0.0 } else { x.clamp(f32::MIN, f32::MAX) };
    }
    floats
}

#[test]
fn no_finite_input_gives_nan() {
    each(hostile, |twin, floats, answers| {
        let mut bad =
            items(twin, floats, answers).filter(|(_, [_, fast])| fast.iter().any(|x| x.is_nan()));
        match bad.next() {
            Some((item, [strict, fast])) => {
                Err(format!("{} items, {item:?}: {fast:?} for {strict:?}", bad.count() + 1))
            }
            None => Ok(()),
        }
    });
}

/// Fourth powers of what is beyond 1e9, or below 1e-9, leave the range of f32 in one order of
/// factors and not in another: the law holds for the sizes that constructors take, and for 0.
#[test]
fn no_moderate_input_gives_infinity() {
    let moderate = |twin: &Twin| {
        let mut floats = hostile(twin);
        for x in &mut floats {
            *x = if x.abs() < 1e-9 { 0.0 } else { x.clamp(-1e9, 1e9) };
        }
        floats
    };
    each(moderate, |twin, floats, answers| {
        let infinite = |(strict, fast): (&f32, &f32)| strict.is_finite() && !fast.is_finite();
        let mut items = items(twin, floats, answers);
        let bad = items.find(|(_, [strict, fast])| strict.iter().zip(*fast).any(infinite));
        bad.map_or(Ok(()), |(item, [strict, fast])| {
            Err(format!("{item:?}: {fast:?} for {strict:?}"))
        })
    });
}
