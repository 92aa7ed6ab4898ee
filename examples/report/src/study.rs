//! One scene, all methods: pictures, errors, times.

use lobe::Error;

use crate::camera::Size;
use crate::frontier::{Frontier, Point, Price};
use crate::method::{Distribution, Material, Method};
use crate::metric::{Errors, scale};
use crate::reference::{Reference, Sampling};
use crate::render::render;
use crate::scene::Subject;
use crate::timing::{self, Timing};

/// How much work a run does.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    /// Width of the pictures, if the user does not say.
    pub(crate) width: usize,
    pub(crate) sampling: Sampling,
    /// Timed passes per method.
    pub(crate) rounds: usize,
}

impl Effort {
    pub(crate) const QUICK: Self =
        Self { width: 240, sampling: Sampling { samples: 384 }, rounds: 101 };
    pub(crate) const FULL: Self =
        Self { width: 560, sampling: Sampling { samples: 1024 }, rounds: 301 };
}

/// One method's line of the table.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) samples: u32,
    pub(crate) filters: bool,
    pub(crate) errors: Errors,
    /// Nanoseconds of shading per sample, footprint differences included.
    pub(crate) shading: f64,
    /// Nanoseconds per pixel: samples times geometry and shading.
    pub(crate) pixel: f64,
    /// Samples that plain supersampling needs for the same RMSE; of filters only.
    pub(crate) equal_samples: Option<Price>,
    /// Its time over this method's, at the same RMSE; of filters only.
    pub(crate) speed_up: Option<Price>,
    /// Radiance, unscaled.
    pub(crate) picture: Vec<f32>,
}

impl Row {
    /// Nanoseconds per pixel and error.
    pub(crate) fn point(&self) -> Point {
        Point { cost: self.pixel, error: self.errors.rmse }
    }
}

/// All methods of one distribution on one scene.
pub(crate) struct Panel {
    pub(crate) distribution: Distribution,
    /// Brings radiance to a mean reference of 1.
    pub(crate) scale: f64,
    /// The reference's standard error on that scale.
    pub(crate) noise: f64,
    pub(crate) reference: Vec<f64>,
    pub(crate) rows: Vec<Row>,
}

impl Panel {
    /// The filter with the smallest RMSE.
    pub(crate) fn best(&self) -> Option<&Row> {
        let filters = self.rows.iter().filter(|row| row.filters);
        filters.min_by(|a, b| a.errors.rmse.total_cmp(&b.errors.rmse))
    }

    /// The row of one plain sample.
    pub(crate) fn plain(&self) -> Option<&Row> {
        self.rows.iter().find(|row| !row.filters && row.samples == 1)
    }

    /// The reference's noise over the best filter's RMSE, and over the smallest of all rows.
    pub(crate) fn noise_ratios(&self) -> [f64; 2] {
        let over = |error: f64| if error > 0.0 { self.noise / error } else { 0.0 };
        let least = self.rows.iter().map(|row| row.errors.rmse).fold(f64::INFINITY, f64::min);
        [over(self.best().map_or(least, |row| row.errors.rmse)), over(least)]
    }

    /// Filters that one plain sample beats.
    pub(crate) fn worse_than_plain(&self) -> impl Iterator<Item = &Row> {
        let plain = self.plain().map_or(f64::INFINITY, |row| row.errors.rmse);
        self.rows.iter().filter(move |row| row.filters && row.errors.rmse > plain)
    }
}

/// A scene's results.
pub(crate) struct Study {
    pub(crate) name: String,
    pub(crate) caption: String,
    pub(crate) size: Size,
    /// Nanoseconds of geometry per sample.
    pub(crate) geometry: f64,
    pub(crate) panels: Vec<Panel>,
}

/// Steps of progress that one study reports: its rows, for the reference and for every method.
pub(crate) fn steps(size: Size, methods: usize) -> u64 {
    (size.height * (methods + REFERENCE_WEIGHT)) as u64
}

/// A reference row counts as this many rows of a method.
const REFERENCE_WEIGHT: usize = 40;

impl Study {
    /// Renders, measures and compares; calls `progress` with the steps done.
    pub(crate) fn run(
        subject: Subject,
        alpha: f64,
        methods: &[Method],
        effort: Effort,
        progress: &(impl Fn(u64) + Sync),
    ) -> Result<Self, Error> {
        let material = Material::new(alpha)?;
        let Subject { name, caption, size, engine, exact } = subject;

        // Timed first, while no other thread of ours runs.
        let timed: Vec<_> = methods.iter().filter(|method| method.samples == 1).collect();
        let timing = timing::measure(&engine, size, &material, &timed, effort.rounds);
        let shading_of = |method: &Method| shading_time(method, &timed, &timing);

        let row_done = || progress(REFERENCE_WEIGHT as u64);
        let references = effort.sampling.render(&exact, size, alpha, &row_done)?;

        let panels = Distribution::ALL.map(|distribution| {
            let pictures: Vec<_> = methods
                .iter()
                .filter(|method| method.distribution == distribution)
                .map(|method| {
                    let picture = render(&engine, size, &material, method, &|| progress(1));
                    (method, picture, shading_of(method))
                })
                .collect();
            panel(distribution, references.of(distribution), pictures, timing.geometry)
        });
        Ok(Self { name, caption, size, geometry: timing.geometry, panels: panels.into() })
    }
}

/// Shading time of a method; supersampling repeats the plain shading of its distribution.
fn shading_time(method: &Method, timed: &[&Method], timing: &Timing) -> f64 {
    let same = |other: &&Method| {
        other.distribution == method.distribution
            && other.filters == method.filters
            && (!method.filters || other.name == method.name)
    };
    timed.iter().position(same).map_or(f64::NAN, |index| timing.shading[index])
}

fn panel(
    distribution: Distribution,
    reference: &Reference,
    pictures: Vec<(&Method, Vec<f32>, f64)>,
    geometry: f64,
) -> Panel {
    let scale = scale(&reference.radiance);
    let mut rows: Vec<_> = pictures
        .into_iter()
        .map(|(method, picture, shading)| Row {
            name: method.name.clone(),
            samples: method.samples,
            filters: method.filters,
            errors: Errors::of(&picture, &reference.radiance, scale),
            shading,
            pixel: f64::from(method.samples) * (geometry + shading),
            equal_samples: None,
            speed_up: None,
            picture,
        })
        .collect();
    let line = |cost: fn(&Row) -> f64| {
        let plain = rows.iter().filter(|row| !row.filters);
        Frontier(plain.map(|row| Point { cost: cost(row), error: row.errors.rmse }).collect())
    };
    let (time, samples) = (line(|row| row.pixel), line(|row| f64::from(row.samples)));
    for row in rows.iter_mut().filter(|row| row.filters) {
        row.equal_samples = samples.price(row.errors.rmse);
        row.speed_up = time.price(row.errors.rmse).map(|price| price.over(row.pixel));
    }
    let noise = reference.noise * scale;
    Panel { distribution, scale, noise, reference: reference.radiance.clone(), rows }
}
