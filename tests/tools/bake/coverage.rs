//! Coverage from the alpha channel: texels outside of a texture's islands.

use super::picture::{assembled, filtered, picture, zlib};
use super::{bake, complains, described, folder, warned};
use lobe::SlopeMoments;
use lobe::material::lean::{Float32, Storage};
use png::{BitDepth, ColorType};
use std::fs;
use std::path::Path;

const SIDE: u32 = 16;

/// An island of normals, 6 x 10 texels of 16 x 16, and its alpha; black and clear around it.
fn island(edge: u8) -> Vec<[u8; 4]> {
    let texel = |k: u32| {
        let (x, y) = (k % SIDE, k / SIDE);
        let inside = (3..9).contains(&x) && (2..12).contains(&y);
        let alpha = if x == 3 || x == 8 { edge } else { 255 };
        let code = |factor: u32| 123 + (k * factor % 11) as u8;
        if inside { [code(7), code(5), 255, alpha] } else { [0; 4] }
    };
    (0..SIDE * SIDE).map(texel).collect()
}

/// Mean and covariance of the slopes by alpha, in two passes.
fn direct(texels: &[[u8; 4]]) -> ([f64; 2], [f64; 3]) {
    let slope = |&[x, y, z, a]: &[u8; 4]| {
        let [x, y, z] = [x, y, z].map(|v| 2.0 * f64::from(v) - 255.0);
        ([-x / z, -y / z], f64::from(a))
    };
    let slopes: Vec<_> = texels.iter().map(slope).filter(|(_, weight)| *weight > 0.0).collect();
    let total: f64 = slopes.iter().map(|(_, weight)| weight).sum();
    let sum =
        |f: &dyn Fn([f64; 2]) -> f64| slopes.iter().map(|(s, w)| w * f(*s)).sum::<f64>() / total;
    let mean = [sum(&|s| s[0]), sum(&|s| s[1])];
    let about = |i: usize, k: usize| sum(&|s| (s[i] - mean[i]) * (s[k] - mean[k]));
    (mean, [about(0, 0), about(0, 1), about(1, 1)])
}

/// The moments of a level's first texel as they are written.
fn written(out: &Path, level: usize) -> SlopeMoments<f32> {
    let raw = fs::read(out.join(format!("moments.{level}.f32"))).expect("a file");
    let number = |k: usize| f32::from_le_bytes(raw[4 * k..][..4].try_into().expect("four"));
    let layout = Float32::new(16.0).expect("a range");
    layout.decode([0, 1, 2, 3, 4].map(number)).expect("moments")
}

#[track_caller]
fn close(got: &SlopeMoments<f32>, (mean, covariance): ([f64; 2], [f64; 3])) {
    for (a, b) in got.mean().into_iter().zip(mean) {
        assert!((f64::from(a) - b).abs() < 1e-6, "mean {a}, not {b}");
    }
    for (a, b) in got.covariance().entries().into_iter().zip(covariance) {
        assert!((f64::from(a) - b).abs() < 1e-6, "covariance {a}, not {b}");
    }
}

#[test]
fn texels_outside_of_islands_count_for_nothing() {
    let folder = folder("coverage");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    for edge in [255, 100, 1] {
        let texels = island(edge);
        let wide: Vec<u8> = texels.as_flattened().iter().flat_map(|&v| [v, v]).collect();
        for (depth, data) in
            [(BitDepth::Eight, texels.as_flattened()), (BitDepth::Sixteen, &wide[..])]
        {
            fs::write(&input, picture([SIDE; 2], ColorType::Rgba, depth, data)).expect("a file");
            // Most of it points down, and alpha says why.
            complains(&bake(&input, &out, &[]), &["do not point up", "76.6 %", "--coverage"]);
            let (_, warnings) = warned(&input, &out, &["--coverage"]);
            assert_eq!(warnings, [""; 0]);
            close(&written(&out, 4), direct(&texels));
            let description = described(&out);
            assert_eq!(
                (&description["coverage"], &description["clipped"]["of"]),
                (&true.into(), &60.into())
            );
            // Nothing steep is left: black is a slope of 1.41.
            assert!(description["steepest"].as_f64().expect("a slope") < 0.1);
            // A texel of level 2 that covers nothing has the moments of level 3, which covers a
            // part of the island.
            let quarter: Vec<_> = (0..SIDE as usize / 2)
                .flat_map(|row| texels[row * SIDE as usize..][..SIDE as usize / 2].to_vec())
                .collect();
            close(&written(&out, 3), direct(&quarter));
        }
    }
}

