//! What a picture's pixels send to the camera, beside what the smooth lobe would.

/// Sums over pixels; they add in any order that is always the same.
#[derive(Clone, Copy, Default)]
pub(crate) struct Energy {
    /// Radiance of details, and of the smooth lobe in their place.
    pub(crate) details: f64,
    pub(crate) smooth: f64,
    /// Of the first, if every detail reflects or not by itself.
    pub(crate) variance: f64,
    /// Pixels that show the material, as parts of whole ones.
    pub(crate) pixels: f64,
    /// Cells that were asked, once for all lights, in all and for one pixel.
    pub(crate) cells: u64,
    pub(crate) most: u32,
    pub(crate) shaded: u64,
}

impl Energy {
    /// The sums of two parts.
    pub(crate) fn and(self, other: &Self) -> Self {
        Self {
            details: self.details + other.details,
            smooth: self.smooth + other.smooth,
            variance: self.variance + other.variance,
            pixels: self.pixels + other.pixels,
            cells: self.cells + other.cells,
            most: self.most.max(other.most),
            shaded: self.shaded + other.shaded,
        }
    }

    /// Of a pixel that shows so much of the material.
    pub(crate) fn covering(self, part: f64) -> Self {
        Self {
            details: part * self.details,
            smooth: part * self.smooth,
            variance: part * part * self.variance,
            pixels: part * self.pixels,
            ..self
        }
    }

    /// Details against the smooth lobe: near 1.
    pub(crate) fn ratio(&self) -> f64 {
        self.details / self.smooth.max(f64::MIN_POSITIVE)
    }

    /// How far from 1 the ratio may lie by chance, as one standard deviation.
    pub(crate) fn deviation(&self) -> f64 {
        self.variance.sqrt() / self.smooth.max(f64::MIN_POSITIVE)
    }

    /// Cells of a pixel, in the mean.
    pub(crate) fn cells(&self) -> f64 {
        self.cells as f64 / (self.shaded as f64).max(1.0)
    }
}
