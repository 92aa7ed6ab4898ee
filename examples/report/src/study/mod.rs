//! One scene under its lights, all alphas, all methods: pictures, errors, times.

mod panel;

use lobe::Error;
use serde::Serialize;

use crate::camera::Size;
use crate::coverage;
use crate::footprints::{Disagreement, counted};
use crate::frontier::{Frontier, Point, pareto};
use crate::light::LightKind;
use crate::method::{Derivatives, Distribution, Method, Surfacing, Tally};
use crate::metric::{Errors, scale};
use crate::reference::{Reference, References, Sampling, Target};
use crate::render::{Pictures, render};
use crate::scene::Subject;
use crate::timing::{self, Timing};
use crate::window::{MARGIN, PixelWindow};

pub(crate) use panel::{Panel, Row};

/// Width of a quick run's pictures.
pub const QUICK_WIDTH: usize = 240;

/// Samples per pixel of a quick run's references, to deal out by need.
pub(crate) const QUICK_SAMPLES: u32 = 192;

/// What a run does to every scene.
#[derive(Clone)]
pub(crate) struct Effort {
    /// Width of the pictures, if the user does not say.
    pub(crate) width: usize,
    pub(crate) sampling: Sampling,
    /// Timed passes per method.
    pub(crate) rounds: usize,
    /// Lights, the one of the pictures first.
    pub(crate) lights: Vec<LightKind>,
    /// Roughness of the material along its smoother axis, increasing.
    pub(crate) alphas: Vec<f64>,
}

/// A scene's results.
#[derive(Serialize)]
pub(crate) struct Study {
    pub(crate) name: String,
    pub(crate) caption: String,
    pub(crate) size: Size,
    /// The pixels that errors count, rows from the top.
    #[serde(skip)]
    pub(crate) judged: Vec<bool>,
    /// Nanoseconds of geometry per sample.
    pub(crate) geometry: f64,
    /// Nanoseconds per sample that motions take on top.
    pub(crate) motion: f64,
    /// Samples per pixel of the first light's references.
    pub(crate) reference_samples: f64,
    /// Quads' footprints against analytic ones, under the first light.
    pub(crate) disagreement: Option<Disagreement>,
    /// By light, then alpha, then distribution; the first one has pictures.
    pub(crate) panels: Vec<Panel>,
}

impl Study {
    /// The part of the picture that is judged.
    pub(crate) fn judged_part(&self) -> f64 {
        let count = self.judged.iter().filter(|judged| **judged).count();
        count as f64 / self.size.pixels() as f64
    }
}

/// Steps of progress that one study reports: its rows, for the references and for every method.
pub(crate) fn steps(size: Size, methods: usize, effort: &Effort) -> u64 {
    let rows = size.height * methods * effort.alphas.len();
    let reference = size.grown(MARGIN).height * REFERENCE_WEIGHT;
    (effort.lights.len() * (rows + reference)) as u64
}

/// A reference row counts as this many rows of a method.
const REFERENCE_WEIGHT: usize = 120;

impl Study {
    /// Renders, measures and compares; calls `progress` with the steps done.
    pub(crate) fn run(
        subject: Subject,
        methods: &[Method],
        effort: &Effort,
        progress: &(impl Fn(u64) + Sync),
    ) -> Result<Self, Error> {
        let (size, finish) = (subject.size, subject.finish);
        let materials: Vec<_> = effort
            .alphas
            .iter()
            .map(|&alpha| Surfacing::new(finish, alpha))
            .collect::<Result<_, _>>()?;
        let distant = subject.lit(LightKind::Distant);
        let judged = coverage::judged(&distant.exact, size);

        // Timed first, while no other thread of ours runs.
        let timed: Vec<_> = methods.iter().filter(|method| method.samples == 1).collect();
        let material = materials.first().ok_or(Error::Length { expected: 1, found: 0 })?;
        let timing =
            timing::measure(&distant.engine, size, &judged, material, &timed, effort.rounds);
        let alpha =
            effort.alphas.first().copied().ok_or(Error::Length { expected: 1, found: 0 })?;
        let counted = counted(&distant.engine, size, &judged, alpha)?;
        let costs: Vec<_> =
            methods.iter().map(|m| cost_of(m, &timed, &timing, m.count(&counted))).collect();

        let (mut panels, mut disagreement, mut reference_samples) = (Vec::new(), None, 0.0);
        for &light in &effort.lights {
            let lit = subject.lit(light);
            let alphas = &effort.alphas;
            let target = Target { scene: &lit.exact, size, finish, alphas, judged: &judged };
            let row_done = || progress(REFERENCE_WEIGHT as u64);
            let references = effort.sampling.render(&target, &row_done)?;
            let rows_done = |rows: usize| progress((rows * methods.len() * alphas.len()) as u64);
            let pictures = render(&lit.engine, size, &materials, methods, &rows_done);
            let shown = panels.is_empty();
            if shown {
                disagreement = Disagreement::on(&lit.engine, size, &judged);
                reference_samples = references.samples;
            }
            let under = Under { light, alphas, methods, costs: &costs, judged: &judged };
            panels.extend(under.panels(&references, pictures, shown));
        }
        Ok(Self {
            name: subject.name,
            caption: subject.caption,
            size,
            judged,
            geometry: timing.geometry,
            motion: timing.motion,
            reference_samples,
            disagreement,
            panels,
        })
    }
}

