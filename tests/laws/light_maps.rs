//! Light from everywhere: cube maps against the directions they were painted for, harmonics against
//! quadrature.
#![cfg(feature = "leadr")]

use crate::common::{check, near, near_all};
use core::f64::consts::PI;
use lobe::material::leadr::{CubeMap, Irradiance, Light, cube_lod, dupuy_cube_lod};
use lobe::{Error, slope::direction::normalize};

/// The direction of a point on a face in [-1, 1]^2, as the Vulkan specification tabulates sc, tc
/// and ma.
fn on_face(face: usize, s: f64, t: f64) -> [f64; 3] {
    match face {
        0 => [1.0, -t, -s],
        1 => [-1.0, -t, s],
        2 => [s, 1.0, t],
        3 => [s, -1.0, -t],
        4 => [s, -t, 1.0],
        _ => [-s, -t, -1.0],
    }
}

/// A map that shows a function of the direction.
fn painted(face: usize, paint: impl Fn([f64; 3]) -> [f64; 3]) -> CubeMap<f64, Vec<[f64; 3]>> {
    let center = |k: usize| (2 * k + 1) as f64 / face as f64 - 1.0;
    let texels = (0..6 * face * face).map(|place| {
        let (of, row, column) = (place / (face * face), place / face % face, place % face);
        paint(normalize(on_face(of, center(column), center(row))))
    });
    let mut texels: Vec<_> = texels.collect();
    texels.resize(CubeMap::<f64, Vec<[f64; 3]>>::texels(face), [0.0; 3]);
    CubeMap::new(face, texels).expect("a map")
}

#[test]
fn a_cube_map_shows_what_was_painted_across_edges_and_corners() {
    let smooth = |w: [f64; 3]| [1.0 + w[0], 1.0 + w[1] * w[2], 2.0 + w[2]];
    let map = painted(64, smooth);
    check(20_000, |source| {
        let mut w = source.direction();
        // Any octant, and edges and corners of the cube.
        let sign = |source: &mut crate::common::arbitrary::Source| source.sign();
        w = w.map(|x| x * sign(source));
        if source.pick(3) == 0 {
            w[1] = w[0] * source.sign() * (1.0 + source.uniform(-1e-3, 1e-3));
        }
        if source.pick(3) == 0 {
            w[2] = w[0] * source.sign() * (1.0 + source.uniform(-1e-3, 1e-3));
        }
        let w = normalize(w.map(|x| x * 3.7));
        if w == [0.0; 3] {
            return Ok(());
        }
        // Bilinear over 1/32 of a face.
        near_all(&map.lookup(w, 0.0), &smooth(w), 0.02, &w)
    });
}

#[test]
fn levels_are_means_and_solid_angles_choose_them() {
    let map = painted(16, |w| if w[2] > 0.0 { [1.0; 3] } else { [0.0; 3] });
    // The whole face +z is bright; the last level has one texel a face.
    let up = [0.0, 0.0, 1.0];
    for lod in [0.0, 1.5, 4.0, 99.0, -3.0] {
        near(map.lookup(up, lod)[0], 1.0, 1e-15, &lod).unwrap_or_else(|e| panic!("{e}"));
    }
    // A face of the sides is half bright, at its last level gray.
    near(map.lookup([1.0, 0.0, 0.0], 4.0)[1], 0.5, 1e-15, &"side")
        .unwrap_or_else(|e| panic!("{e}"));
    let texel = 4.0 * PI / (6.0 * 256.0);
    let side = [1.0, 0.0, 0.3];
    assert_eq!(map.radiance(side, 16.0 * texel), map.lookup(side, 2.0));
    assert_eq!(map.radiance(side, 0.0), map.lookup(side, 0.0));
    for nothing in [[0.0; 3], [f64::NAN; 3]] {
        assert!(map.lookup(nothing, f64::NAN).iter().all(|x| x.is_finite()));
    }
    let refused = |face, count| CubeMap::new(face, vec![[0.0_f32; 3]; count]).map(|_| ());
    assert!(matches!(refused(3, 70), Err(Error::CubeMap { .. })));
    assert!(matches!(refused(2, 24), Err(Error::CubeMap { .. })));
    assert!(matches!(refused(0, 0), Err(Error::CubeMap { .. })));
}

