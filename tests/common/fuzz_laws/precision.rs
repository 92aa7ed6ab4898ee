//! What f32 computes agrees with f64 on the same numbers, over the whole documented domain.

use super::bytes::Bytes;
use core::fmt::Debug;
use lobe::slope::direction::{normal_of, reflect};
use lobe::slope::{Compensated, Whiten};
use lobe::{
    Anisotropic, AxisAligned, Beckmann, Distribution, Footprint, Ggx, Isotropic, LobeShape, Ndf,
    NonCentered, Psd, Roughness,
};

/// Relative errors allowed in f32.
const GGX: f64 = 3e-5;
const BECKMANN: f64 = 2e-4;
const PARALLELOGRAM: f64 = 1e-3;
const LAMBDA: f64 = 1e-2;

/// A lobe and where to look at it; every number is exactly f32.
#[derive(Debug)]
struct Scene {
    alphas: [f32; 2],
    /// A as `[xx, xy, yy]`.
    matrix: [f32; 3],
    mean: [f32; 2],
    slope: [f32; 2],
    wo: [f32; 3],
    wi: [f32; 3],
    u: [f32; 2],
    v: [f32; 2],
}

/// The law: one scene through every shape and both distributions.
pub(crate) fn precision(bytes: &[u8]) {
    let scene = Scene::decode(&mut Bytes::new(bytes));
    let [alpha_x, alpha_y] = scene.alphas;
    let (wide_x, wide_y) = (f64::from(alpha_x), f64::from(alpha_y));
    let valid = "the decoded scene lies in the domain";
    let isotropic = (Isotropic::new(alpha_x).expect(valid), Isotropic::new(wide_x).expect(valid));
    scene.compare(isotropic.0, isotropic.1);
    let aligned = AxisAligned::new(alpha_x, alpha_y).expect(valid);
    scene.compare(aligned, AxisAligned::new(wide_x, wide_y).expect(valid));
    let wide_mean = scene.mean.map(f64::from);
    let exact = Compensated::new(scene.mean, scene.matrix).expect(valid);
    let wide_exact = Compensated::new(wide_mean, scene.matrix.map(f64::from)).expect(valid);
    scene.compare(exact, wide_exact);
    // Plain shapes are backward accurate, which tests/laws/backward.rs holds; their means over
    // polygons are forward accurate in the factor.
    let [xx, xy, yy] = scene.matrix;
    let factor = Psd::new(xx, xy, yy).expect(valid);
    let wide_factor = Psd::from_cholesky(factor.cholesky().map(f64::from)).expect(valid);
    let shape = Anisotropic::new(Roughness::from_matrix(factor));
    let wide_shape = Anisotropic::new(Roughness::from_matrix(wide_factor));
    scene.over_footprint(shape, wide_shape);
    scene.over_footprint(
        NonCentered::new(shape, scene.mean).expect(valid),
        NonCentered::new(wide_shape, wide_mean).expect(valid),
    );
}

impl Scene {
    fn decode(input: &mut Bytes) -> Self {
        let kinds = [0; 4].map(|_| input.byte());
        let alphas = [0; 2].map(|_| input.log_between(1e-4, 30.0) as f32);
        let [x, y] = alphas.map(f64::from);
        // Half the correlations crowd towards 0.9999.
        let rho = if kinds[0] & 1 == 0 {
            1.0 - input.log_between(1e-4, 1.0)
        } else {
            input.between(0.0, 0.9999)
        };
        let rho = if kinds[0] & 2 == 0 { rho } else { -rho };
        let covariance = (rho * x * y) as f32;
        let matrix = [(x * x) as f32, covariance, (y * y) as f32];
        let mean = if kinds[1] & 1 == 0 { [0.0; 2] } else { polar(input, 1e-4, 1e3) };
        // Near the lobe in its own units, or anywhere.
        let slope = if kinds[1] & 2 == 0 {
            let [p, q] = polar(input, 1e-3, 1e3);
            let across = (1.0 - rho * rho).sqrt();
            let s = [mean[0] + x * p, mean[1] + y * (rho * p + across * q)];
            s.map(|s| s.clamp(-1e3, 1e3))
        } else {
            polar(input, 1e-4, 1e3)
        };
        let wo = direction(input, kinds[2] & 7 == 7);
        // The mirror direction of a slope near the lobe, or anywhere.
        let wi = if kinds[2] & 8 == 0 {
            reflect(wo, normal_of(slope))
        } else {
            direction(input, kinds[2] & 0x70 == 0x70)
        };
        let u = polar(input, 1e-5, 1e2);
        let v = match kinds[3] % 4 {
            0 => [0.0; 2],
            1 => {
                let (along, across) = (input.between(-1.0, 1.0), input.log_between(1e-9, 1.0));
                [u[0] * along - u[1] * across, u[1] * along + u[0] * across]
            }
            _ => polar(input, 1e-5, 1e2),
        };
        let [mean, slope, u, v] = [mean, slope, u, v].map(|v| v.map(|x| x as f32));
        let [wo, wi] = [wo, wi].map(|w| w.map(|x| x as f32));
        Self { alphas, matrix, mean, slope, wo, wi, u, v }
    }

