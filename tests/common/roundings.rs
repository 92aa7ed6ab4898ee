//! Backward accuracy: by how many roundings inputs and result must be moved for the result to be
//! exact.

/// The largest number of roundings that is tried.
const MOST: f64 = 4096.0;

/// Where in [-1, 1] the search finds `f` largest: at an end, in the middle, by golden sections.
fn summit(f: &dyn Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut low, mut high) = (-1.0, 1.0);
    let mut best = (f(0.0), 0.0);
    let mut consider = |place: f64| {
        // A place without a value is below every other, so that the search turns away from it.
        let value = f(place).max(f64::NEG_INFINITY);
        if value > best.0 {
            best = (value, place);
        }
        value
    };
    consider(low);
    consider(high);
    for _ in 0..16 {
        let reach = GOLDEN * (high - low);
        let (right, left) = (low + reach, high - reach);
        if consider(left) > consider(right) { high = right } else { low = left }
    }
    best.1
}

/// The largest value of `sign * f` that the search finds over inputs within `relative` of `inputs`:
/// one input after the other moves to its best place, twice over.
fn extreme(f: &dyn Fn(&[f64]) -> f64, inputs: &[f64], relative: f64, sign: f64) -> f64 {
    let mut moved = inputs.to_vec();
    for k in (0..2 * inputs.len()).map(|k| k % inputs.len()) {
        let at = |place: f64| {
            let mut moved = moved.clone();
            moved[k] = inputs[k] * (1.0 + place * relative);
            moved
        };
        moved = at(summit(&|place| sign * f(&at(place))));
    }
    f(&moved)
}

/// The least of 1, 2, 4, ... that suffices; infinite if [`MOST`] does not.
fn least_count(suffices: impl Fn(f64) -> bool) -> f64 {
    let counts = core::iter::successors(Some(1.0), |count| Some(2.0 * count));
    counts
        .take_while(|&count| count <= MOST)
        .find(|&count| suffices(count))
        .unwrap_or(f64::INFINITY)
}

/// The least of 1, 2, 4, ... roundings by which inputs and result must be moved for `got` to be
/// exact; infinite if [`MOST`] do not suffice.
///
/// `f` is the exact function and `unit` one rounding, relative. Every input and the result may be
/// moved by as many at once; an input of 0 stays. A search that misses the best moves returns too
/// large a number, never one too small. Results below `least` have no digits. Inputs at which `f`
/// is NaN are not moved to.
pub(crate) fn roundings(
    got: f64,
    f: &dyn Fn(&[f64]) -> f64,
    inputs: &[f64],
    unit: f64,
    least: f64,
) -> f64 {
    let exact = f(inputs);
    least_count(|count| {
        let relative = count * unit;
        let slack = |x: f64| relative * x.abs() + least;
        let above = got <= exact + slack(exact) || {
            let most = extreme(f, inputs, relative, 1.0);
            got <= most + slack(most)
        };
        let below = got >= exact - slack(exact) || {
            let fewest = extreme(f, inputs, relative, -1.0);
            got >= fewest - slack(fewest)
        };
        above && below
    })
}

/// As [`roundings`], but to the first order of the moves: the error over the sum of what one
/// rounding of each input and of the result changes.
///
/// The derivative along an input is the steeper of two difference quotients, over steps of 2^-36 of
/// the input. Steps are long beside the roundings of f64 and short beside the lobes of the golden
/// tables: 2^-36 of a mean of 1e3 is a 7,000th of an alpha of 1e-4, and a determinant of 2e-4 `a_xx
/// a_yy` changes by 1e-7 of itself. Where a determinant is below 2^-30 `a_xx a_yy`, `f` bends
/// within a step and the number is an estimate.
pub(crate) fn roundings_to_first_order(
    got: f64,
    f: &dyn Fn(&[f64]) -> f64,
    inputs: &[f64],
    unit: f64,
    least: f64,
) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 36) as f64;
    let exact = f(inputs);
    let slope = |k: usize, step: f64| {
        let mut moved = inputs.to_vec();
        moved[k] *= 1.0 + step;
        (f(&moved) - exact).abs() / STEP
    };
    // A maximum of a number and NaN is the number.
    let slopes = (0..inputs.len()).map(|k| slope(k, STEP).max(slope(k, -STEP)).max(0.0));
    let slack = unit * (exact.abs() + slopes.sum::<f64>());
    let error = (got - exact).abs() - least;
    least_count(|count| error <= count * slack)
}
