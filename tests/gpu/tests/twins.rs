//! Every function of the WGSL port against its Rust twin, on every driver that is there.
//!
//! **Exact mode**: no operation fused, folded or reordered; equal to Rust's f32 to the bit. Only
//! the sign of zero is free, and results below the smallest normal number, which a driver may
//! flush.
//!
//! **As shipped**: the text as wgpu hands it to the driver, whose compiler may fuse and
//! reorder. |gpu - rust| <= k 2^-24 scale, where the scale of an input is what
//! [`Rounded`](lobe::probe::Rounded) says: the sum over all operations of what one more rounding of
//! each could change. k is [`K`] for every function.
//!
//! **Fused**: Rust with every a * b + c fused, as real GPUs do, within the same.
//!
//! Where a function decides (a cell, a bin, a count), a result jumps on the few inputs that one
//! rounding more decides otherwise. A twin says how many at most ([`Twin::flips`]); they are
//! counted, and in exact mode there are none.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use lobe::probe::Rounded;
use lobe::wgsl::{Item, source};
use lobe_gpu::size::size;
use lobe_gpu::twins::{Input, Twin, all};
use lobe_gpu::{Driver, Gpu, Mode};

/// Inputs per function.
fn count() -> usize {
    size(4_000, 100_000)
}

/// How many scales a result may be off: two evaluations, each within one.
const K: f64 = 2.0;

/// Runs `law` on every twin and collects what it complains of.
fn each(law: impl Fn(&Twin) -> Result<String, String>) {
    let (mut complaints, mut notes) = (Vec::new(), Vec::new());
    for twin in all() {
        let title = format!("{} {}", twin.name, twin.by);
        match law(&twin) {
            Ok(note) => notes.push(format!("{title}: {note}")),
            Err(complaint) => complaints.push(format!("{title}: {complaint}")),
        }
    }
    println!("{}", notes.join("\n"));
    assert!(complaints.is_empty(), "{} twins differ:\n{}", complaints.len(), complaints.join("\n"));
}

/// What a driver makes of a twin.
fn on(gpu: &'static Gpu, mode: Mode, twin: &Twin, floats: &[f32]) -> Result<Vec<f32>, String> {
    let (library, body) = (twin.library(), twin.body());
    twin.job(&library, &body).run(gpu, mode, floats)
}

/// Equal to the bit, but for the sign of zero and subnormal numbers.
fn same(got: f32, want: f32) -> bool {
    let least = f32::MIN_POSITIVE;
    got.to_bits() == want.to_bits() || (got.abs() <= least && want.abs() <= least)
}

#[test]
fn exact_mode_equals_rust_to_the_bit() {
    each(|twin| {
        let floats = twin.draw(count());
        let got = on(Gpu::lavapipe(), Mode::Exact, twin, &floats)?;
        let (mut wrong, mut first) = (0, None);
        for (item, got) in floats.chunks(twin.reads()).zip(got.chunks(twin.writes())) {
            let want = twin.single(item);
            if !got.iter().zip(&want).all(|(&got, &want)| same(got, want)) {
                wrong += 1;
                first = first.or(Some(format!("{item:?}: {got:?} for {want:?}")));
            }
        }
        match first {
            Some(first) => Err(format!("{wrong} of {}, first {first}", count())),
            None => Ok(String::from("equal")),
        }
    });
}

/// SwiftShader flushes subnormal numbers, on the way to a result, too. What that changes is rare,
/// and within the scale.
#[test]
fn exact_mode_on_swiftshader_but_for_subnormal_numbers() {
    /// One input in this many may meet a subnormal number.
    const FLUSHED: usize = 50;
    for gpu in Gpu::every().iter().filter(|gpu| gpu.kind() == Driver::SwiftShader) {
        each(|twin| {
            let floats = twin.draw(count());
            let got = on(gpu, Mode::Exact, twin, &floats)?;
            let (mut changed, mut flips) = (0, 0);
            for (item, got) in floats.chunks(twin.reads()).zip(got.chunks(twin.writes())) {
                let want = twin.rounded(item);
                if got.iter().zip(&want).all(|(&got, want)| same(got, want.value())) {
                    continue;
                }
                changed += 1;
                let near = |(got, want): (&f32, &Rounded)| {
                    (f64::from(*got) - f64::from(want.value())).abs() <= tolerance(want)
                };
                let is_near = got.iter().zip(&want).all(near);
                flips += usize::from(!is_near);
                if changed > count() / FLUSHED || flips as f64 > most_flips(twin) {
                    return Err(format!(
                        "{changed} differ, the last {item:?}: {got:?} for {want:?}"
                    ));
                }
            }
            Ok(format!("{changed} differ{}", flipped(twin, flips)))
        });
    }
}

