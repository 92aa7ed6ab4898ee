//! Texels in and out: decoding with a cap, heights, and stored moments with the alpha floors they
//! state.
#![cfg(feature = "lean")]
#![allow(clippy::cast_sign_loss, reason = "codes are made of numbers that are not negative")]

use crate::common::arbitrary::Source;
use crate::common::{check, ensure, near, near_all};
use lobe::material::lean::{
    Border, ClippedTexels, Float16, Float32, HeightField, SlopeCap, Storage, Unorm16,
};
use lobe::slope::direction::normal_of;
use lobe::{Error, Psd, SlopeMoments};

#[test]
fn normals_of_any_length_and_width_have_their_slopes() {
    let cap = SlopeCap::new(100.0_f64).expect("a cap");
    check(5_000, |source| {
        let slope = source.vector(1e-3, 20.0);
        let n = normal_of(slope);
        let length = source.log_uniform(1e-3, 1e3);
        let (got, clipped) = cap.slope(n.map(|x| length * x));
        ensure(!clipped, "within the cap", &slope)?;
        let size = slope[0].abs() + slope[1].abs();
        near_all(&got, &slope, 1e-13 * (1.0 + size * size), &slope)?;
        // Codes of 8 and 16 bits, decoded by hand.
        let code = |x: f64, most: f64| ((x + 1.0) * 0.5 * most + 0.5).floor();
        let of = |most: f64| {
            let [x, y, z] = n.map(|x| 2.0 * code(x, most) / most - 1.0);
            [-x / z, -y / z]
        };
        if n[2] > 0.1 {
            let byte = cap.slope(n.map(|x| code(x, 255.0) as u8)).0;
            near_all(&byte, &of(255.0), 1e-12 * (1.0 + size), &slope)?;
            let [r, g, b] = n.map(|x| code(x, 255.0) as u8);
            crate::common::near_all(&cap.slope([r, g, b, 7]).0, &byte, 0.0, &slope)?;
            let word = cap.slope(n.map(|x| code(x, 65535.0) as u16)).0;
            near_all(&word, &of(65535.0), 1e-12 * (1.0 + size), &slope)?;
            // Two channels: z from what is left.
            let pair = [n[0], n[1]].map(|x| code(x, 65535.0) as u16);
            let [x, y] = pair.map(|v| 2.0 * f64::from(v) / 65535.0 - 1.0);
            let z = (1.0 - x * x - y * y).sqrt();
            near_all(&cap.slope(pair).0, &[-x / z, -y / z], 1e-10 * (1.0 + size), &slope)?;
        }
        Ok(())
    });
}

#[test]
fn a_cap_shortens_and_keeps_the_direction() {
    check(5_000, |source| {
        let steepest = source.log_uniform(0.1, 100.0);
        let cap = SlopeCap::new(steepest).expect("a cap");
        let [x, y] = source.vector(1e-3, 1.0);
        let z = source.uniform(-1.0, 1.0);
        let ([sx, sy], clipped) = cap.slope([x, y, z]);
        let length = (sx * sx + sy * sy).sqrt();
        let wanted = (x * x + y * y).sqrt() / z;
        ensure(length <= steepest * (1.0 + 1e-14), "capped", &(x, y, z, steepest))?;
        near(sx * y, sy * x, 1e-13 * length, &"same line")?;
        ensure(sx * x + sy * y <= 0.0, "against the normal's side", &(x, y, z))?;
        if clipped {
            near(length, steepest, 1e-13 * steepest, &(x, y, z))?;
            ensure(
                z <= 0.0 || wanted > steepest * (1.0 - 1e-13),
                "only what is steeper",
                &(x, y, z),
            )
        } else {
            near(length, wanted, 1e-13 * wanted, &(x, y, z))
        }
    });
    let cap = SlopeCap::new(10.0_f32).expect("a cap");
    for nothing in [[0.0; 3], [0.0, 0.0, -1.0], [f32::NAN, 0.0, 1.0], [0.0, f32::INFINITY, 1.0]] {
        assert_eq!(cap.slope(nothing), ([0.0; 2], true), "{nothing:?}");
    }
    assert_eq!(cap.slope([-f32::MAX, f32::MAX, 0.0]).0, [50.0_f32.sqrt(), -(50.0_f32.sqrt())]);
    for bad in [0.0, -1.0, 2e9, f32::NAN] {
        assert!(matches!(SlopeCap::new(bad), Err(Error::Cap(_))));
    }
    let mut short = [[0.0_f32; 2]; 1];
    let differ = cap.slopes(&[[0_u8; 3]; 2], &mut short);
    assert!(matches!(differ, Err(Error::Length { .. })));
}

