//! Two scenes as plain numbers: what one sample sees in every pixel, what the report makes of it,
//! what is right.
//!
//! For renderers that are not ours, such as a fragment shader: given [`Shot::seen`], they should
//! draw the pictures of [`Shot::plain`], [`Shot::widened`] and [`Shot::exact`], and
//! [`Shot::errors`] judges theirs as the report judges its own. The same numbers come out of every
//! run, those of the report's `--quick --light distant --size WIDTH --alpha ALPHA`.
//!
//! # Quads
//!
//! Pixels (2i, 2j) to (2i + 1, 2j + 1), rows from the top, are a quad, as on a GPU. Every pixel has
//! its half vector in its *own* shading frame, $h = (w_o + w_i)/|w_o + w_i|$, and the slope of it
//! there, $s = (-h_x/h_z, -h_y/h_z)$. The sides of its footprint are the slopes of the pixel beside
//! it and of the one below or above it in the quad, less its own: `dpdxFine(s)` and `dpdyFine(s)`
//! but for the sign, which is theirs in even columns and rows and the opposite in odd ones, and
//! which no filter asks for. No half vector is brought into a neighbor's frame: how the frames turn
//! is part of the footprint (Kaplanyan et al. 2016, Eq. 6). If one of the three half vectors is not
//! above its horizon, the footprint is zero.

use lobe::Footprint;

use crate::camera::Size;
use crate::coverage;
use crate::footprints::Disagreement;
use crate::light::LightKind;
use crate::method::{self, Distribution, Method, MovingPixel, Pixel, QuadPixel, Surfacing};
use crate::metric::{self, Errors};
use crate::overlap;
use crate::page::Tone;
use crate::reference::{Reference, Sampling, Target};
use crate::render::render;
use crate::scene::{Sample, Scene, Subject, carried_maps};
use crate::study::QUICK_SAMPLES;
use crate::window::PixelWindow;

pub use crate::scene::Traced;

/// What the sample at a pixel's center sees, as the methods get it: directions are of unit length,
/// in the pixel's own shading frame, the normal along z, but for [`Seen::normal`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seen {
    /// To the eye.
    pub wo: [f32; 3],
    /// To the light.
    pub wi: [f32; 3],
    /// Their half vector.
    pub half: [f32; 3],
    /// The normal, in the world: what a G-buffer holds.
    pub normal: [f32; 3],
    /// Irradiance on a surface that faces the light: a pixel is BRDF times `wi[2]` times this.
    pub strength: f32,
    /// Whether there is a surface. Without one all numbers are zero, and the pixel is black.
    pub covered: bool,
}

/// A method's picture, and what it should be.
#[derive(Clone, Debug)]
pub struct Shaded {
    /// As in the report's tables.
    pub name: String,
    /// Radiance, rows from the top.
    pub picture: Vec<f32>,
    /// The converged picture under the pixel filter that the method approximates.
    pub reference: Vec<f64>,
    /// The reference's standard error, on the scale of the errors.
    pub noise: f64,
    /// Of the picture against the reference: what the report prints.
    pub errors: Errors,
}

/// A scene under its distant light, seen once, with a GGX of one alpha.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The scene, as in the report's tables.
    pub name: String,
    /// What is seen.
    pub caption: String,
    /// Roughness of the GGX, the same in all directions.
    pub alpha: f64,
    /// Of the pictures, in pixels.
    pub width: usize,
    /// Of the pictures, in pixels: nine sixteenths of the width.
    pub height: usize,
    /// Of whole quads, rows from the top: [`Shot::quad_size`] pixels, those outside the pictures
    /// included.
    pub seen: Vec<Seen>,
    /// The sides of each pixel's footprint on the slope plane, towards the pixels beside and below
    /// or above: to compare with. Of the pictures' size.
    pub footprints: Vec<[[f32; 2]; 2]>,
    /// What Kaplanyan's matrix M is made of, of whole quads as `seen`; for the balls, which have no
    /// normal map.
    pub traced: Vec<Traced<f32>>,
    /// The sides by the scene's own derivatives, towards the pixels at the right and below: what M
    /// gives on the balls. Of the pictures' size.
    pub analytic: Vec<[[f32; 2]; 2]>,
    /// How far those two footprints are from each other by [`non_overlap`]: the report's Fig. 7; 0
    /// where a pixel is not judged.
    pub disagreement: Vec<f64>,
    /// The pixels that errors count: those whose 3 x 3 neighbors are covered.
    pub judged: Vec<bool>,
    /// Brings radiance to a mean box reference of 1 over the judged pixels.
    pub scale: f64,
    /// GGX, no filter. Under the box.
    pub plain: Shaded,
    /// Variance addition, 1/12: a wider GGX. Under the Gaussian of that variance.
    pub widened: Shaded,
    /// The exact mean over the parallelogram. Under the box.
    pub exact: Shaded,
}