#[test]
fn a_transparent_color_is_coverage_too() {
    let folder = folder("key");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let texels = island(255);
    let rgb: Vec<u8> = texels.iter().flat_map(|&[x, y, z, _]| [x, y, z]).collect();
    let chunks = [(b"tRNS", vec![0; 6]), (b"IDAT", zlib(&filtered(&rgb, SIDE)))];
    let file = assembled([SIDE; 2], ColorType::Rgb, BitDepth::Eight, false, &chunks);
    fs::write(&input, file).expect("a file");
    warned(&input, &out, &["--coverage"]);
    close(&written(&out, 4), direct(&texels));
}

#[test]
fn clipping_is_told_with_what_may_have_caused_it() {
    let folder = folder("clipped");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    // A third of the map is clear and black with a blue of 128: nearly at the horizon.
    let texels: Vec<u8> = (0..96_u32)
        .flat_map(
            |k| if k % 3 == 0 { [0, 0, 128, 0] } else { [120 + (k % 16) as u8, 128, 254, 255] },
        )
        .collect();
    fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &texels)).expect("a file");
    let (_, warnings) = warned(&input, &out, &[]);
    let first = "33.3 % of the texels are steeper than --cap 10 and were shortened to it; \
                 alpha is 0 in 33.3 % of all texels, which --coverage leaves out";
    assert_eq!(warnings[0], first);
    assert_eq!(warned(&input, &out, &["--coverage"]).1, [""; 0]);
    // Islands on white, whose slope no cap shortens, and on the neutral color: alpha that looks
    // like a mask is told of, alpha that has all values is not.
    for around in [255, 128] {
        let island = |k: u32, clear: u8| {
            if k % 3 == 0 {
                [around, around, 255, clear]
            } else {
                [120 + (k % 16) as u8, 128, 254, 255]
            }
        };
        let masked: Vec<u8> = (0..96).flat_map(|k| island(k, 0)).collect();
        fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &masked))
            .expect("a file");
        let (_, warnings) = warned(&input, &out, &[]);
        let told = "alpha is 0 in 33.3 % of all texels, which --coverage leaves out";
        assert!(warnings.iter().any(|line| line == told), "{warnings:?}");
        let heights: Vec<u8> = (0..96).flat_map(|k| island(k, (k / 3 * 8) as u8)).collect();
        fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &heights))
            .expect("a file");
        let (_, warnings) = warned(&input, &out, &[]);
        assert!(warnings.iter().all(|line| !line.contains("alpha is 0")), "{warnings:?}");
    }
    // A soft border of as many texels as an eighth of the map; an alpha that is 0 everywhere masks
    // nothing.
    let soft = |k: u32| {
        [120 + (k % 16) as u8, 128, 254, [0, 0, 90, 255, 255, 255, 255, 255][k as usize % 8]]
    };
    let clear = |k: u32| [120 + (k % 16) as u8, 128, 254, 0];
    for (texel, lines) in [(&soft as &dyn Fn(u32) -> [u8; 4], 1), (&clear, 0)] {
        let texels: Vec<u8> = (0..96).flat_map(texel).collect();
        fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &texels))
            .expect("a file");
        let (_, warnings) = warned(&input, &out, &[]);
        assert_eq!(warnings.len(), lines, "{warnings:?}");
    }
    // A map that is refused with alpha read as x: alpha is no coverage then.
    let steep: Vec<u8> = (0..96_u8).flat_map(|k| [k, 128, 9, k / 90 * 255]).collect();
    fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &steep)).expect("a file");
    let refused = bake(&input, &out, &["--channels", "agb"]);
    complains(&refused, &["do not point up"]);
    assert!(!String::from_utf8_lossy(&refused.stderr).contains("--coverage"));
    // Nothing is covered.
    let none: Vec<u8> = texels.chunks_exact(4).flat_map(|t| [t[0], t[1], t[2], 0]).collect();
    fs::write(&input, picture([12, 8], ColorType::Rgba, BitDepth::Eight, &none)).expect("a file");
    complains(&bake(&input, &out, &["--coverage"]), &["normal.png: alpha is 0 in every texel"]);
    // One of a hundred may be clipped without a word, two may not.
    for (count, lines) in [(1, 0), (2, 1)] {
        let texels: Vec<u8> = (0..100)
            .flat_map(|k| if k < count { [255, 128, 128] } else { [128 + k % 2, 128, 255] })
            .collect();
        fs::write(&input, picture([10, 10], ColorType::Rgb, BitDepth::Eight, &texels))
            .expect("a file");
        let clipped =
            warned(&input, &out, &[]).1.into_iter().filter(|line| line.contains("--cap 10"));
        assert_eq!(clipped.count(), lines);
    }
}
