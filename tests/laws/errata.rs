//! Errors of the papers that this crate covers: the printed formula fails against quadrature or
//! differences, ours holds.
//!
//! One test for each, named by paper and equation. Those of LEADR stand in errata_leadr.rs.
#![cfg(feature = "published")]

use crate::common::quadrature::{adaptive, over_plane, over_square, trapezoid};
use crate::common::reference::eigenvalues;
use core::f64::consts::{FRAC_1_PI, PI, TAU};
use lobe::filter::{
    box_peak_alpha, kaplanyan_deferred_alpha, kaplanyan_proxy_alpha, kaplanyan_rectangle_mean,
    kaplanyan_rectangle_mean_as_printed, largest_deferred_alpha,
};
use lobe::slope::direction::normal_of;
use lobe::slope::jacobian::slope_per_normal;
use lobe::{AxisAligned, Beckmann, Footprint, Ggx, Kernel, PixelFilter, Psd};
use nalgebra::Vector3;

/// Within a relative tolerance.
#[track_caller]
fn agree(got: f64, want: f64, tolerance: f64) {
    assert!((got / want - 1.0).abs() <= tolerance, "got {got}, want {want}");
}

/// Off by a factor, whole percent of it.
#[track_caller]
fn off_by(got: f64, want: f64, factor: f64) {
    assert!(
        (got / want / factor - 1.0).abs() < 0.005,
        "got {got}, want {want}: {} times",
        got / want
    );
}

/// GGX, 1/(pi alpha beta (1 + q)^2).
fn ggx([alpha, beta]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    let secant2 = 1.0 + (x / alpha).powi(2) + (y / beta).powi(2);
    1.0 / (PI * alpha * beta * secant2 * secant2)
}

/// Mean of GGX over `slope +- widths/2` by quadrature.
fn mean_of_ggx(alphas: [f64; 2], slope: [f64; 2], widths: [f64; 2]) -> f64 {
    over_square(
        &mut |x, y| ggx(alphas, [slope[0] + x * widths[0], slope[1] + y * widths[1]]),
        1e-11,
    )
}

/// The text integrates over h -+ dh under the prefactor of h -+ dh/2: 4 times too large.
#[test]
fn kaplanyan_2016_appendix_a_is_four_times_too_large() {
    let alphas = [0.4, 0.3];
    for (slope, widths) in
        [([0.1, -0.2], [0.01, 0.02]), ([0.0, 0.0], [0.02, 0.01]), ([0.5, 0.3], [0.3, 0.4])]
    {
        let want = mean_of_ggx(alphas, slope, widths);
        agree(kaplanyan_rectangle_mean(alphas, slope, widths), want, 1e-9);
        agree(
            Ggx::new(AxisAligned::new(alphas[0], alphas[1]).expect("in range"))
                .rectangle_mean(slope, widths),
            want,
            1e-9,
        );
        // Literally: 4 times the mean over twice the widths.
        let printed = kaplanyan_rectangle_mean_as_printed(alphas, slope, widths);
        agree(printed, 4.0 * mean_of_ggx(alphas, slope, widths.map(|w| 2.0 * w)), 1e-9);
        assert!(printed > 3.0 * want, "{printed} {want}");
    }
    let small = kaplanyan_rectangle_mean_as_printed(alphas, [0.1, 0.1], [0.01, 0.01]);
    off_by(small, mean_of_ggx(alphas, [0.1, 0.1], [0.01, 0.01]), 4.0);
}

/// The result is a density of slopes: as a density of normals it wants 1/h_z^4.
#[test]
fn kaplanyan_2016_appendix_a_is_no_density_of_normals() {
    let (alphas, widths) = ([1.0, 1.0], [0.6, 0.6]);
    // Integral of D(m) m_z over the hemisphere, with dm = m_z^3 ds.
    let mass = |power: i32| {
        over_plane(&mut |slope| {
            // Beyond lies a ten millionth, and Appendix A has lost its digits.
            if slope[0].hypot(slope[1]) > 3e3 {
                return 0.0;
            }
            let z = normal_of(slope)[2];
            kaplanyan_rectangle_mean(alphas, slope, widths) * z.powi(power) * z.powi(4)
        })
    };
    agree(mass(-4), 1.0, 1e-6);
    assert!(mass(0) < 0.5, "{}", mass(0));
}

