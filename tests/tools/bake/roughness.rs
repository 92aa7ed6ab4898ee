//! Roughness mips: one channel for engines without moments.

use super::picture::picture;
use super::{bake, baked, complains, described, folder, warned};
use crate::command::{names, said};
use png::{BitDepth, ColorType};
use std::fs;
use std::path::Path;

const SIZE: [usize; 2] = [8, 4];

/// Normals from flat ones on the left to steep ones on the right.
fn texels() -> Vec<[u8; 3]> {
    let texel = |k: usize| {
        let (x, y) = (k % SIZE[0], k / SIZE[0]);
        let reach = 2 + 12 * x;
        let code = |turn: usize| (128 + (turn * (k + 3) * 37 + turn) % (2 * reach) - reach) as u8;
        [code(1), code(2), 250 - 3 * (x + y) as u8]
    };
    (0..SIZE[0] * SIZE[1]).map(texel).collect()
}

fn write(input: &Path, texels: &[[u8; 3]]) {
    let size = SIZE.map(|n| n as u32);
    let file = picture(size, ColorType::Rgb, BitDepth::Eight, texels.as_flattened());
    fs::write(input, file).expect("a file");
}

/// The trace of the covariance of a level's texel, in two passes over the texels that it covers.
fn spread(texels: &[[u8; 3]], level: usize, column: usize, row: usize) -> f64 {
    let side = |k: usize| SIZE[k].min(1 << level);
    let mut slopes = Vec::new();
    for y in row * side(1)..(row + 1) * side(1) {
        for x in column * side(0)..(column + 1) * side(0) {
            let [x, y, z] = texels[y * SIZE[0] + x].map(|v| 2.0 * f64::from(v) - 255.0);
            slopes.push([-x / z, -y / z]);
        }
    }
    let count = slopes.len() as f64;
    (0..2)
        .map(|axis| {
            let mean = slopes.iter().map(|s| s[axis]).sum::<f64>() / count;
            slopes.iter().map(|s| (s[axis] - mean).powi(2)).sum::<f64>() / count
        })
        .sum()
}

/// A gray PNG's size, bits and codes.
fn codes(path: &Path) -> ([usize; 2], usize, Vec<u32>) {
    let file = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut data).expect("pixels");
    assert_eq!(info.color_type, ColorType::Grayscale);
    let bytes = info.bit_depth as usize / 8;
    let number = |bytes: &[u8]| bytes.iter().fold(0, |sum, &byte| sum << 8 | u32::from(byte));
    let codes = data.chunks_exact(bytes).map(number).collect();
    ([info.width as usize, info.height as usize], 8 * bytes, codes)
}

#[test]
fn codes_are_the_nearest_to_base_and_covariance_together() {
    let folder = folder("roughness");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let texels = texels();
    write(&input, &texels);
    for (kind, base, bits) in [
        ("perceptual", 0.0, 8),
        ("perceptual", 0.3, 8),
        ("perceptual", 0.3, 16),
        ("alpha", 0.0, 16),
        ("alpha", 0.09, 8),
        ("alpha", 0.4, 16),
    ] {
        let (base_text, bits_text) = (base.to_string(), bits.to_string());
        let options =
            ["--roughness", &base_text, "--roughness-as", kind, "--roughness-bits", &bits_text];
        let said = baked(&input, &out, &options);
        assert!(said.contains("roughness"), "{said}");
        let alpha: f64 = if kind == "alpha" { base } else { base * base };
        let largest = f64::from((1_u32 << bits) - 1);
        let description = described(&out);
        let levels = description["levels"].as_array().expect("levels");
        assert_eq!(levels.len(), 4);
        let mut above = 0;
        for (level, files) in levels.iter().enumerate() {
            let name = files["roughness"].as_str().expect("a name");
            let ([width, height], found, codes) = codes(&out.join(name));
            assert_eq!([width, height], SIZE.map(|n| (n >> level).max(1)));
            assert_eq!(found, bits);
            for (place, code) in codes.into_iter().enumerate() {
                let square = alpha * alpha + spread(&texels, level, place % width, place / width);
                let value = if kind == "alpha" { square.sqrt() } else { square.sqrt().sqrt() };
                above += usize::from(value > 1.0);
                let exact = value.min(1.0) * largest;
                // Half a step, and what the chain of f32 errs by.
                let error = (f64::from(code) - exact).abs();
                assert!(error <= 0.5 + 2e-6 * largest, "{kind} {bits}: {code} for {exact}");
            }
        }
        let roughness = &description["roughness"];
        assert_eq!((&roughness["base"], &roughness["bits"]), (&base.into(), &bits.into()));
        assert_eq!((&roughness["kind"], &roughness["above_one"]), (&kind.into(), &above.into()));
        assert!(description["decode"]["roughness"].as_str().expect("a text").contains(kind));
    }
}

