//! What engines ship: their filters with their constants, to reproduce a picture and to say what
//! the constants mean.
//!
//! Layer 3. All take the change of the normal to the next pixels and cite the same papers.
//! Translated into this crate's units (`c` is what multiplies $|\Delta n_u|^2 + |\Delta n_v|^2$
//! before it is added to alpha^2, as $c = 2\sigma_{px}^2$ in Tokuyoshi's Eq. 13), they differ by a
//! factor of 2.5 in what they add and by 4.5 in where they stop. Constants as read in each engine's
//! source or, for Bevy, in the pull request; engines move on, this table does not.
//!
#![doc = include_str!("engine.md")]

use super::deferred::{norm_squared, widened};
use super::kernel::PixelFilter;
use crate::error::Error;
use crate::scalar::Real;

/// An engine whose filter [`Engine::alpha`] reproduces.
///
/// ```
/// use lobe::filter::engine::Engine;
/// let (dn_u, dn_v) = ([0.2_f64, 0.0, 0.0], [0.0, 0.2, 0.0]);
/// let alphas = Engine::ALL.iter().map(|engine| engine.alpha(0.01, dn_u, dn_v).unwrap());
/// // One surface, as many answers as engines.
/// let most = alphas.clone().fold(0.0, f64::max);
/// let least = alphas.fold(1.0, f64::min);
/// assert!(most > 2.0 * least);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Engine {
    /// Google Filament, material defaults.
    Filament,
    /// Unity HDRP, material defaults.
    UnityHdrp,
    /// Godot 4, project defaults.
    Godot,
    /// O3DE, Atom's `SpecularAA`.
    O3de,
    /// three.js, `MeshStandardMaterial`.
    ThreeJs,
    /// Babylon.js, PBR material with specular anti-aliasing on.
    BabylonJs,
    /// Bevy's proposal, pull request 24427.
    BevyProposal,
}

/// A filter that adds $\min(c\, (|\Delta n_u|^2 + |\Delta n_v|^2), \mathrm{cap})$ to alpha^2.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct AddedVariance {
    /// What multiplies the squared derivatives.
    pub coefficient: f64,
    /// The most that is added to alpha^2.
    pub cap: f64,
}

impl AddedVariance {
    /// The pixel filter that this coefficient stands for in Tokuyoshi 2017, Eq. 13: $c =
    /// 2\sigma_{px}^2$.
    ///
    /// ```
    /// use lobe::{PixelFilter, filter::engine::Engine};
    /// let o3de = Engine::O3de.added().unwrap().filter();
    /// assert_eq!(o3de, PixelFilter::KAPLANYAN);
    /// ```
    pub fn filter(&self) -> PixelFilter {
        // Constants of this file: in range.
        PixelFilter::with_variance(0.5 * self.coefficient).unwrap_or(PixelFilter::BOX)
    }
}