/// Eq. 20 solves Eq. 19 for a square: its first line is garbled, and its last wants w^2/3 or w^2/pi
/// for w^2.
#[test]
fn kaplanyan_2016_eq_20_ends_in_a_proxy_up_to_three_times_too_dark() {
    let printed_first = |alpha: f64, w: f64| {
        let root = (4.0 * alpha * alpha + w * w).sqrt();
        (w.powi(4) * 4.0 * alpha * alpha + w * w).sqrt() / (2.0 * (w / root).atan().sqrt())
    };
    let peak = |alpha: f64| FRAC_1_PI / (alpha * alpha);
    let alpha = 0.1;
    for ratio in [0.01, 0.3, 1.0, 3.0, 30.0] {
        let w = ratio * alpha;
        // The lobe's middle is narrow against wide squares: a quarter of it, from the corner.
        let mut across = |y: f64| adaptive(&mut |x| ggx([alpha; 2], [x, y]), 0.0, 0.5 * w, 1e-11);
        let want = adaptive(&mut across, 0.0, 0.5 * w, 1e-10) / (0.25 * w * w);
        agree(peak(box_peak_alpha(alpha, w).expect("in range")), want, 1e-8);
        let first = peak(printed_first(alpha, w)) / want;
        assert!((first - 1.0).abs() > 0.1, "{first} at w/alpha = {ratio}");
    }
    let ours = |w: f64| box_peak_alpha(alpha, w).expect("in range").powi(2) - alpha * alpha;
    let last = |w: f64| kaplanyan_proxy_alpha(alpha, w).expect("in range").powi(2) - alpha * alpha;
    let (small, large) = (0.01 * alpha, 1e5 * alpha);
    agree(ours(small), small * small / 3.0, 1e-4);
    agree(ours(large), large * large / PI, 1e-4);
    off_by(last(small), ours(small), 3.0);
    off_by(last(large), ours(large), PI);
}

/// Second moments of a Gaussian of this deviation, in pixels, carried to slopes by the footprint:
/// by quadrature.
fn carried(footprint: &Footprint<f64>, deviation: f64) -> [f64; 3] {
    let Footprint { u, v } = *footprint;
    [(0, 0), (0, 1), (1, 1)].map(|(i, j)| {
        let mut across = |y: f64| {
            let mut along = |x: f64| {
                let s = [x * u[0] + y * v[0], x * u[1] + y * v[1]].map(|s| s * deviation);
                (-0.5 * (x * x + y * y)).exp() / TAU * s[i] * s[j]
            };
            trapezoid(&mut along, 9.0, 0.25)
        };
        trapezoid(&mut across, 9.0, 0.25)
    })
}

/// Read with row vectors, P P^T is the Gram matrix: trace and determinant agree, the kernel is
/// turned.
#[test]
fn kaplanyan_2016_eq_13_with_row_vectors_is_the_gram_matrix() {
    let footprint = Footprint::from_slopes([0.3, 0.1], [-0.05, 0.2]);
    let want = carried(&footprint, 0.5);
    let got = Kernel::of(&footprint, PixelFilter::KAPLANYAN).covariance();
    for (got, want) in got.entries().into_iter().zip(want) {
        agree(got, want, 1e-12);
    }
    let Footprint { u, v } = footprint;
    let dot = |a: [f64; 2], b: [f64; 2]| 0.25 * (a[0] * b[0] + a[1] * b[1]);
    let gram = Psd::new(dot(u, u), dot(u, v), dot(v, v)).expect("a Gram matrix");
    agree(gram.trace(), got.trace(), 1e-14);
    agree(gram.det(), got.det(), 1e-13);
    let [a, b] = [gram, got].map(|matrix| matrix.eigen());
    agree(a.major, b.major, 1e-13);
    let turned = (a.axis[0] * b.axis[1] - a.axis[1] * b.axis[0]).abs();
    assert!(turned > 0.25, "by {turned} of a right angle's sine");
    assert!((gram.entries()[0] / want[0] - 1.0).abs() > 0.05, "{:?} {want:?}", gram.entries());
}

/// Eq. 13 takes deviations of half a pixel, Tokuyoshi full pixels and sigma^2 = 1/4: both at once
/// are a quarter.
#[test]
fn kaplanyan_2016_eq_13_and_tokuyoshis_quarter_are_the_same_quarter() {
    let footprint = Footprint::from_slopes([0.3, 0.1], [-0.05, 0.2]);
    let half = footprint * 0.5;
    let want = carried(&footprint, 0.5);
    let eq_13 = Psd::outer_sum(half.u, half.v);
    let tokuyoshi = Kernel::of(&footprint, PixelFilter::KAPLANYAN).covariance();
    let both = Kernel::of(&half, PixelFilter::KAPLANYAN).covariance();
    for (k, &want) in want.iter().enumerate() {
        agree(eq_13.entries()[k], want, 1e-12);
        agree(tokuyoshi.entries()[k], want, 1e-12);
        agree(both.entries()[k], 0.25 * want, 1e-12);
    }
}