/// The methods that are shown, by name.
const METHODS: [&str; 3] = ["none (1 sample)", "variance addition, 1/12", "exact parallelogram"];

impl Shot {
    /// Balls of many sizes: curvature that makes a highlight of a pixel and less. The report's
    /// scene `sphere`.
    ///
    /// `width` is that of the picture; [`QUICK_WIDTH`](crate::QUICK_WIDTH) is the one of quick
    /// runs.
    ///
    /// # Errors
    /// If alpha is negative or not finite.
    pub fn balls(width: usize, alpha: f64) -> Result<Self, String> {
        Self::of(Subject::balls(Size::of_width(width)), alpha)
    }

    /// A plane with a normal map: every pixel has a shading frame of its own. The report's scene
    /// `plane: leather`.
    ///
    /// # Errors
    /// If alpha is negative or not finite.
    pub fn leather(width: usize, alpha: f64) -> Result<Self, String> {
        let maps = carried_maps(false)?;
        let map = maps.first().ok_or("no normal map is carried")?;
        Self::of(Subject::plane(Size::of_width(width), map), alpha)
    }

    /// Columns and rows of [`Shot::seen`]: the pictures' size, made even.
    pub fn quad_size(&self) -> [usize; 2] {
        [self.width, self.height].map(|side| side.next_multiple_of(2))
    }

    /// What a pixel of [`Shot::seen`] sees, the one beside it in its quad, and the one below or
    /// above it.
    pub fn quad(&self, x: usize, y: usize) -> [&Seen; 3] {
        [(x, y), (x ^ 1, y), (x, y ^ 1)].map(|(x, y)| &self.seen[y * self.quad_size()[0] + x])
    }

    /// Errors of a picture of the same scene against the reference of one of the methods.
    pub fn errors(&self, picture: &[f32], of: &Shaded) -> Errors {
        Errors::of(picture, &of.reference, &self.judged, self.scale)
    }

    /// Gray bytes in sRGB of a picture as the report's page shows it, under the tone curve of the
    /// box reference.
    pub fn shown(&self, picture: &[f64]) -> Vec<u8> {
        Tone::of(&self.exact.reference).gray(picture)
    }

    fn of(subject: Subject, alpha: f64) -> Result<Self, String> {
        let wrong = |error: lobe::Error| error.to_string();
        let lit = subject.lit(LightKind::Distant);
        let (size, finish) = (subject.size, subject.finish);
        let judged = coverage::judged(&lit.exact, size);
        let materials = [Surfacing::new(finish, alpha).map_err(wrong)?];
        let target = Target { scene: &lit.exact, size, finish, alphas: &[alpha], judged: &judged };
        let references =
            Sampling::of_still(QUICK_SAMPLES).render(&target, &|| ()).map_err(wrong)?;
        let reference = references.of(0, Distribution::Ggx);
        let scale = metric::scale(&reference.radiance[PixelWindow::Box as usize], &judged);

        let methods = methods();
        let pictures = render(&lit.engine, size, &materials, &methods, &|_| ());
        let shaded = methods.iter().zip(pictures.into_iter().flatten());
        let shaded: Vec<_> =
            shaded.map(|(m, picture)| Shaded::of(m, picture, reference, &judged, scale)).collect();
        let Ok([plain, widened, exact]) = <[Shaded; 3]>::try_from(shaded) else {
            return Err("a method of these names is missing".into());
        };
        let samples = Samples::at_centers(&lit.engine, size);
        Ok(Self {
            name: subject.name,
            caption: subject.caption,
            alpha,
            width: size.width,
            height: size.height,
            seen: samples.seen(),
            footprints: samples.footprints(size),
            traced: centers(samples.width, samples.samples.len())
                .map(|[x, y]| lit.engine.traced(x, y))
                .collect(),
            analytic: centers(size.width, size.pixels())
                .map(|[x, y]| {
                    let (here, motions) = lit.engine.sample_in_motion(x, y);
                    let footprint = MovingPixel { here: &here, motions: &motions }.footprint();
                    [footprint.u, footprint.v]
                })
                .collect(),
            disagreement: Disagreement::on(&lit.engine, size, &judged)
                .map_or_else(Vec::new, |on| on.map),
            judged,
            scale,
            plain,
            widened,
            exact,
        })
    }
}

