//! What came out: a row for every method, a panel for every light, alpha and distribution.

use serde::Serialize;

use crate::frontier::{Point, Price};
use crate::light::LightKind;
use crate::method::{Derivatives, Distribution, Family, Tally};
use crate::metric::Errors;
use crate::window::{PerWindow, PixelWindow};

/// One method's line of a table.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) family: Family,
    pub(crate) derivatives: Derivatives,
    pub(crate) samples: u32,
    pub(crate) filters: bool,
    /// The pixel filter whose picture the method approximates.
    pub(crate) window: PixelWindow,
    /// Against the reference of that filter.
    pub(crate) errors: Errors,
    /// Against the reference of the box.
    pub(crate) box_errors: Errors,
    /// Nanoseconds of shading per sample, footprints included.
    pub(crate) shading: f64,
    /// Nanoseconds per pixel: samples times geometry, motions if the method needs them, and
    /// shading.
    pub(crate) pixel: f64,
    /// Operations of shading per sample, in the mean; of an isotropic material.
    pub(crate) operations: Tally,
    /// No other method of the panel is both faster and nearer to its own reference.
    pub(crate) pareto: bool,
    /// Samples that plain supersampling needs for the same RMSE; of filters only.
    pub(crate) equal_samples: Option<Price>,
    /// Its time over this method's, at the same RMSE; of filters only.
    pub(crate) speed_up: Option<Price>,
    /// Radiance, unscaled; in the panel that is shown.
    #[serde(skip)]
    pub(crate) picture: Option<Vec<f32>>,
}

impl Row {
    /// Nanoseconds per pixel and error.
    pub(crate) fn point(&self) -> Point {
        Point { cost: self.pixel, error: self.errors.rmse }
    }
}

/// All methods of one distribution on one scene under one light at one alpha.
#[derive(Serialize)]
pub(crate) struct Panel {
    pub(crate) light: LightKind,
    pub(crate) alpha: f64,
    pub(crate) distribution: Distribution,
    /// Brings radiance to a mean box reference of 1 over the judged pixels.
    pub(crate) scale: f64,
    /// The references' standard errors on that scale.
    pub(crate) noise: PerWindow<f64>,
    /// The box reference, unscaled; in the panel that is shown.
    #[serde(skip)]
    pub(crate) reference: Option<Vec<f64>>,
    pub(crate) rows: Vec<Row>,
}

impl Panel {
    /// The filter with the smallest RMSE.
    pub(crate) fn best(&self) -> Option<&Row> {
        self.best_by(|errors| errors.rmse)
    }

    /// The filter with the smallest SMAPE.
    pub(crate) fn best_by_smape(&self) -> Option<&Row> {
        self.best_by(|errors| errors.smape)
    }

    /// The filter with the smallest of an error; the first of equal ones.
    fn best_by(&self, error: fn(&Errors) -> f64) -> Option<&Row> {
        let filters = self.rows.iter().filter(|row| row.filters);
        filters.min_by(|a, b| error(&a.errors).total_cmp(&error(&b.errors)))
    }

    /// The row of one plain sample.
    pub(crate) fn plain(&self) -> Option<&Row> {
        self.rows.iter().find(|row| !row.filters && row.samples == 1)
    }

    /// The noise of a row's own reference.
    pub(crate) fn noise_of(&self, row: &Row) -> f64 {
        self.noise[row.window as usize]
    }

    /// The reference's noise over the best filter's RMSE, and the largest such ratio of all rows.
    pub(crate) fn noise_ratios(&self) -> [f64; 2] {
        let over = |row: &Row| {
            if row.errors.rmse > 0.0 { self.noise_of(row) / row.errors.rmse } else { 0.0 }
        };
        let largest = self.rows.iter().map(over).fold(0.0, f64::max);
        [self.best().map_or(largest, over), largest]
    }

    /// Filters that one plain sample beats.
    pub(crate) fn worse_than_plain(&self) -> impl Iterator<Item = &Row> {
        let plain = self.plain().map_or(f64::INFINITY, |row| row.errors.rmse);
        self.rows.iter().filter(move |row| row.filters && row.errors.rmse > plain)
    }
}
