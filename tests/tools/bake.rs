//! The command line of examples/bake: maps in and their moments out, mistakes in one line, and
//! nothing half-written.
#![cfg(all(feature = "std", feature = "lean"))]

mod coverage;
mod files;
mod looks;
mod picture;
mod roughness;

use crate::command::{self, names};
use lobe::SlopeMoments;
use lobe::material::lean::{
    Border, Float32, HeightField, MomentMap, NormalTexel, SlopeCap, Storage, Unorm16,
};
use picture::{SIZE, checksum, interlaced, picture, rgb, texels};
use png::{BitDepth, ColorType};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

fn example() -> &'static Path {
    static EXAMPLE: OnceLock<PathBuf> = OnceLock::new();
    EXAMPLE.get_or_init(|| {
        crate::program::example("bake", &["examples/bake", "examples/common", "src"])
    })
}

fn bake(input: &Path, out: &Path, options: &[&str]) -> Output {
    let mut command = Command::new(example());
    command.arg(input).arg("--out").arg(out).args(options).output().expect("the example runs")
}

/// What it prints, if it succeeds; it may warn.
#[track_caller]
fn baked(input: &Path, out: &Path, options: &[&str]) -> String {
    warned(input, out, options).0
}

/// What it prints and the warnings' lines, if it succeeds.
#[track_caller]
fn warned(input: &Path, out: &Path, options: &[&str]) -> (String, Vec<String>) {
    let output = bake(input, out, options);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let begin = format!("bake: warning: {}: ", input.display());
    let line = |line: &str| {
        line.strip_prefix(&begin).unwrap_or_else(|| panic!("no warning: {line}")).to_owned()
    };
    (String::from_utf8(output.stdout).expect("UTF-8"), said.lines().map(line).collect())
}

/// One line that says all of `parts`, and nothing printed.
#[track_caller]
fn complains(output: &Output, parts: &[&str]) {
    command::complains("bake", output, parts);
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    crate::program::folder("bake", name)
}

/// What the library makes of the same texels in f64.
fn expected<T: NormalTexel>(texels: &[T], cap: f64, border: Border) -> MomentMap<f64> {
    let cap = SlopeCap::new(cap).expect("a cap");
    let size = SIZE.map(|n| n as usize);
    MomentMap::from_normals(size, texels, cap, border).expect("a map").0
}

/// A written PNG's size and codes.
fn codes(path: &Path) -> ([usize; 2], Vec<[u16; 3]>) {
    let file = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut data).expect("pixels");
    assert_eq!((info.color_type, info.bit_depth), (ColorType::Rgb, BitDepth::Sixteen));
    let texels = data.chunks_exact(6);
    let texels = texels.map(|t| [0, 2, 4].map(|k| u16::from_be_bytes([t[k], t[k + 1]])));
    ([info.width as usize, info.height as usize], texels.collect())
}

fn described(out: &Path) -> Value {
    let text = fs::read_to_string(out.join("moments.json")).expect("a description");
    serde_json::from_str(&text).expect("JSON")
}

/// Moments within the floor of their storage: half its square is an entry's error.
#[track_caller]
fn close(stored: &SlopeMoments<f32>, exact: &SlopeMoments<f64>, mean: f64, floor: f64) {
    for (a, b) in stored.mean().into_iter().zip(exact.mean()) {
        assert!((f64::from(a) - b).abs() <= mean, "mean {a}, not {b}");
    }
    let pairs = stored.covariance().entries().into_iter().zip(exact.covariance().entries());
    for (a, b) in pairs {
        // Roundings of the f32 chain come on top.
        assert!(
            (f64::from(a) - b).abs() <= 0.505 * floor * floor + 1e-6,
            "covariance {a}, not {b}"
        );
    }
}

