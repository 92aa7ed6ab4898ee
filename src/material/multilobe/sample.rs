//! Directions drawn by what a pixel sees of many facets, and their density.
//!
//! Layer 4.

use super::ndf::{PatchNdf, bounded};
use super::plane::Plane;
use crate::ndf::{cavity_masking, cavity_masking_shadowing};
use crate::scalar::Real;
use crate::scalar::quantile::normal_quantile;
use crate::slope::direction::{dot, half_vector, normal_of, reflect};

/// A direction that was drawn.
#[doc(alias = "LobeDirectionSample")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct DirectionSample<R> {
    /// Towards the light.
    pub wi: [R; 3],
    /// Its density over solid angle.
    pub pdf: R,
    /// BRDF without Fresnel times cosine over the density, $G_2/G_1 \le 1$; 0 where nothing is
    /// reflected.
    pub weight: R,
}

impl<R: Real> PatchNdf<'_, R> {
    /// A direction towards the light, drawn by the facets that `wo` sees.
    ///
    /// `u` are independent uniform numbers in [0, 1): the cell; two for its marginals; two within
    /// their boxes; the piece of the kernel; a facet or its mirror. The slope is one of the density
    /// exactly, by the inverse of the cumulative; of a facet and the one opposite one is taken, in
    /// proportion to how much is seen of it. None if `wo` lies below the horizon, and for NaN. Of a
    /// mirror, which has no density, the pdf is 0.
    ///
    /// Under kernels, but without the lookups of [`PatchNdf::with_mips`], which are no density's.
    ///
    /// Source: Chermain et al. 2021b; Heitz & d'Eon 2014, for V-cavities.
    ///
    /// ```
    /// use lobe::Roughness;
    /// use lobe::material::cells::Patch;
    /// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
    /// let dictionary = Dictionary::<f64>::new(&Recipe { levels: 8, ..Recipe::default() })?;
    /// let sand = MultiLobe::new(Roughness::from_alpha(0.5)?, 1e6)?;
    /// let pixel = sand.ndf(&dictionary, &Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 2e-3]));
    /// let wo = [0.6, 0.0, 0.8];
    /// let drawn = pixel.sample(wo, [0.2, 0.9, 0.3, 0.5, 0.5, 0.1, 0.7]).expect("above");
    /// assert!(drawn.weight <= 1.0);
    /// let pdf = pixel.pdf(wo, drawn.wi);
    /// assert!((drawn.pdf - pdf).abs() <= 1e-9 * pdf);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_patch_ndf_sample")]
    pub fn sample(&self, wo: impl Into<[R; 3]>, u: [R; 7]) -> Option<DirectionSample<R>> {
        let wo = wo.into();
        if !(wo[2] > R::ZERO) {
            return None;
        }
        let m = normal_of(self.sample_slope(u));
        let opposite = [-m[0], -m[1], m[2]];
        let [seen, other] = [m, opposite].map(|m| dot(wo, m).max(R::ZERO));
        let m = if u[6] * (seen + other) < seen { m } else { opposite };
        let wi = reflect(wo, m);
        if !wi.iter().all(|x| x.is_finite()) {
            return None;
        }
        let weight = match cavity_masking(wo, m) {
            masking if masking > R::ZERO => cavity_masking_shadowing(wo, wi, m) / masking,
            _ => R::ZERO,
        };
        Some(DirectionSample { wi, pdf: self.pdf(wo, wi), weight })
    }

    /// Density over solid angle with which [`PatchNdf::sample`] draws `wi`: $G_1(w_o, h) D(h)/(4
    /// o_z)$, 0 for `wo` below the horizon. Over all `wi`, those below the horizon included, its
    /// integral is 1.
    #[doc(alias = "lobe_patch_ndf_pdf")]
    pub fn pdf(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> R {
        let (wo, wi) = (wo.into(), wi.into());
        let h = half_vector(wo, wi);
        let masking = cavity_masking(wo, h);
        if masking > R::ZERO {
            bounded(self.without_mips().d(h) * (masking / (R::lit(4.0) * wo[2])))
        } else {
            R::ZERO
        }
    }

    /// A slope of [`PatchNdf::slope_pdf`], by the first six of those numbers.
    #[doc(alias = "lobe_patch_ndf_sample_slope")]
    pub fn sample_slope(&self, u: [R; 7]) -> [R; 2] {
        let Some(facets) = self.chosen(u[0]) else {
            return self.sample_smooth([u[1], u[2]]);
        };
        let plane = Plane::new(self.roughness(), self.kernel(), None);
        let piece = plane.pieces().piece_at(u[5]);
        let widths = piece.widths(facets.turn);
        let [x, y] = [0, 1].map(|k| {
            let marginal = self.dictionary().marginal(facets.marginals[k], facets.level);
            marginal.quantile(u[1 + k]) + widths[k] * (u[3 + k] - R::HALF)
        });
        let [cos, sin] = facets.turn;
        let [p, q] = piece.offset;
        plane.slope([cos * x - sin * y - p, sin * x + cos * y - q])
    }

    /// A slope of the smooth lobe, by two numbers.
    fn sample_smooth(&self, u: [R; 2]) -> [R; 2] {
        let smooth = self.roughness().widened(self.kernel());
        let [[a, b], [_, c]] = smooth.chermain_matrix(R::ONE);
        let [x, y] = u.map(|u| normal_quantile(R::ONE - u));
        [a * x + b * y, c * y]
    }
}
