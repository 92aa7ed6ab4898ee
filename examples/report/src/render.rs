//! The methods' pictures of a scene: geometry once, every material and method on it.

use rayon::prelude::*;

use crate::camera::Size;
use crate::method::{Derivatives, Method, Rows, Surfacing};
use crate::pattern::hammersley;
use crate::scene::{Motions, Sample, Scene};

/// Pictures of a scene, rows from the top: `[material][method]`.
pub(crate) type Pictures = Vec<Vec<Vec<f32>>>;

/// Renders every material with every method; `rows_done` is called with the number of rows
/// finished.
pub(crate) fn render(
    scene: &Scene<f32>,
    size: Size,
    materials: &[Surfacing],
    methods: &[Method],
    rows_done: &(impl Fn(usize) + Sync),
) -> Pictures {
    let bands: Vec<_> = (0..size.height.div_ceil(2))
        .into_par_iter()
        .map(|band| {
            let rows = render_band(scene, 2 * band, size, materials, methods);
            rows_done(rows.len());
            rows
        })
        .collect();
    let mut pictures =
        vec![vec![Vec::with_capacity(size.pixels()); methods.len()]; materials.len()];
    for row in bands.into_iter().flatten() {
        let whole = pictures.iter_mut().flatten();
        whole.zip(row).for_each(|(picture, row)| picture.extend_from_slice(&row));
    }
    pictures
}

/// The two rows of a band of quads, one if the picture ends there: `[row][material and method]`.
fn render_band(
    scene: &Scene<f32>,
    y: usize,
    size: Size,
    materials: &[Surfacing],
    methods: &[Method],
) -> Vec<Vec<Vec<f32>>> {
    let even = size.width.next_multiple_of(2);
    let rows = 2.min(size.height - y);
    let blank = vec![vec![0.0; size.width]; materials.len() * methods.len()];
    let mut pictures = vec![blank; rows];

    let moves = methods.iter().any(|method| method.derivatives == Derivatives::Analytic);
    let band = [0, 1].map(|k| Row::at(scene, y + k, even, moves));
    for (row, pictures) in pictures.iter_mut().enumerate() {
        let (here, other) = (&band[row], &band[1 - row]);
        let rows = Rows { here: &here.samples, other: &other.samples, motions: &here.motions };
        let pictures = pictures.chunks_mut(methods.len()).zip(materials);
        for (pictures, material) in pictures {
            for (method, picture) in methods.iter().zip(pictures) {
                if method.filters() {
                    method.shade(material, &rows, picture);
                }
            }
        }
    }
    // Plain methods of one count share their samples.
    let mut counts: Vec<_> =
        methods.iter().filter(|method| !method.filters()).map(|method| method.samples).collect();
    counts.sort_unstable();
    counts.dedup();
    for (row, pictures) in pictures.iter_mut().enumerate() {
        for &count in &counts {
            supersample(scene, y + row, count, materials, methods, pictures);
        }
    }
    pictures
}

/// Fills the pictures of the plain methods of a sample count.
fn supersample(
    scene: &Scene<f32>,
    y: usize,
    count: u32,
    materials: &[Surfacing],
    methods: &[Method],
    pictures: &mut [Vec<f32>],
) {
    let width = pictures.first().map_or(0, Vec::len);
    let mut samples = Vec::new();
    let mut shaded = vec![0.0; width];
    let weight = 1.0 / count as f32;
    for index in 0..count {
        let offset = hammersley(index, count);
        sample_row(scene, y as f32, offset, width.next_multiple_of(2), &mut samples);
        let rows = Rows { here: &samples, other: &samples, motions: &[] };
        for (pictures, material) in pictures.chunks_mut(methods.len()).zip(materials) {
            let plain = methods.iter().zip(pictures);
            for (method, picture) in plain.filter(|(m, _)| !m.filters() && m.samples == count) {
                method.shade(material, &rows, &mut shaded);
                picture.iter_mut().zip(&shaded).for_each(|(sum, value)| *sum += weight * value);
            }
        }
    }
}

/// A row of samples at pixel centers, with motions if they are asked for.
struct Row {
    samples: Vec<Sample<f32>>,
    motions: Vec<Motions<f32>>,
}

impl Row {
    fn at(scene: &Scene<f32>, y: usize, count: usize, moves: bool) -> Self {
        if moves {
            let pixel = |x: usize| scene.sample_in_motion(x as f32 + 0.5, y as f32 + 0.5);
            let (samples, motions) = (0..count).map(pixel).unzip();
            return Self { samples, motions };
        }
        let mut samples = Vec::new();
        sample_row(scene, y as f32, [0.5, 0.5], count, &mut samples);
        Self { samples, motions: Vec::new() }
    }
}

/// Samples of the first `count` pixels of row `y`, at `offset` in each pixel.
fn sample_row(
    scene: &Scene<f32>,
    y: f32,
    offset: [f32; 2],
    count: usize,
    row: &mut Vec<Sample<f32>>,
) {
    row.clear();
    row.extend((0..count).map(|x| scene.sample(x as f32 + offset[0], y + offset[1])));
}