/// Reads every file back, and compares it with the map.
#[track_caller]
fn holds(out: &Path, map: &MomentMap<f64>) {
    let description = described(out);
    let range = description["range"].as_f64().expect("a range");
    assert!(range >= map.range() * (1.0 - 1e-6));
    let short = Unorm16::new(range as f32).expect("a range");
    let steepest = description["steepest"].as_f64().expect("a slope") as f32;
    let long = Float32::new(steepest).expect("a range");
    for (name, floor) in [("unorm16", short.alpha_floor()), ("f32", long.alpha_floor())] {
        let told = description["alpha_floor"][name].as_f64().expect("a floor");
        // The reader of JSON rounds its last digit either way.
        assert!((told / f64::from(floor) - 1.0).abs() < 1e-15, "{told}, not {floor}");
    }
    let levels = description["levels"].as_array().expect("levels");
    assert_eq!(levels.len(), map.levels());
    assert_eq!(names(out).len(), 1 + 3 * map.levels());
    for (level, description) in levels.iter().enumerate() {
        let file = |part: &str| out.join(description[part].as_str().expect("a name"));
        let (size, means) = codes(&file("mean"));
        let (second_size, seconds) = codes(&file("second"));
        let raw = fs::read(file("raw")).expect("a file");
        assert_eq!((size, second_size), (map.size(level), map.size(level)));
        assert_eq!(raw.len(), 20 * size[0] * size[1]);
        let numbers: Vec<_> = raw
            .chunks_exact(4)
            .map(|bytes| f32::from_le_bytes(bytes.try_into().expect("four")))
            .collect();
        for place in 0..size[0] * size[1] {
            let exact = map.texel(level, place % size[0], place / size[0]);
            let [x, y, blue] = means[place];
            assert_eq!(blue, 0);
            let [xx, xy, yy] = seconds[place];
            let stored = short.decode([x, y, xx, xy, yy]).expect("moments");
            close(&stored, &exact, 0.51 * range / 32767.0, f64::from(short.alpha_floor()));
            let texel = numbers[5 * place..][..5].try_into().expect("five");
            let stored = long.decode(texel).expect("moments");
            close(&stored, &exact, 1e-6 * range, f64::from(long.alpha_floor()));
        }
    }
    assert_eq!(map.size(levels.len() - 1), [1, 1]);
}

