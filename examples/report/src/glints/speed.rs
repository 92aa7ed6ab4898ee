//! Nanoseconds per evaluation, one thread, in turns: by view, by cells, by the density of details.

use std::hint::black_box;

use lobe::Error;
use lobe::slope::direction::{normal_of, reflect};
use serde::Serialize;

use super::cells::{cut, whole};
use super::material::{Material, snow};
use super::model::{Made, Model, Seen};
use super::points::Points;
use super::sample::{Light, Pixel};
use crate::pattern::Jitter;
use crate::timing::in_turns;
use crate::vector::dot;

/// Elevations of the view in degrees: steep, grazing as in the paper, and where pixels are as long
/// as they may be.
///
/// Not 90: straight from above Beckmann's masking underflows, which takes processors longer than
/// the whole lobe.
pub(crate) const ELEVATIONS: [f64; 3] = [85.0, 10.0, 3.583_32];

/// Models that stand in the table.
pub(crate) const TIMED: [Model; 5] =
    [Model::Smooth, Model::Default, Model::Varied, Model::Published, Model::PublishedVaried];

/// Models in the charts.
pub(crate) const DRAWN: [Model; 2] = [Model::Default, Model::Published];

/// Details in a pixel where their number does not vary.
pub(crate) const DETAILS: f64 = 1e3;

/// Aspects of the chart over cells.
const SHAPES: [f64; 8] = [1.0, 1.5, 2.5, 4.0, 6.0, 8.5, 12.0, 16.0];

/// Details in a pixel, powers of ten; of points up to the fifth.
const DECADES: u32 = 10;
const POINTS_TO: u32 = 4;

/// Medians in nanoseconds per pixel.
#[derive(Serialize)]
pub(crate) struct Speed {
    /// Aspects of [`ELEVATIONS`].
    pub(crate) aspects: [f64; 3],
    /// Mean cells of the default and of the published model there.
    pub(crate) cells: [[f64; 3]; 2],
    /// For each of [`TIMED`].
    pub(crate) views: Vec<Timed>,
    /// For each of [`DRAWN`]: mean cells and time.
    pub(crate) by_cells: Vec<Curve>,
    /// For each of [`DRAWN`] at the first view and the last: details in a pixel and time.
    pub(crate) by_details: Vec<Curve>,
    /// The brute force at the first view.
    pub(crate) points: Vec<[f64; 2]>,
}

/// A model's times at [`ELEVATIONS`].
#[derive(Serialize)]
pub(crate) struct Timed {
    pub(crate) model: Model,
    pub(crate) times: [f64; 3],
}

/// A model's times over something else.
#[derive(Serialize)]
pub(crate) struct Curve {
    pub(crate) model: Model,
    pub(crate) aspect: f64,
    pub(crate) points: Vec<[f64; 2]>,
}

impl Speed {
    /// The smooth lobe's times.
    pub(crate) fn smooth(&self) -> [f64; 3] {
        self.times(Model::Smooth).unwrap_or([f64::NAN; 3])
    }

    fn times(&self, model: Model) -> Option<[f64; 3]> {
        self.views.iter().find(|timed| timed.model == model).map(|timed| timed.times)
    }

    /// What glints add to the smooth lobe at the second and third view over what they add at the
    /// first.
    pub(crate) fn growth(&self, model: Model) -> [Option<f64>; 2] {
        let added = |k: usize| Some(self.times(model)?[k] - self.smooth()[k]);
        [1, 2].map(|k| (model != Model::Smooth).then(|| Some(added(k)? / added(0)?)).flatten())
    }
}

impl Curve {
    /// Slope of the line through the points by least squares, and how far off it one is at most,
    /// over its height.
    pub(crate) fn line(&self) -> (f64, f64) {
        let count = self.points.len() as f64;
        let mean = [0, 1].map(|k| self.points.iter().map(|p| p[k]).sum::<f64>() / count);
        let product = |a: usize, b: usize| {
            self.points.iter().map(|p| (p[a] - mean[a]) * (p[b] - mean[b])).sum::<f64>()
        };
        let slope = product(0, 1) / product(0, 0);
        let off = |p: &[f64; 2]| {
            let height = mean[1] + slope * (p[0] - mean[0]);
            (p[1] / height - 1.0).abs()
        };
        (slope, self.points.iter().map(off).fold(0.0, f64::max))
    }
}

/// How much is timed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Load {
    pub(super) pixels: u64,
    pub(super) rounds: usize,
}

/// A pass over some pixels.
type Task<'a> = Box<dyn Fn() + 'a>;

