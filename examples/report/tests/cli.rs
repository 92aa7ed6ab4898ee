//! Mistakes on the command line: exit code 2 and one line on stderr that names the culprit.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn report(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lobe-report")).args(arguments).output().unwrap()
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The mistake's line.
fn refusal(arguments: &[&str]) -> String {
    let output = report(arguments);
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
    assert!(output.stdout.is_empty());
    assert!(text.starts_with("error: ") && text.trim_end().lines().count() == 1, "{text}");
    text
}

#[test]
fn numbers_out_of_range_name_their_parameter() {
    for (parameter, values) in [
        ("--alpha", ["0", "-0.1", "nan", "inf", "2", "rough"].as_slice()),
        ("--size", ["0", "-3", "4.5", "100000", "large"].as_slice()),
        ("--scene", ["fire", ""].as_slice()),
        ("--light", ["candle", ""].as_slice()),
    ] {
        for value in values {
            let line = refusal(&[&format!("{parameter}={value}")]);
            assert!(line.contains(parameter), "{line}");
        }
    }
    assert!(refusal(&["--nonsense"]).contains("--nonsense"));
    assert!(refusal(&["--alpha"]).contains("--alpha"));
}

#[test]
fn normal_maps_that_cannot_be_used_are_named_and_leave_nothing_behind() {
    let folder = folder("maps");
    let out = folder.join("out");
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let gray = picture(png::ColorType::Grayscale, &[0]);
    let blue = picture(png::ColorType::Rgb, &[128, 128, 255]);
    // Pixels whose own sum is wrong, under a chunk's checksum made anew.
    let mut sum = blue.clone();
    let data = sum.windows(4).position(|name| name == b"IDAT").unwrap();
    let end = data + 4 + usize::from(sum[data - 1]);
    sum[end - 1] ^= 1;
    let crc = checksum(&sum[data..end]);
    sum[end..end + 4].copy_from_slice(&crc.to_be_bytes());
    let mut no_pixels = gray.clone();
    no_pixels[16..24].fill(0);
    for (path, reason) in [
        (folder.join("missing.png"), ""),
        (folder.clone(), ""),
        (write("empty.png", &[]), "empty"),
        (write("text.png", b"not a picture"), "PNG"),
        (write("cut.png", &gray[..40]), "PNG"),
        (write("no-pixels.png", &no_pixels), ""),
        (write("end.png", &blue[..blue.len() - 2]), "PNG"),
        (write("sum.png", &sum), "PNG"),
        (write("photo.png", b"\xff\xd8\xff\xe0JFIF"), "JPEG"),
        (write("gray.png", &gray), "height (bump) map"),
        (write("bump.png", &picture(png::ColorType::Rgb, &[7; 3])), "height (bump) map"),
        (write("black.png", &picture(png::ColorType::Rgb, &[1, 9, 12])), "normal map"),
    ] {
        let path = path.to_str().unwrap();
        let line = refusal(&["--normal-map", path, "--quick", "--out", out.to_str().unwrap()]);
        assert!(line.contains("--normal-map") && line.contains(path), "{line}");
        assert!(line.contains(reason), "{line}");
    }
    assert!(!out.exists(), "the input is checked before anything is made");
}

/// A PNG of one texel.
fn picture(color: png::ColorType, texel: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 1, 1);
    encoder.set_color(color);
    encoder.write_header().unwrap().write_image_data(texel).unwrap();
    file
}

/// CRC-32 as PNG has it.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

#[test]
fn what_a_normal_map_looks_like_is_told_and_its_channels_are_named() {
    let folder = folder("looks");
    let map = folder.join("map.png");
    let write = |texels: &[[u8; 4]]| {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 4, texels.len() as u32 / 4);
        encoder.set_color(png::ColorType::Rgba);
        encoder.write_header().unwrap().write_image_data(texels.as_flattened()).unwrap();
        fs::write(&map, &file).unwrap();
    };
    // x in alpha, y in green.
    write(&[0, 1, 2, 3].map(|k| [255, 120 + 9 * k, 255, 140 - 11 * k]));
    let map = map.to_str().unwrap();
    // The map is looked at first: then the run ends, as a file is in the folder's place.
    let run = |channels: &str| {
        let output =
            report(&["--quick", "--normal-map", map, "--channels", channels, "--out", map]);
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8(output.stderr).unwrap()
    };
    let said = run("rgb");
    let mut lines = said.lines();
    let hint = lines.next().unwrap();
    assert!(hint.starts_with("warning: --normal-map") && hint.contains("--channels ag"), "{said}");
    assert!(lines.next_back().unwrap().starts_with("error: --out"), "{said}");
    assert_eq!(run("ag").lines().count(), 1);
    // Slopes are told of as `bake` tells of them: a flat color that is not flat, texels at the
    // horizon, y that points down.
    let (rising, flat, fallen) = ([134, 121, 255, 255], [118, 118, 255, 255], [0, 128, 128, 255]);
    let (sinking, neutral) = ([121, 134, 255, 255], [128, 128, 255, 255]);
    for (texels, expected) in [
        (&[flat; 4][..], "every slope is (0.0745, 0.0745)"),
        (
            &[neutral, fallen, neutral, neutral],
            "25.0 % of the texels are steeper than a slope of 10",
        ),
        (
            &[
                [neutral, rising, neutral, sinking],
                [sinking, neutral, rising, neutral],
                [neutral, sinking, neutral, rising],
                [rising, neutral, sinking, neutral],
            ]
            .concat(),
            "green looks as if it pointed down",
        ),
    ] {
        write(texels);
        let said = run("rgb");
        assert!(
            said.lines().any(|line| line.starts_with("warning: ") && line.contains(expected)),
            "{said}"
        );
    }
    assert!(run("rr").contains("--channels"));
    assert!(refusal(&["--channels", "ag"]).contains("--normal-map"));
}

#[test]
fn a_normal_map_on_a_scene_without_one_is_a_mistake() {
    for scene in ["water", "sphere", "torus", "strip", "disk", "relief", "glints"] {
        let line = refusal(&["--scene", scene, "--normal-map", "x.png"]);
        assert!(line.contains("--normal-map") && line.contains(scene), "{line}");
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let file = folder("out").join("file");
    fs::write(&file, "").unwrap();
    let below = file.join("below");
    let below = below.to_str().unwrap();
    let line = refusal(&["--quick", "--size", "32", "--scene", "water", "--out", below]);
    assert!(line.contains("--out") && line.contains(below), "{line}");
}

#[test]
fn help_names_every_option() {
    let output = report(&["--help"]);
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    for option in [
        "--quick",
        "--scene",
        "--light",
        "--normal-map",
        "--channels",
        "--alpha",
        "--size",
        "--out",
    ] {
        assert!(text.contains(option), "{option}");
    }
}
