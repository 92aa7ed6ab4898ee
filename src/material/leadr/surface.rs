//! A displaced surface as its lobe leaves it: area, facets, light from a point.
//!
//! Layer 4.

use crate::ndf::Beckmann;
use crate::scalar::Real;
use crate::slope::direction::{dot, normal_of, reflect};
use crate::slope::{Anisotropic, Lobe, LobeShape, NonCentered};

/// Which of the relief's own shadows a mean has.
///
/// Masking always: what is hidden from the eye is not seen. Shadows only where the renderer would
/// draw them close by: a filter that darkens what the displaced geometry itself does not is
/// inconsistent between scales.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Shadowing {
    /// Masking and shadowing, height-correlated: $1/(1 + \Lambda_o + \Lambda_i)$.
    ///
    /// It knows of heights, not of azimuths: where eye and light lean the same way, what the one
    /// sees the other reaches, and this is too dark. (A sky on ray-cast relief, 32 x 32 facets:
    /// RMSE of 8.5 % of the mean at deviation 2, 20 % over deep grooves. The report measures it.)
    Both,
    /// Masking alone: $1/(1 + \Lambda_o)$, in which the mean plane's area cancels, so $1/\sigma_o$
    /// is all.
    MaskingOnly,
}

/// A surface with Gaussian slopes around a mean: what LEADR maps give a pixel.
///
/// ```
/// use lobe::material::leadr::{Leadr, Shadowing};
/// use lobe::{Lobe, Roughness};
/// // Deviations 0.3 and 0.1, the mean plane leaning.
/// let lobe = Lobe::new([0.2_f64, 0.0], Roughness::from_sigma_rho(0.3, 0.1, 0.0)?)?;
/// let surface = Leadr::new(&lobe);
/// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// let radiance = surface.brdf_cos(wo, wi, Shadowing::Both);
/// assert!(radiance > 0.0 && radiance <= surface.brdf_cos(wo, wi, Shadowing::MaskingOnly));
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: material/leadr/diffuse.rs, material/leadr/environment.rs.
#[doc(alias = "LobeLeadr")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leadr<R: Real> {
    ndf: Beckmann<NonCentered<Anisotropic<R>>>,
    mean: [R; 2],
    /// L of the covariance, $\Sigma = L L^T$: `l11`, `l21`, `l22`.
    factor: [R; 3],
    /// $\sqrt{\det \Sigma}$: the area of a unit of the grid.
    cell: R,
}

/// A node of a grid of N x N, in standard deviations.
#[doc(alias = "LobeNode")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Node<R> {
    /// Where: independent deviations along two axes.
    pub place: [R; 2],
    /// Its share of the density; all nodes' sum is 1.
    pub weight: R,
    /// The area of the plane of deviations that it stands for.
    pub extent: R,
}

/// A facet that a grid's node stands for.
#[doc(alias = "LobeFacet")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Facet<R> {
    /// Its unit normal.
    pub normal: [R; 3],
    /// The mirror direction of `wo` about it.
    pub wi: [R; 3],
    /// $\langle m, w_o \rangle$, 0 from behind: the cosine that a Fresnel term takes.
    pub cosine: R,
    /// Weight times the area it shows, $W \langle m, w_o \rangle / m_z$.
    pub area: R,
    /// Solid angle that its reflection covers, $4 \langle m, w_o \rangle m_z^3$ times its area on
    /// the slope plane: what a light lookup should average over.
    pub solid_angle: R,
}

impl<R: Real> Leadr<R> {
    /// The surface of a lobe: its mean slope, and its covariance $A/2$.
    ///
    /// From maps: [`SlopeMoments::lobe`](crate::SlopeMoments::lobe), with the base roughness 0 or
    /// that of the facets.
    #[doc(alias = "lobe_leadr_new")]
    pub fn new(lobe: &Lobe<R>) -> Self {
        let covariance = lobe.roughness().covariance();
        Self {
            ndf: Beckmann::new(lobe.shape()),
            mean: lobe.mean(),
            factor: covariance.cholesky(),
            cell: covariance.root_det(),
        }
    }

    /// The distribution underneath: density, projected area, masking.
    pub const fn ndf(&self) -> &Beckmann<NonCentered<Anisotropic<R>>> {
        &self.ndf
    }

    /// Radiance towards `wo` per unit of radiance and solid angle from `wi`, without Fresnel: BRDF
    /// times cosine.
    ///
    /// $\frac{D(h)}{4 c_o (1 + \Lambda_o + \Lambda_i)}$, or $\frac{D(h)}{4 \sigma_o}$ with masking
    /// alone. Multiply by the light's radiance, solid angle and Fresnel. c is the projected area of
    /// the mean plane (meso normalization). 0 where the mean plane turns away from either
    /// direction; with masking alone `wi` may lie anywhere.
    ///
    /// Source: Dupuy et al. 2013, section 3.3, with $\Lambda$ exact instead of Walter's fit, the
    /// half vector in the tangent frame (the listing passes the world's), and no normalization of a
    /// zero at normal incidence.
    #[doc(alias = "lobe_leadr_brdf_cos")]
    #[doc(alias = "lobe_leadr_unshadowed_brdf_cos")]
    pub fn brdf_cos(
        &self,
        wo: impl Into<[R; 3]>,
        wi: impl Into<[R; 3]>,
        shadowing: Shadowing,
    ) -> R {
        let (wo, wi) = (wo.into(), wi.into());
        match shadowing {
            Shadowing::Both => {
                let area = self.ndf.shape().mean_area(wi).max(R::ZERO);
                (self.ndf.brdf(wo, wi) * area).min(R::MAX)
            }
            Shadowing::MaskingOnly => self.ndf.unshadowed_brdf_cos(wo, wi),
        }
    }

