//! Small runs from end to end: one page, whole, without anything from outside.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Runs the report into an empty folder; its standard output and its page.
fn run(name: &str, arguments: &[&str]) -> (String, String) {
    let folder: PathBuf = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    let output = Command::new(env!("CARGO_BIN_EXE_lobe-report"))
        .args(["--quick", "--out", folder.to_str().unwrap()])
        .args(if arguments.contains(&"--size") { [].as_slice() } else { &["--size", "32"] })
        .args(arguments)
        .output()
        .unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{errors}");
    assert!(errors.is_empty(), "no progress bar without a terminal: {errors}");
    let mut files: Vec<_> =
        fs::read_dir(&folder).unwrap().map(|f| f.unwrap().file_name()).collect();
    files.sort();
    let mut expected = vec!["advice.md", "cover.png", "index.html", "report.json"];
    // Relief and glints have no picture without a filter.
    let bare = ["relief", "glints"].iter().any(|scene| arguments.contains(scene));
    expected.retain(|file| *file != "cover.png" || !bare);
    assert_eq!(files, expected, "nothing unfinished");
    (
        String::from_utf8(output.stdout).unwrap(),
        fs::read_to_string(folder.join("index.html")).unwrap(),
    )
}

/// Text and page of the scene water, which several tests read.
static WATER: LazyLock<(String, String)> = LazyLock::new(|| run("water", &["--scene", "water"]));

/// Text and page of the scene torus, which has neither motion nor relief nor glints.
static TORUS: LazyLock<(String, String)> =
    LazyLock::new(|| run("torus-only", &["--scene", "torus"]));

/// A page without its pictures' data, in which any letters may stand.
fn words(page: &str) -> String {
    let mut pieces = page.split("base64,");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |words, piece| words + &piece[piece.find('"').unwrap_or_default()..])
}