/// What a method costs: nanoseconds of shading per sample and per pixel, operations of shading.
struct Cost {
    shading: f64,
    pixel: f64,
    operations: Tally,
}

/// Of a method; supersampling repeats the plain shading of its distribution.
fn cost_of(method: &Method, timed: &[&Method], timing: &Timing, operations: Tally) -> Cost {
    let same = |other: &&Method| {
        other.distribution == method.distribution
            && other.derivatives == method.derivatives
            && (!method.filters() || other.name == method.name)
    };
    let shading = timed.iter().position(same).map_or(f64::NAN, |index| timing.shading[index]);
    let motion = if method.derivatives == Derivatives::Analytic { timing.motion } else { 0.0 };
    let pixel = f64::from(method.samples) * (timing.geometry + motion + shading);
    Cost { shading, pixel, operations }
}

/// What the panels under one light have in common.
struct Under<'a> {
    light: LightKind,
    alphas: &'a [f64],
    methods: &'a [Method],
    costs: &'a [Cost],
    judged: &'a [bool],
}

impl Under<'_> {
    /// The panels of every alpha and distribution; the first one keeps its pictures if it is
    /// `shown`.
    fn panels(&self, references: &References, pictures: Pictures, shown: bool) -> Vec<Panel> {
        let mut panels = Vec::new();
        for (index, mut pictures) in pictures.into_iter().enumerate() {
            for distribution in Distribution::ALL {
                let shown = shown && panels.is_empty();
                let reference = references.of(index, distribution);
                let alpha = self.alphas[index];
                panels.push(self.panel(alpha, distribution, reference, &mut pictures, shown));
            }
        }
        panels
    }

    fn panel(
        &self,
        alpha: f64,
        distribution: Distribution,
        reference: &Reference,
        pictures: &mut [Vec<f32>],
        shown: bool,
    ) -> Panel {
        let of_box = &reference.radiance[PixelWindow::Box as usize];
        let scale = scale(of_box, self.judged);
        let methods = self.methods.iter().zip(self.costs).zip(pictures);
        let mut rows: Vec<_> = methods
            .filter(|((method, _), _)| method.distribution == distribution)
            .map(|((method, cost), picture)| {
                let against = |reference| Errors::of(picture, reference, self.judged, scale);
                Row {
                    name: method.name.clone(),
                    family: method.family,
                    derivatives: method.derivatives,
                    samples: method.samples,
                    filters: method.filters(),
                    window: method.window,
                    errors: against(&reference.radiance[method.window as usize]),
                    box_errors: against(of_box),
                    shading: cost.shading,
                    pixel: cost.pixel,
                    operations: cost.operations,
                    pareto: false,
                    equal_samples: None,
                    speed_up: None,
                    picture: shown.then(|| core::mem::take(picture)),
                }
            })
            .collect();
        compare(&mut rows);
        Panel {
            light: self.light,
            alpha,
            distribution,
            scale,
            noise: reference.noise.map(|noise| noise * scale),
            reference: shown.then(|| of_box.clone()),
            rows,
        }
    }
}

/// Fills in what rows are worth against each other: the front, and what supersampling pays for the
/// same error.
fn compare(rows: &mut [Row]) {
    let points: Vec<_> = rows.iter().map(Row::point).collect();
    let front = pareto(&points);
    rows.iter_mut().zip(front).for_each(|(row, pareto)| row.pareto = pareto);
    let line = |cost: fn(&Row) -> f64| {
        let plain = rows.iter().filter(|row| !row.filters);
        Frontier(plain.map(|row| Point { cost: cost(row), error: row.errors.rmse }).collect())
    };
    let (time, samples) = (line(|row| row.pixel), line(|row| f64::from(row.samples)));
    for row in rows.iter_mut().filter(|row| row.filters) {
        row.equal_samples = samples.price(row.errors.rmse);
        row.speed_up = time.price(row.errors.rmse).map(|price| price.over(row.pixel));
    }
}
