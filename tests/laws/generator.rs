//! The generator of inputs reaches every special class, and the references agree with each other.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use crate::common::arbitrary::{LARGEST_RHO, SPECIAL_ALPHAS, Source};
use crate::common::quadrature::{adaptive, over_plane, over_square, trapezoid};
use crate::common::reference::Known;
use lobe::Footprint;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};

const DRAWS: u64 = 20_000;

/// A class of inputs: its name, and whether a value belongs.
type Class<'a, T> = (&'a str, &'a dyn Fn(&T) -> bool);

/// Asserts that every class occurs among values drawn from seeds.
fn occurs<T>(draw: impl Fn(&mut Source) -> T, classes: &[Class<T>]) {
    let values: Vec<T> = (0..DRAWS).map(|seed| draw(&mut Source::from_seed(seed))).collect();
    for (name, class) in classes {
        let count = values.iter().filter(|value| class(value)).count();
        assert!(count >= 20, "{name}: {count} times in {DRAWS} draws");
    }
}

#[test]
fn alphas_are_special_near_special_and_ordinary() {
    let at = |x: f64| move |alpha: &f64| *alpha == x;
    for special in SPECIAL_ALPHAS {
        occurs(
            Source::alpha,
            &[
                ("special", &at(special)),
                ("an f32 above", &at(f64::from((special as f32).next_up()))),
                ("an f32 below", &at(f64::from((special as f32).next_down()))),
                ("an f64 above", &at(special.next_up())),
                ("an f64 below", &at(special.next_down())),
            ],
        );
    }
    let between = |low: f64, high: f64| move |alpha: &f64| (low..high).contains(alpha);
    let decades = [1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 30.0];
    for pair in decades.windows(2) {
        occurs(Source::alpha, &[("decade", &between(pair[0] * 1.01, pair[1] * 0.99))]);
    }
}

#[test]
fn ellipses_are_round_aligned_correlated_and_nearly_singular() {
    occurs(
        Source::ellipse,
        &[
            ("round", &|e| e.x == e.y && e.rho == 0.0),
            ("along the axes", &|e| e.x != e.y && e.rho == 0.0),
            ("correlated", &|e| e.rho.abs() > 0.1),
            ("the largest correlation", &|e| e.rho == LARGEST_RHO),
            ("the smallest correlation", &|e| e.rho == -LARGEST_RHO),
            ("nearly singular", &|e| (0.999..LARGEST_RHO).contains(&e.rho.abs())),
            ("thin", &|e| e.widths()[0] < 1e-4 * e.widths()[1]),
        ],
    );
}

#[test]
fn directions_are_normal_nearly_normal_grazing_and_ordinary() {
    let off = |w: &[f64; 3]| w[0].hypot(w[1]);
    occurs(
        Source::direction,
        &[
            ("the normal", &|w| off(w) == 0.0),
            ("nearly the normal", &|w| off(w) > 0.0 && off(w) < 1e-6),
            ("grazing", &|w| w[2] < 1e-3),
            ("all but horizontal", &|w| w[2] < 2e-6),
            ("ordinary", &|w| w[2] > 0.1 && w[2] < 0.9),
            ("along an axis", &|w| w[1] == 0.0 && w[0] > 0.1),
        ],
    );
    let unit = |w: &[f64; 3]| (off(w).hypot(w[2]) - 1.0).abs() < 4.0 * f64::EPSILON;
    for seed in 0..DRAWS {
        let w = Source::from_seed(seed).direction();
        assert!(unit(&w) && w[2] >= 1e-6 * (1.0 - 1e-12), "{w:?} from seed {seed}");
    }
}

#[test]
fn pairs_are_equal_mirrored_nearly_mirrored_and_opposed() {
    type Pair = [[f64; 3]; 2];
    let sum = |[o, i]: &Pair| (o[0] + i[0]).hypot(o[1] + i[1]);
    occurs(
        Source::pair,
        &[
            ("equal", &|p| p[0] == p[1]),
            ("a mirror pair", &|p| sum(p) == 0.0 && p[0][2] == p[1][2]),
            ("nearly a mirror pair", &|p| sum(p) > 0.0 && sum(p) < 1e-5 && p[0][2] > 0.1),
            ("opposed at the horizon", &|p| sum(p) < 1e-5 && p[0][2] + p[1][2] < 1e-4),
            ("any", &|p| sum(p) > 0.1),
        ],
    );
}