#[test]
fn heights_have_the_slopes_of_what_they_displace() {
    // h = sin(2 pi i / w) cos(2 pi j / h), whose central difference is known exactly.
    let (width, height) = (24_usize, 10_usize);
    let turn = |k: usize, n: usize| 2.0 * core::f64::consts::PI * k as f64 / n as f64;
    let heights: Vec<f64> = (0..width * height)
        .map(|p| turn(p % width, width).sin() * turn(p / width, height).cos())
        .collect();
    let field = HeightField::new([width, height], &heights, [0.5, -0.25], 3.0, Border::Wrap);
    let field = field.expect("a field");
    let mut slopes = vec![[0.0; 2]; width * height];
    let cap = SlopeCap::new(1e9).expect("a cap");
    // In two bands, as threads take it.
    let (upper, lower) = slopes.split_at_mut(4 * width);
    let clipped =
        field.slopes(cap, 0, upper).expect("rows") + field.slopes(cap, 4, lower).expect("rows");
    assert_eq!(clipped, ClippedTexels { texels: 0, of: width * height });
    for (p, [x, y]) in slopes.into_iter().enumerate() {
        let (a, b) = (turn(p % width, width), turn(p / width, height));
        let along = 3.0 / 0.5 * a.cos() * turn(1, width).sin() * b.cos();
        let across = 3.0 / -0.25 * a.sin() * -b.sin() * turn(1, height).sin();
        assert!((x - along).abs() < 1e-13 && (y - across).abs() < 1e-13, "{p}");
    }
    // A ramp is a ramp up to a clamped edge; one texel is flat.
    let ramp = [0.0_f32, 1.0, 2.0];
    for (size, want) in [([3, 1], [1.0, 0.0]), ([1, 3], [0.0, 1.0])] {
        let field = HeightField::new(size, &ramp, [1.0, 1.0], 1.0, Border::Clamp).expect("a field");
        let mut slopes = [[9.0_f32; 2]; 3];
        field.slopes(SlopeCap::new(5.0).expect("a cap"), 0, &mut slopes).expect("rows");
        assert_eq!(slopes, [want; 3]);
    }
    let bad =
        |size, texel, scale| HeightField::new(size, &ramp, texel, scale, Border::Wrap).map(|_| ());
    assert_eq!(bad([2, 1], [1.0; 2], 1.0), Err(Error::MapSize { size: [2, 1], texels: 3 }));
    assert!(matches!(bad([3, 1], [0.0, 1.0], 1.0), Err(Error::Texel(_))));
    assert_eq!(bad([3, 1], [1.0; 2], f32::NAN), Err(Error::Displacement(f32::NAN.into())));
}

/// Moments within a range, some at its ends, some of one slope.
fn moments(source: &mut Source, range: f64) -> SlopeMoments<f32> {
    let within = |source: &mut Source| {
        let x = source.unit() * if source.pick(2) == 0 { 1.0 } else { 1e-2 };
        x * source.sign() * range
    };
    let mean = [within(source), within(source)];
    // A variance that slopes within the range can have.
    let most = mean.map(|x| (range * range - x * x).max(0.0).sqrt());
    let share = if source.pick(3) == 0 { 0.0 } else { source.unit() };
    let [x, y] = most.map(|d| d * share);
    let rho = source.rho();
    let covariance = Psd::new(x * x, rho * x * y, y * y).expect("a covariance");
    let [xx, xy, yy] = covariance.entries().map(|c| c as f32);
    SlopeMoments::new(mean.map(|x| x as f32), Psd::nearest(xx, xy, yy)).expect("moments")
}

/// Largest error of an entry of the covariance over many texels, as an alpha; the mean within
/// `step`.
fn worst(layout: &impl Storage, range: f64, step: f64) -> f64 {
    let mut worst = 0.0_f64;
    for seed in 0..200_000 {
        let mut source = Source::from_seed(seed);
        let want = moments(&mut source, range);
        let texel = layout.encode(&want);
        let (mean, second) = layout.raw(texel);
        for (got, want) in mean.into_iter().zip(want.mean()) {
            assert!((f64::from(got) - f64::from(want)).abs() <= step, "{seed}");
        }
        // Before negative eigenvalues are mended, which may move entries further.
        let [x, y] = mean.map(f64::from);
        let [xx, xy, yy] = second.map(f64::from);
        let central = [xx - x * x, xy - x * y, yy - y * y];
        for (got, want) in central.into_iter().zip(want.covariance().entries()) {
            worst = worst.max((got - f64::from(want)).abs());
        }
        assert!(layout.decode(texel).is_ok());
    }
    (2.0 * worst).sqrt()
}