/// A tolerance that allows anything proves nothing: half of a twin's results are held to this many
/// ulp, and only this share of them to nothing. The loosest are densities of many lobes, of whose
/// roughness the entries are drawn: the factor's own roundings are in all that follows.
const LOOSEST: f64 = 2000.0;
const UNBOUNDED: f64 = 0.05;

/// How far a result may be off; subnormal ones may be 0.
fn tolerance(want: &Rounded) -> f64 {
    K * want.bound() + f64::from(f32::MIN_POSITIVE)
}

/// Results against their tolerances.
#[derive(Default)]
struct Tally {
    /// Inputs whose result is outside its tolerance.
    wrong: usize,
    first: Option<String>,
    /// The largest share of a tolerance that was taken, jumps left out.
    worst: f64,
    farthest: f64,
    /// Tolerances in ulp of results other than 0.
    ulps: Vec<f64>,
    results: usize,
    unbounded: usize,
}

impl Tally {
    fn add(&mut self, item: &[f32], got: &[f32], want: &[Rounded]) {
        let mut most = 0.0_f64;
        for (got, want) in got.iter().zip(want) {
            let value = f64::from(want.value());
            let tolerance = tolerance(want);
            self.results += 1;
            self.unbounded += usize::from(!tolerance.is_finite());
            if value != 0.0 {
                self.ulps.push(tolerance / value.abs() / f64::from(f32::EPSILON));
            }
            if got.to_bits() != want.value().to_bits() {
                let share = (f64::from(*got) - value).abs() / tolerance;
                // What is no number is as far away as can be.
                most = most.max(if share.is_nan() { f64::INFINITY } else { share });
            }
        }
        if most <= 1.0 {
            self.worst = self.worst.max(most);
        } else {
            self.wrong += 1;
            self.farthest = self.farthest.max(most);
            self.first.get_or_insert_with(|| format!("{item:?}: {got:?} for {want:?}"));
        }
    }

    fn verdict(mut self, twin: &Twin) -> Result<String, String> {
        // A decision may fall either way; what is no number falls no way.
        let too_many = self.wrong as f64 > most_flips(twin);
        if let Some(first) = &self.first
            && (too_many || self.farthest.is_infinite())
        {
            return Err(format!(
                "{} of {}, worst {:.1e}, first {first}",
                self.wrong,
                count(),
                self.farthest
            ));
        }
        self.ulps.sort_by(f64::total_cmp);
        let median = self.ulps.get(self.ulps.len() / 2).copied().unwrap_or(0.0);
        let (results, unbounded) = (self.results, self.unbounded);
        let text = format!(
            "{:.2} of the tolerance, whose median is {median:.1} ulp; {unbounded} of {results} \
                unbounded{}",
            self.worst,
            flipped(twin, self.wrong)
        );
        // Results that are all 0 say as little.
        let tight = median <= LOOSEST
            && unbounded as f64 <= UNBOUNDED * results as f64
            && 8 * self.ulps.len() >= results;
        if tight { Ok(text) } else { Err(format!("says too little: {text}")) }
    }
}

/// How many inputs of a twin that decides may jump. The inputs of an ordinary run are few: it may
/// meet more than its share of the jumps of a long one, by three deviations.
fn most_flips(twin: &Twin) -> f64 {
    let share = twin.flips * count() as f64;
    share + size(3.0 * share.sqrt(), 0.0)
}

/// What a twin that decides says of its jumps.
fn flipped(twin: &Twin, count: usize) -> String {
    let most = most_flips(twin);
    if twin.flips > 0.0 { format!("; {count} flips, at most {most:.0}") } else { String::new() }
}

/// The results of a twin within their tolerances.
fn within(
    twin: &Twin,
    floats: &[f32],
    got: impl Iterator<Item = impl AsRef<[f32]>>,
) -> Result<String, String> {
    let mut tally = Tally::default();
    for (item, got) in floats.chunks(twin.reads()).zip(got) {
        tally.add(item, got.as_ref(), &twin.rounded(item));
    }
    tally.verdict(twin)
}

