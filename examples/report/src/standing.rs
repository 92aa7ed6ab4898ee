//! What methods are worth over all scenes, and the advice that follows.

use serde::Serialize;

use crate::frontier::{Point, pareto};
use crate::method::{Derivatives, Distribution, Family, Tally};
use crate::study::{Panel, Row, Study};

/// A method over all panels of one distribution and alpha.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Standing {
    pub(crate) name: String,
    pub(crate) family: Family,
    pub(crate) derivatives: Derivatives,
    /// Geometric mean over the panels of its RMSE over that of no filter, each against the method's
    /// own window.
    pub(crate) ratio: f64,
    /// The same against the box.
    pub(crate) box_ratio: f64,
    /// The same of SMAPE, which weighs dark pixels as bright ones.
    pub(crate) smape_ratio: f64,
    /// The largest ratio, and where.
    pub(crate) worst: f64,
    pub(crate) worst_scene: String,
    /// Mean nanoseconds per pixel, and of shading per sample.
    pub(crate) pixel: f64,
    pub(crate) shading: f64,
    /// Mean operations of shading per sample.
    pub(crate) operations: Tally,
    /// No other method has both a smaller ratio and a smaller time per pixel.
    pub(crate) pareto: bool,
}

/// One line of advice: which method, for whom, and what it did in this run.
#[derive(Debug, Serialize)]
pub(crate) struct Advice {
    pub(crate) situation: &'static str,
    pub(crate) alpha: f64,
    pub(crate) standing: Standing,
    /// Nanoseconds of shading per sample over those of no filter.
    pub(crate) cost: f64,
}

/// The methods of one distribution at one alpha over the panels of all studies and lights, in their
/// order. Empty without panels.
pub(crate) fn standings(
    studies: &[Study],
    distribution: Distribution,
    alpha: f64,
) -> Vec<Standing> {
    let panels: Vec<(&Study, &Panel)> = studies
        .iter()
        .flat_map(|study| study.panels.iter().map(move |panel| (study, panel)))
        .filter(|(_, panel)| {
            panel.distribution == distribution && panel.alpha.total_cmp(&alpha).is_eq()
        })
        .collect();
    let Some((_, first)) = panels.first() else { return Vec::new() };
    let mut standings: Vec<_> =
        (0..first.rows.len()).map(|index| standing(&panels, index)).collect();
    let points: Vec<_> =
        standings.iter().map(|s| Point { cost: s.pixel, error: s.ratio }).collect();
    standings.iter_mut().zip(pareto(&points)).for_each(|(standing, front)| standing.pareto = front);
    standings
}

/// The method of a row's index over panels that have the same methods.
fn standing(panels: &[(&Study, &Panel)], index: usize) -> Standing {
    let count = panels.len() as f64;
    let over_plain = |panel: &Panel, error: fn(&Row) -> f64| {
        error(&panel.rows[index]) / panel.plain().map_or(f64::NAN, error)
    };
    let geometric_mean = |error: fn(&Row) -> f64| {
        let logs = panels.iter().map(|(_, panel)| over_plain(panel, error).ln());
        (logs.sum::<f64>() / count).exp()
    };
    let (mut worst, mut worst_scene) = (0.0, "");
    let (mut pixel, mut shading, mut operations) = (0.0, 0.0, Tally::default());
    for (study, panel) in panels {
        let row = &panel.rows[index];
        let ratio = over_plain(panel, |row| row.errors.rmse);
        if ratio > worst {
            (worst, worst_scene) = (ratio, &study.name);
        }
        pixel += row.pixel / count;
        shading += row.shading / count;
        operations = operations.plus(&row.operations, 1.0 / count);
    }
    let Row { name, family, derivatives, .. } = &panels[0].1.rows[index];
    Standing {
        name: name.clone(),
        family: *family,
        derivatives: *derivatives,
        ratio: geometric_mean(|row| row.errors.rmse),
        box_ratio: geometric_mean(|row| row.box_errors.rmse),
        smape_ratio: geometric_mean(|row| row.errors.smape),
        worst,
        worst_scene: worst_scene.to_owned(),
        pixel,
        shading,
        operations,
        pareto: false,
    }
}