/// Those of [`METHODS`], in their order.
fn methods() -> Vec<Method> {
    let ggx = |method: &Method| method.distribution == Distribution::Ggx;
    let place = |method: &Method| METHODS.iter().position(|name| *name == method.name);
    let mut methods: Vec<_> =
        method::all().into_iter().filter(|m| ggx(m) && place(m).is_some()).collect();
    methods.sort_by_key(place);
    methods
}

impl Shaded {
    fn of(
        method: &Method,
        picture: Vec<f32>,
        reference: &Reference,
        judged: &[bool],
        scale: f64,
    ) -> Self {
        let window = method.window as usize;
        let radiance = &reference.radiance[window];
        Self {
            name: method.name.clone(),
            errors: Errors::of(&picture, radiance, judged, scale),
            picture,
            reference: radiance.clone(),
            noise: reference.noise[window] * scale,
        }
    }
}

/// Area of non-overlap of two footprints, given as their sides, over the larger area (Kaplanyan et
/// al. 2016, Fig. 7).
///
/// From 0 for equal ones to 2 for disjoint ones of one area; 1 if one alone has no area.
pub fn non_overlap(a: [[f32; 2]; 2], b: [[f32; 2]; 2]) -> f64 {
    let [a, b] = [a, b].map(|[u, v]| Footprint::from_slopes(u, v));
    overlap::non_overlap(&a, &b)
}

/// Centers of so many pixels, row by row.
fn centers(width: usize, count: usize) -> impl Iterator<Item = [f32; 2]> {
    (0..count).map(move |index| [index % width, index / width].map(|corner| corner as f32 + 0.5))
}

/// Samples at the centers of whole quads of pixels.
struct Samples {
    width: usize,
    samples: Vec<Sample<f32>>,
}

impl Samples {
    fn at_centers(scene: &Scene<f32>, size: Size) -> Self {
        let [width, height] = [size.width, size.height].map(|side| side.next_multiple_of(2));
        let samples = centers(width, width * height).map(|[x, y]| scene.sample(x, y)).collect();
        Self { width, samples }
    }

    fn seen(&self) -> Vec<Seen> {
        let seen = |s: &Sample<f32>| {
            let Sample { wo, wi, half, normal, strength, hit, .. } = *s;
            Seen { wo, wi, half, normal, strength, covered: hit }
        };
        self.samples.iter().map(seen).collect()
    }

    /// Of the pixels of a picture.
    fn footprints(&self, size: Size) -> Vec<[[f32; 2]; 2]> {
        let footprint = |index: usize| {
            let (x, y) = (index % size.width, index / size.width);
            let at = |x: usize, y: usize| &self.samples[y * self.width + x];
            let (here, beside, below) = (at(x, y), at(x ^ 1, y), at(x, y ^ 1));
            let footprint = QuadPixel { here, beside, below, across: at(x ^ 1, y ^ 1) }.footprint();
            [footprint.u, footprint.v]
        };
        (0..size.pixels()).map(footprint).collect()
    }
}

#[cfg(test)]
mod tests;