fn shipped_on(gpu: &'static Gpu) {
    each(|twin| {
        let floats = twin.draw(count());
        let got = on(gpu, Mode::Shipped, twin, &floats)?;
        within(twin, &floats, got.chunks(twin.writes()))
    });
}

#[test]
fn as_shipped_within_the_tolerance() {
    shipped_on(Gpu::lavapipe());
}

/// Chromium's driver and real GPUs, where they are there. Both flush subnormal numbers, and what
/// comes of them.
#[test]
fn other_drivers_within_the_tolerance() {
    for gpu in Gpu::every().iter().filter(|gpu| gpu.kind() != Driver::Lavapipe) {
        println!("{}", gpu.name());
        shipped_on(gpu);
    }
}

#[test]
fn rust_with_every_product_fused_within_the_tolerance() {
    each(|twin| {
        let floats = twin.draw(count());
        within(twin, &floats, floats.chunks(twin.reads()).map(|item| twin.fused(item)))
    });
}

#[test]
fn no_input_gives_nan() {
    for gpu in Gpu::every() {
        println!("{}", gpu.name());
        each(|twin| {
            // They are made to drop the NaN of their first argument, and to pass on the other.
            if ["min", "max"].contains(&twin.name.as_str()) {
                return Ok(String::from("exempt"));
            }
            let floats = twin.draw_hostile(count() / 4);
            let got = on(gpu, Mode::Shipped, twin, &floats)?;
            let items = floats.chunks(twin.reads()).zip(got.chunks(twin.writes()));
            let mut bad = items.filter(|(_, got)| got.iter().any(|x| x.is_nan()));
            match bad.next() {
                Some((item, got)) => Err(format!("{} items, {item:?}: {got:?}", bad.count() + 1)),
                None => Ok(String::from("numbers")),
            }
        });
    }
}

/// A slope or direction that is NaN is seen nowhere: not in the middle of the lobe, where a 0 in
/// its place would be. (Of an area without extent Beckmann leaves 3e-20.)
#[test]
fn nan_is_no_highlight() {
    let seen =
        ["slope_pdf", "_d", "brdf", "masking", "shadowing", "visibility", "area", "_mean", "over"];
    let mut count = 0;
    for twin in all().iter().filter(|twin| seen.iter().any(|end| twin.name.ends_with(end))) {
        let mut floats = twin.draw(1000);
        let places = twin.inputs.iter().scan(0, |base, input| {
            let place = *base;
            *base += input.floats();
            Some((*input, place))
        });
        let where_from =
            [Input::Slope, Input::Direction, Input::Pair, Input::Half, Input::Mirrored];
        let Some((_, place)) = places.into_iter().find(|(input, _)| where_from.contains(input))
        else {
            continue;
        };
        count += 1;
        for (k, item) in floats.chunks_mut(twin.reads()).enumerate() {
            item[place + k % 2] = f32::NAN;
        }
        let got = on(Gpu::lavapipe(), Mode::Shipped, twin, &floats).expect("valid WGSL");
        let bad = floats
            .chunks(twin.reads())
            .zip(got.chunks(twin.writes()))
            .find(|(_, got)| got[0].abs() > 1e-18);
        assert!(bad.is_none(), "{} {}: {bad:?}", twin.name, twin.by);
    }
    assert!(count > 50, "only {count} functions of slopes and directions");
}

#[test]
fn every_function_of_the_port_is_run() {
    for twin in all() {
        let (name, body) = (&twin.name, twin.body());
        assert!(body.contains(&format!("lobe_{name}(")), "the entry {name} does not run it");
    }
    let run: Vec<String> = all().iter().map(|twin| format!("{} ", twin.name)).collect();
    let bodies: String = all().iter().map(Twin::body).collect();
    for item in Item::ALL {
        let name = item.name();
        let is_function = source(&[*item]).contains(&format!("fn lobe_{name}("));
        // Fragment functions have quads, which no compute shader has: tests/render.rs runs them.
        if is_function && item.twin().is_some() {
            assert!(run.contains(&format!("{name} ")), "{name} has no entry in src/twins");
        } else if is_function && !name.starts_with("fragment_") {
            assert!(bodies.contains(&format!("lobe_{name}(")), "{name} is run by no entry");
        }
    }
}
