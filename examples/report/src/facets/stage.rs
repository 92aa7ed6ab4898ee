//! A body before a camera under distant lights: what shading needs of each point of the picture.

use lobe::material::cells::Patch;
use lobe::slope::MeanFrame;
use lobe::slope::direction::{half_vector, normalize, slope_of};
use lobe::{Error, Psd, Real, SlopeMoments};
use serde::Serialize;

use super::body::{Body, distance};
use super::fibers::Fibers;
use crate::camera::{Camera, Size};
use crate::frame::Frame;
use crate::vector::{Vector, dot, scaled};

/// What is known of the normal map under a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Normals {
    /// Its slope at the point.
    Point,
    /// The mean.
    Mean,
    /// And the variances, without their correlation.
    Apart,
    /// And that.
    Whole,
}

/// A body, lit.
pub(super) struct Stage {
    pub(super) size: Size,
    pub(super) camera: Camera<f64>,
    pub(super) body: Body,
    /// Unit directions.
    pub(super) lights: Vec<Vector<f64>>,
    pub(super) fibers: Option<Fibers>,
    /// Texture coordinates of a pixel's length on the body.
    pub(super) unit: f64,
}

/// A point of the picture on the body.
struct Place {
    frame: Frame<f64>,
    wo: Vector<f64>,
    patch: Patch<f64>,
}

/// A pixel under one light, in the frame that it is shaded in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen<R> {
    pub(super) patch: Patch<R>,
    pub(super) wo: [R; 3],
    pub(super) wi: [R; 3],
    /// Of the normal map, about their mean; none without a map.
    pub(super) moments: Option<SlopeMoments<R>>,
    /// Derivatives to the pixels at the right and above: of the unit half vector's first two
    /// components, and of its slope.
    pub(super) disk: [[R; 2]; 2],
    pub(super) slope: [[R; 2]; 2],
}

/// Half the distance of differences, in pixels.
const STEP: f64 = 1e-3;

impl Stage {
    /// What is seen at a point of the picture, without derivatives; one for each light.
    pub(super) fn points(&self, x: f64, y: f64) -> Option<Vec<Seen<f64>>> {
        let place = self.place(x, y)?;
        let (frame, moments) = self.shading(&place, Normals::Point).ok()?;
        let seen = self.lights.iter().map(|&light| place.seen(&frame, moments, light));
        Some(seen.collect())
    }

    /// The same with derivatives.
    pub(super) fn pixels(&self, x: f64, y: f64, normals: Normals) -> Option<Vec<Seen<f64>>> {
        let place = self.place(x, y)?;
        let (frame, moments) = self.shading(&place, normals).ok()?;
        // Each in its own frame of the surface, all of them turned alike to the map's mean: what
        // the map's slopes differ by is in its moments.
        let near = [[STEP, 0.0], [-STEP, 0.0], [0.0, -STEP], [0.0, STEP]]
            .map(|[right, down]| self.place(x + right, y + down));
        let seen = self.lights.iter().map(|&light| {
            let half = near.each_ref().map(|near| {
                near.as_ref().map(|near| frame.to_local(half_vector(near.wo, near.to(light))))
            });
            let difference = |of: fn([f64; 3]) -> [f64; 2]| {
                [[half[0], half[1]], [half[2], half[3]]].map(|[after, before]| {
                    let (Some(after), Some(before)) = (after, before) else { return [0.0; 2] };
                    let (after, before) = (of(after), of(before));
                    [0, 1].map(|k| (after[k] - before[k]) / (2.0 * STEP))
                })
            };
            Seen {
                disk: difference(|[x, y, _]| [x, y]),
                slope: difference(slope_of),
                ..place.seen(&frame, moments, light)
            }
        });
        Some(seen.collect())
    }

    fn place(&self, x: f64, y: f64) -> Option<Place> {
        let ray = self.camera.ray(x, y);
        let hit = self.body.hit(&ray)?;
        let steps = self.camera.differentials(&ray, distance(&ray, hit.point), hit.normal);
        let [right, up] = steps.map(|step| hit.gradients.map(|gradient| dot(gradient, step)));
        let frame = Frame::around(hit.normal, hit.tangent);
        let wo = frame.to_local(normalize(scaled(-1.0, ray.direction)));
        let [uv, right, up] = [hit.uv, right, up].map(|v| v.map(|x| self.unit * x));
        Some(Place { frame, wo, patch: Patch::new(uv, right, up) })
    }

    /// The frame about the map's mean slope, and what is known of slopes about it.
    fn shading(
        &self,
        place: &Place,
        normals: Normals,
    ) -> Result<(MeanFrame<f64>, Option<SlopeMoments<f64>>), Error> {
        let Some(fibers) = &self.fibers else { return Ok((MeanFrame::of([0.0; 2]), None)) };
        if normals == Normals::Point {
            return Ok((MeanFrame::of(fibers.slope(place.patch.uv)), None));
        }
        let moments = fibers.moments(&place.patch);
        let frame = MeanFrame::of(moments.mean());
        let about = frame.moments(&moments);
        let [xx, _, yy] = about.covariance().entries();
        let known = match normals {
            Normals::Point | Normals::Mean => None,
            Normals::Apart => Some(SlopeMoments::new([0.0; 2], Psd::new(xx, 0.0, yy)?)?),
            Normals::Whole => Some(about),
        };
        Ok((frame, known))
    }
}

impl Place {
    /// A light's direction in the surface's frame.
    fn to(&self, light: Vector<f64>) -> Vector<f64> {
        self.frame.to_local(light)
    }

    fn seen(
        &self,
        frame: &MeanFrame<f64>,
        moments: Option<SlopeMoments<f64>>,
        light: Vector<f64>,
    ) -> Seen<f64> {
        Seen {
            patch: self.patch,
            wo: frame.to_local(self.wo),
            wi: frame.to_local(self.to(light)),
            moments,
            disk: [[0.0; 2]; 2],
            slope: [[0.0; 2]; 2],
        }
    }
}

impl Seen<f64> {
    /// The same in another precision.
    pub(super) fn cast<R: Real>(&self) -> Result<Seen<R>, Error> {
        let pair = |v: [f64; 2]| v.map(R::lit);
        let vector = |v: [f64; 3]| v.map(R::lit);
        let Patch { tile, uv, right, up } = self.patch;
        let moments = self.moments.map(|moments| {
            let [xx, xy, yy] = vector(moments.covariance().entries());
            SlopeMoments::new(pair(moments.mean()), Psd::nearest(xx, xy, yy))
        });
        Ok(Seen {
            patch: Patch::in_tile(tile, pair(uv), pair(right), pair(up)),
            wo: vector(self.wo),
            wi: vector(self.wi),
            moments: moments.transpose()?,
            disk: self.disk.map(pair),
            slope: self.slope.map(pair),
        })
    }
}
