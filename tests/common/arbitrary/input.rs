//! Lobes as the generator has them: exact numbers, from which either precision is made.

use super::ULP;
use lobe::{Lobe, Psd, Real, Roughness};

/// A roughness by its alphas along x and y and the correlation of the two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipse {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) rho: f64,
}

/// A lobe: an ellipse and a mean slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LobeInput {
    pub(crate) ellipse: Ellipse,
    pub(crate) mean: [f64; 2],
}

impl Ellipse {
    /// Entries xx, xy, yy of A.
    pub(crate) fn entries(&self) -> [f64; 3] {
        [self.x * self.x, self.rho * self.x * self.y, self.y * self.y]
    }

    /// Entries rounded to f32.
    pub(crate) fn entries_single(&self) -> [f32; 3] {
        self.entries().map(|x| x as f32)
    }

    /// The root of A's determinant.
    pub(crate) fn root_det(&self) -> f64 {
        self.x * self.y * ((1.0 - self.rho) * (1.0 + self.rho)).sqrt()
    }

    /// The smaller and the larger alpha along the axes of the ellipse, to a factor of root two.
    pub(crate) fn widths(&self) -> [f64; 2] {
        let larger = self.x.max(self.y);
        [self.root_det() / larger, larger]
    }

    /// The roughness with these entries, rounded to the precision.
    pub(crate) fn roughness<R: Real>(&self) -> Roughness<R> {
        let [xx, xy, yy] = self.entries().map(R::lit);
        Roughness::from_matrix(Psd::new(xx, xy, yy).expect("an ellipse with |rho| < 1"))
    }
}

impl LobeInput {
    /// The slope at whitened coordinates `w`, `mean + L w` with L lower triangular.
    pub(crate) fn slope_at(&self, w: [f64; 2]) -> [f64; 2] {
        let Ellipse { x, y, rho } = self.ellipse;
        let minor = y * ((1.0 - rho) * (1.0 + rho)).sqrt();
        [self.mean[0] + x * w[0], self.mean[1] + rho * y * w[0] + minor * w[1]]
    }

    /// The library's lobe, inputs rounded to the precision.
    pub(crate) fn lobe<R: Real>(&self) -> Lobe<R> {
        Lobe::new(self.mean.map(R::lit), self.ellipse.roughness()).expect("a finite mean")
    }

    /// How far rounding moves a slope of size `reach`, in units of the lobe's smaller alpha: a
    /// density that changes by at most a factor of e per alpha or so inherits it as a relative
    /// error.
    pub(crate) fn blur(&self, reach: f64) -> f64 {
        let [minor, major] = self.ellipse.widths();
        let mean = self.mean[0].abs() + self.mean[1].abs();
        ULP * (mean + major + reach) / minor
    }
}
