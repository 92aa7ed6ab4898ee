//! Cells under a pixel: shares that sum to 1, in bounded number, without jumps (law Z5), and any
//! pixel at all (law B1).
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::{ODD, check, ensure, near};
use lobe::material::cells::Patch;
use lobe::material::glint::{ANISOTROPY_LIMIT, CoveredCell, Grid};
use nalgebra::{Matrix2, SymmetricEigen, Vector2};
use std::collections::HashMap;

/// A pixel of any shape: round, long, sheared, thin, nothing at all along one axis.
fn patch(source: &mut Source) -> Patch<f64> {
    let size = source.log_uniform(1e-6, 1.0);
    let mut side = || {
        let long = size * source.log_uniform(1e-3, 1.0);
        let angle = match source.pick(4) {
            0 => 0.0,
            1 => core::f64::consts::FRAC_PI_4,
            _ => source.uniform(-3.2, 3.2),
        };
        [long * f64::cos(angle), long * f64::sin(angle)]
    };
    let (right, mut up) = (side(), side());
    match source.pick(8) {
        0 => up = [0.0; 2],
        1 => up = right.map(|x| 1.5 * x),
        // A square, turned by anything; and medians of equal extent.
        2 => up = [-right[1], right[0]],
        3 => up[0] = right[0],
        _ => {}
    }
    let uv = [0, 1].map(|_| match source.pick(4) {
        0 => 0.0,
        // A cell's center, and the middle between two.
        1 => f64::from(source.pick(9) as i32 - 4) * 0.125,
        _ => source.uniform(-2.0, 2.0),
    });
    Patch::new(uv, right, up)
}

fn stretch(source: &mut Source) -> [f64; 2] {
    match source.pick(5) {
        0 => [source.log_uniform(1e-3, 1.0), 1.0],
        1 => [1.0, source.log_uniform(1e-3, 1.0)],
        2 => [1.0, 0.0],
        _ => [1.0; 2],
    }
}

fn cells(grid: &Grid<f64>) -> Vec<CoveredCell<f64>> {
    let mut cells = Vec::new();
    grid.visit(|cell| cells.push(cell));
    cells
}

#[test]
fn shares_are_positive_and_sum_to_one_over_a_bounded_number_of_cells() {
    check(50_000, |source| {
        let (patch, factors) = (patch(source), stretch(source));
        let least = if source.pick(2) == 0 { 1e-12 } else { source.log_uniform(1e-6, 1.0) };
        let cells = cells(&Grid::stretched(&patch, factors, least));
        let sum: f64 = cells.iter().map(|cell| cell.share).sum();
        near(sum, 1.0, 1e-12, &(patch, factors, least))?;
        ensure(cells.iter().all(|cell| cell.share > 0.0), "a share", &(patch, factors))?;
        let most = 2 * (3 * ANISOTROPY_LIMIT + 4) as usize;
        ensure(cells.len() <= most, "too many cells", &(patch, factors, cells.len()))
    });
}

/// Without compression cells are as large as the pixel is wide: between half of its width and all
/// of it on the finer grid.
#[test]
fn cells_are_as_large_as_the_pixel_is_wide() {
    check(20_000, |source| {
        let patch = patch(source);
        let [a, b] = patch.extents();
        let long = a.max(b);
        let matrix = Matrix2::from_columns(&[patch.right.into(), patch.up.into()]);
        let shorter = matrix.singular_values().min();
        // The sum of squares that nalgebra begins with keeps half of the digits of a thin pixel's
        // width.
        near(patch.width(), shorter, 1e-12 * shorter + 1e-15 * long, &patch)?;
        let width = patch.width().max(long / f64::from(ANISOTROPY_LIMIT));
        let grid = Grid::new(&patch, 1e-12);
        let finer = f64::powi(2.0, grid.exponent());
        // Nor are they smaller than 2^-20 of the way to the origin.
        let width = width.max(patch.uv[0].abs().max(patch.uv[1].abs()) * f64::powi(2.0, -20));
        ensure(finer <= width && width <= 2.0 * finer, "size", &(patch, finer, width))?;
        near(finer * grid.coarser().exp2(), width, 1e-12 * width, &patch)
    });
}

/// Every cell stands next to the pixel's middle line: nothing far away is seen.
#[test]
fn cells_stand_next_to_the_pixel() {
    check(20_000, |source| {
        let (patch, factors) = (patch(source), stretch(source));
        let grid = Grid::stretched(&patch, factors, 1e-12);
        let scaled = |v: [f64; 2]| Vector2::new(v[0] * factors[0], v[1] * factors[1]);
        let (uv, right, up) = (scaled(patch.uv), scaled(patch.right), scaled(patch.up));
        for CoveredCell { index, exponent, .. } in cells(&grid) {
            let size = f64::powi(2.0, exponent);
            let offset = Vector2::from(index.map(|i| i as f64)) * size - uv;
            // In the parallelogram's own coordinates, grown by two cells each way.
            let reach = [0, 1].map(|k| 0.5 * (right[k].abs() + up[k].abs()) + 2.0 * size);
            let inside = offset[0].abs() <= reach[0] && offset[1].abs() <= reach[1];
            ensure(inside, "a cell beside the pixel's box", &(patch, factors, index, exponent))?;
            // Of a thin pixel, next to its line.
            let moment = right * right.transpose() + up * up.transpose();
            let eigen = SymmetricEigen::new(moment);
            let across = eigen.eigenvectors.column(eigen.eigenvalues.imin());
            let distance = across.dot(&offset).abs();
            let width = eigen.eigenvalues.min().max(0.0).sqrt();
            let near = distance <= 2.5 * size + width;
            ensure(
                near,
                "a cell away from the pixel",
                &(patch, factors, index, exponent, distance),
            )?;
        }
        Ok(())
    });
}

