//! Light from everywhere: a sum over the facets of a grid.
//!
//! Layer 4.

use super::quadrature::Quadrature;
use super::surface::{Facet, Leadr, Shadowing};
use crate::material::Fresnel;
use crate::scalar::Real;

/// Light from everywhere: a function of direction and of the solid angle to average over, or a
/// [`CubeMap`](super::CubeMap).
///
/// Functions `Fn([R; 3], R) -> [R; 3]` are lights. Directions are unit vectors of the surface's
/// tangent frame.
pub trait Light<R> {
    /// Radiance from the direction `wi`, averaged over `solid_angle` around it, in three channels.
    fn radiance(&self, wi: [R; 3], solid_angle: R) -> [R; 3];
}

impl<R: Real, F: Fn([R; 3], R) -> [R; 3]> Light<R> for F {
    #[inline]
    fn radiance(&self, wi: [R; 3], solid_angle: R) -> [R; 3] {
        self(wi, solid_angle)
    }
}

/// What a sum over facets is divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Normalization {
    /// The projected area $\sigma(w_o)$ in closed form: without bias as the grid grows, and no sum
    /// to keep. A constant light comes out as S/sigma, off by what the grid misses of the area
    /// ([`Quadrature::cells`](super::Quadrature::cells) has the numbers).
    ProjectedArea,
    /// S, the sum of the facets' areas: the paper's. A constant light comes out as itself for any
    /// grid, also where no facet of the grid is seen (by [`Leadr::artificial_facet`]; of a mirror
    /// exactly edge-on nothing is): the choice for few nodes and for silhouettes.
    Sum,
}

impl<R: Real> Leadr<R> {
    /// Radiance towards `wo` under light from everywhere, mirrored by N x N facets, in three
    /// channels.
    ///
    /// $\frac{1}{\sigma_o} \sum_{j,k} W_j W_k \frac{\langle m, w_o\rangle}{m_z} F(\langle m,
    /// w_o\rangle)\, \frac{G_2}{G_1}\, L(w_i)$ with $w_i$ the mirror direction about m; $G_2/G_1 =
    /// 1$ with masking alone. L is averaged over the solid angle of each facet. `wo`: unit. Where
    /// no facet is seen: the artificial one, by [`Normalization::Sum`], or black.
    ///
    /// Source: Dupuy et al. 2013, Algorithm 1 and its simplified form.
    ///
    /// ```
    /// use lobe::material::Fresnel;
    /// use lobe::material::leadr::{Leadr, Normalization, Quadrature, Shadowing};
    /// use lobe::{Lobe, Roughness};
    /// let surface = Leadr::new(&Lobe::centered(Roughness::from_sigma_rho(0.2_f32, 0.1, 0.0)?));
    /// let sky =
    ///     |wi: [f32; 3], _: f32| if wi[2] > 0.0 { [0.3, 0.5, 1.0] } else { [0.2, 0.1, 0.0] };
    /// let [red, _, blue] = surface.environment(
    ///     [0.6, 0.0, 0.8],
    ///     &Quadrature::<f32, 5>::dupuy(),
    ///     Shadowing::MaskingOnly,
    ///     Normalization::Sum,
    ///     &Fresnel::white(),
    ///     &sky,
    /// );
    /// assert!((red - 0.3).abs() < 1e-3 && blue > 0.9);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn environment<const N: usize>(
        &self,
        wo: impl Into<[R; 3]>,
        quadrature: &Quadrature<R, N>,
        shadowing: Shadowing,
        normalization: Normalization,
        fresnel: &Fresnel<R>,
        light: &impl Light<R>,
    ) -> [R; 3] {
        let wo = wo.into();
        let share = match shadowing {
            Shadowing::Both => Some(self.reaching_from(wo)),
            Shadowing::MaskingOnly => None,
        };
        self.mean_over_facets(wo, quadrature, normalization, |facet| {
            let reaching = share.as_ref().map_or(R::ONE, |share| share(facet.wi));
            let radiance = light.radiance(facet.wi, facet.solid_angle);
            let reflected = fresnel.reflectance(facet.cosine);
            [0, 1, 2].map(|k: usize| reaching * reflected[k] * radiance[k])
        })
    }

    /// The mean of `shade` over the facets that `wo` sees, by the areas they show.
    pub(super) fn mean_over_facets<const N: usize>(
        &self,
        wo: [R; 3],
        quadrature: &Quadrature<R, N>,
        normalization: Normalization,
        shade: impl Fn(&Facet<R>) -> [R; 3],
    ) -> [R; 3] {
        let (mut sum, mut total) = ([R::ZERO; 3], R::ZERO);
        let mut add = |facet: &Facet<R>| {
            if facet.area > R::ZERO {
                let shaded = shade(facet);
                sum = [0, 1, 2].map(|k: usize| sum[k] + facet.area * shaded[k]);
                total = total + facet.area;
            }
        };
        for j in 0..N {
            for k in 0..N {
                add(&self.facet(wo, quadrature.node(j, k)));
            }
        }
        let divisor = match normalization {
            Normalization::ProjectedArea => self.ndf().projected_area(wo),
            Normalization::Sum => {
                add(&self.artificial_facet(wo));
                total
            }
        };
        // Far behind a silhouette the area is the smallest number: its reciprocal would be
        // infinite.
        sum.map(|x| if divisor > R::ZERO { (x / divisor).min(R::MAX) } else { R::ZERO })
    }
}