#[test]
fn an_odd_map_is_read_back_within_the_alpha_floor() {
    let folder = folder("odd");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    fs::write(&input, rgb(&texels())).expect("a file");
    let said = baked(&input, &out, &[]);
    for part in ["5 x 3, 3 levels", "1 of 15 texels", "alpha floor", "decoding", "megapixels/s"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    holds(&out, &expected(&texels(), 10.0, Border::Wrap));
    let description = described(&out);
    assert_eq!(description["size"], serde_json::json!([5, 3]));
    // The texel below the horizon has the cap's length.
    assert_eq!((&description["range"], &description["border"]), (&16.0.into(), &"wrap".into()));
    assert_eq!((&description["cap"], &description["clipped"]["texels"]), (&10.0.into(), &1.into()));
    assert_eq!(names(&folder), ["moments", "normal.png"]);

    // A smaller map over it leaves no level of the larger one.
    let one = picture([1, 1], ColorType::Rgb, BitDepth::Eight, &[128, 128, 255]);
    let small = folder.join("small.png");
    fs::write(&small, one).expect("a file");
    baked(&small, &out, &[]);
    assert_eq!(names(&out), ["mean.0.png", "moments.0.f32", "moments.json", "second.0.png"]);
    fs::remove_file(&small).expect("a file");
    baked(&input, &out, &[]);

    // A description of someone else's lists files that no bake writes, or writes under other
    // numbers: they stay.
    let mut foreign = described(&out);
    for (level, part, name) in
        [(0, "mean", "photo.png"), (1, "second", "mean.07.png"), (2, "raw", "second.9.png")]
    {
        foreign["levels"][level][part] = name.into();
        fs::write(out.join(name), "mine").expect("a file");
    }
    fs::write(out.join("moments.json"), foreign.to_string()).expect("a file");
    baked(&input, &out, &[]);
    for name in ["photo.png", "mean.07.png", "second.9.png"] {
        assert_eq!(fs::read(out.join(name)).expect("a file"), b"mine");
        fs::remove_file(out.join(name)).expect("still there");
    }

    // The same from one thread and many, over what is there; a stranger's file stays.
    let first = fs::read(out.join("second.1.png")).expect("a file");
    fs::write(out.join("notes.txt"), "mine").expect("a file");
    baked(&input, &out, &["--threads", "1"]);
    assert_eq!(fs::read(out.join("second.1.png")).expect("a file"), first);
    fs::remove_file(out.join("notes.txt")).expect("still there");
    let options = ["--cap", "0.5", "--border", "clamp", "--range", "0.625", "--threads", "7"];
    baked(&input, &out, &options);
    holds(&out, &expected(&texels(), 0.5, Border::Clamp));
    assert_eq!(described(&out)["range"], 0.625);
    assert_eq!(described(&out)["border"], "clamp");
}

#[test]
fn alpha_sixteen_bits_interlacing_and_two_channels_are_read() {
    let folder = folder("kinds");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let texels = texels();
    let map = expected(&texels, 10.0, Border::Wrap);
    let rgba: Vec<u8> = texels.iter().flat_map(|&[x, y, z]| [x, y, z, 9]).collect();
    fs::write(&input, picture(SIZE, ColorType::Rgba, BitDepth::Eight, &rgba)).expect("a file");
    baked(&input, &out, &[]);
    holds(&out, &map);

    // 257 v / 65535 = v / 255.
    let wide: Vec<u8> = rgba.iter().flat_map(|&v| [v, v]).collect();
    fs::write(&input, picture(SIZE, ColorType::Rgba, BitDepth::Sixteen, &wide)).expect("a file");
    baked(&input, &out, &[]);
    holds(&out, &map);

    fs::write(&input, interlaced(&texels)).expect("a file");
    baked(&input, &out, &[]);
    holds(&out, &map);

    fs::write(&input, rgb(&texels)).expect("a file");
    let turned: Vec<_> = texels.iter().map(|&[x, y, z]| [x, 255 - y, z]).collect();
    baked(&input, &out, &["--flip-y"]);
    holds(&out, &expected(&turned, 10.0, Border::Wrap));

    let pairs: Vec<_> = texels.iter().map(|&[x, y, _]| [x, y]).collect();
    // Blue is not looked at.
    let black: Vec<_> = pairs.iter().map(|&[x, y]| [x, y, 0]).collect();
    fs::write(&input, rgb(&black)).expect("a file");
    baked(&input, &out, &["--channels", "rg"]);
    holds(&out, &expected(&pairs, 10.0, Border::Wrap));
    let wide: Vec<u8> = black.as_flattened().iter().flat_map(|&v| [v, v]).collect();
    fs::write(&input, picture(SIZE, ColorType::Rgb, BitDepth::Sixteen, &wide)).expect("a file");
    baked(&input, &out, &["--channels", "rg"]);
    holds(&out, &expected(&pairs, 10.0, Border::Wrap));
}

#[test]
fn displacement_maps_are_slopes_in_their_unit() {
    let folder = folder("height");
    let (input, out) = (folder.join("height.png"), folder.join("moments"));
    let values: Vec<u8> = (0..15_u32).map(|k| (k * k * 31 % 256) as u8).collect();
    let size = SIZE.map(|n| n as usize);
    for (y, flip) in [(-0.25, None), (0.25, Some("--flip-y"))] {
        let mut slopes = vec![[0.0_f64; 2]; 15];
        let heights: Vec<_> = values.iter().map(|&v| f64::from(v) / 255.0).collect();
        let field =
            HeightField::new(size, &heights, [0.25, y], 0.5, Border::Clamp).expect("heights");
        field.slopes(SlopeCap::new(10.0).expect("a cap"), 0, &mut slopes).expect("slopes");
        let map = MomentMap::from_slopes(size, slopes, Border::Clamp).expect("a map");
        let wide: Vec<u8> = values.iter().flat_map(|&v| [v, v, 1, 2]).collect();
        let pictures = [
            picture(SIZE, ColorType::Grayscale, BitDepth::Eight, &values),
            picture(SIZE, ColorType::GrayscaleAlpha, BitDepth::Sixteen, &wide),
        ];
        for picture in pictures {
            fs::write(&input, picture).expect("a file");
            let options = ["--height", "0.5", "--texel", "0.25", "--border", "clamp"];
            baked(&input, &out, &options.into_iter().chain(flip).collect::<Vec<_>>());
            holds(&out, &map);
        }
    }
}

#[test]
fn pictures_that_are_no_normal_maps_are_refused() {
    let folder = folder("refused");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    complains(&bake(&input, &out, &[]), &["normal.png", "cannot be read"]);
    complains(&bake(&folder, &out, &[]), &["is a folder"]);
    assert!(names(&folder).is_empty());

    let whole = rgb(&texels());
    let mut huge = whole.clone();
    huge[16..20].copy_from_slice(&16385_u32.to_be_bytes());
    // The header's checksum is the decoder's first question.
    let sum = checksum(&huge[12..29]);
    huge[29..33].copy_from_slice(&sum.to_be_bytes());
    let eight = |color, data: &[u8]| picture(SIZE, color, BitDepth::Eight, data);
    let down: Vec<_> = texels().iter().map(|&[x, y, _]| [x, y, 12]).collect();
    let gray = eight(ColorType::Grayscale, &[9; 15]);
    let height: &[&str] = &["--height", "1", "--texel", "1"];
    // Damaged pixels under a chunk's checksum that was made anew: the pixels' own one knows.
    let mut damaged = whole.clone();
    let data = whole.windows(4).position(|name| name == b"IDAT").expect("pixels");
    let length = u32::from_be_bytes(whole[data - 4..data].try_into().expect("four")) as usize;
    let end = data + 4 + length;
    damaged[end - 1] ^= 1;
    let sum = checksum(&damaged[data..end]);
    damaged[end..end + 4].copy_from_slice(&sum.to_be_bytes());
    let cases: [(&[u8], &[&str], &str); 12] = [
        (&damaged, &[], "not a readable PNG"),
        (&[], &[], "empty"),
        (b"GIF89a", &[], "not a readable PNG"),
        (&whole[..20], &[], "not a readable PNG"),
        (&whole[..whole.len() / 2], &[], "not a readable PNG"),
        // Without its end alone, too.
        (&whole[..whole.len() - 12], &[], "not a readable PNG"),
        (&huge, &[], "16385 x 3 is too large"),
        (&gray, &[], "height (bump) map"),
        (&eight(ColorType::GrayscaleAlpha, &[9; 30]), &[], "--height"),
        (&rgb(&down), &[], "not a tangent-space normal map"),
        (&rgb(&[[250, 250, 255]; 15]), &["--channels", "rg"], "not a tangent-space normal map"),
        (&whole, height, "color"),
    ];
    for (file, options, said) in cases {
        fs::write(&input, file).expect("a file");
        complains(&bake(&input, &out, options), &["normal.png: ", said]);
        assert_eq!(names(&folder), ["normal.png"], "{said}");
    }
}

#[test]
fn mistakes_are_one_line_that_names_them() {
    let folder = folder("mistakes");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    fs::write(&input, rgb(&texels())).expect("a file");
    let cases: [(&[&str], &str); 37] = [
        (&["--cap", "0"], "--cap"),
        (&["--cap", "-1"], "--cap"),
        (&["--cap", "NaN"], "--cap"),
        (&["--cap", "steep"], "--cap"),
        (&["--cap", "1e39"], "'1e39' for '--cap <SLOPE>': not a finite number"),
        (&["--range", "0.1"], "--range 0.1: the map's slopes reach"),
        (&["--range", "0"], "--range 0: range = 0 is not in (1e-9, 1e9]"),
        (&["--range", "NaN"], "'NaN' for '--range <SLOPE>': not a finite number"),
        (&["--range", "inf"], "--range"),
        (&["--range", "x"], "--range"),
        (&["--border", "mirror"], "--border"),
        (&["--channels", "rgba"], "--channels"),
        (&["--channels", "r"], "--channels"),
        (&["--channels", "gg"], "--channels"),
        (&["--channels", "xy"], "--channels"),
        (&["--channels", ""], "--channels"),
        (&["--channels", "ag"], "normal.png: has no alpha channel, which --channels ag"),
        (&["--coverage"], "normal.png: has no alpha channel, which --coverage"),
        (&["--coverage", "--channels", "ag"], "--coverage: --channels ag"),
        (&["--coverage", "--height", "1", "--texel", "1"], "--height"),
        (&["--roughness", "1.01"], "--roughness 1.01: perceptual = 1.01 is not in [0, 1]"),
        (&["--roughness", "-0.1"], "--roughness -0.1: perceptual = -0.1 is not in [0, 1]"),
        (&["--roughness", "NaN"], "'NaN' for '--roughness <BASE>': not a finite number"),
        (&["--roughness", "x"], "'x' for '--roughness <BASE>': not a number"),
        // Numbers are repeated as they were written.
        (&["--cap", "1e-46"], "--cap 1e-46: "),
        (&["--cap", "1.0000001e9"], "--cap 1.0000001e9: "),
        (&["--height", "1", "--texel", "1e30"], "--texel 1e30: "),
        (&["--roughness-as", "alpha"], "--roughness"),
        (&["--roughness", "0.5", "--roughness-bits", "12"], "--roughness-bits"),
        (&["--threads", "0"], "'0' for '--threads <COUNT>': must be a whole number from 1 to 1024"),
        (&["--threads", "1.5"], "must be a whole number from 1 to 1024"),
        (&["--height", "1"], "--texel"),
        (&["--texel", "1"], "--height"),
        (&["--height", "inf", "--texel", "1"], "--height"),
        (&["--height", "1", "--texel", "0"], "--texel"),
        (&["--height", "1", "--texel", "1e-12"], "--texel"),
        (&["--height", "1", "--texel", "1", "--channels", "rg"], "--channels"),
    ];
    for (options, said) in cases {
        complains(&bake(&input, &out, options), &[said]);
        assert_eq!(names(&folder), ["normal.png"], "{said}");
    }
    let nothing = Command::new(example()).output().expect("the example runs");
    complains(&nothing, &["--out", "INPUT"]);
    let help = Command::new(example()).arg("--help").output().expect("the example runs");
    assert!(help.status.success() && help.stderr.is_empty());
    let help = String::from_utf8(help.stdout).expect("UTF-8");
    for said in [
        "--channels",
        "--coverage",
        "--roughness ",
        "--roughness-as",
        "--roughness-bits",
        "--flip-y",
        "checksum",
        "palette",
        "DXT5nm",
        "tr Sigma",
        "warning",
    ] {
        assert!(help.contains(said), "{said}");
    }
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = folder("nothing");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    fs::write(&input, rgb(&texels())).expect("a file");
    complains(&bake(&input, &input, &[]), &["--out", "normal.png", "is no folder"]);
    complains(&bake(&input, &folder.join("missing/moments"), &[]), &["--out", "missing"]);
    assert_eq!(names(&folder), ["normal.png"]);

    // A folder where the fifth file belongs: the four before it are what they were.
    baked(&input, &out, &[]);
    let before: Vec<_> = names(&out).iter().map(|name| fs::read(out.join(name)).ok()).collect();
    fs::remove_file(out.join("second.1.png")).expect("a file");
    fs::create_dir(out.join("second.1.png")).expect("a folder");
    complains(&bake(&input, &out, &["--cap", "0.5"]), &["--out", "second.1.png"]);
    fs::remove_dir(out.join("second.1.png")).expect("an empty folder");
    let after: Vec<_> = names(&out).iter().map(|name| fs::read(out.join(name)).ok()).collect();
    let others = before.iter().filter(|file| !after.contains(file)).count();
    assert_eq!((after.len() + 1, others), (before.len(), 1));
}

/// A name that has a line break in it is told of in one line.
#[cfg(unix)]
#[test]
fn names_of_files_are_escaped() {
    let folder = folder("names");
    let out = folder.join("moments");
    complains(&bake(&folder.join("a\nb\u{1b}.png"), &out, &[]), &["a\\nb\\u{1b}.png: "]);
}

/// Warnings and mistakes that cannot be written change no file and no exit code.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_changes_nothing() {
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
    let folder = folder("said");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    fs::write(&input, rgb(&[[118, 118, 255]; 15])).expect("a file");
    for (option, code) in [("--flip-y", 0), ("--cap=0", 2), ("--none", 2)] {
        let mut command = Command::new(example());
        command.arg(&input).arg("--out").arg(&out).arg(option).stderr(full());
        assert_eq!(command.output().expect("the example runs").status.code(), Some(code));
    }
    assert_eq!(described(&out)["warnings"].as_array().map(Vec::len), Some(1));
}

