//! Lobes over the plane of slopes, by their correlation: of few facets and of many (Fig. 10).

use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe};
use lobe::{Error, Roughness};
use serde::Serialize;

use super::dictionary::Precision;
use crate::camera::Size;

/// Correlations, as in the paper.
pub(crate) const CORRELATIONS: [f64; 3] = [0.0, 0.6, 0.9];

/// Facets in the pixel.
pub(crate) const COUNTS: [f64; 2] = [64.0, 1e15];

/// Deviations of the slopes, and how many of them a picture reaches to.
const SIGMA: f64 = 0.25;
const REACH: f64 = 4.2;

/// One lobe.
#[derive(Serialize)]
pub(crate) struct Shown {
    pub(crate) facets: f64,
    pub(crate) correlation: f64,
    /// Sum over the picture, and the correlation that it shows.
    pub(crate) integral: f64,
    pub(crate) found: f64,
    #[serde(skip)]
    pub(crate) picture: Vec<f64>,
}

/// Pictures of all lobes.
#[derive(Serialize)]
pub(crate) struct Lobes {
    pub(crate) size: Size,
    /// Count after count.
    pub(crate) shown: Vec<Shown>,
}

impl Lobes {
    pub(super) fn seen(side: usize) -> Result<Self, Error> {
        let dictionary = f64::dictionary()?;
        let pairs = COUNTS.iter().flat_map(|&count| CORRELATIONS.map(|rho| (count, rho)));
        let shown = pairs.map(|(count, rho)| Shown::of(dictionary, count, rho, side));
        Ok(Self {
            size: Size { width: side, height: side },
            shown: shown.collect::<Result<_, _>>()?,
        })
    }
}

impl Shown {
    fn of(
        dictionary: &Dictionary<f64>,
        facets: f64,
        correlation: f64,
        side: usize,
    ) -> Result<Self, Error> {
        let roughness = Roughness::from_sigma_rho(SIGMA, SIGMA, correlation)?;
        // As many lobes in each cell: some would have a handful, and draw all there is to see.
        let surface = MultiLobe::new(roughness, facets)?.with_variation(0.0)?;
        let patch = Patch::new([0.37, 0.61], [1.0, 0.0], [0.0, 1.0]);
        let pixel = surface.ndf(dictionary, &patch);
        let step = 2.0 * REACH * SIGMA / side as f64;
        let at = |k: usize| step * (k as f64 + 0.5) - REACH * SIGMA;
        // Means of finer points: lobes are about as narrow as a point of the picture.
        let parts = || (0..PARTS).map(|k| step * ((f64::from(k) + 0.5) / f64::from(PARTS) - 0.5));
        let density = |x: f64, y: f64| {
            let points = parts().flat_map(|a| parts().map(move |b| [x + a, y + b]));
            points.map(|slope| pixel.slope_pdf(slope)).sum::<f64>() / f64::from(PARTS * PARTS)
        };
        let places = (0..side * side).map(|k| [at(k % side), at(side - 1 - k / side)]);
        let picture: Vec<_> = places.clone().map(|[x, y]| density(x, y)).collect();
        let sum = |of: fn([f64; 2]) -> f64| {
            let terms = places.clone().zip(&picture).map(|(slope, p)| of(slope) * p);
            terms.sum::<f64>() * step * step
        };
        let [xx, xy, yy] = [sum(|[x, _]| x * x), sum(|[x, y]| x * y), sum(|[_, y]| y * y)];
        Ok(Self {
            facets,
            correlation,
            integral: sum(|_| 1.0),
            found: xy / (xx * yy).sqrt(),
            picture,
        })
    }
}

/// Points of a mean, along either side.
const PARTS: u32 = 3;
