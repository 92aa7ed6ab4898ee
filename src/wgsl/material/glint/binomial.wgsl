// How many of n details reflect, from one uniform number. Rust: src/material/glint/binomial.rs.

// Rust: `STEPS`.
const LOBE_BINOMIAL_STEPS: u32 = 24u;
// Rust: `BLEND`.
const LOBE_BINOMIAL_BLEND = array<f32, 2>(4.0, 8.0);
// Rust: `LATTICE`.
const LOBE_BINOMIAL_LATTICE: f32 = 0.9;
// Rust: `LN_LATTICE`.
const LOBE_BINOMIAL_LN_LATTICE: f32 = -0.10536051565782628;
// Rust: `RAREST`.
const LOBE_BINOMIAL_RAREST: f32 = 9.313226e-10;

// Rust: `Binomial`.
struct LobeBinomial {
    trials: f32,
    rarer: f32,
    mean: f32,
    failures: bool,
    low: LobeInversion,
    high: LobeInversion,
    of_high: f32,
    of_normal: f32,
}

// Rust: `Binomial::new`. Of NaN there is one trial, or none succeeds.
fn lobe_binomial_new(n: f32, p: f32) -> LobeBinomial {
    let number = lobe_min(lobe_max(n, 1.0), 1e18);
    let trials = lobe_binomial_ceiling(number);
    let each = lobe_min(lobe_max(p, 0.0), 1.0) * (number / trials);
    let failures = each > 0.5;
    let rarer = select(each, 1.0 - each, failures);
    let mean = trials * rarer;
    let blend = LOBE_BINOMIAL_BLEND;
    let of_normal = lobe_min(lobe_max((mean - blend[0]) / (blend[1] - blend[0]), 0.0), 1.0);
    let none = LobeInversion(0.0, 0.0, 0.0);
    var binomial = LobeBinomial(trials, rarer, mean, failures, none, none, 0.0, of_normal);
    if of_normal < 1.0 {
        let place = lobe_ln(2.0 * lobe_max(rarer, LOBE_MIN_POSITIVE)) / LOBE_BINOMIAL_LN_LATTICE;
        let steps = f32(lobe_floor(place));
        let above = lobe_min(0.5 * lobe_exp(steps * LOBE_BINOMIAL_LN_LATTICE), 0.5);
        let below = LOBE_BINOMIAL_LATTICE * above;
        let step = lobe_max(above - below, LOBE_MIN_POSITIVE);
        binomial.of_high = lobe_min(lobe_max((rarer - below) / step, 0.0), 1.0);
        binomial.low = lobe_inversion_new(trials, below);
        binomial.high = lobe_inversion_new(trials, above);
    }
    return binomial;
}

// Rust: `Binomial::draw`.
fn lobe_binomial_draw(binomial: LobeBinomial, tail: f32) -> f32 {
    let rarer = binomial.rarer;
    let mean = binomial.mean;
    let v = select(tail, 1.0 - tail, binomial.failures);
    var count = mean;
    if !(mean < LOBE_BINOMIAL_RAREST) {
        count = 0.0;
        if binomial.of_normal < 1.0 {
            count = (1.0 - binomial.of_normal) * lobe_binomial_inverted(binomial, v);
        }
        if binomial.of_normal > 0.0 {
            let z = lobe_normal_quantile(v);
            let deviation = sqrt(mean * (1.0 - rarer));
            let skew = (1.0 - 2.0 * rarer) * (z * z - 1.0) / 6.0;
            let normal = lobe_min(lobe_max(mean + deviation * z + skew, 0.0), binomial.trials);
            count = count + binomial.of_normal * normal;
        }
    }
    return select(count, binomial.trials - count, binomial.failures);
}

// Rust: `Binomial::inverted`.
fn lobe_binomial_inverted(binomial: LobeBinomial, tail: f32) -> f32 {
    let trials = binomial.trials;
    var low = binomial.low;
    var high = binomial.high;
    var few = 0.0;
    var many = 0.0;
    for (var k = 0u; k < LOBE_BINOMIAL_STEPS; k++) {
        if !(tail < high.more) {
            break;
        }
        let next = many + 1.0;
        few = select(few, next, tail < low.more);
        let ratio = (trials - many) / next;
        low = lobe_inversion_after(low, ratio);
        high = lobe_inversion_after(high, ratio);
        many = next;
    }
    let fewest = lobe_min(few, trials);
    return fewest + binomial.of_high * (lobe_min(many, trials) - fewest);
}

// Rust: `Inversion`.
struct LobeInversion {
    exactly: f32,
    more: f32,
    odds: f32,
}

// Rust: `Inversion::new`.
fn lobe_inversion_new(trials: f32, p: f32) -> LobeInversion {
    let series = -(p * (1.0 + p * (0.5 + p * (0.33333334 + p * 0.25))));
    let ln_rest = select(lobe_ln(1.0 - p), series, p < 0.02);
    let x = trials * ln_rest;
    let none = lobe_exp(x);
    let less = -(x * (1.0 + x * 0.5 * (1.0 + x * 0.33333334 * (1.0 + x * 0.25))));
    return LobeInversion(none, select(1.0 - none, less, x > -0.02), p / (1.0 - p));
}

// Rust: `Inversion::after`.
fn lobe_inversion_after(inversion: LobeInversion, ratio: f32) -> LobeInversion {
    let factor = ratio * inversion.odds;
    let exactly = inversion.exactly * factor;
    let more = inversion.more - exactly;
    return LobeInversion(
        exactly, select(more, lobe_min(more, exactly), factor < 0.5), inversion.odds
    );
}

// Rust: `ceiling`.
fn lobe_binomial_ceiling(n: f32) -> f32 {
    return select(-f32(lobe_floor(-n)), n, n > 8388608.0);
}
