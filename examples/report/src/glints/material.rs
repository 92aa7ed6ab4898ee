//! Materials of details, by how many of them a pixel has.

use lobe::material::glint::Biscale;
use lobe::{Error, Real};

/// Details whose roughness from afar is equal along both axes. Where one detail has all the
/// roughness along v, the details are grooves along v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Material {
    pub(crate) name: &'static str,
    /// From afar.
    pub(crate) alpha: f64,
    /// Share of it that one detail has, along u and v.
    pub(crate) fractions: [f64; 2],
    /// In a pixel; of grooves, across a square one.
    pub(crate) details: f64,
}

/// The snow of Zirr & Kaplanyan's demonstration, with this many details in a pixel.
pub(crate) const fn snow(name: &'static str, details: f64) -> Material {
    Material { name, alpha: 0.6, fractions: [0.024; 2], details }
}

/// What errors are measured on.
pub(crate) const MATERIALS: [Material; 6] = [
    snow("snow, 10 details", 10.0),
    snow("snow, 1000", 1e3),
    snow("snow, 100000", 1e5),
    Material { name: "rough details, 1000", alpha: 0.6, fractions: [0.2; 2], details: 1e3 },
    Material { name: "rough surface, 100", alpha: 2.0, fractions: [0.5; 2], details: 100.0 },
    Material { name: "grooves, 100 across", alpha: 0.3, fractions: [0.1, 1.0], details: 100.0 },
];

impl Material {
    pub(super) fn is_groove(&self) -> bool {
        self.fractions[1] == 1.0
    }

    pub(super) fn biscale<R: Real>(&self) -> Result<Biscale<R>, Error> {
        Biscale::from_fractions([R::lit(self.alpha); 2], self.fractions.map(R::lit))
    }

    /// Details per unit area where a pixel of this area has as many as it should; of grooves the
    /// root counts, per unit length across.
    pub(super) fn density(&self, area: f64) -> f64 {
        if self.is_groove() { self.details * self.details / area } else { self.details / area }
    }

    /// The same material with other details.
    pub(super) fn with_details(&self, details: f64) -> Self {
        Self { details, ..*self }
    }
}
