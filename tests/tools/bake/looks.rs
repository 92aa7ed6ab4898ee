//! Maps that are not what they are read as: heights, two channels, a flat color that is not flat, y
//! turned.

use super::picture::{SIZE, picture, rgb, texels};
use super::{bake, baked, complains, described, expected, folder, holds, warned};
use lobe::material::lean::Border;
use png::{BitDepth, ColorType};
use std::fs;
use std::path::PathBuf;

/// How a normal's codes are laid out as RGBA, and what is said of it.
type Layout<'a> = (&'a dyn Fn([u8; 3]) -> [u8; 4], &'a str);

/// The nearest code of 8 bits.
fn nearest(x: f64) -> u8 {
    // In range after the clamp.
    #[allow(clippy::cast_sign_loss)]
    let code = x.clamp(0.0, 255.0).round() as u8;
    code
}

/// Normals of a smooth surface, y up: (z, x, y) of bumps.
fn bumps(side: u32) -> Vec<[u8; 3]> {
    let normal = |k: u32| {
        let (x, y) = (f64::from(k % side), f64::from(k / side));
        let turn = core::f64::consts::TAU / f64::from(side);
        // h = sin(3 turn x + 1) sin(2 turn y'), y' up.
        let (a, b) = (3.0 * turn * x + 1.0, -2.0 * turn * y);
        let [p, q] = [0.8 * a.cos() * b.sin(), 0.6 * a.sin() * b.cos()];
        let length = (1.0 + p * p + q * q).sqrt();
        [-p, -q, 1.0].map(|c| nearest(127.5 + 127.5 * c / length))
    };
    (0..side * side).map(normal).collect()
}

/// A folder with a picture in it, and where its moments go.
fn files(name: &str) -> (PathBuf, PathBuf) {
    let folder = folder(name);
    (folder.join("normal.png"), folder.join("moments"))
}

#[test]
fn a_height_map_is_refused_by_what_it_is() {
    let (input, out) = files("bump");
    let grays: Vec<u8> = (0..15_u8).map(|k| 17 * k).collect();
    let rgb: Vec<u8> = grays.iter().flat_map(|&v| [v, v, v]).collect();
    let rgba: Vec<u8> = grays.iter().flat_map(|&v| [v, v, v, 255]).collect();
    let wide: Vec<u8> = rgb.iter().flat_map(|&v| [v, 3]).collect();
    // As a lossy format leaves grays.
    let nearly: Vec<u8> = grays.iter().flat_map(|&v| [v, v.saturating_add(2), v]).collect();
    for (color, depth, data, said) in [
        (ColorType::Rgb, BitDepth::Eight, &rgb, "are equal"),
        (ColorType::Rgba, BitDepth::Eight, &rgba, "are equal"),
        (ColorType::Rgb, BitDepth::Sixteen, &wide, "are equal"),
        (ColorType::Grayscale, BitDepth::Eight, &grays, "are equal"),
        (ColorType::Rgb, BitDepth::Eight, &nearly, "are nearly equal"),
    ] {
        fs::write(&input, picture(SIZE, color, depth, data)).expect("a file");
        for options in [&[][..], &["--channels", "rg"]] {
            let parts = ["normal.png: looks like a height (bump) map", said, "--height"];
            complains(&bake(&input, &out, options), &parts);
        }
        assert!(!out.exists());
        baked(&input, &out, &["--height", "1", "--texel", "1"]);
        fs::remove_dir_all(&out).expect("a folder");
    }
    // Grays with x in alpha are two channels.
    let pairs: Vec<_> = texels().iter().map(|&[x, y, _]| [x, y]).collect();
    let gray: Vec<u8> = pairs.iter().flat_map(|&[x, y]| [y, x]).collect();
    fs::write(&input, picture(SIZE, ColorType::GrayscaleAlpha, BitDepth::Eight, &gray))
        .expect("a file");
    complains(&bake(&input, &out, &[]), &["height (bump) map", "--channels ag"]);
    baked(&input, &out, &["--channels", "ag"]);
    holds(&out, &expected(&pairs, 10.0, Border::Wrap));
    // A colored texel among a thousand makes no normal map of it; two do.
    let mut bright = vec![[200_u8; 3]; 1024];
    for (red, said) in [(3, Some("in all but 1 of 1024 texels")), (1000, None)] {
        bright[red] = [255, 0, 0];
        let data = bright.as_flattened();
        fs::write(&input, picture([32; 2], ColorType::Rgb, BitDepth::Eight, data)).expect("a file");
        match said {
            Some(said) => complains(&bake(&input, &out, &[]), &["height (bump) map", said]),
            None => drop(baked(&input, &out, &[])),
        }
    }
    // Not one texel of a normal map is that of a height map.
    let mut one = vec![[90_u8; 3]; 15];
    one[14] = [90, 90, 255];
    fs::write(&input, super::rgb(&one)).expect("a file");
    complains(&bake(&input, &out, &[]), &["most texels do not point up"]);
}

