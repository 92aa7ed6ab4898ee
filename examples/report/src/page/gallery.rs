//! Pictures of a scene: unfiltered, filtered, as it should be.

use super::escape;
use super::picture::{self, Tone};
use super::table::significant;
use crate::study::{Panel, Row, Study};

/// Width of a column of pictures, as in style.css.
const COLUMN: usize = 560;

/// Pictures of a panel on its scale, black where it is not judged: unfiltered, best filter, reference. `None`
/// if they were not kept.
fn scaled_pictures(study: &Study, panel: &Panel) -> Option<[Vec<f64>; 3]> {
    let scaled = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
        let pixels = values.zip(&study.judged);
        pixels.map(|(x, judged)| if *judged { x * panel.scale } else { 0.0 }).collect()
    };
    let picture = |row: &Row| -> Option<Vec<f64>> {
        Some(scaled(&mut row.picture.as_ref()?.iter().map(|&x| f64::from(x))))
    };
    let reference = scaled(&mut panel.reference.as_ref()?.iter().copied());
    Some([picture(panel.plain()?)?, picture(panel.best()?)?, reference])
}

/// The picture for the cover: one scene unfiltered, filtered, and as it should be.
pub(crate) struct Cover {
    pub(super) scene: String,
    pub(super) filter: String,
    /// A PNG file.
    pub(crate) file: Vec<u8>,
}

/// Of the scene of whose light, as shown, a filter mends the largest share. `None` without pictures.
pub(super) fn cover(studies: &[Study]) -> Option<Cover> {
    let shown = studies.iter().filter_map(|study| {
        let panel = study.panels.first()?;
        let pictures = scaled_pictures(study, panel)?;
        let tone = Tone::of(&pictures[2]);
        let [plain, best] = [0, 1].map(|n| tone.difference(study.size, &pictures[n], &pictures[2]));
        Some((plain - best, study, panel.best()?, tone, pictures))
    });
    let (_, study, best, tone, pictures) = shown.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let file = tone.strip(study.size, &pictures.each_ref().map(Vec::as_slice));
    Some(Cover { scene: study.name.clone(), filter: best.name.clone(), file })
}

/// Where quads and analytic derivatives disagree: Kaplanyan et al. 2016, Fig. 7.
fn footprints(study: &Study) -> String {
    let Some(footprints) = &study.disagreement else { return String::new() };
    let caption = "Footprints of 2 \u{d7} 2 differences against analytic ones: area of non-overlap over the larger \
                   area; black is none, white all of it (Kaplanyan et al. 2016, Fig. 7)";
    figure(study, caption, &picture::linear(study.size, &footprints.map))
}

/// A picture of a scene with its caption.
fn figure(study: &Study, caption: &str, url: &str) -> String {
    let scene = escape(&study.name);
    // Whole multiples keep pixels square and of one size.
    let zoom = (COLUMN / study.size.width).max(1);
    format!(
        "<figure><img alt=\"{scene}: {caption}\" width=\"{}\" height=\"{}\" src=\"{url}\">\
         <figcaption>{caption}</figcaption></figure>\n",
        zoom * study.size.width,
        zoom * study.size.height,
    )
}

/// Unfiltered, best, reference and the difference of the last two.
pub(super) fn pictures(study: &Study, panel: &Panel) -> String {
    let (Some([plain, filtered, reference]), Some(best)) =
        (scaled_pictures(study, panel), panel.best())
    else {
        return String::new();
    };
    let difference: Vec<_> = filtered.iter().zip(&reference).map(|(x, r)| (x - r).abs()).collect();
    let name = escape(&best.name);

    let tone = Tone::of(&reference);
    let figures = [
        ("No filter, 1 sample per pixel".into(), &plain),
        (format!("Best filter, {name}, 1 sample per pixel"), &filtered),
        ("Reference".into(), &reference),
        (format!("|{name} \u{2212} reference|"), &difference),
    ];
    let figures = figures
        .map(|(caption, values)| figure(study, &caption, &tone.data_url(study.size, values)));
    format!(
        "<div class=\"pictures\">\n{}{}</div>\n<p class=\"note\">{}, the first four under the same tone curve, \
         1 \u{2212} exp(\u{2212}kx) in sRGB: the reference\u{2019}s 99th percentile, {} times its mean, \
         is {:.0} % of white. Best is by RMSE, which the brightest pixels decide; what a wider lobe adds to dark ones is seen \
         here, and in SMAPE.</p>\n",
        figures.concat(),
        footprints(study),
        panel.distribution.name(),
        significant(tone.bright),
        100.0 * picture::WHITE,
    )
}