/// The largest cap: no power of two above it is a range.
#[test]
fn the_largest_cap_has_a_range() {
    let folder = folder("largest");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let mut texels = [[128, 128, 255]; 15];
    texels[3] = [255, 128, 0];
    fs::write(&input, rgb(&texels)).expect("a file");
    for cap in ["6e8", "1e9"] {
        baked(&input, &out, &["--cap", cap]);
        assert_eq!(described(&out)["range"], 1e9, "--cap {cap}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_summary_that_cannot_be_printed_leaves_nothing() {
    let folder = folder("unprinted");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    fs::write(&input, rgb(&texels())).expect("a file");
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
    let mut command = Command::new(example());
    let output = command.arg(&input).arg("--out").arg(&out).stdout(full).output();
    complains(&output.expect("the example runs"), &["standard output: "]);
    assert_eq!(names(&folder), ["normal.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_leaves_nothing() {
    let folder = folder("full");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let texels: Vec<u8> = (0..64 * 64 * 3_u32).map(|k| 160 + (k * k % 90) as u8).collect();
    let file = picture([64, 64], ColorType::Rgb, BitDepth::Eight, &texels);
    fs::write(&input, file).expect("a file");
    // The first level's files do not fit, the others do.
    for out in [&out, &folder.join(".")] {
        let mut command = command::limited(example());
        let output = command.arg(&input).arg("--out").arg(out).output().expect("a shell");
        complains(&output, &["--out", ".0.", "too large"]);
        assert_eq!(names(&folder), ["normal.png"]);
    }
    baked(&input, &out, &[]);
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing() {
    let folder = folder("interrupt");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let side = 2048_u32;
    let texels: Vec<u8> = (0..3 * side * side).map(|k| 160 + (k % 83) as u8).collect();
    let file = picture([side, side], ColorType::Rgb, BitDepth::Eight, &texels);
    fs::write(&input, file).expect("a file");
    for signal in command::SIGNALS {
        let mut command = Command::new(example());
        command.arg(&input).arg("--out").arg(&out).args(["--threads", "1"]);
        // The temporary folder is there from the header on: seconds before the end.
        command::interrupted("bake", &mut command, signal, &out, || names(&folder).len() > 1);
        assert_eq!(names(&folder), ["normal.png"]);
    }
}