#[test]
fn any_two_channels_are_x_and_y() {
    let (input, out) = files("pairs");
    let texels = texels();
    let pairs: Vec<_> = texels.iter().map(|&[x, y, _]| [x, y]).collect();
    let map = expected(&pairs, 10.0, Border::Wrap);
    let names = ["r", "g", "b", "a"];
    for x in 0..4 {
        for y in (0..4).filter(|y| *y != x) {
            let data = pairs.iter().flat_map(|&[p, q]| {
                let mut texel = [3, 250, 0, 77];
                (texel[x], texel[y]) = (p, q);
                texel
            });
            let data: Vec<u8> = data.collect();
            let wide: Vec<u8> = data.iter().flat_map(|&v| [v, v]).collect();
            let channels = format!("{}{}", names[x], names[y]);
            for (depth, data) in [(BitDepth::Eight, &data), (BitDepth::Sixteen, &wide)] {
                fs::write(&input, picture(SIZE, ColorType::Rgba, depth, data)).expect("a file");
                baked(&input, &out, &["--channels", &channels]);
                holds(&out, &map);
                assert_eq!(described(&out)["channels"], channels);
            }
        }
    }
    // Three channels in another order.
    let turned: Vec<u8> = texels.iter().flat_map(|&[x, y, z]| [z, y, x]).collect();
    fs::write(&input, picture(SIZE, ColorType::Rgb, BitDepth::Eight, &turned)).expect("a file");
    baked(&input, &out, &["--channels", "bgr"]);
    holds(&out, &expected(&texels, 10.0, Border::Wrap));
}

#[test]
fn layouts_of_two_channels_are_pointed_out() {
    let (input, out) = files("layouts");
    let side = 16;
    let normals = bumps(side);
    let write = |texel: &dyn Fn([u8; 3]) -> [u8; 4]| {
        let data: Vec<u8> = normals.iter().flat_map(|&normal| texel(normal)).collect();
        fs::write(&input, picture([side; 2], ColorType::Rgba, BitDepth::Eight, &data))
            .expect("a file");
    };
    // Read as RGB, these are maps of something, and a line says of what.
    let gentle = |v: u8| (64 + v / 2, 96 + v / 4);
    let hinted: [Layout; 9] = [
        (&|[x, y, _]| [255, y, 255, x], "--channels ag"),
        (&|[x, y, _]| [128, y, 255, x], "--channels ag"),
        (&|[x, y, z]| [0, y, z, x], "--channels ag"),
        (&|[x, y, _]| [y, 255, 255, x], "--channels ra or ar"),
        (&|[x, y, _]| [x, y, 255, 255], "--channels rg"),
        (&|[x, y, _]| [x, y, 255, x ^ y], "--channels rg"),
        // Flatter ones; something else in blue.
        (&|[x, y, _]| [gentle(x).0, gentle(y).0, 255, 255], "--channels rg"),
        (&|[x, y, _]| [x, y, 180 + x % 32, 255], "if blue is not z, --channels rg"),
        (&|[x, y, _]| [x, y, 180 + x % 32, y], "ag from alpha and green"),
    ];
    for (texel, said) in hinted {
        write(texel);
        let (_, warnings) = warned(&input, &out, &[]);
        assert!(warnings[0].contains(said), "{said}: {warnings:?}");
        assert_eq!(described(&out)["warnings"][0], warnings[0]);
    }
    // Blue points down: refused, and the line says why.
    let refused: [Layout; 5] = [
        (&|[x, y, _]| [0, x, 0, y], "or ga"),
        (&|[x, y, _]| [0, y, 0, x], "--channels ag"),
        (&|[x, y, _]| [x, y, 0, 255], "--channels rg"),
        (&|[x, y, _]| [x, y, 127 - y % 2, 255], "do not point up"),
        (&|[x, y, _]| [y, y, y, x], "--channels ag"),
    ];
    for (texel, said) in refused {
        write(texel);
        complains(&bake(&input, &out, &[]), &["normal.png: ", said]);
    }
    // The right channels say nothing; the wrong two of them do.
    write(&|[x, y, _]| [255, y, 255, x]);
    assert_eq!(warned(&input, &out, &["--channels", "ag"]).1, [""; 0]);
    complains(&bake(&input, &out, &["--channels", "rg"]), &["--channels ag"]);
    // A map with alpha for something else, one whose blue is 255 as it is nearly flat, grooves of
    // constant x.
    write(&|[x, y, z]| [x, y, z, x ^ y]);
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    write(&|[x, y, _]| [120 + x / 16, 120 + y / 16, 255, 255]);
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    // With alpha for something else, nearly flat, a roof of two slopes.
    write(&|[x, y, _]| [120 + x / 16, 120 + y / 16, 255, x ^ y]);
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    write(&|[x, y, _]| [128, if x < 128 { 51 } else { 204 }, 230, x ^ y]);
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    write(&|[x, y, _]| [if x < 128 { 51 } else { 204 }, 128, 230, x ^ y]);
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    write(&|[x, y, _]| [7, 120 + y / 16, 255, 120 + x / 16]);
    assert_eq!(warned(&input, &out, &["--channels", "agb"]).1, [""; 0]);
    write(&|[x, _, _]| {
        let z = 127.5 + (127.5_f64.powi(2) - (f64::from(x) - 127.5).powi(2)).sqrt();
        [128, x, nearest(z), x]
    });
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
}

