//! Integrals in f64, for references: adaptive Gauss-Kronrod, and the trapezoid rule where it
//! converges geometrically.

/// Positive nodes of Kronrod's 15 point rule, with its weights and those of Gauss' 7 point rule.
///
/// Source: QUADPACK (Piessens et al. 1983), routine QK15.
const KRONROD: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55, 0.129_484_966_168_869_7),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_7),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4, 0.381_830_050_505_118_9),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.0, 0.209_482_141_084_727_83, 0.417_959_183_673_469_4),
];

/// Kronrod's estimate over [a, b], and its difference from Gauss'.
fn kronrod(f: &mut dyn FnMut(f64) -> f64, a: f64, b: f64) -> (f64, f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut fine, mut coarse) = (0.0, 0.0);
    for (x, weight, gauss) in KRONROD {
        let value = if x == 0.0 { f(middle) } else { f(middle - half * x) + f(middle + half * x) };
        fine += weight * value;
        coarse += gauss * value;
    }
    (fine * half, (fine - coarse).abs() * half.abs())
}

/// The integral over [a, b], its error estimated below `relative` of it (or 1e-300).
pub(crate) fn adaptive(f: &mut dyn FnMut(f64) -> f64, a: f64, b: f64, relative: f64) -> f64 {
    let (whole, error) = kronrod(f, a, b);
    let mut pieces = vec![(a, b, whole, error)];
    // The estimate of a 15 point rule by a 7 point rule is pessimistic: bisection stops late
    // enough.
    for _ in 0..2000 {
        let total: f64 = pieces.iter().map(|p| p.2).sum();
        let error: f64 = pieces.iter().map(|p| p.3).sum();
        if error <= relative * total.abs() + 1e-300 {
            break;
        }
        let worst = (0..pieces.len())
            .max_by(|&i, &j| pieces[i].3.total_cmp(&pieces[j].3))
            .expect("at least one piece");
        let (a, b, ..) = pieces.swap_remove(worst);
        let middle = 0.5 * (a + b);
        for (a, b) in [(a, middle), (middle, b)] {
            let (value, error) = kronrod(f, a, b);
            pieces.push((a, b, value, error));
        }
    }
    pieces.iter().map(|p| p.2).sum()
}

/// The integral over [-reach, reach] by steps of about `step`: exact to rounding for analytic
/// functions that vanish at both ends.
pub(crate) fn trapezoid(f: &mut dyn FnMut(f64) -> f64, reach: f64, step: f64) -> f64 {
    let half = (reach / step).ceil() as i32;
    let step = reach / f64::from(half);
    (-half..=half).map(|k| f(step * f64::from(k))).sum::<f64>() * step
}

/// The integral over the plane in polar coordinates, of a function that has one center at the
/// origin, width 1, and falls like $|w|^{-4}$ or faster: trapezoid in ln r and in the angle.
///
/// In x = ln r, the integrands $2 r^2/(1 + r^2)^2$ and $2 r^2 e^{-r^2}$ are analytic for |Im x| <
/// pi/4: a step of 1/8 errs by $e^{-2\pi (\pi/4) 8}$ = 7e-18; beyond |x| = 18 lies less than e^-36.
pub(crate) fn over_plane(f: &mut dyn FnMut([f64; 2]) -> f64) -> f64 {
    const ANGLES: i32 = 12;
    let turn = core::f64::consts::TAU / f64::from(ANGLES);
    let mut ring = |x: f64| {
        let r = x.exp();
        let sum: f64 = (0..ANGLES)
            .map(|k| {
                // Half a step off the axes.
                let (sin, cos) = (turn * (f64::from(k) + 0.5)).sin_cos();
                f([r * cos, r * sin])
            })
            .sum();
        sum * turn * r * r
    };
    trapezoid(&mut ring, 18.0, 0.125)
}

/// Mean of `f` over the unit square centered at the origin, adaptive in both directions.
pub(crate) fn over_square(f: &mut dyn FnMut(f64, f64) -> f64, relative: f64) -> f64 {
    let mut across = |y: f64| adaptive(&mut |x| f(x, y), -0.5, 0.5, 0.1 * relative);
    adaptive(&mut across, -0.5, 0.5, relative)
}

/// The integral over the square of this half side by midpoints, for functions that have steps or
/// kinks.
pub(crate) fn midpoints(half: f64, nodes: u32, f: impl Fn([f64; 2]) -> f64) -> f64 {
    let step = 2.0 * half / f64::from(nodes);
    let at = |k: u32| step * (f64::from(k) + 0.5) - half;
    let places = (0..nodes).flat_map(|i| (0..nodes).map(move |j| [at(i), at(j)]));
    places.map(f).sum::<f64>() * step * step
}
