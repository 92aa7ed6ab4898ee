//! A scene's picture: rays first, then one shading per pixel, by rows dealt to threads.

use super::camera::Camera;
use super::energy::Energy;
use super::options::Method;
use super::picture::{Picture, tone};
use super::pixel::shade;
use super::progress::Progress;
use super::scene::Scene;
use glam::Vec3;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::scope;

/// Rays along each side of a pixel that a silhouette crosses.
const RAYS: usize = 4;

/// How a scene is drawn.
#[derive(Clone, Copy)]
pub(crate) struct Renderer<'a> {
    pub(crate) size: [usize; 2],
    pub(crate) method: Method,
    pub(crate) seed: u32,
    /// Pictures and energies do not depend on them.
    pub(crate) threads: usize,
    pub(crate) progress: &'a Progress,
}

/// Texture coordinates, where a ray meets the surface.
type Hit = Option<[f64; 2]>;

impl Renderer<'_> {
    /// Steps of the progress for one picture.
    pub(crate) fn steps(&self) -> u64 {
        2 * self.size[1] as u64
    }

    /// The picture, and its energy.
    pub(crate) fn draw(&self, scene: &Scene) -> Result<(Picture, Energy), String> {
        let camera = Camera::new(&scene.view, self.size);
        let [width, _] = self.size;
        let hits: Vec<Vec<Hit>> = self.rows(|y| {
            let ray = |x: usize| camera.ray([x as f64 + 0.5, y as f64 + 0.5]);
            (0..width).map(|x| scene.surface.meet(&ray(x))).collect()
        })?;
        let rows = self.rows(|y| {
            let mut energy = Energy::default();
            let mut row = Vec::with_capacity(width);
            for x in 0..width {
                let (radiance, part) = self.pixel(scene, &camera, &hits, [x, y]);
                row.push(tone(radiance * scene.exposure, [x, y]));
                energy = energy.and(&part);
            }
            (row, energy)
        })?;
        // In the order of rows: the same sum for any number of threads.
        let energy = rows.iter().fold(Energy::default(), |sum, (_, part)| sum.and(part));
        let pixels = rows.into_iter().flat_map(|(row, _)| row).collect();
        Ok((Picture { size: self.size, pixels }, energy))
    }

    /// A pixel's radiance: shaded once, where it is covered by the surface, and the backdrop for
    /// the rest.
    fn pixel(
        &self,
        scene: &Scene,
        camera: &Camera,
        hits: &[Vec<Hit>],
        [x, y]: [usize; 2],
    ) -> (Vec3, Energy) {
        let center = [x as f64 + 0.5, y as f64 + 0.5];
        let backdrop = || (scene.backdrop)(camera.ray(center).direction);
        let here = hits[y][x];
        let neighbors = [
            (x > 0).then(|| hits[y][x - 1]),
            hits[y].get(x + 1).copied(),
            (y > 0).then(|| hits[y - 1][x]),
            hits.get(y + 1).map(|row| row[x]),
        ];
        let edge = neighbors.iter().flatten().any(|hit| hit.is_some() != here.is_some());
        let (part, shown) = if edge { coverage(scene, camera, center, here) } else { (1.0, here) };
        let Some(uv) = shown else { return (backdrop(), Energy::default()) };
        let (radiance, energy) = shade(scene, camera, uv, self.method);
        if edge {
            let mixed = backdrop().lerp(radiance, part as f32);
            return (mixed, energy.covering(part));
        }
        (radiance, energy)
    }

    /// What `each` makes of every row, in order; several at a time.
    fn rows<T: Send>(&self, each: impl Fn(usize) -> T + Sync) -> Result<Vec<T>, String> {
        let (next, height) = (AtomicUsize::new(0), self.size[1]);
        let work = || {
            let mut done = Vec::new();
            loop {
                let row = next.fetch_add(1, Ordering::Relaxed);
                if row >= height {
                    return Ok(done);
                }
                done.push((row, each(row)));
                self.progress.by(1)?;
            }
        };
        let parts: Vec<Result<_, String>> = scope(|scope| {
            let workers: Vec<_> =
                (0..self.threads.min(height)).map(|_| scope.spawn(work)).collect();
            let joined = workers.into_iter().map(std::thread::ScopedJoinHandle::join);
            joined
                .map(|made| made.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
                .collect()
        });
        let mut rows = Vec::with_capacity(height);
        for part in parts {
            rows.extend(part?);
        }
        rows.sort_by_key(|(row, _)| *row);
        Ok(rows.into_iter().map(|(_, made)| made).collect())
    }
}

/// Which part of a pixel the surface covers, by rays that shade nothing, and its place that lies
/// nearest to the center.
fn coverage(scene: &Scene, camera: &Camera, center: [f64; 2], here: Hit) -> (f64, Hit) {
    let offset = |k: usize| (k as f64 + 0.5) / RAYS as f64 - 0.5;
    let (mut count, mut nearest) = (0, (f64::INFINITY, here));
    for k in 0..RAYS * RAYS {
        let [dx, dy] = [offset(k % RAYS), offset(k / RAYS)];
        let hit = scene.surface.meet(&camera.ray([center[0] + dx, center[1] + dy]));
        if hit.is_some() {
            count += 1;
            let distance = dx * dx + dy * dy;
            if here.is_none() && distance < nearest.0 {
                nearest = (distance, hit);
            }
        }
    }
    (f64::from(count) / (RAYS * RAYS) as f64, nearest.1)
}