/// Maps from lossy files, whose vectors are up to a third too long or too short.
#[test]
fn real_maps_are_taken_as_they_are() {
    let (_, out) = files("real");
    let assets = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/report/assets");
    for name in ["diamond-plate", "leather", "wood-fiber"] {
        assert_eq!(warned(&assets.join(format!("{name}.png")), &out, &[]).1, [""; 0]);
    }
    // The green of crumpled-paper.png points down, as the README beside it says.
    let (_, warnings) = warned(&assets.join("crumpled-paper.png"), &out, &[]);
    assert!(warnings.len() == 1 && warnings[0].contains("pointed down"), "{warnings:?}");
}

#[test]
fn alpha_that_colors_were_multiplied_by_is_pointed_out() {
    let (input, out) = files("premultiplied");
    let part = |v: u8, alpha: u8| (u16::from(v) * u16::from(alpha) / 255) as u8;
    let alpha = |k: usize| if k % 3 == 0 { 200 } else { 255 };
    let data = bumps(16).into_iter().enumerate().flat_map(|(k, [x, y, z])| {
        let a = alpha(k);
        [part(x, a), part(y, a), part(z, a), a]
    });
    let data: Vec<u8> = data.collect();
    fs::write(&input, picture([16; 2], ColorType::Rgba, BitDepth::Eight, &data)).expect("a file");
    let (_, warnings) = warned(&input, &out, &[]);
    assert!(warnings[0].contains("premultiplied"), "{warnings:?}");
    // A roof whose colors lie below an alpha that is hardly less than 1.
    let roof = (0..256_usize)
        .flat_map(|k| [if k / 4 % 2 == 0 { 37 } else { 218 }, 128, 218, 225 + (k * k % 31) as u8]);
    let roof: Vec<u8> = roof.collect();
    fs::write(&input, picture([16; 2], ColorType::Rgba, BitDepth::Eight, &roof)).expect("a file");
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
}