#[test]
fn slopes_and_means_are_zero_small_ordinary_and_large() {
    let length = |v: &[f64; 2]| v[0].hypot(v[1]);
    for draw in [Source::slope, Source::mean] {
        occurs(
            draw,
            &[
                ("zero", &|s| length(s) == 0.0),
                ("small", &|s| length(s) > 0.0 && length(s) < 1e-3),
                ("ordinary", &|s| (0.1..1.0).contains(&length(s))),
                ("large", &|s| length(s) > 300.0),
                ("along an axis", &|s| s[1] == 0.0 && s[0] > 0.0),
            ],
        );
    }
}

#[test]
fn footprints_are_points_segments_slivers_squares_and_huge() {
    type F = Footprint<f64>;
    let length = |v: [f64; 2]| v[0].hypot(v[1]);
    let sides = |f: &F| {
        let (u, v) = (length(f.u), length(f.v));
        [u.min(v), u.max(v)]
    };
    let parallel = |f: &F| f.area() <= 1e-15 * sides(f)[0] * sides(f)[1];
    occurs(
        Source::footprint,
        &[
            ("a point", &|f| sides(f)[1] == 0.0),
            ("a segment along u", &|f| length(f.u) > 0.0 && length(f.v) == 0.0),
            ("a segment along v", &|f| length(f.v) > 0.0 && length(f.u) == 0.0),
            ("parallel sides", &|f| sides(f)[0] > 0.0 && parallel(f)),
            ("a sliver", &|f| f.area() > 0.0 && f.area() < 1e-4 * sides(f)[1].powi(2)),
            ("a sheared sliver", &|f| {
                f.area() < 1e-4 * sides(f)[0] * sides(f)[1] && sides(f)[0] > 0.3 * sides(f)[1]
            }),
            ("a square", &|f| (sides(f)[1] / sides(f)[0] - 1.0).abs() < 1e-14),
            ("a rectangle along the axes", &|f| {
                f.u[1] == 0.0 && f.v[0] == 0.0 && f.u[0] != 0.0 && f.v[1] != 0.0
            }),
            ("huge", &|f| f.area() > 100.0),
            ("tiny", &|f| sides(f)[1] > 0.0 && sides(f)[1] < 1e-4),
        ],
    );
}

#[test]
fn a_source_is_the_same_by_words_bytes_and_after_its_end() {
    let words: Vec<u64> = (0..9).map(|k| 0x1234_5678_9abc_def1_u64.rotate_left(7 * k)).collect();
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let (mut by_words, mut by_bytes) = (Source::from_words(&words), Source::from_bytes(&bytes));
    for _ in 0..4 {
        assert_eq!(by_words.lobe(), by_bytes.lobe());
    }
    // Words run out: the plainest choices.
    assert_eq!(by_words.lobe().mean, [0.0, 0.0]);
    assert_eq!(Source::from_words(&[]).direction(), [0.0, 0.0, 1.0]);
}

#[test]
fn quadratures_reproduce_integrals_known_by_hand() {
    let pi = core::f64::consts::PI;
    let bump = adaptive(&mut |x| 1.0 / (1e-8 + x * x), -1.0, 1.0, 1e-12);
    assert!((bump / (2e4 * 1e4_f64.atan()) - 1.0).abs() < 1e-11, "{bump}");
    let gauss = trapezoid(&mut |x| (-x * x).exp(), 7.0, 0.25);
    assert!((gauss - pi.sqrt()).abs() < 1e-14, "{gauss}");
    for density in [BeckmannDistribution::unit_density, GgxDistribution::unit_density] {
        let mass = over_plane(&mut |w| density(w));
        assert!((mass - 1.0).abs() < 1e-14, "{mass}");
    }
    let moment = over_square(&mut |x, y| x * x * y * y, 1e-12);
    assert!((moment - 1.0 / 144.0).abs() < 1e-15, "{moment}");
}

#[test]
fn the_references_of_one_density_agree() {
    for seed in 0..DRAWS / 10 {
        let mut source = Source::from_seed(seed);
        let lobe = source.mild_lobe();
        let w = source.vector(1e-3, 5.0);
        let pairs = [
            (BeckmannDistribution::unit_density(w), {
                BeckmannDistribution::chained_density(&lobe, lobe.slope_at(w))
            }),
            (GgxDistribution::unit_density(w), {
                GgxDistribution::chained_density(&lobe, lobe.slope_at(w))
            }),
        ];
        for (unit, chained) in pairs {
            let ratio = chained * lobe.ellipse.root_det() / unit;
            assert!(
                (ratio - 1.0).abs() < 1e-10 + 100.0 * lobe.blur(1.0),
                "{ratio} at {lobe:?} {w:?}"
            );
        }
    }
}
