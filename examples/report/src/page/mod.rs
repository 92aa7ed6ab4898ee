//! The report: one self-contained HTML page, and the same tables as text.

mod axis;
mod chart;
mod colors;
mod facets;
mod gallery;
mod glints;
mod grid;
mod kernels;
mod measure;
mod minify;
mod overall;
mod part;
mod picture;
mod plot;
mod proxy;
mod relief;
mod section;
mod sequence;
mod sizes;
mod spheres;
mod table;
mod zoom;

use serde::Serialize;

use crate::facets::Facets;
use crate::glints::Glitter;
use crate::kernels::Kernels;
use crate::method::{Distribution, Method};
use crate::minify::Minified;
use crate::relief::Relief;
use crate::sequence::Sequence;
use crate::sizes::Sizes;
use crate::standing::{Advice, Standing, advice, standings};
use crate::study::{Effort, Panel, Row, Study};
use crate::timing;
use section::{equal_samples, equal_time};
use table::{Line, Table, significant};

pub(crate) use gallery::Cover;
pub(crate) use minify::text as minified_text;
pub(crate) use picture::Tone;
pub(crate) use section::text;
pub(crate) use sequence::text as sequence_text;

/// Everything the page shows.
pub(crate) struct Report {
    effort: Effort,
    processor: String,
    pub(crate) kernels: Kernels,
    sizes: Sizes,
    pub(crate) studies: Vec<Study>,
    pub(crate) sequences: Vec<Sequence>,
    pub(crate) relief: Option<Relief>,
    pub(crate) glints: Option<Glitter>,
    pub(crate) facets: Option<Facets>,
    pub(crate) minified: Vec<Minified>,
}

impl Report {
    pub(crate) fn new(effort: Effort, kernels: Kernels, sizes: Sizes) -> Self {
        Self {
            effort,
            processor: timing::processor(),
            kernels,
            sizes,
            studies: Vec::new(),
            sequences: Vec::new(),
            relief: None,
            glints: None,
            facets: None,
            minified: Vec::new(),
        }
    }

    /// The filters without a renderer, as text.
    pub(crate) fn kernels_text(&self) -> String {
        kernels::text(&self.kernels)
    }

    /// LEADR against rays, as text; empty if it was not asked for.
    pub(crate) fn relief_text(&self) -> String {
        self.relief.as_ref().map(relief::text).unwrap_or_default()
    }

    /// Glints, as text; empty if they were not asked for.
    pub(crate) fn glints_text(&self) -> String {
        self.glints.as_ref().map(glints::text).unwrap_or_default()
    }

    /// Facets, as text; empty if they were not asked for.
    pub(crate) fn facets_text(&self) -> String {
        self.facets.as_ref().map(facets::text).unwrap_or_default()
    }

    /// The shaders' sizes, as text.
    pub(crate) fn sizes_text(&self) -> String {
        sizes::text(&self.sizes)
    }

    /// One line per scene and distribution: the best filter, its cost and what it saves; then what
    /// the cover shows.
    pub(crate) fn summary_text(&self, cover: Option<&Cover>) -> String {
        let rows = self.findings().map(|(study, panel, best)| Line {
            cells: vec![
                format!("{}, {}", study.name, panel.distribution.name()),
                best.name.clone(),
                significant(best.errors.rmse),
                significant(best.pixel),
                equal_samples(best),
                equal_time(best),
            ],
            class: "",
        });
        let headers =
            &["Scene", "Best filter", "RMSE", "ns per pixel", "Equal samples", "Equal time"];
        let table = Table { headers, rows: rows.collect() };
        let cover = cover.map(|cover| {
            format!("Cover: {}, without a filter, with {}, reference.\n", cover.scene, cover.filter)
        });
        format!("\n{}{}\n{}", table.text(), self.conditions(), cover.unwrap_or_default())
    }

    /// What to use when, as text.
    pub(crate) fn advice_text(&self) -> String {
        let standings = overall::standings_table(&self.standings()).text();
        let advice = overall::advice_table(&self.advice()).text();
        format!(
            "\nAll methods over all scenes, GGX, alpha {}\n{standings}\nWhat to use \
                when\n{advice}{}\n",
            self.alpha(),
            overall::ADVICE_NOTE,
        )
    }

    fn alpha(&self) -> f64 {
        self.effort.alphas.first().copied().unwrap_or_default()
    }

    /// GGX over all scenes at the smallest alpha.
    pub(crate) fn standings(&self) -> Vec<Standing> {
        standings(&self.studies, Distribution::Ggx, self.alpha())
    }

    pub(crate) fn advice(&self) -> Vec<Advice> {
        advice(&self.studies, &self.effort.alphas)
    }

    /// The scene that a filter mends most, without one, with the best, and as it should be.
    pub(crate) fn cover(&self) -> Option<Cover> {
        gallery::cover(&self.studies)
    }

    /// What to use when, as a table for README.
    pub(crate) fn advice_markdown(&self) -> String {
        overall::advice_table(&self.advice()).markdown()
    }

