//! Errors of Chermain et al. 2020 and 2021 and of their published code: what is printed fails, ours holds.
#![cfg(feature = "glint")]

use lobe::Roughness;
use lobe::material::glint::Patch;
use lobe::material::multilobe::{Dictionary, Marginal, Means, MultiLobe, Recipe};
use lobe::slope::direction::{normal_of, slope_of};
use lobe::slope::{MeanFrame, jacobian::apply};

fn dictionary(means: Means) -> Dictionary<f64> {
    Dictionary::new(&Recipe { means, ..Recipe::default() }).expect("valid")
}

/// Section 6.1 says that mips add a third, 384 KiB to 512 KiB: so they do in two dimensions. In one every mip has half the
/// texels of the one before, and all of them nearly double it. A cumulative doubles it, too, and filters exactly.
#[test]
fn chermain_2021_section_6_1_counts_mips_of_two_dimensions() {
    let table = 192 * 16 * 2 * 64;
    let mips: u32 = (0..7).map(|mip| 192 * 16 * 2 * (64 >> mip)).sum();
    let kibibytes = |bytes: u32| bytes / 1024;
    assert_eq!([kibibytes(table), kibibytes(mips)], [384, 762]);
    assert!((f64::from(mips) / f64::from(table) - 4.0 / 3.0).abs() > 0.6);
    let ours = dictionary(Means::Stratified);
    assert_eq!(ours.bytes() / 2, 192 * 16 * 65 * 8);
}

/// A marginal, and what a filter makes of it at a place.
type Filter<'a> = &'a dyn Fn(&Marginal<'_, f64>, f64) -> f64;

/// Eq. 14 and section 4.2 call the separable kernel conservative. The lookup of Eq. 19 takes the longer of two derivatives
/// times s_K: of a pixel whose corners are 2 d apart, as both of its derivatives lie along the axis, it averages what d/2
/// asks for, and leaves the corners out.
#[test]
fn chermain_2021_eq_19_is_not_conservative() {
    let dictionary = dictionary(Means::Stratified);
    // What a filter adds to the variance: its kernel's own, in the mean over places and lobes.
    let variance = |filter: Filter<'_>| {
        let step = 1.0 / 128.0;
        let places = (-640..640).map(|k| (f64::from(k) + 0.5) * step);
        let second = (0..192).map(|index| {
            let marginal = dictionary.marginal(index, 4);
            places.clone().map(|x| step * x * x * filter(&marginal, x)).sum::<f64>()
        });
        second.sum::<f64>() / 192.0
    };
    let d = 1.0;
    let plain = variance(&|marginal, x| marginal.density(x));
    let printed = (variance(&|marginal, x| marginal.mip_mean(x, 0.5 * d)) - plain).sqrt();
    let width = 2.0_f64.sqrt() * d;
    let ours = (variance(&|marginal, x| marginal.mean(x, width)) - plain).sqrt();
    // A box pixel's own: the sum of two boxes, each d wide.
    let truth = d * (2.0_f64 / 12.0).sqrt();
    println!("deviation of the kernel: printed {printed}, ours {ours}, the pixel's {truth}");
    assert!(printed < 0.75 * truth, "{printed} of {truth}");
    assert!((ours / truth - 1.0).abs() < 0.05, "{ours} of {truth}");
}

/// The code stores densities at nodes and reads them as texels, half an interval further out: every marginal gains what half an
/// interval has at 0, 2.5 % in the mean of one axis, so 5 % of the light, and up to 40 % and more.
#[test]
fn chermain_2020_tables_are_read_half_a_texel_off() {
    let dictionary = dictionary(Means::Published);
    let step = 1.0 / 16.0;
    let mass = |index: u32| {
        let marginal = dictionary.marginal(index, 0);
        let texels = (0..64).map(|k| marginal.density(step * f64::from(k)));
        2.0 * step * texels.sum::<f64>()
    };
    let masses: Vec<f64> = (0..192).map(mass).collect();
    let mean = masses.iter().sum::<f64>() / 192.0;
    let worst = masses.iter().copied().fold(0.0, f64::max);
    println!("mass as read: {mean} in the mean, {worst} at worst");
    for (index, mass) in (0..).zip(&masses) {
        let ends =
            dictionary.marginal(index, 0).density(0.0) - dictionary.marginal(index, 0).density(4.0);
        assert!((mass - 1.0 - step * ends).abs() < 1e-9, "{index}: {mass}");
    }
    // The smooth density at 0 times an interval; of 192 that vary by 1.35, three deviations.
    assert!((mean - 1.025).abs() < 3.0 * step * 1.35 / 192.0_f64.sqrt(), "{mean}");
    assert!(worst > 1.3, "{worst}");
    // Ours reads nodes as nodes, and the box as wide as all has all.
    for index in 0..192 {
        assert!((8.0 * dictionary.marginal(index, 0).mean(0.0, 8.0) - 1.0).abs() < 1e-12);
    }
}

/// The early way out, where a cell has as many facets in the mean as the last level, forgets that cells vary: many are still
/// below, and every pixel jumps to the smooth lobe by 1.2 to 1.7 % of it.
#[test]
fn chermain_2020_leaves_too_early() {
    let dictionary = dictionary(Means::Stratified);
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    // Cells of size 1; 4^levels facets in each, times another power of 4.
    let step = |beyond: i32| {
        let facets = MultiLobe::new(roughness, 4.0_f64.powi(16 + beyond)).expect("in range");
        let squares = (0..3000).map(|k| {
            let patch = Patch::new([0.37 * f64::from(k), 0.2], [1.0, 0.0], [0.0, 1.0]);
            let pixel = facets.lobe(&dictionary, &patch);
            (pixel.slope_pdf([0.2, 0.1]) / pixel.smooth().slope_pdf([0.2, 0.1]) - 1.0).powi(2)
        });
        (squares.sum::<f64>() / 3000.0).sqrt()
    };
    let (printed, ours) = (step(0), step(13));
    println!("the step: as published {printed}, ours {ours}; on the way {}", step(6));
    assert!((0.008..0.025).contains(&printed), "{printed}");
    // Cells draw numbers of up to 6.5 deviations of 2 levels each.
    assert!(ours < 1e-6, "{ours}");
}

/// Section 5 takes the map's covariance over into the frame of its mean normal. Seen from there, slopes are flatter along
/// the tilt by the square of its cosine: of a relief that leans by 45 degrees a half.
#[test]
fn chermain_2021_section_5_takes_slopes_of_another_frame() {
    let mean = [1.0_f64, 0.0];
    let frame = MeanFrame::of(mean);
    let step = 1e-4_f64;
    let seen = slope_of(frame.to_local(normal_of([mean[0] + step, mean[1]])));
    let printed = step;
    let ours = apply(frame.jacobian(), [step, 0.0])[0];
    assert!((ours / seen[0] - 1.0).abs() < 1e-3, "{ours} of {}", seen[0]);
    assert!((printed / seen[0] - 2.0).abs() < 1e-3, "{printed} of {}", seen[0]);
}
