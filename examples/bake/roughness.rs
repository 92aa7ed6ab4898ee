//! One roughness for a level's texel: what engines without moments store.

use clap::ValueEnum;
use lobe::SlopeMoments;

/// What a roughness is a number of.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Kind {
    /// The square root of alpha.
    Perceptual,
    /// Alpha.
    Alpha,
}

impl Kind {
    /// The name on the command line and in the description.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Perceptual => "perceptual",
            Self::Alpha => "alpha",
        }
    }
}

/// A material's roughness under a map, and how it is stored.
///
/// The lobe of a texel is A = alpha^2 I + 2 Sigma, and half its trace is one number: alpha_K^2 =
/// alpha^2 + tr Sigma. A Beckmann lobe of alpha has slopes of mean square alpha^2 about its mean,
/// so the number keeps the mean square slope of material and map together; LEAN (Olano &
/// Baker 2010) keeps it along both axes, CLEAN (Baker 2011) as one number. It does not change where
/// the map is turned. The root of A's determinant would keep the peak of the lobe instead, and hide
/// grooves: it is alpha times the wide axis, 0 for a mirror.
#[derive(Clone, Copy)]
pub(crate) struct Roughness {
    /// As given.
    pub(crate) base: f64,
    pub(crate) kind: Kind,
    /// 16 bits, not 8.
    pub(crate) wide: bool,
}

impl Roughness {
    /// Roughness mips over a material's base roughness, which lies in [0, 1].
    pub(crate) fn new(base: f64, kind: Kind, wide: bool) -> Result<Self, String> {
        if (0.0..=1.0).contains(&base) {
            Ok(Self { base, kind, wide })
        } else {
            Err(format!("perceptual = {base} is not in [0, 1]"))
        }
    }

    /// Bits of a code.
    pub(crate) fn bits(&self) -> u32 {
        if self.wide { 16 } else { 8 }
    }

    /// The largest code.
    pub(crate) fn largest(&self) -> u16 {
        if self.wide { u16::MAX } else { u8::MAX.into() }
    }

    /// The code nearest to a texel's roughness (ties round up), and whether the roughness is above
    /// 1, which no code holds.
    pub(crate) fn code(&self, moments: &SlopeMoments<f32>) -> (u16, bool) {
        let alpha = match self.kind {
            Kind::Perceptual => self.base * self.base,
            Kind::Alpha => self.base,
        };
        let [xx, _, yy] = moments.covariance().entries().map(f64::from);
        let together = (alpha * alpha + xx + yy).sqrt();
        let value = match self.kind {
            Kind::Perceptual => together.sqrt(),
            Kind::Alpha => together,
        };
        // Not negative, and at most the largest code.
        #[allow(clippy::cast_sign_loss)]
        let code = (value.min(1.0) * f64::from(self.largest()) + 0.5) as u16;
        (code, value > 1.0)
    }
}
