//! The truth: details as points at random places, each a Gaussian lobe, averaged over the pixel's
//! rectangle.
//!
//! The mean of the pixels is the smooth lobe exactly, and their variance has a closed form.
//! [`Points`](super::points::Points) sums the details of a pixel one by one.

use std::f64::consts::PI;

use super::material::Material;
use super::sample::Pixel;
use crate::pattern::Jitter;

/// A material of real details: a Poisson process on the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Truth {
    material: Material,
    axes: [Axis; 2],
}

/// Slopes along one axis: how details spread, and how rough one is, as alpha^2.
#[derive(Clone, Copy, Debug)]
struct Axis {
    spread: f64,
    local: f64,
}

/// Details farther than this many of their alphas from the half vector, whose part is below 2e-11,
/// are left out.
const REACH: f64 = 5.0;

/// A Gaussian of this alpha^2.
fn lobe(x: f64, a: f64) -> f64 {
    (-x * x / a).exp() / (PI * a).sqrt()
}

impl Axis {
    /// Mean of a detail's squared density over the square of the mean.
    fn excess(self, slope: f64) -> f64 {
        let Self { spread, local } = self;
        let mean = lobe(slope, spread + local);
        lobe(slope, spread + 0.5 * local) / ((2.0 * PI * local).sqrt() * mean * mean)
    }

    /// Begin and length of the slopes of details that reach this slope, and how many there are at
    /// most, per unit of slope.
    fn window(self, slope: f64) -> [f64; 3] {
        let half = REACH * self.local.sqrt();
        let nearest = (slope.abs() - half).max(0.0);
        [slope - half, 2.0 * half, lobe(nearest, self.spread)]
    }
}

impl Truth {
    /// Under a light that adds `blur` to every detail's alpha^2.
    pub(super) fn new(material: &Material, blur: f64) -> Self {
        let global = material.alpha * material.alpha;
        let axes = material.fractions.map(|f| {
            let local = f * f * global;
            Axis { spread: global - local, local: local + blur }
        });
        Self { material: *material, axes }
    }

    /// Relative variance of a pixel.
    ///
    /// A pixel of n details in the mean has $E[P_l^2]/(n P_g^2)$: near the pole $1/(2 n P)$, half
    /// the variance of details that reflect all or nothing. For grooves, the expected sum of the
    /// squared shares of the pixel that its grooves fill takes the place of 1/n.
    pub(super) fn variance(&self, slope: [f64; 2], pixel: &Pixel) -> f64 {
        let across = self.axes[0].excess(slope[0]);
        if self.material.is_groove() {
            let [short, long] = widths(pixel);
            across * (long - short / 3.0) / (long * long * self.per_length(pixel))
        } else {
            across * self.axes[1].excess(slope[1]) / self.material.details
        }
    }

    /// A pixel over the smooth lobe. Only details near the half vector are drawn.
    pub(super) fn draw(&self, slope: [f64; 2], pixel: &Pixel, jitter: &mut Jitter) -> f64 {
        if self.material.is_groove() {
            return self.grooved(slope[0], pixel, jitter);
        }
        let windows = [0, 1].map(|k| self.axes[k].window(slope[k]));
        let [[u, du, most_u], [v, dv, most_v]] = windows;
        let details = self.material.details;
        let mut sum = 0.0;
        arrivals(details * du * most_u * dv * most_v, jitter, |chance, jitter| {
            let [a, b] = jitter.next();
            let at = [u + a * du, v + b * dv];
            let spread = |k: usize| lobe(at[k], self.axes[k].spread);
            if chance * most_u * most_v < spread(0) * spread(1) {
                sum += [0, 1]
                    .map(|k| lobe(slope[k] - at[k], self.axes[k].local))
                    .iter()
                    .product::<f64>();
            }
        });
        let mean = |k: usize| lobe(slope[k], self.axes[k].spread + self.axes[k].local);
        sum / (details * mean(0) * mean(1))
    }

    /// The same of grooves: each counts with its length within the pixel.
    fn grooved(&self, slope: f64, pixel: &Pixel, jitter: &mut Jitter) -> f64 {
        let axis = self.axes[0];
        let [begin, length, most] = axis.window(slope);
        let ([short, long], per_length) = (widths(pixel), self.per_length(pixel));
        let reach = short + long;
        let mut sum = 0.0;
        arrivals(per_length * reach * length * most, jitter, |chance, jitter| {
            let [place, at] = jitter.next();
            let at = begin + at * length;
            if chance * most < lobe(at, axis.spread) {
                let inside = 0.5 * reach - reach * (place - 0.5).abs();
                sum += (inside / short).min(1.0) / long * lobe(slope - at, axis.local);
            }
        });
        sum / (per_length * lobe(slope, axis.spread + axis.local))
    }

    /// Grooves per unit length across.
    fn per_length(&self, pixel: &Pixel) -> f64 {
        self.material.density(pixel.area).sqrt()
    }
}

/// Calls `f` for every event of a Poisson process, with a random number of its own.
pub(super) fn arrivals(mean: f64, jitter: &mut Jitter, mut f: impl FnMut(f64, &mut Jitter)) {
    let mut time = 0.0;
    loop {
        let [gap, chance] = jitter.next();
        time -= gap.ln();
        if time > mean {
            break;
        }
        f(chance, jitter);
    }
}

/// How far a pixel's two sides reach across grooves, the smaller first.
fn widths(pixel: &Pixel) -> [f64; 2] {
    let (a, b) = (pixel.patch.right[0].abs(), pixel.patch.up[0].abs());
    [a.min(b), a.max(b)]
}