/// Advice for GGX, derived from the standings at the smallest and the largest alpha.
pub(crate) fn advice(studies: &[Study], alphas: &[f64]) -> Vec<Advice> {
    let (Some(&smallest), Some(&largest)) = (alphas.first(), alphas.last()) else {
        return Vec::new();
    };
    let smooth = standings(studies, Distribution::Ggx, smallest);
    let in_quads = |s: &Standing| s.derivatives == Derivatives::Quad;
    let of = |family: Family| move |s: &Standing| s.family == family && in_quads(s);
    let filters = |s: &Standing| matches!(s.family, Family::Widened | Family::Area);
    let mean = |s: &Standing| s.ratio;
    let smallest_error = least(&smooth, |s| filters(s) && in_quads(s), mean);
    let lines: [(&str, Option<&Standing>); 6] = [
        ("Forward shading with quads, the smallest error", smallest_error),
        (
            "The same, and a lobe must come out: many lights, area lights, sampling",
            least(&smooth, of(Family::Widened), mean),
        ),
        (
            "The same, and no scene may go wrong: smallest worst case",
            // Unless it is the one above.
            least(&smooth, |s| filters(s) && in_quads(s), |s| s.worst)
                .filter(|safest| smallest_error.is_none_or(|best| best.name != safest.name)),
        ),
        (
            "Positions and curvature are known: ray tracing, compute, offline",
            least(&smooth, |s| s.derivatives == Derivatives::Analytic, mean),
        ),
        ("Before the light is known: a G-buffer", least(&smooth, of(Family::Deferred), mean)),
        ("What engines ship, the best of it", least(&smooth, of(Family::Engine), mean)),
    ];
    let mut advice: Vec<_> = lines
        .into_iter()
        .filter_map(|(situation, best)| Some(line(situation, smallest, best?, &smooth)))
        .collect();
    let beckmann = standings(studies, Distribution::Beckmann, smallest);
    let best = least(&beckmann, in_quads, mean);
    advice.extend(best.map(|best| line("Beckmann in place of GGX", smallest, best, &beckmann)));
    if largest > smallest {
        let rough = standings(studies, Distribution::Ggx, largest);
        let best = least(&rough, |s| s.family != Family::Supersampling && in_quads(s), mean);
        advice.extend(best.map(|best| line("Rough materials", largest, best, &rough)));
    }
    advice
}

fn least(
    standings: &[Standing],
    eligible: impl Fn(&Standing) -> bool,
    measure: impl Fn(&Standing) -> f64,
) -> Option<&Standing> {
    let eligible = standings.iter().filter(|standing| eligible(standing));
    eligible.min_by(|a, b| measure(a).total_cmp(&measure(b)))
}

fn line(situation: &'static str, alpha: f64, best: &Standing, all: &[Standing]) -> Advice {
    let plain = all.first().map_or(0.0, |plain| plain.shading);
    Advice { situation, alpha, standing: best.clone(), cost: best.shading - plain }
}

#[cfg(test)]
mod tests {
    use super::{Standing, least};
    use crate::method::{Derivatives, Family, Tally};

    fn standing(name: &str, ratio: f64, worst: f64) -> Standing {
        Standing {
            name: name.into(),
            family: Family::Widened,
            derivatives: Derivatives::Quad,
            ratio,
            box_ratio: ratio,
            smape_ratio: ratio,
            worst,
            worst_scene: String::new(),
            pixel: 1.0,
            shading: 1.0,
            operations: Tally::default(),
            pareto: false,
        }
    }

    #[test]
    fn the_least_is_taken_of_the_eligible() {
        let all = [standing("a", 0.1, 9.0), standing("b", 0.2, 0.5), standing("c", 0.05, 20.0)];
        let name = |best: Option<&Standing>| best.map(|s| s.name.clone());
        assert_eq!(name(least(&all, |_| true, |s| s.ratio)), Some("c".into()));
        assert_eq!(name(least(&all, |_| true, |s| s.worst)), Some("b".into()));
        assert_eq!(name(least(&all, |s| s.name != "c", |s| s.ratio)), Some("a".into()));
        assert_eq!(name(least(&all, |_| false, |s| s.ratio)), None);
    }
}
