//! A method's picture of a scene.

use rayon::prelude::*;

use crate::camera::Size;
use crate::method::{Material, Method, Rows};
use crate::pattern::hammersley;
use crate::scene::{Sample, Scene};

/// Radiance of every pixel under a light of unit irradiance, rows from the top.
pub(crate) fn render(
    scene: &Scene<f32>,
    size: Size,
    material: &Material,
    method: &Method,
    row_done: &(impl Fn() + Sync),
) -> Vec<f32> {
    let mut picture = vec![0.0; size.pixels()];
    picture.par_chunks_mut(size.width).enumerate().for_each(|(y, out)| {
        render_row(scene, y, material, method, out);
        row_done();
    });
    picture
}

fn render_row(scene: &Scene<f32>, y: usize, material: &Material, method: &Method, out: &mut [f32]) {
    let mut here = Vec::with_capacity(out.len() + 1);
    if method.filters {
        let mut above = Vec::with_capacity(out.len() + 1);
        sample_row(scene, y as f32, [0.5, 0.5], out.len() + 1, &mut here);
        sample_row(scene, y as f32 - 1.0, [0.5, 0.5], out.len() + 1, &mut above);
        method.shade(material, &Rows { here: &here, above: &above }, out);
        return;
    }
    let mut shaded = vec![0.0; out.len()];
    for index in 0..method.samples {
        sample_row(scene, y as f32, hammersley(index, method.samples), out.len() + 1, &mut here);
        method.shade(material, &Rows { here: &here, above: &here }, &mut shaded);
        for (sum, value) in out.iter_mut().zip(&shaded) {
            *sum += value;
        }
    }
    let weight = 1.0 / method.samples as f32;
    for sum in out {
        *sum *= weight;
    }
}

/// Samples of the first `count` pixels of row `y`, at `offset` in each pixel.
///
/// One more than the picture is wide gives the last pixel its right neighbour; row -1 gives the first
/// row its upper one.
pub(crate) fn sample_row(
    scene: &Scene<f32>,
    y: f32,
    offset: [f32; 2],
    count: usize,
    row: &mut Vec<Sample<f32>>,
) {
    row.clear();
    row.extend((0..count).map(|x| scene.sample(x as f32 + offset[0], y + offset[1])));
}