#[test]
fn a_flat_color_that_is_not_flat_is_pointed_out() {
    let (input, out) = files("flat");
    let flat = |texel: [u8; 3], side: u32| {
        let data = vec![texel; (side * side) as usize];
        fs::write(&input, picture([side; 2], ColorType::Rgb, BitDepth::Eight, data.as_flattened()))
            .expect("a file");
    };
    for (texel, slope, srgb) in [
        ([118, 118, 255], 19.0 / 255.0, false),
        ([188, 188, 255], -121.0 / 255.0, true),
        ([187, 187, 255], -119.0 / 255.0, true),
        ([55, 55, 255], 145.0 / 255.0, false),
        ([130, 130, 255], -5.0 / 255.0, false),
    ] {
        for side in [64, 1] {
            flat(texel, side);
            let (said, warnings) = warned(&input, &out, &[]);
            assert!(warnings.len() == 1 && warnings[0].contains("every slope is"), "{warnings:?}");
            assert_eq!(
                warnings[0].contains("encoded as sRGB, (188, 188, 255)"),
                srgb,
                "{warnings:?}"
            );
            let decoded = warnings[0].contains("decoded as sRGB, (55, 55, 255)");
            assert_eq!(decoded, texel == [55, 55, 255], "{warnings:?}");
            assert!(said.contains("mean slope"), "{said}");
            let description = described(&out);
            for axis in 0..2 {
                let mean = description["mean_slope"][axis].as_f64().expect("a number");
                assert!((mean - slope).abs() < 1e-6, "{mean}, not {slope}");
            }
            assert_eq!(description["deviation"], 0.0);
        }
    }
    // Both codes next to the middle are 0, of 8 bits that became 16, too.
    for texel in [[128, 128, 255], [127, 127, 255], [127, 128, 254]] {
        flat(texel, 4);
        assert_eq!(warned(&input, &out, &[]).1, [""; 0]);
    }
    let wide = [128_u8; 4].iter().chain(&[255; 2]).copied().collect::<Vec<_>>();
    fs::write(&input, picture([1; 2], ColorType::Rgb, BitDepth::Sixteen, &wide)).expect("a file");
    assert_eq!(warned(&input, &out, &[]).1, [""; 0]);

    // A map that varies, on such a color: x by 8 codes to either side.
    let tilted: Vec<[u8; 3]> = (0..15).map(|k| [110 + k % 5 * 4, 100, 255]).collect();
    fs::write(&input, rgb(&tilted)).expect("a file");
    let (_, warnings) = warned(&input, &out, &[]);
    let [x, y] = described(&out)["mean_slope"]
        .as_array()
        .map_or([0.0; 2], |mean| [0, 1].map(|axis| mean[axis].as_f64().expect("a number")));
    let tilted_by = format!("of length {:.4} is larger than the deviation", x.hypot(y));
    assert!(warnings[0].contains(&tilted_by), "{warnings:?}");
    // The mean and deviation of its slopes.
    let slopes = tilted.iter().map(|&[x, _, _]| (255.0 - 2.0 * f64::from(x)) / 255.0);
    let mean = slopes.clone().sum::<f64>() / 15.0;
    let variance = slopes.map(|s| (s - mean).powi(2)).sum::<f64>() / 15.0;
    let description = described(&out);
    assert!((description["mean_slope"][0].as_f64().expect("a number") - mean).abs() < 1e-6);
    assert!((description["deviation"].as_f64().expect("a number") - variance.sqrt()).abs() < 1e-6);

    // The whole of a map encoded as sRGB, which a color picker shows as (188, 188, 255), and of one
    // decoded as sRGB.
    let encoded = |v: u8| {
        let v = f64::from(v) / 255.0;
        let code = if v > 0.003_130_8 { 1.055 * v.powf(1.0 / 2.4) - 0.055 } else { 12.92 * v };
        nearest(255.0 * code)
    };
    let decoded = |v: u8| {
        let v = f64::from(v) / 255.0;
        nearest(255.0 * if v > 0.040_45 { ((v + 0.055) / 1.055).powf(2.4) } else { v / 12.92 })
    };
    let curves: [(&dyn Fn(u8) -> u8, &str); 2] =
        [(&encoded, "encoded as sRGB"), (&decoded, "decoded as sRGB")];
    for (curve, said) in curves {
        let gentle =
            bumps(32).into_iter().map(|[x, y, _]| [96 + x / 4, 96 + y / 4, 250].map(curve));
        let gentle: Vec<_> = gentle.collect();
        fs::write(&input, picture([32; 2], ColorType::Rgb, BitDepth::Eight, gentle.as_flattened()))
            .expect("a file");
        let (_, warnings) = warned(&input, &out, &[]);
        assert!(warnings.len() == 1 && warnings[0].contains(said), "{warnings:?}");
    }
}

#[test]
fn green_that_points_down_is_pointed_out() {
    let (input, out) = files("down");
    let up = bumps(32);
    let down: Vec<_> = up.iter().map(|&[x, y, z]| [x, 255 - y, z]).collect();
    for (normals, options, said) in [
        (&up, &[][..], None),
        (&down, &[], Some("--flip-y")),
        (&down, &["--flip-y"], None),
        (&up, &["--flip-y"], Some("leave --flip-y out")),
    ] {
        fs::write(
            &input,
            picture([32; 2], ColorType::Rgb, BitDepth::Eight, normals.as_flattened()),
        )
        .expect("a file");
        let (_, warnings) = warned(&input, &out, options);
        assert_eq!(warnings.len(), usize::from(said.is_some()), "{warnings:?}");
        assert!(
            warnings.iter().all(|line| line.contains(said.unwrap_or_default())),
            "{warnings:?}"
        );
    }
}
