//! Pictures of a scene: unfiltered, filtered, as it should be.

use super::escape;
use super::picture::{self, Tone};
use super::table::significant;
use crate::study::{Panel, Row, Study};

/// Width of a column of pictures, as in style.css.
const COLUMN: usize = 560;

/// Radiance on a panel's scale, black where it is not judged.
fn scaled(study: &Study, panel: &Panel, values: impl Iterator<Item = f64>) -> Vec<f64> {
    let pixels = values.zip(&study.judged);
    pixels.map(|(x, judged)| if *judged { x * panel.scale } else { 0.0 }).collect()
}

/// A method's picture of a panel's scene; `None` if it was not kept.
fn picture(study: &Study, panel: &Panel, row: &Row) -> Option<Vec<f64>> {
    Some(scaled(study, panel, row.picture.as_ref()?.iter().map(|&x| f64::from(x))))
}

/// Unfiltered, best filter by RMSE, reference; `None` if they were not kept.
fn kept(study: &Study, panel: &Panel) -> Option<[Vec<f64>; 3]> {
    let reference = scaled(study, panel, panel.reference.as_ref()?.iter().copied());
    let of = |row: &Row| picture(study, panel, row);
    Some([of(panel.plain()?)?, of(panel.best()?)?, reference])
}

/// The picture for the cover: one scene unfiltered, filtered, and as it should be.
pub(crate) struct Cover {
    pub(super) scene: String,
    pub(super) filter: String,
    /// A PNG file.
    pub(crate) file: Vec<u8>,
}

/// Of the scene of whose light, as shown, a filter mends the largest share. `None` without
/// pictures.
pub(super) fn cover(studies: &[Study]) -> Option<Cover> {
    let shown = studies.iter().filter_map(|study| {
        let panel = study.panels.first()?;
        let pictures = kept(study, panel)?;
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
    let caption = "Footprints of 2 \u{d7} 2 differences against analytic ones: area of \
        non-overlap over the larger \
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

/// Unfiltered, best, reference and the difference of the last two; the best by each measure where
/// they differ.
pub(super) fn pictures(study: &Study, panel: &Panel) -> String {
    let (Some([plain, filtered, reference]), Some(best)) = (kept(study, panel), panel.best())
    else {
        return String::new();
    };
    let name = escape(&best.name);
    let difference = filtered.iter().zip(&reference).map(|(x, r)| (x - r).abs()).collect();
    // A lobe that is wide enough for the brightest pixels can be a fog over all others.
    let other = panel.best_by_smape().filter(|other| other.name != best.name);
    let other = other.and_then(|row| Some((row, picture(study, panel, row)?)));
    let title = if other.is_some() { "Best by RMSE" } else { "Best filter" };

    let tone = Tone::of(&reference);
    let mut figures = vec![
        ("No filter, 1 sample per pixel".into(), plain),
        (format!("{title}, {name}, 1 sample per pixel"), filtered),
    ];
    figures.extend(other.map(|(row, picture)| {
        (format!("Best by SMAPE, {}, 1 sample per pixel", escape(&row.name)), picture)
    }));
    figures.push(("Reference".into(), reference));
    figures.push((format!("|{name} \u{2212} reference|"), difference));
    let figures = figures
        .iter()
        .map(|(caption, values)| figure(study, caption, &tone.data_url(study.size, values)));
    format!(
        "<div class=\"pictures\">\n{}{}</div>\n<p class=\"note\">{}, all but the footprints under \
            the same tone \
         curve, 1 \u{2212} exp(\u{2212}kx) in sRGB: the reference\u{2019}s 99th percentile, {} \
         times its mean, \
         is {:.0} % of white. RMSE is decided by the brightest pixels; what a wider lobe adds to \
         dark ones counts in \
         SMAPE.</p>\n",
        figures.collect::<Vec<_>>().concat(),
        footprints(study),
        panel.distribution.name(),
        significant(tone.bright),
        100.0 * picture::WHITE,
    )
}

#[cfg(test)]
mod tests {
    use super::pictures;
    use crate::camera::Size;
    use crate::light::LightKind;
    use crate::method;
    use crate::reference::Sampling;
    use crate::scene::Subject;
    use crate::study::{Effort, Study};

    #[test]
    fn the_best_by_smape_has_a_picture_of_its_own_where_it_is_another_method() {
        let effort = Effort {
            width: 16,
            sampling: Sampling::of_frame(16),
            rounds: 1,
            lights: vec![LightKind::Distant],
            alphas: vec![0.05],
        };
        let subject = Subject::water(Size::of_width(effort.width));
        let mut study = Study::run(subject, &method::all(), &effort, &|_| ()).unwrap();
        let mut shown = |rmse: f64, smape: f64| {
            let rows = &mut study.panels[0].rows;
            let row = rows.iter_mut().find(|row| row.name == "rectangle").unwrap();
            (row.errors.rmse, row.errors.smape) = (rmse, smape);
            pictures(&study, &study.panels[0])
        };
        // Nothing is below zero but what is put there.
        let one = shown(-1.0, -1.0);
        assert!(one.contains("<figcaption>Best filter, rectangle,") && !one.contains("Best by"));
        let two = shown(9.0, -1.0);
        assert!(two.contains("<figcaption>Best by SMAPE, rectangle,"));
        assert!(two.contains("<figcaption>Best by RMSE,") && !two.contains("Best filter"));
        assert_eq!([&one, &two].map(|html| html.matches("<img").count()), [5, 6]);
    }
}