#[test]
fn a_flat_map_keeps_the_base_and_halves_are_rounded_up() {
    let folder = folder("base");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    write(&input, &vec![[128, 128, 255]; SIZE[0] * SIZE[1]]);
    for (base, bits, code) in [
        ("0", "8", 0),
        ("1", "8", 255),
        ("0.5", "8", 128),
        ("0.5", "16", 32768),
        ("1", "16", 65535),
        ("0.2", "8", 51),
        ("0.001", "8", 0),
        ("0.002", "8", 1),
    ] {
        for kind in ["perceptual", "alpha"] {
            let options = ["--roughness", base, "--roughness-bits", bits, "--roughness-as", kind];
            said(bake(&input, &out, &options));
            for level in 0..4 {
                let codes = codes(&out.join(format!("roughness.{level}.png"))).2;
                assert!(codes.iter().all(|&found| found == code), "{base}: {codes:?}");
            }
            assert_eq!(described(&out)["roughness"]["above_one"], 0);
        }
    }
}

#[test]
fn a_turned_map_has_the_roughness_that_it_had() {
    let folder = folder("turned");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let last = |texels: &[[u8; 3]]| {
        write(&input, texels);
        baked(&input, &out, &["--roughness", "0.2", "--roughness-bits", "16"]);
        codes(&out.join("roughness.3.png")).2[0]
    };
    // Grooves along y, along x, and by an eighth of a turn: 3, 4, 5.
    let grooves = |a: [i16; 2]| {
        let sign = |k: usize| if k % 2 == 0 { 1 } else { -1 };
        let texel = |k: usize| {
            a.map(|x| (255 - 2 * sign(k) * x) / 2).map(|v| u8::try_from(v).expect("a code"))
        };
        let texels = (0..SIZE[0] * SIZE[1]).map(|k| [texel(k)[0], texel(k)[1], 255]);
        texels.collect::<Vec<_>>()
    };
    let (x, y, askew) =
        (last(&grooves([50, 0])), last(&grooves([0, 50])), last(&grooves([30, 40])));
    assert!(x.abs_diff(y) <= 1 && x.abs_diff(askew) <= 1, "{x} {y} {askew}");
}

#[test]
fn roughness_comes_and_goes_with_its_levels_or_not_at_all() {
    let folder = folder("company");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    write(&input, &texels());
    baked(&input, &out, &["--roughness", "0.4"]);
    assert_eq!(names(&out).len(), 1 + 4 * 4);
    // Without it no level of the last run stays.
    baked(&input, &out, &[]);
    assert_eq!(names(&out).len(), 1 + 3 * 4);
    assert_eq!(described(&out)["roughness"], serde_json::Value::Null);
    // A folder where a file belongs: what was there is what is there.
    fs::create_dir(out.join("roughness.2.png")).expect("a folder");
    let before: Vec<_> = names(&out).iter().map(|name| fs::read(out.join(name)).ok()).collect();
    complains(
        &bake(&input, &out, &["--roughness", "0.4", "--cap", "0.5"]),
        &["--out", "roughness.2.png"],
    );
    let after: Vec<_> = names(&out).iter().map(|name| fs::read(out.join(name)).ok()).collect();
    assert_eq!(before, after);
    // Rougher than 1 is 1, and counted.
    fs::remove_dir(out.join("roughness.2.png")).expect("an empty folder");
    let steep: Vec<_> = (0..32).map(|k| [if k % 2 == 0 { 20 } else { 235 }, 128, 150]).collect();
    write(&input, &steep);
    let (said, _) = warned(&input, &out, &["--roughness", "0.9", "--roughness-as", "alpha"]);
    assert!(said.contains("11 texels above 1"), "{said}");
    assert!(codes(&out.join("roughness.1.png")).2.iter().all(|&code| code == 255));
}
