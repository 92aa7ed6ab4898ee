//! The command line of examples/glints: pictures of the asked size, the zoom's energies, mistakes
//! in one line, and nothing half-written.
#![cfg(all(feature = "std", feature = "glint"))]

mod files;

use crate::command::{self, names, said};
use files::{Picture, files, picture};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

const STILLS: [&str; 4] = ["ball.png", "brushed.png", "fabric.png", "snow.png"];

fn example() -> &'static Path {
    static EXAMPLE: OnceLock<PathBuf> = OnceLock::new();
    let sources = ["examples/glints", "examples/common", "src"];
    EXAMPLE.get_or_init(|| crate::program::example("glints", &sources))
}

fn glints(out: &Path, options: &[&str]) -> Output {
    let mut command = Command::new(example());
    command.arg("--out").arg(out).args(options).output().expect("the example runs")
}

/// What it prints, if it succeeds.
#[track_caller]
fn drawn(out: &Path, options: &[&str]) -> String {
    said(glints(out, options))
}

/// One line that says all of `parts`, and nothing printed.
#[track_caller]
fn complains(output: &Output, parts: &[&str]) {
    command::complains("glints", output, parts);
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    crate::program::folder("glints", name)
}

/// The numbers of a line of the zoom's table, its unit left out.
fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn every_scene_is_drawn_in_the_asked_size_by_any_number_of_threads() {
    let folder = folder("all");
    let options = ["--size", "72x40", "--frames", "9"];
    let one = folder.join("one");
    let said = drawn(&one, &[&options[..], &["--threads", "1"]].concat());
    let frames = (0..9).map(|k| format!("zoom.{k}.png"));
    let stills = STILLS.map(str::to_owned).into_iter();
    let mut expected: Vec<String> = stills.chain(frames).chain(["zoom.png".to_owned()]).collect();
    expected.sort();
    assert_eq!(names(&one), expected);
    for name in &expected {
        let Picture { size, codes } = picture(&one.join(name));
        // Four middles of a quarter of the width in a row, two rows of half the height, and lines
        // between.
        let sheet = name == "zoom.png";
        assert_eq!(size, if sheet { [78, 42] } else { [72, 40] }, "{name}");
        let brightest = codes.iter().max().copied().unwrap_or_default();
        let darkest = codes.iter().min().copied().unwrap_or_default();
        assert!(
            brightest > 200 && brightest.abs_diff(darkest) > 50,
            "{name}: {darkest} to {brightest}"
        );
    }
    for (name, line) in STILLS.iter().rev().zip(said.lines()) {
        let ratio = line.strip_prefix(&format!("{name}: ")).and_then(|rest| rest.split(' ').next());
        let ratio: f64 = ratio.and_then(|ratio| ratio.parse().ok()).expect("a ratio");
        // Of small pictures of few grooves.
        assert!((0.3..3.0).contains(&ratio) && line.contains("cells a pixel"), "{line}");
    }

    let many = folder.join("many");
    drawn(&many, &[&options[..], &["--threads", "5"]].concat());
    assert!(files(&one) == files(&many), "pictures depend on the number of threads");
    assert_eq!(names(&folder), ["many", "one"]);
}

/// Law Z1 in pictures: whatever the distance, as much light as of the smooth lobe.
#[test]
fn the_zoom_s_energies_lie_near_1() {
    let out = folder("zoom").join("out");
    let said = drawn(&out, &["--scene", "zoom", "--size", "320x180", "--frames", "8"]);
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("zoom.png: 8 frames in "), "{said}");
    assert!(lines[1].starts_with("frame ") && lines.len() == 11, "{said}");
    let mut before = 0.0;
    for (k, line) in lines[2..10].iter().enumerate() {
        let numbers = numbers(line);
        let [frame, distance, details, radiance, smooth, ratio, expected, cells, most] =
            numbers[..]
        else {
            panic!("{line}");
        };
        assert!(frame == k as f64 && distance > before && details > 0.0, "{line}");
        assert!((radiance / smooth - ratio).abs() < 2e-4, "{line}");
        // Cells that both levels have draw once for both: more noise than of independent details.
        assert!((ratio - 1.0).abs() < 5.0 * expected + 1e-3, "{line}");
        assert!(cells >= 4.0 && cells <= most && most <= 104.0, "{line}");
        before = distance;
    }
    let first = numbers(lines[2])[1];
    assert!(before > 64.0 * first, "a factor of 2^6 at least: {said}");
    assert!(lines[10].starts_with("largest change between frames "), "{said}");
}