/// Every `src`, `href`, `url(` and `@import` of a page points into the page.
fn assert_self_contained(page: &str) {
    for attribute in ["src=\"", "href=\""] {
        for (at, _) in page.match_indices(attribute) {
            let value = &page[at + attribute.len()..];
            assert!(value.starts_with("data:image/png;base64,"), "{}", &value[..60]);
        }
    }
    for outside in ["url(", "@import", "http:", "https:", "<script", "<link", "<iframe"] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn water_gives_one_self_contained_page_with_finite_numbers() {
    let (text, page) = &*WATER;
    assert_self_contained(page);
    // One for each distribution; two of water in motion; four measures under two pixels and two
    // figures of Eq. 20.
    assert_eq!(page.matches("<svg").count(), 2 + 2 + 4 * 2 + 2);
    // On water one filter is the best by RMSE and by SMAPE: no second picture.
    assert!(page.contains("Best filter, ") && !page.contains("Best by SMAPE"));
    assert_eq!(page.matches("<img").count(), 5);
    // Two alphas; supersampling and rectangles for both distributions, parallelograms for GGX with
    // two kinds of footprints. Each GGX method once over all scenes; in motion GGX at one alpha,
    // without the many samples.
    for (name, rows) in
        [("exact parallelogram", 6 + 2), ("supersampling 256", 5), ("rectangle", 5 + 1)]
    {
        let lines = text.lines().filter(|line| line.starts_with(name));
        assert_eq!(lines.count(), rows, "{name}");
        assert!(page.contains(name), "{name}");
    }
    for wrong in ["NaN", "inf ", "-0."] {
        assert!(!text.contains(wrong), "{wrong} in\n{text}");
    }
}

#[test]
fn filters_without_a_renderer_stand_in_text_and_page() {
    let (text, page) = &*WATER;
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap();
    // Eq. 20's last form is 1/pi of the peak of a large box, all but the mass beyond it.
    assert!(line("Eq. 20, last form").contains("\u{2212}68"), "{text}");
    // Nothing is wrong with an exact Gaussian under a Gaussian.
    let exact: Vec<_> = line("exact Gaussian, f64").split_whitespace().collect();
    assert!(exact.ends_with(&["0", "%", "0", "0", "%", "1.00\u{d7}"]), "{exact:?}");
    for name in ["Eq. 20, re-derived", "Gaussian peak, fitted", "Appendix A rectangle, f32"] {
        assert!(page.contains(name) && !line(name).is_empty(), "{name}");
    }
}

#[test]
fn on_water_the_exact_filter_beats_every_other_and_supersampling_converges() {
    let (text, _) = run("order", &["--scene", "water", "--alpha", "0.01"]);
    let ggx: Vec<_> = text.lines().take_while(|line| !line.starts_with("Beckmann")).collect();
    let rmse = |name: &str| -> f64 {
        // Names end where two spaces begin.
        let start = format!("{name}  ");
        let line = ggx.iter().find(|line| line.starts_with(&start)).unwrap();
        // Pixel filter (a word or two, not a number), RMSE.
        let mut cells = line[name.len()..].split_whitespace();
        cells.find_map(|cell| cell.parse().ok()).unwrap()
    };
    for kind in ["", ", analytic"] {
        let exact = rmse(&format!("exact parallelogram{kind}"));
        for other in ["variance addition, 1/12", "Tokuyoshi 2017"] {
            assert!(exact < rmse(&format!("{other}{kind}")), "{other}{kind}");
        }
        for other in ["none (1 sample)", "rectangle", "variance addition, 1/4"] {
            assert!(exact < rmse(other), "{other}");
        }
    }
    assert!(rmse("supersampling 256") < 0.25 * rmse("supersampling 16"));
}

#[test]
fn every_scene_runs_under_both_lights_at_one_alpha() {
    for (scene, title) in [
        ("sphere", "sphere"),
        ("torus", "torus"),
        ("mapped-sphere", "sphere: leather"),
        ("strip", "strip"),
        ("disk", "disk"),
    ] {
        let (text, page) = run(scene, &["--scene", scene, "--light", "all", "--alpha", "0.05"]);
        assert_self_contained(&page);
        assert!(page.contains(&format!("<h2>{title}</h2>")), "{title}");
        for light in ["distant light", "point light"] {
            let headings =
                text.lines().filter(|line| line.ends_with(&format!("{light}, alpha 0.05")));
            assert_eq!(headings.count(), 2, "{light} in\n{text}");
        }
        assert!(!text.contains("NaN"), "{text}");
    }
}

#[test]
fn pictures_too_small_to_judge_say_so_with_dashes() {
    let (text, _) = run("tiny", &["--scene", "torus", "--size", "16", "--light", "point"]);
    assert!(text.contains("16 x 9 pixels"));
    assert!(!text.contains("NaN"), "{text}");
}

#[test]
fn a_user_s_map_replaces_the_carried_ones_and_its_name_is_escaped() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let map = folder.join("a&b.png");
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 2, 2);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Sixteen);
    let texel = |x: u8, y: u8| [x, 0, y, 0, 255, 0, 9, 9];
    let data = [texel(128, 128), texel(150, 128), texel(128, 100), texel(110, 140)].concat();
    encoder.write_header().unwrap().write_image_data(&data).unwrap();
    fs::write(&map, file).unwrap();

    let (text, page) = run("map", &["--scene", "plane", "--normal-map", map.to_str().unwrap()]);
    assert_self_contained(&page);
    assert!(text.contains("plane: a&b") && !text.contains("leather"));
    assert!(page.contains("<h2>plane: a&amp;b</h2>"));
}

#[test]
fn minified_maps_have_charts_tables_pictures_and_a_zoom() {
    let folder: PathBuf = Path::new(env!("CARGO_TARGET_TMPDIR")).join("minified");
    let _ = fs::remove_dir_all(&folder);
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/crumpled-paper.png");
    let output = Command::new(env!("CARGO_BIN_EXE_lobe-report"))
        .args(["--quick", "--size", "16", "--scene", "minified", "--normal-map", map, "--out"])
        .arg(&folder)
        .output()
        .unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let page = fs::read_to_string(folder.join("index.html")).unwrap();
    assert_self_contained(&page);
    assert!(text.contains("normal map, minified: crumpled-paper"), "{text}");
    assert!(text.contains("crumpled-paper: a slow zoom") && !text.contains("leather"));
    // For both distributions: over the ratio, at two ratios against time, over the elevation; and
    // one of the zoom.
    for name in ["plain mips", "LEAN, raw moments", "64 samples"] {
        let rows = text.lines().filter(|line| line.starts_with(name)).count();
        assert_eq!(rows, 2 * 4 + 1, "{name}");
    }
    // Both distributions; peaks and their ratios; four measures under two pixels and two figures of
    // Eq. 20.
    assert_eq!(page.matches("<svg").count(), 2 + 2 + 4 * 2 + 2);
    // The reference and five methods at two ratios.
    assert_eq!(page.matches("<img").count(), 2 * 6);
    for wrong in ["NaN", "inf ", "-0."] {
        assert!(!text.contains(wrong), "{wrong} in\n{text}");
    }
    let data = fs::read_to_string(folder.join("report.json")).unwrap();
    assert!(data.contains("\"peak_deviation\"") && data.contains("\"LEAN, base visibility\""));
}