    /// The share of the relief seen from `wo` that light from `wi` reaches: $G_2/G_1 =
    /// \sigma_o/(\sigma_o + c_o \Lambda_i)$.
    ///
    /// In \[0, 1\]. 0 for light from below the mean plane; where that plane turns away from `wo`,
    /// 1: what is seen of it are its crests.
    ///
    /// ```
    /// use lobe::material::leadr::Leadr;
    /// use lobe::{Lobe, Roughness};
    /// let surface = Leadr::new(&Lobe::centered(Roughness::from_sigma_rho(0.5_f64, 0.5, 0.0)?));
    /// let wo = [0.6, 0.0, 0.8];
    /// assert_eq!(surface.light_reaching(wo, [0.0, 0.0, 1.0]), 1.0);
    /// assert!(surface.light_reaching(wo, [0.96, 0.0, 0.28]) < 0.9);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_leadr_light_reaching")]
    pub fn light_reaching(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> R {
        self.reaching_from(wo.into())(wi.into())
    }

    /// [`Leadr::light_reaching`] of one `wo` for many `wi`.
    #[inline]
    pub(super) fn reaching_from(&self, wo: [R; 3]) -> impl Fn([R; 3]) -> R + '_ {
        let area = self.ndf.projected_area(wo).max(R::MIN_POSITIVE);
        let plane = self.ndf.shape().mean_area(wo).max(R::ZERO);
        move |wi| {
            let shaded = plane * self.ndf.lambda(wi);
            if self.ndf.shape().mean_area(wi) > R::ZERO { area / (area + shaded) } else { R::ZERO }
        }
    }

    /// The facet at a node of a grid: slope $\mu + L p$ with the node's place p.
    ///
    /// Source: Dupuy et al. 2013, Algorithm 1, which writes L by deviations and correlation. The
    /// solid angle takes the node's own area on the slope plane, where the paper takes the square
    /// of the larger side for all.
    ///
    /// ```
    /// use lobe::material::leadr::{Quadrature, Leadr};
    /// use lobe::{Lobe, Roughness};
    /// let surface = Leadr::new(&Lobe::centered(Roughness::from_sigma_rho(0.2_f64, 0.2, 0.0)?));
    /// let middle = surface.facet([0.6, 0.0, 0.8], Quadrature::<f64, 5>::dupuy().node(2, 2));
    /// assert_eq!((middle.normal, middle.wi), ([0.0, 0.0, 1.0], [-0.6, 0.0, 0.8]));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_leadr_facet")]
    #[inline]
    pub fn facet(&self, wo: impl Into<[R; 3]>, node: Node<R>) -> Facet<R> {
        let (wo, place) = (wo.into(), node.place);
        let [l11, l21, l22] = self.factor;
        let slope =
            [self.mean[0] + l11 * place[0], self.mean[1] + (l21 * place[0] + l22 * place[1])];
        let normal = normal_of(slope);
        // On the slope plane the area shown is linear in the slope: no quotient of two small
        // cosines.
        let shown = (wo[2] - slope[0] * wo[0] - slope[1] * wo[1]).max(R::ZERO);
        let cosine = shown * normal[2];
        let z = normal[2];
        Facet {
            normal,
            wi: reflect(wo, normal),
            cosine,
            area: node.weight * shown,
            solid_angle: R::lit(4.0) * cosine * (z * z * z) * (node.extent * self.cell),
        }
    }

    /// A facet that always faces `wo` a little, for pixels whose mean plane does not: silhouettes
    /// of coarse tessellations.
    ///
    /// $m = \mathrm{normalize}(n - (n \cdot w_o)\,\epsilon\, w_o)$ with the unit normal n of the
    /// mean plane and $\epsilon = 1.01$; weight $10^{-5}$, so it counts where no other facet does.
    /// Where the mean plane faces `wo`, it turns away and has area 0.
    ///
    /// Source: Dupuy et al. 2013, section 3.7.
    ///
    /// ```
    /// use lobe::material::leadr::Leadr;
    /// use lobe::{Lobe, Roughness};
    /// let mirror = Leadr::new(&Lobe::new([2.0_f64, 0.0], Roughness::from_alpha(0.0)?)?);
    /// assert!(mirror.artificial_facet([0.8, 0.0, 0.6]).area > 0.0);
    /// assert_eq!(mirror.artificial_facet([0.0, 0.0, 1.0]).area, 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_leadr_artificial_facet")]
    pub fn artificial_facet(&self, wo: impl Into<[R; 3]>) -> Facet<R> {
        let wo = wo.into();
        let n = normal_of(self.mean);
        let along = R::lit(1.01) * dot(n, wo);
        let normal =
            crate::slope::direction::normalize([0, 1, 2].map(|k: usize| n[k] - along * wo[k]));
        let cosine = dot(normal, wo).max(R::ZERO);
        let z = normal[2].abs();
        // The paper divides by the height of this normal, too, which may be 0: it belongs to no
        // slope.
        Facet {
            normal,
            wi: reflect(wo, normal),
            cosine,
            area: R::lit(1e-5) * cosine,
            solid_angle: R::lit(4.0) * cosine * (z * z * z) * self.cell,
        }
    }
}