    fn compare<S, W>(&self, single: S, wide: W)
    where
        S: Whiten<Scalar = f32> + Debug,
        W: Whiten<Scalar = f64>,
    {
        self.evaluate(Ggx::new(single), Ggx::new(wide), GGX, &("GGX", single));
        self.evaluate(Beckmann::new(single), Beckmann::new(wide), BECKMANN, &("Beckmann", single));
        self.over_footprint(single, wide);
    }

    fn over_footprint<S, W>(&self, single: S, wide: W)
    where
        S: Whiten<Scalar = f32> + Debug,
        W: Whiten<Scalar = f64>,
    {
        let ggx = (Ggx::new(single), Ggx::new(wide));
        let footprint = Footprint::from_slopes(self.u, self.v);
        let widened = Footprint::from_slopes(self.u.map(f64::from), self.v.map(f64::from));
        let got = ggx.0.parallelogram_mean(self.slope, &footprint);
        let expected = ggx.1.parallelogram_mean(self.slope.map(f64::from), &widened);
        self.hold("parallelogram_mean", got, expected, PARALLELOGRAM, &("GGX", single));
    }

    fn evaluate<D, S, W>(&self, single: Ndf<D, S>, wide: Ndf<D, W>, limit: f64, of: &dyn Debug)
    where
        D: Distribution,
        S: LobeShape<Scalar = f32>,
        W: LobeShape<Scalar = f64>,
    {
        let (slope, wo, wi) = (self.slope, self.wo, self.wi);
        let (slope_w, wo_w, wi_w) = (slope.map(f64::from), wo.map(f64::from), wi.map(f64::from));
        let rows = [
            ("slope_pdf", single.slope_pdf(slope), wide.slope_pdf(slope_w)),
            ("d", single.d(wo), wide.d(wo_w)),
            ("projected_area", single.projected_area(wo), wide.projected_area(wo_w)),
            ("lambda", single.lambda(wo), wide.lambda(wo_w)),
            ("g1", single.g1(wo), wide.g1(wo_w)),
            ("g2", single.g2(wo, wi), wide.g2(wo_w, wi_w)),
            ("visibility", single.visibility(wo, wi), wide.visibility(wo_w, wi_w)),
            ("brdf", single.brdf(wo, wi), wide.brdf(wo_w, wi_w)),
        ];
        for (name, got, expected) in rows {
            let limit = if name == "lambda" { LAMBDA } else { limit };
            self.hold(name, got, expected, limit, of);
        }
    }

    fn hold(&self, name: &str, got: f32, expected: f64, limit: f64, of: &dyn Debug) {
        let valid = got >= 0.0 && got.is_finite() && expected >= 0.0 && expected.is_finite();
        // Where the true value exceeds f32, the largest f32 stands for it.
        let nearest = expected.min(f64::from(f32::MAX));
        let scale = nearest.max(f64::from(f32::MIN_POSITIVE));
        let error = (f64::from(got) - nearest).abs() / scale;
        assert!(
            valid && error <= limit,
            "{name} = {got:e}, in f64 {expected:e}: error {error:.1e} above {limit:e}; {of:?}, \
                {self:?}"
        );
    }
}

/// A vector of this length range, any direction.
fn polar(input: &mut Bytes, low: f64, high: f64) -> [f64; 2] {
    let length = input.log_between(low, high);
    let angle = input.between(0.0, core::f64::consts::TAU);
    [length * angle.cos(), length * angle.sin()]
}

/// A unit vector; its height is evenly distributed in the logarithm.
fn direction(input: &mut Bytes, below: bool) -> [f64; 3] {
    let z = input.log_between(1e-4, 1.0);
    let [x, y] = polar(input, 1.0, 1.0).map(|x| x * (1.0 - z * z).sqrt());
    [x, y, if below { -z } else { z }]
}