#[test]
fn water_and_mapped_ball_are_shown_in_motion_and_a_user_s_map_on_the_ball() {
    let (text, page) = run("pan", &["--scene", "water", "--size", "48", "--alpha", "0.02"]);
    assert!(text.contains("water, passing by") && !text.contains("turning"), "{text}");
    assert!(text.contains("48 x 27 pixels, 100 % of them judged; GGX, distant light, alpha 0.02."));
    assert_eq!(page.matches("<h2>In motion</h2>").count(), 1);

    let (text, _) = run("turn", &["--scene", "mapped-sphere", "--light", "point", "--size", "16"]);
    assert!(text.contains("sphere: diamond-plate, turning"), "{text}");
    assert!(text.contains("16 x 9 pixels") && text.contains("GGX, point light, alpha 0.01."));
    for wrong in ["NaN", "inf"] {
        assert!(!text.contains(wrong), "{wrong} in\n{text}");
    }

    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/leather.png");
    let (text, _) = run("own", &["--scene", "mapped-sphere", "--normal-map", map]);
    assert!(text.contains("sphere: leather, turning") && !text.contains("diamond"), "{text}");

    let (text, page) = &*TORUS;
    assert!(!text.contains("turning") && !page.contains("In motion"));
}

#[test]
fn relief_has_pictures_tables_and_charts_of_its_own() {
    let (text, page) = run("relief", &["--scene", "relief", "--size", "16"]);
    assert_self_contained(&page);
    assert!(text.contains("LEADR against ray-cast relief") && text.contains("16 x 16 pixels"));
    // Four spheres: mapped, displaced and seven grids; the lamp twice with shadows and twice
    // without.
    assert_eq!(page.matches("<img").count(), 4 * (9 + 4));
    // Three charts, and the figures of filters without a renderer.
    assert_eq!(page.matches("<svg").count(), 3 + 4 * 2 + 2);
    for wrong in ["NaN", "inf "] {
        assert!(!text.contains(wrong) && !words(&page).contains(wrong), "{wrong} in\n{text}");
    }
    let (text, page) = &*TORUS;
    assert!(!text.contains("LEADR") && !page.contains("LEADR"));
}

#[test]
fn glints_have_pictures_tables_and_charts_of_their_own() {
    // The smallest size of all: pictures of facets are wider.
    let (text, page) = run("glints", &["--scene", "glints", "--size", "16"]);
    assert_self_contained(&page);
    assert!(page.contains("<h2>Glints</h2>") && text.contains("\nGlints\n"));
    assert!(page.contains("<h2>Facets</h2>") && text.contains("\nFacets\n"));
    // The hall; of facets a tube, beads and a ball with their differences, lobes, a zoom of two
    // rows.
    assert_eq!(page.matches("<img").count(), 2 + (6 + 6) + (6 + 5) + (4 + 3) + 6 + 2 * 8);
    // Two keys of colors; two charts of cells, two of times, one of variance, four of error against
    // run time; keys of differences, three charts of error against run time, two over facets; and
    // the figures of filters without a renderer.
    assert_eq!(page.matches("<svg").count(), 2 + 2 + 2 + 1 + 4 + (6 + 5 + 3 + 3 + 2) + 4 * 2 + 2);
    // Dictionaries are published, too.
    for (name, rows) in [
        ("snow, 1000, ", 2 * 3),
        ("published", 2 + 4 + 2),
        ("grooves, ", 2 * 3),
        ("mips, s_K", 4),
        ("LEAN with", 4),
    ] {
        let lines = text.lines().filter(|line| line.starts_with(name));
        assert_eq!(lines.count(), rows, "{name} in\n{text}");
    }
    for wrong in ["NaN", "inf ", "-0."] {
        assert!(!text.contains(wrong) && !words(&page).contains(wrong), "{wrong} in\n{text}");
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("glints");
    let data = fs::read_to_string(folder.join("report.json")).unwrap();
    let names = "visited speed operations instructions judged gains ripples contests \
                 tube sweep beads ball lobes zoom memory";
    for name in names.split_whitespace() {
        assert!(data.contains(&format!("\"{name}\": ")), "{name}");
    }
    let (text, page) = &*TORUS;
    assert!(!text.contains("Glints") && !page.contains("Glints"));
}