#[test]
fn the_smooth_lobe_and_the_published_model_are_drawn_beside() {
    let folder = folder("methods");
    let options = ["--scene", "ball", "--scene", "snow", "--size", "48x27"];
    drawn(&folder, &options);
    drawn(&folder, &[&options[..], &["--published"]].concat());
    let said = drawn(&folder, &[&options[..], &["--smooth"]].concat());
    assert_eq!(said.matches(": 1.0000 of the smooth lobe's light").count(), 2, "{said}");
    let expected = ["", ".published", ".smooth"].map(|method| format!("ball{method}.png"));
    assert_eq!(names(&folder)[..3], expected);
    assert_eq!(names(&folder).len(), 6);
    let [ours, theirs, smooth] = expected.map(|name| picture(&folder.join(name)).codes);
    assert!(ours != theirs && ours != smooth && theirs != smooth);

    // Again the same bits; of another seed, others.
    drawn(&folder, &options);
    assert!(picture(&folder.join("ball.png")).codes == ours);
    drawn(&folder, &[&options[..], &["--seed", "1"]].concat());
    assert!(picture(&folder.join("ball.png")).codes != ours);
}

/// Frames of a longer sequence would be taken for the shorter one's; a stranger's file stays.
#[test]
fn a_shorter_zoom_replaces_a_longer_one() {
    let out = folder("shorter");
    let zoom = |frames| drawn(&out, &["--scene", "zoom", "--size", "32x18", "--frames", frames]);
    zoom("12");
    for name in ["zoom.txt", "zoom.07.png", "zoom.smooth.9.png", "zoom.x.png"] {
        fs::write(out.join(name), "mine").expect("a file");
    }
    zoom("2");
    let mut expected = ["zoom.png", "zoom.0.png", "zoom.1.png", "zoom.txt"].to_vec();
    expected.extend(["zoom.07.png", "zoom.smooth.9.png", "zoom.x.png"]);
    expected.sort_unstable();
    assert_eq!(names(&out), expected);
}

#[test]
fn mistakes_are_one_line_that_names_them() {
    let folder = folder("mistakes");
    let out = folder.join("out");
    let cases: [(&[&str], &str); 19] = [
        (&["--scene", "sand"], "--scene"),
        (&["--size", "960"], "--size"),
        (&["--size", "axb"], "--size"),
        (&["--size", "32x"], "--size"),
        (&["--size", "32x18x3"], "--size"),
        (&["--size", "0x18"], "sides must lie between 16 and 8192"),
        (&["--size", "32x15"], "--size"),
        (&["--size", "8193x18"], "--size"),
        (&["--size", "-32x18"], "--size"),
        (&["--frames", "0"], "--frames"),
        (&["--frames", "1"], "--frames"),
        (&["--frames", "1001"], "--frames"),
        (&["--frames", "many"], "--frames"),
        (&["--frames", "4", "--scene", "snow"], "--frames: of the scenes only zoom has frames"),
        (&["--threads", "0"], "--threads"),
        (&["--seed", "-1"], "--seed"),
        (&["--published", "--smooth"], "--smooth"),
        (&["--published", "--seed", "1"], "--seed"),
        (&["snow"], "snow"),
    ];
    for (options, said) in cases {
        complains(&glints(&out, options), &[said]);
        assert!(names(&folder).is_empty(), "{said}");
    }
    let help = Command::new(example()).arg("--help").output().expect("the example runs");
    assert!(help.status.success() && !help.stdout.is_empty() && help.stderr.is_empty());
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = folder("nothing");
    let small = ["--scene", "ball", "--size", "32x18"];
    let file = folder.join("file");
    fs::write(&file, "mine").expect("a file");
    complains(&glints(&file, &small), &["--out", "file", "is no folder"]);
    complains(&glints(&folder.join("missing/out"), &small), &["--out", "missing"]);
    complains(&glints(&file.join("out"), &small), &["--out", "file"]);
    assert_eq!(names(&folder), ["file"]);

    // A folder where the second picture belongs: the first is what it was.
    let out = folder.join("out");
    let both = ["--scene", "ball", "--scene", "brushed", "--size", "32x18"];
    drawn(&out, &both);
    let before = fs::read(out.join("ball.png")).expect("a file");
    fs::remove_file(out.join("brushed.png")).expect("a file");
    fs::create_dir(out.join("brushed.png")).expect("a folder");
    complains(&glints(&out, &[&both[..], &["--seed", "1"]].concat()), &["--out", "brushed.png"]);
    assert_eq!(names(&out), ["ball.png", "brushed.png"]);
    assert!(fs::read(out.join("ball.png")).expect("a file") == before);
}

#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_leaves_nothing() {
    let folder = folder("full");
    let mut command = command::limited(example());
    command.arg("--out").arg(folder.join("out"));
    command.args(["--scene", "fabric", "--size", "320x180"]);
    let output = command.output().expect("a shell");
    complains(&output, &["--out", "fabric.png", "too large"]);
    assert!(names(&folder).is_empty());
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing() {
    let folder = folder("interrupt");
    for signal in command::SIGNALS {
        let mut command = Command::new(example());
        let out = folder.join("out");
        command.arg("--out").arg(&out).args(["--size", "2048x1152"]);
        // The temporary folder is there from the beginning on: many seconds before the end.
        command::interrupted("glints", &mut command, signal, &out, || !names(&folder).is_empty());
        assert!(names(&folder).is_empty());
    }
}