    /// Everything that was measured, for programs.
    pub(crate) fn json(&self) -> Result<Vec<u8>, String> {
        let data = Data {
            program: concat!("lobe-report ", env!("CARGO_PKG_VERSION")),
            processor: &self.processor,
            alphas: &self.effort.alphas,
            advice: self.advice(),
            standings: self.standings(),
            studies: &self.studies,
            sequences: &self.sequences,
            minified: &self.minified,
            kernels: &self.kernels,
            relief: self.relief.as_ref(),
            glints: self.glints.as_ref(),
            facets: self.facets.as_ref(),
            shaders: &self.sizes,
        };
        serde_json::to_vec_pretty(&data).map_err(|error| format!("report.json: {error}"))
    }

    /// The page.
    pub(crate) fn html(&self, methods: &[Method]) -> String {
        let sections: Vec<_> = self.studies.iter().map(section::html).collect();
        let [front, back] = overall::html(&self.advice(), &self.standings(), self.alpha());
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>lobe: error against run time</title>\n<style>\n{}</style>\n</head>\n<body>\n\
             <h1>Error against run time</h1>\n\
             <p class=\"lead\">Specular filters at one sample per pixel against plain \
             supersampling, \
             plots at alpha = {}. The large number is how much longer supersampling takes to \
             reach the best \
             filter\u{2019}s error.</p>\n\
             {front}{}{back}{}{}{}{}{}{}{}{}{}</body>\n</html>\n",
            include_str!("style.css"),
            self.alpha(),
            self.summary(),
            sections.concat(),
            sequence::html(&self.sequences),
            minify::html(&self.minified),
            self.relief.as_ref().map(relief::html).unwrap_or_default(),
            self.glints.as_ref().map(glints::html).unwrap_or_default(),
            self.facets.as_ref().map(facets::html).unwrap_or_default(),
            kernels::html(&self.kernels),
            sizes::html(&self.sizes),
            self.explanation(methods),
        )
    }

    /// Each study's best filters under the first light at the smallest alpha.
    fn findings(&self) -> impl Iterator<Item = (&Study, &Panel, &Row)> {
        let leading = |study| section::leading(study).iter();
        let panels = self.studies.iter().flat_map(move |s| leading(s).map(move |p| (s, p)));
        panels.filter_map(|(study, panel)| Some((study, panel, panel.best()?)))
    }

    /// Cards at the top of the page, of GGX.
    fn summary(&self) -> String {
        let ggx = self.findings().filter(|(_, panel, _)| panel.distribution == Distribution::Ggx);
        let cards = ggx.map(|(study, panel, best)| {
            let plain = panel.plain().map_or(f64::NAN, |row| row.errors.rmse);
            format!(
                "<li><span class=\"where\">{}</span><span class=\"factor\">{}</span>\
                 <span class=\"how\"><b>{}</b><br>the error of {} samples<br>in {} ns per pixel<br>\
                 RMSE {}<br>unfiltered {}</span></li>\n",
                escape(&study.name),
                equal_time(best),
                escape(&best.name),
                equal_samples(best),
                significant(best.pixel),
                significant(best.errors.rmse),
                significant(plain),
            )
        });
        format!(
            "<ul class=\"summary\">\n{}</ul>\n<p class=\"note\">{}</p>\n",
            cards.collect::<Vec<_>>().concat(),
            escape(&self.conditions()),
        )
    }

    /// What the numbers hold for.
    fn conditions(&self) -> String {
        format!(
            "Timed in this run on one thread of: {}. Times compare within one run only.",
            self.processor,
        )
    }

    /// How it was measured, and the methods with their sources.
    fn explanation(&self, methods: &[Method]) -> String {
        let rows = methods.iter().filter(|m| m.filters() || m.samples == 1).map(|m| Line {
            cells: vec![
                if m.filters() { m.name.clone() } else { "none, supersampling".into() },
                m.distribution.name().into(),
                m.window.name().into(),
                m.source.into(),
                m.note.into(),
            ],
            class: "",
        });
        let headers = &["Method", "NDF", "Pixel filter", "Source", "What it does"];
        let table = Table { headers, rows: rows.collect() };
        let rounds = self.effort.rounds.to_string();
        format!(
            "{}<h3>Methods</h3>\n<div class=\"methods\">{}</div>\n",
            include_str!("explanation.html").replace("{rounds}", &rounds),
            table.html(),
        )
    }
}

/// The results as they are written to report.json. Numbers that are not finite become null.
#[derive(Serialize)]
struct Data<'a> {
    program: &'static str,
    processor: &'a str,
    alphas: &'a [f64],
    advice: Vec<Advice>,
    /// GGX at the smallest alpha, over all scenes and lights.
    standings: Vec<Standing>,
    studies: &'a [Study],
    sequences: &'a [Sequence],
    minified: &'a [Minified],
    kernels: &'a Kernels,
    relief: Option<&'a Relief>,
    glints: Option<&'a Glitter>,
    facets: Option<&'a Facets>,
    shaders: &'a Sizes,
}

/// Text for HTML, in elements and in quoted attributes.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            _ => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn names_of_files_cannot_break_the_page() {
        assert_eq!(escape("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
    }
}
