//! Errors of Chermain et al. 2020 and 2021 and of their published code: what is printed fails, ours
//! holds.
#![cfg(feature = "glint")]

use lobe::Roughness;
use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, LobeMeans, Marginal, MultiLobe, Recipe};
use lobe::slope::direction::{normal_of, slope_of};
use lobe::slope::{MeanFrame, jacobian::apply};

fn dictionary(means: LobeMeans) -> Dictionary<f64> {
    Dictionary::new(&Recipe { means, ..Recipe::default() }).expect("valid")
}

/// Section 6.1 says that mips add a third, 384 KiB to 512 KiB: so they do in two dimensions. In one
/// every mip has half the texels of the one before, and all of them nearly double it. A cumulative
/// doubles it, too, and filters exactly.
#[test]
fn chermain_2021_section_6_1_counts_mips_of_two_dimensions() {
    let ours = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    let Recipe { marginals, levels, intervals, .. } = *ours.recipe();
    // Halves, and mips down to one texel.
    let texels = |mip: u32| 2 * marginals * levels * (intervals >> mip);
    let mips: u32 = (0..=intervals.ilog2()).map(texels).sum();
    let kibibytes = |bytes: u32| bytes / 1024;
    assert_eq!([kibibytes(texels(0)), kibibytes(mips)], [384, 762]);
    assert!((f64::from(mips) / f64::from(texels(0)) - 4.0 / 3.0).abs() > 0.6);
    // Density and cumulative of twice the bytes each, at one node more.
    assert_eq!(ours.bytes(), 4 * (texels(0) + 2 * marginals * levels) as usize);
}

/// A marginal, and what a filter makes of it at a place.
type Filter<'a> = &'a dyn Fn(&Marginal<'_, f64>, f64) -> f64;

/// Section 4.2 calls the separable kernel of Eq. 14 conservative. The lookup of Eq. 19 takes the
/// longer of two derivatives times s_K: of a pixel both of whose derivatives lie along the axis the
/// default s_K of 1/2 averages over 0.6 of the deviation, and s_K of 1 over 1.2 of it; there is no
/// s_K that is right for this pixel and for one along its axes.
#[test]
fn chermain_2021_eq_19_is_conservative_with_s_k_1_alone() {
    let dictionary = dictionary(LobeMeans::Stratified);
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
    let printed =
        |scale: f64| (variance(&|marginal, x| marginal.mip_mean(x, scale * d)) - plain).sqrt();
    // The pixel's own: along the axis one derivative, a box; along the diagonal the sum of two.
    let [axis, diagonal] = [1.0, 2.0].map(|boxes: f64| d * (boxes / 12.0).sqrt());
    let [half, one] = [0.5, 1.0].map(printed);
    println!("deviations: s_K 0.5 {half}, s_K 1 {one}; the pixel's {axis} and {diagonal}");
    assert!(half < 0.75 * diagonal && (half / axis - 1.0).abs() < 0.2, "{half}");
    assert!(one > diagonal && one > 1.5 * axis, "{one}");
    for (boxes, truth) in [(1.0_f64, axis), (2.0, diagonal)] {
        let ours = (variance(&|marginal, x| marginal.mean(x, boxes.sqrt() * d)) - plain).sqrt();
        assert!((ours / truth - 1.0).abs() < 0.05, "{ours} of {truth}");
    }
}

/// The code stores densities at nodes and reads them as texels, half an interval further out: every
/// marginal gains half an interval of what it has at 0: 2.5 % are expected on one axis, so 5 % of
/// the light; of one marginal up to 40 % and more.
#[test]
fn chermain_2020_tables_are_read_half_a_texel_off() {
    let dictionary = dictionary(LobeMeans::Chermain);
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
    // The smooth density at 0 times an interval. Of a lobe and its mirror the density at 0 has a
    // second moment of p(0)/(2 sqrt(pi) width): 1.35 is its deviation, three of that of 192.
    assert!((mean - 1.025).abs() < 3.0 * step * 1.35 / 192.0_f64.sqrt(), "{mean}");
    assert!(worst > 1.3, "{worst}");
    // Ours reads nodes as nodes, and the box as wide as all has all.
    for index in 0..192 {
        assert!((8.0 * dictionary.marginal(index, 0).mean(0.0, 8.0) - 1.0).abs() < 1e-12);
    }
}

/// The early way out, where the mean number of facets rounds to the last level's, forgets that
/// cells vary: many are still below, and every pixel jumps to the smooth lobe by 1 to 2 % of it.
#[test]
fn chermain_2020_leaves_too_early() {
    let dictionary = dictionary(LobeMeans::Stratified);
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    // Cells of size 1, and 4 to this power of facets in each.
    let step = |level: f64| {
        let facets = MultiLobe::new(roughness, 4.0_f64.powf(level)).expect("in range");
        let squares = (0..3000).map(|k| {
            let patch = Patch::new([0.37 * f64::from(k), 0.2], [1.0, 0.0], [0.0, 1.0]);
            let pixel = facets.ndf(&dictionary, &patch);
            (pixel.slope_pdf([0.2, 0.1]) / pixel.smooth().slope_pdf([0.2, 0.1]) - 1.0).powi(2)
        });
        (squares.sum::<f64>() / 3000.0).sqrt()
    };
    let (printed, ours) = (step(15.5), step(29.0));
    println!("the step: as published {printed}, ours {ours}; on the way {}", step(22.0));
    assert!((0.01..0.02).contains(&printed), "{printed}");
    // Cells draw numbers of up to 6.5 deviations of 2 levels each.
    assert!(ours < 1e-6, "{ours}");
}

/// Section 5 takes the map's covariance over into the frame of its mean normal. Seen from there,
/// slopes are flatter along the tilt by the square of its cosine: of a relief that leans by 45
/// degrees slopes a half, and their variance a quarter.
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