/// Shares by place: cells of two levels at one place are one.
fn shares(grid: &Grid<f64>) -> HashMap<([i64; 2], i32), f64> {
    cells(grid).into_iter().map(|cell| ((cell.index, cell.exponent), cell.share)).collect()
}

/// Law Z5: shares move by no more than a few times what the pixel does, whatever it crosses: cells,
/// ends, levels.
#[test]
fn shares_change_as_little_as_the_pixel() {
    check(50_000, |source| {
        let (here, factors) = (patch(source), stretch(source));
        let grid = Grid::stretched(&here, factors, 1e-9);
        let step = 1e-9;
        let mut nudge = |x: f64| x * (1.0 + step * source.uniform(-1.0, 1.0));
        let there = Patch {
            uv: here.uv.map(|x| x + step * f64::powi(2.0, grid.exponent())),
            right: here.right.map(&mut nudge),
            up: here.up.map(&mut nudge),
            ..here
        };
        let moved = Grid::stretched(&there, factors, 1e-9);
        let (one, other) = (shares(&grid), shares(&moved));
        let all = one.keys().chain(other.keys());
        for key in all {
            let (a, b) = (one.get(key).unwrap_or(&0.0), other.get(key).unwrap_or(&0.0));
            // Of a pixel whose width is a difference, relative steps of the derivatives are larger
            // ones of it. Where both extents of a long pixel are equal, columns become rows.
            let scaled = |v: [f64; 2]| [v[0] * factors[0], v[1] * factors[1]];
            let stretched = Patch::new(here.uv, scaled(here.right), scaled(here.up));
            let [e, f] = stretched.extents();
            let long = here.extents()[0].max(here.extents()[1]);
            let anisotropy = (long * long / here.area().max(1e-300)).min(1e6);
            let long_one = e > stretched.width() * (1.0 + 1e-6);
            let turns =
                long_one && (e / f - 1.0).abs() < 1e-6 && e > f64::powi(2.0, grid.exponent());
            let allowed = 100.0 * step * (1.0 + anisotropy);
            ensure(turns || (a - b).abs() <= allowed, "a jump", &(here, factors, key, a, b))?;
        }
        Ok(())
    });
}

/// A plane that faces the camera has square pixels, and rounding says which side is longer: no
/// share may depend on it.
#[test]
fn rounding_does_not_turn_squares() {
    check(20_000, |source| {
        let (width, turn) = (source.log_uniform(1e-3, 1.0), source.uniform(-3.2, 3.2));
        let (sin, cos) = turn.sin_cos();
        let uv = [source.uniform(-2.0, 2.0) as f32, source.uniform(-2.0, 2.0) as f32];
        // As differences in a quad have it.
        let mut pixel = || {
            let mut side = |x: f64| (width * x * (1.0 + 1e-5 * source.uniform(-1.0, 1.0))) as f32;
            let (right, up) = ([side(cos), side(sin)], [side(-sin), side(cos)]);
            let mut shares = HashMap::new();
            Grid::new(&Patch::new(uv, right, up), 1e-9).visit(|cell| {
                shares.insert((cell.index, cell.exponent), f64::from(cell.share));
            });
            shares
        };
        let (one, other) = (pixel(), pixel());
        let share = |of: &HashMap<_, f64>, key| of.get(key).copied().unwrap_or(0.0);
        let keys = one.keys().chain(other.keys().filter(|key| !one.contains_key(*key)));
        let moved: f64 = keys.map(|key| (share(&one, key) - share(&other, key)).abs()).sum();
        ensure(moved < 1e-3, "a square turned", &(width, turn, uv, moved))
    });
}

/// Law B1: no pixel, however broken, has no cells, or shares that are none.
#[test]
fn any_pixel_has_cells() {
    let odd = ODD.map(|x| x as f32);
    let mut source = Source::from_seed(7);
    for _ in 0..100_000 {
        let mut any = || odd[source.pick(odd.len() as u64) as usize];
        let patch = Patch::new([any(), any()], [any(), any()], [any(), any()]);
        let (least, factors) = (any(), [1.0, any().abs().min(1.0)]);
        let (mut count, mut sum) = (0, 0.0);
        Grid::stretched(&patch, factors, least).visit(|cell| {
            count += 1;
            assert!(cell.share > 0.0 && cell.share <= 1.0, "{patch:?}, {least}: {cell:?}");
            sum += cell.share;
        });
        assert!((1..=104).contains(&count), "{patch:?}, {least}: {count} cells");
        assert!((sum - 1.0_f32).abs() < 1e-3, "{patch:?}, {least}, {factors:?}: {sum}");
    }
}