/// The first term wants h_x^2: with h_z^2 the density does not fall along x, and has no end of
/// mass.
#[test]
fn tokuyoshi_2017_eq_15_wants_h_x_in_its_first_term() {
    let alphas = [0.3, 0.6];
    let printed = |h: [f64; 3]| {
        let sum = (h[2] / alphas[0]).powi(2) + (h[1] / alphas[1]).powi(2) + h[2] * h[2];
        1.0 / (PI * alphas[0] * alphas[1] * sum * sum)
    };
    let ndf = Ggx::new(AxisAligned::new(alphas[0], alphas[1]).expect("in range"));
    // Integral of D(h) h_z over the slopes up to `reach` along x, dh = h_z^3 ds; slopes are sinh.
    let mass = |d: &dyn Fn([f64; 3]) -> f64, reach: f64| {
        let mut along = |x: f64| {
            let mut across = |y: f64| {
                let h = normal_of([x.sinh(), y.sinh()]);
                d(h) * h[2].powi(4) * y.cosh()
            };
            x.cosh() * trapezoid(&mut across, 14.0, 0.125)
        };
        2.0 * adaptive(&mut along, 0.0, reach.asinh(), 1e-9)
    };
    agree(mass(&|h| ndf.d(h), 1e4), 1.0, 1e-7);
    let [near, far] = [100.0, 1000.0].map(|reach| mass(&printed, reach));
    assert!(near > 5.0 && far > 50.0, "{near} {far}");
    let up = [0.0, 0.0, 1.0];
    agree(ndf.d(up), 1.0 / (PI * alphas[0] * alphas[1]), 1e-14);
    assert!(printed(up) < 0.01 * ndf.d(up), "{} {}", printed(up), ndf.d(up));
}

/// Section 4 takes the rectangle's larger width for a bound on the kernel: along the diagonal it is
/// half of it.
#[test]
fn tokuyoshi_2017_section_4_takes_a_width_for_a_bound() {
    let (u, v, filter) = ([0.1, 0.1], [0.0, 0.0], PixelFilter::KAPLANYAN);
    let [largest, _] = eigenvalues([u[0] * u[0], u[0] * u[1], u[1] * u[1]].map(|x| 0.5 * x));
    let footprint = Footprint::from_slopes(u, v);
    let width = kaplanyan_deferred_alpha(0.0, &footprint, filter, 0.18).unwrap().powi(2);
    off_by(width, largest, 0.5);
    let (dn_u, dn_v) = ([u[0], u[1], 0.0], [v[0], v[1], 0.0]);
    let ours = largest_deferred_alpha(0.0, dn_u, dn_v, filter, 0.18).unwrap().powi(2);
    agree(ours, largest, 1e-12);
}

/// A density of slopes becomes one of normals by dividing by (m.n)^4, not by multiplying.
#[test]
fn zirr_2016_eq_6_inverts_the_jacobian() {
    // A groove: the Dirac delta along u as a narrow Gaussian.
    let alphas = [0.01, 0.8];
    let ndf = Beckmann::new(AxisAligned::new(alphas[0], alphas[1]).expect("in range"));
    let mass = |d: &dyn Fn([f64; 2], [f64; 3]) -> f64| {
        over_plane(&mut |w| {
            let slope = [alphas[0] * w[0], alphas[1] * w[1]];
            let m = normal_of(slope);
            d(slope, m) * m[2].powi(4) * alphas[0] * alphas[1]
        })
    };
    agree(mass(&|slope, m| ndf.slope_pdf(slope) / m[2].powi(4)), 1.0, 1e-10);
    agree(mass(&|_, m| ndf.d(m)), 1.0, 1e-10);
    let printed = mass(&|slope, m| ndf.slope_pdf(slope) * m[2].powi(4));
    assert!(printed < 0.6, "{printed}");
    // dm/dx by differences: m_z^3, the fourth power is the projection's.
    let (slope, step) = ([0.3, -0.7], 1e-5);
    let at = |x: f64, y: f64| Vector3::from(normal_of([slope[0] + x, slope[1] + y]));
    let sides = [at(step, 0.0) - at(-step, 0.0), at(0.0, step) - at(0.0, -step)]
        .map(|side| side / (2.0 * step));
    let m = normal_of(slope);
    agree(sides[0].cross(&sides[1]).norm(), m[2].powi(3), 1e-8);
    agree(slope_per_normal(m), m[2].powi(-3), 1e-14);
}