impl Engine {
    /// All of them.
    pub const ALL: &'static [Self] = &[
        Self::Filament,
        Self::UnityHdrp,
        Self::Godot,
        Self::O3de,
        Self::ThreeJs,
        Self::BabylonJs,
        Self::BevyProposal,
    ];

    /// The engine's name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Filament => "Filament",
            Self::UnityHdrp => "Unity HDRP",
            Self::Godot => "Godot 4",
            Self::O3de => "O3DE",
            Self::ThreeJs => "three.js",
            Self::BabylonJs => "Babylon.js",
            Self::BevyProposal => "Bevy (proposal)",
        }
    }

    /// What the engine computes, in its own terms: r is perceptual roughness, t the squared
    /// derivatives' sum.
    pub const fn formula(self) -> &'static str {
        match self {
            Self::Filament => "alpha^2 + min(2 0.15 t, 0.2^2)",
            Self::UnityHdrp => "alpha^2 + min(2 0.1 t, 0.2^2)",
            Self::Godot => "alpha + min(2 0.25 t, 0.18)",
            Self::O3de => "alpha^2 + min(2 0.25 t, 0.18)",
            Self::ThreeJs => "max(r, 0.0525) + largest |component| of the two derivatives",
            Self::BabylonJs => "max(r, largest |derivative|^0.666); alpha = r^2 + 0.0005",
            Self::BevyProposal => "alpha^2 + min(0.25 t, 0.18)",
        }
    }

    /// Coefficient and cap where the filter adds to alpha^2; the others have none that would hold
    /// for every alpha.
    pub fn added(self) -> Option<AddedVariance> {
        let (coefficient, cap) = match self {
            Self::Filament => (2.0 * 0.15, 0.2 * 0.2),
            Self::UnityHdrp => (2.0 * 0.1, 0.2 * 0.2),
            Self::O3de => (2.0 * 0.25, 0.18),
            Self::BevyProposal => (0.25, 0.18),
            Self::Godot | Self::ThreeJs | Self::BabylonJs => return None,
        };
        Some(AddedVariance { coefficient, cap })
    }

    /// Which normal the engine differentiates: the geometry's, or the shading normal after its map.
    pub const fn normal(self) -> &'static str {
        match self {
            Self::Filament | Self::UnityHdrp | Self::ThreeJs => "geometry",
            Self::Godot | Self::O3de | Self::BabylonJs | Self::BevyProposal => "shading",
        }
    }

    /// What is wrong or left unsaid.
    pub const fn shortcoming(self) -> &'static str {
        match self {
            Self::Filament => {
                "right space; the threshold is squared, so that it stops at a fifth of the \
                    paper's; 0.15 is nobody's pixel"
            }
            Self::UnityHdrp => "right space; the threshold is squared here as well",
            Self::Godot => {
                "adds to alpha what belongs to alpha^2: nearly no filtering where it matters"
            }
            Self::O3de => {
                "none in the formula; mapped normals make it also blur what a map resolves"
            }
            Self::ThreeJs => {
                "linear in r, the largest component depends on the view's axes; never below r = \
                    0.0525"
            }
            Self::BabylonJs => {
                "no variances: rough surfaces get nothing, smooth ones all; adds 0.0005 to every \
                    alpha (punctual lights; reflections add 0.75 |derivative| to alpha)"
            }
            Self::BevyProposal => {
                "says sigma^2 = 0.25 and adds it once: half of the equation it cites"
            }
        }
    }

    /// The alpha that the engine shades with.
    ///
    /// `alpha` = r^2 before filtering, `dn_u` and `dn_v` the differences of the normal to the next
    /// pixels. As shipped, defects included ([`Engine::shortcoming`]);
    /// [`tokuyoshi_deferred_alpha`](super::tokuyoshi_deferred_alpha) is the formula that they
    /// meant. The frame of the normals matters to three.js only (view space). Godot and three.js
    /// end at 1, whatever alpha came in.
    ///
    /// # Errors
    /// [`Error::Alpha`] unless alpha lies in $[0, 10^9]$.
    ///
    /// ```
    /// use lobe::filter::engine::Engine;
    /// // Perceptual roughness 0.1, a kernel of 0.05: alpha should be 0.224.
    /// let (dn_u, dn_v) = ([0.1_f64.sqrt(), 0.0, 0.0], [0.0; 3]);
    /// assert!((Engine::O3de.alpha(0.01, dn_u, dn_v)? - 0.224).abs() < 5e-4);
    /// assert!((Engine::Godot.alpha(0.01, dn_u, dn_v)? - 0.060).abs() < 5e-4);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_engine_alpha")]
    pub fn alpha<R: Real>(
        self,
        alpha: R,
        dn_u: impl Into<[R; 3]>,
        dn_v: impl Into<[R; 3]>,
    ) -> Result<R, Error> {
        if !alpha.is_magnitude() {
            return Err(Error::Alpha(alpha.into()));
        }
        let (u, v, lit) = (dn_u.into(), dn_v.into(), R::lit);
        let (u_squared, v_squared) = (norm_squared(u), norm_squared(v));
        if let Some(AddedVariance { coefficient, cap }) = self.added() {
            return widened(alpha, lit(coefficient) * (u_squared + v_squared), lit(cap));
        }
        let perceptual = alpha.sqrt();
        Ok(match self {
            Self::Godot => {
                let added = (lit(0.5) * (u_squared + v_squared)).max(R::ZERO).min(lit(0.18));
                (alpha + added).min(R::ONE)
            }
            Self::ThreeJs => {
                let largest = u.iter().chain(&v).fold(R::ZERO, |most, x| most.max(x.abs()));
                let r = (perceptual.max(lit(0.0525)) + largest).min(R::ONE);
                r * r
            }
            _ => {
                let largest = u_squared.max(v_squared).min(R::ONE);
                let floor = (lit(0.333) * largest.ln()).exp();
                let r = perceptual.max(floor);
                r * r + lit(0.0005)
            }
        })
    }
}