#[test]
fn layouts_keep_their_alpha_floors() {
    // The stated floor is a bound, and one that is reached.
    for range in [1.0_f32, 4.0, 0.3] {
        let wide = f64::from(range);
        let unorm = Unorm16::new(range).expect("a range");
        let half = Float16::new(range).expect("a range");
        let full = Float32::new(range).expect("a range");
        let cases = [
            ("unorm16", worst(&unorm, wide, wide / 32767.0 * 1.01), unorm.alpha_floor()),
            ("f16", worst(&half, wide, wide / 2048.0 * 1.01), half.alpha_floor()),
            ("f32", worst(&full, wide, 0.0), full.alpha_floor()),
        ];
        for (name, got, floor) in cases {
            let floor = f64::from(floor);
            assert!(got <= floor * 1.01, "{name} of range {range}: {got:e} above {floor:e}");
            assert!(
                got >= floor * 0.7,
                "{name} of range {range}: {got:e}, a floor of {floor:e} says little"
            );
        }
    }
    // For range 1, as documented.
    let floors = [
        Unorm16::new(1.0).expect("a range").alpha_floor(),
        Float16::new(1.0).expect("a range").alpha_floor(),
        Float32::new(1.0).expect("a range").alpha_floor(),
    ];
    for (floor, want) in floors.into_iter().zip([0.0055, 0.031, 3.5e-4]) {
        assert!((floor / want - 1.0).abs() < 0.02, "{floor} for {want}");
    }
}

#[test]
fn two_slopes_at_the_ends_of_the_range_are_no_mirror() {
    // Nearly all at one end, a few at the other: the mean rounds to the end, where no variance
    // would fit.
    for (layout_range, share) in [(1.0_f32, 7.66e-6_f64), (8.0, 1e-5), (0.3, 5e-6)] {
        let range = f64::from(layout_range);
        let (mean, variance) =
            (range * (1.0 - 2.0 * share), 4.0 * share * (1.0 - share) * range * range);
        let covariance = Psd::new(variance as f32, 0.0, 0.0).expect("a variance");
        for sign in [1.0, -1.0] {
            let moments =
                SlopeMoments::new([(sign * mean) as f32, 0.0], covariance).expect("moments");
            let layout = Unorm16::new(layout_range).expect("a range");
            let floor = f64::from(layout.alpha_floor());
            let ([x, _], [xx, _, _]) = layout.raw(layout.encode(&moments));
            let error = f64::from(xx) - f64::from(x).powi(2) - variance;
            assert!(2.0 * error.abs() <= 1.01 * floor * floor, "{layout_range} {sign}: {error:e}");
            assert!(
                layout.decode(layout.encode(&moments)).expect("moments").covariance().trace() > 0.0
            );
        }
    }
}

#[test]
fn flat_maps_are_stored_flat_and_ends_saturate() {
    let flat = SlopeMoments::of_slope([0.0_f32, 0.0]).expect("a slope");
    let unorm = Unorm16::new(8.0).expect("a range");
    assert_eq!(unorm.decode(unorm.encode(&flat)), Ok(flat));
    let half = Float16::new(8.0).expect("a range");
    assert_eq!(half.decode(half.encode(&flat)), Ok(flat));
    let steep = SlopeMoments::of_slope([100.0_f32, -100.0]).expect("a slope");
    let kept = unorm.decode(unorm.encode(&steep)).expect("moments");
    assert!((kept.mean()[0] - 8.0).abs() < 1e-4 && (kept.mean()[1] + 8.0).abs() < 1e-4);
    assert!(matches!(Float32::new(0.0).map(|_| ()), Err(Error::Range(_))));
    assert!(matches!(Float16::new(256.0).map(|_| ()), Err(Error::HalfRange(_))));
    assert!(matches!(Unorm16::new(f32::NAN).map(|_| ()), Err(Error::Range(_))));
    let full = Float32::new(1.0).expect("a range");
    assert!(matches!(full.decode([f32::NAN, 0.0, 0.0, 0.0, 0.0]), Err(Error::Mean(_))));
    assert!(matches!(full.decode([0.0, 0.0, f32::INFINITY, 0.0, 0.0]), Err(Error::MatrixEntry(_))));
}

#[test]
fn samplers_numbers_are_the_texels() {
    check(5_000, |source| {
        let layout = Unorm16::new(2.0).expect("a range");
        let texel = layout.encode(&moments(source, 2.0));
        let [x, y, xx, xy, yy] = texel.map(|code| f64::from(code) / 65535.0);
        let got = SlopeMoments::from_unorm([x, y], [xx, xy, yy], 2.0).expect("moments");
        let want = layout.decode(texel).expect("moments");
        near_all(&got.mean(), &want.mean().map(f64::from), 1e-6, &texel)?;
        near_all(
            &got.covariance().entries(),
            &want.covariance().entries().map(f64::from),
            3e-6,
            &texel,
        )
    });
}
