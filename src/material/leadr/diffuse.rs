//! Matt relief: a sum of irradiances over the facets of a grid.
//!
//! Layer 4.

use super::environment::Normalization;
use super::quadrature::Quadrature;
use super::surface::Leadr;
use crate::scalar::Real;

impl<R: Real> Leadr<R> {
    /// Radiance towards `wo` of Lambertian facets of albedo 1, from the irradiance on a facet of a
    /// normal.
    ///
    /// $\frac{1}{\pi \sigma_o} \sum_{j,k} W_j W_k \frac{\langle m, w_o\rangle}{m_z} E(m)$.
    /// `irradiance` takes a unit normal: [`Irradiance::at`](super::Irradiance::at) for
    /// environments, or for one light of radiance L and solid angle omega exactly $L \omega \max(0,
    /// m \cdot w_i)$. Shadows enter as a factor of each light, [`Leadr::light_reaching`].
    ///
    /// 5 x 5 facets have all of a matt surface's features (Dupuy et al. 2013, section 2.3).
    ///
    /// Source: Dupuy et al. 2013, Algorithm 3.
    ///
    /// ```
    /// use lobe::material::leadr::{Quadrature, Leadr, Normalization};
    /// use lobe::{Lobe, Roughness};
    /// let surface = Leadr::new(&Lobe::centered(Roughness::from_sigma_rho(0.5_f64, 0.5, 0.0)?));
    /// let (grid, sum) = (Quadrature::<f64, 5>::dupuy(), Normalization::Sum);
    /// // Lit from the eye, relief is brighter at grazing angles than a plane.
    /// let wo = [0.96, 0.0, 0.28];
    /// let lit = |m: [f64; 3]| [core::f64::consts::PI * (m[0] * wo[0] + m[2] * wo[2]).max(0.0); 3];
    /// assert!(surface.diffuse(wo, &grid, sum, lit)[0] > 1.5 * wo[2]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn diffuse<const N: usize>(
        &self,
        wo: impl Into<[R; 3]>,
        quadrature: &Quadrature<R, N>,
        normalization: Normalization,
        irradiance: impl Fn([R; 3]) -> [R; 3],
    ) -> [R; 3] {
        let inverse_pi = R::lit(core::f64::consts::FRAC_1_PI);
        self.mean_over_facets(wo.into(), quadrature, normalization, |facet| {
            irradiance(facet.normal).map(|e| e * inverse_pi)
        })
    }
}