impl Speed {
    pub(super) fn measured(load: Load) -> Result<Self, Error> {
        let material = snow("", DETAILS);
        let made = Made::new(&material, 1.0, 0)?;
        let aspects = ELEVATIONS.map(|elevation| 1.0 / elevation.to_radians().sin());
        let views = aspects.map(|aspect| pixels(&material, aspect, load.pixels));
        let shapes = SHAPES.map(|aspect| pixels(&material, aspect, load.pixels));
        let thousands = (0..=DECADES)
            .map(|power| Made::new(&snow("", 10.0_f64.powf(power.into())), 1.0, 0))
            .collect::<Result<Vec<_>, _>>()?;
        let surfaces: Vec<_> = (0..=POINTS_TO)
            .map(|power| Points::new(&material, 10.0_f64.powf(power.into()), 0))
            .collect();

        let few: Vec<_> = views[0].iter().take(POINTS_PER_PASS).collect();
        let mut tasks: Vec<Task<'_>> = Vec::new();
        for model in TIMED {
            tasks.extend(views.iter().map(|view| pass(&made, model, view)));
        }
        for model in DRAWN {
            tasks.extend(shapes.iter().map(|shape| pass(&made, model, shape)));
        }
        for model in DRAWN {
            for view in [&views[0], &views[2]] {
                tasks.extend(thousands.iter().map(|made| pass(made, model, view)));
            }
        }
        for surface in &surfaces {
            tasks.push(Box::new(|| {
                for pixel in &few {
                    black_box(surface.slope_pdf(&black_box(pixel).exact.patch, pixel.slope));
                }
            }));
        }
        let mut times = in_turns(tasks.len(), load.rounds, |task| tasks[task]()).into_iter();
        let mut next = |pixels: usize| times.next().unwrap_or_default() / pixels.max(1) as f64;

        let exact = Made::<f64>::new(&material, 1.0, 0)?;
        let mean = |view: &[Pixels], count: fn(&Made<f64>, &Pixels) -> f64| {
            view.iter().map(|p| count(&exact, p)).sum::<f64>() / view.len() as f64
        };
        let of = |model: Model| -> fn(&Made<f64>, &Pixels) -> f64 {
            match model {
                Model::Published => |made, p| cut(made, &p.exact.patch)[0],
                _ => |made, p| whole(made, &p.exact.patch),
            }
        };
        let timed =
            TIMED.map(|model| Timed { model, times: [0, 1, 2].map(|k| next(views[k].len())) });
        let by_cells = DRAWN.map(|model| Curve {
            model,
            aspect: f64::NAN,
            points: shapes
                .iter()
                .map(|shape| [mean(shape, of(model)), next(shape.len())])
                .collect(),
        });
        let decades = || (0..=DECADES).map(|power| 10.0_f64.powf(power.into()));
        let mut by_details = Vec::new();
        for model in DRAWN {
            for k in [0, 2] {
                let points = decades().map(|details| [details, next(views[k].len())]).collect();
                by_details.push(Curve { model, aspect: aspects[k], points });
            }
        }
        let points = decades().take(surfaces.len()).map(|d| [d, next(few.len())]).collect();
        Ok(Self {
            aspects,
            cells: DRAWN.map(|model| [0, 1, 2].map(|k| mean(&views[k], of(model)))),
            views: timed.into(),
            by_cells: by_cells.into(),
            by_details,
            points,
        })
    }
}

/// Points take their time: so few pixels of them.
const POINTS_PER_PASS: usize = 4;

/// A pixel to time, in both precisions.
struct Pixels {
    seen: Seen<f32>,
    exact: Seen<f64>,
    /// Of the half vector.
    slope: [f64; 2],
}

/// Pixels of a plane seen from `1 / aspect` high, under a point light, half vectors spread as the
/// smooth lobe.
fn pixels(material: &Material, aspect: f64, count: u64) -> Vec<Pixels> {
    let one = |index: u64| {
        let mut jitter = Jitter::new(!index);
        // Areas from a half to 2.
        let Pixel { patch: mut pixel, angle, .. } = Pixel::random(aspect, None, index);
        let scale = 1.0 / (2.0 * aspect).sqrt();
        (pixel.right, pixel.up) = (pixel.right.map(|x| scale * x), pixel.up.map(|x| scale * x));
        let sine = 1.0 / aspect;
        let cosine = (1.0 - sine * sine).max(0.0).sqrt();
        let wo = [cosine * angle.cos(), cosine * angle.sin(), sine];
        loop {
            let [tail, turn] = jitter.next();
            let radius = material.alpha * (-tail.ln()).sqrt();
            let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
            let slope = [radius * cos, radius * sin];
            let h = normal_of(slope);
            let wi = reflect(wo, h);
            if dot(wo, h) > 0.0 && wi[2] > LEAST {
                let exact = Seen { patch: pixel, wo, wi, radius: Light::Point.radius() };
                return Pixels { seen: exact.cast(), exact, slope };
            }
        }
    };
    (0..count).map(one).collect()
}

/// Lights lower than this are left out.
const LEAST: f64 = 0.05;

fn pass<'a>(made: &'a Made<f32>, model: Model, pixels: &'a [Pixels]) -> Task<'a> {
    Box::new(move || {
        for pixel in pixels {
            black_box(black_box(made).brdf(model, black_box(&pixel.seen)));
        }
    })
}
