//! What came out of one view: a row for every method.

use serde::Serialize;

use super::clock;
use super::ground::Ground;
use super::method::{Method, name};
use super::reference::Reference;
use super::view::Station;
use crate::frontier::{Frontier, Point, Price};
use crate::method::Distribution;
use crate::metric::{Errors, scale};

/// One method's line.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) method: &'static str,
    /// Per pixel; more than one only of plain supersampling.
    pub(crate) samples: u32,
    pub(crate) errors: Errors,
    /// Nanoseconds per pixel, lookups included; at the first alpha.
    pub(crate) time: Option<f64>,
    /// What supersampling takes for the same RMSE, in multiples of this method's time; of single
    /// samples.
    pub(crate) equal_time: Option<Price>,
    /// Radiance, unscaled; where it is shown.
    #[serde(skip)]
    pub(crate) picture: Option<Vec<f32>>,
}

/// All methods in one view at one alpha.
#[derive(Serialize)]
pub(crate) struct Panel {
    pub(crate) distribution: Distribution,
    pub(crate) alpha: f64,
    /// Degrees of the view over the plane.
    pub(crate) elevation: f64,
    /// Texels per pixel across the view.
    pub(crate) ratio: f64,
    /// Standard error of the reference, its mean being 1.
    pub(crate) noise: f64,
    /// Samples per pixel of the reference.
    pub(crate) reference_samples: u32,
    pub(crate) rows: Vec<Row>,
    /// Radiance, unscaled; where it is shown.
    #[serde(skip)]
    pub(crate) reference: Option<Vec<f64>>,
}

/// How a panel is made.
pub(super) struct Making<'a> {
    pub(super) station: &'a Station,
    pub(super) ground: &'a Ground<'a>,
    pub(super) methods: &'a [Method],
    pub(super) alpha: f64,
    /// Of timing; none are not timed.
    pub(super) rounds: usize,
    /// Whether pictures are kept.
    pub(super) shown: bool,
}

impl Making<'_> {
    /// Renders with every method and compares.
    pub(super) fn panel(
        &self,
        distribution: Distribution,
        reference: &Reference,
        reference_samples: u32,
    ) -> Panel {
        let &Self { station, ground, methods, alpha, rounds, shown } = self;
        let size = station.size;
        let judged = vec![true; size.pixels()];
        let scale = scale(&reference.radiance, &judged);
        // Timed first, while no other thread of ours runs.
        let times =
            (rounds > 0).then(|| clock::measure(methods, distribution, ground, size, rounds));
        let rows = methods.iter().enumerate().map(|(index, method)| {
            let picture = method.picture(distribution, ground, size);
            Row {
                method: method.name,
                samples: method.samples,
                errors: Errors::of(&picture, &reference.radiance, &judged, scale),
                time: times.as_ref().map(|times| times[index]),
                equal_time: None,
                picture: shown.then_some(picture),
            }
        });
        let mut panel = Panel {
            distribution,
            alpha,
            elevation: station.elevation,
            ratio: station.ratio,
            noise: reference.noise * scale,
            reference_samples,
            rows: rows.collect(),
            reference: shown.then(|| reference.radiance.clone()),
        };
        panel.price();
        panel
    }
}

impl Panel {
    /// What supersampling pays for each method's error.
    fn price(&mut self) {
        let point = |row: &Row| Some(Point { cost: row.time?, error: row.errors.rmse });
        let plain = self.rows.iter().filter(|row| row.is_plain());
        let line = Frontier(plain.filter_map(point).collect());
        for row in self.rows.iter_mut().filter(|row| row.samples == 1) {
            let price = line.price(row.errors.rmse);
            row.equal_time = row.time.and_then(|time| Some(price?.over(time)));
        }
    }

    pub(crate) fn row(&self, method: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.method == method)
    }

    /// RMSE of a method; NaN without one.
    pub(crate) fn rmse(&self, method: &str) -> f64 {
        self.row(method).map_or(f64::NAN, |row| row.errors.rmse)
    }

    /// The light that a method gives, in parts of the reference's; NaN without one.
    pub(crate) fn energy(&self, method: &str) -> f64 {
        self.row(method).map_or(f64::NAN, |row| row.errors.energy)
    }

    /// The single sample with the least RMSE, of those that a mip chain can serve.
    pub(crate) fn best(&self) -> Option<&Row> {
        let single = self.rows.iter().filter(|row| row.samples == 1 && row.method != name::EXACT);
        single.min_by(|a, b| a.errors.rmse.total_cmp(&b.errors.rmse))
    }
}

impl Row {
    /// Whether it is plain supersampling.
    pub(crate) fn is_plain(&self) -> bool {
        self.samples > 1
    }
}