#[test]
fn the_papers_rules_differ_by_their_constants() {
    check(1_000, |source| {
        let (omega, face) = (source.log_uniform(1e-8, 1.0), source.log_uniform(1.0, 1e4));
        let ours = cube_lod(omega, face);
        // Section 3.5: theta = sqrt(omega / pi), LOD = log2(2 theta face / pi).
        let listing = (2.0 * (omega / PI).sqrt() * face / PI).log2();
        near(dupuy_cube_lod(omega, face, 128), listing, 1e-12, &(omega, face))?;
        // Algorithm 1: log2(sqrt(omega / 4 pi) face).
        let algorithm = ((omega / (4.0 * PI)).sqrt() * face).log2();
        near(ours - algorithm, 0.5 * 6.0_f64.log2(), 1e-12, &(omega, face))?;
        // Printed constants: 0.5 for 5 nodes, -0.5 for 32, both in place of -1.48.
        let bias = |nodes| dupuy_cube_lod(omega, face, nodes) - listing;
        near(bias(5), 1.98, 1e-12, &"5")?;
        near(bias(32), 0.98, 1e-12, &"32")?;
        near(bias(2), 1.98, 1e-12, &"2")?;
        let between = bias(12);
        crate::common::ensure(between < 1.98 && between > 0.98, "in between", &between)
    });
    assert!((cube_lod(0.0_f32, 4.0) + 61.0).abs() < 1e-4);
    assert!(cube_lod(f32::NAN, 8.0).is_finite());
}

/// Irradiance by brute force: light times cosine over the sphere.
fn brute(light: &dyn Fn([f64; 3]) -> f64, m: [f64; 3]) -> f64 {
    let (rows, columns) = (400, 800);
    let mut sum = 0.0;
    for row in 0..rows {
        let z: f64 = (2.0 * f64::from(row) + 1.0) / f64::from(rows) - 1.0;
        for column in 0..columns {
            let (sin, cos) = (2.0 * PI * f64::from(column) / f64::from(columns)).sin_cos();
            let r = (1.0 - z * z).sqrt();
            let w = [r * cos, r * sin, z];
            let along = m[0] * w[0] + m[1] * w[1] + m[2] * w[2];
            sum += light(w) * along.max(0.0);
        }
    }
    sum * 4.0 * PI / f64::from(rows * columns)
}

#[test]
fn second_order_light_has_its_irradiance_exactly() {
    // Polynomials of degree 2 in the direction are what the harmonics span.
    let light = |[x, y, z]: [f64; 3]| 2.0 + x - 0.5 * y + 0.7 * x * y - 0.3 * y * z + 0.4 * z * z;
    let mut harmonics = Irradiance::<f64>::dark();
    harmonics.add_light(&|w: [f64; 3], _: f64| [light(w), 0.0, 2.0 * light(w)], 256);
    for m in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.48, 0.6, -0.64], [0.0, -1.0, 0.0]] {
        let [red, green, blue] = harmonics.at(m);
        let want = brute(&light, m);
        assert!((red / want - 1.0).abs() < 1e-4, "{red} for {want}");
        assert!(green == 0.0 && (blue - 2.0 * red).abs() < 1e-12);
    }
}

#[test]
fn one_light_is_what_the_harmonics_show_worst() {
    // Against the clamped cosine: at most 0.0625 too bright where it faces, and ringing on the dark
    // side.
    let mut sun = Irradiance::<f64>::dark();
    sun.add_directional([0.0, 0.0, 5.0], [1.0; 3]);
    let mut worst = 0.0_f64;
    for degrees in 0..=180 {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        worst = worst.max((sun.at([sin, 0.0, cos])[0] - cos.max(0.0)).abs());
    }
    assert!((0.08..0.0938).contains(&worst), "{worst}");
    // Single precision says the same.
    let mut single = Irradiance::<f32>::dark();
    single.add_directional([0.0, 0.0, 5.0], [1.0; 3]);
    assert!((f64::from(single.at([0.6, 0.0, 0.8])[0]) - sun.at([0.6, 0.0, 0.8])[0]).abs() < 1e-6);
}
