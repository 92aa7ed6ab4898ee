//! The report's scenes drawn by fragment shaders, on every driver that is there: what the report's
//! own renderer computes, at 1 sample per pixel, from the same numbers.
//!
//! The tolerances are for GPUs that fuse a * b + c and miss quotients by an ulp or two.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

#[path = "render/drawn.rs"]
mod drawn;

use std::sync::LazyLock;

use drawn::{
    DEFERRED, DIFFERENCE, DISK, MATRIX, PATCH, PLAIN_QUAD, QUAD, SHADED, Spread, Stage, sides,
};
use lobe::filter::{DiskKernel, tokuyoshi_kaplanyan_deferred_alpha};
use lobe::material::cells::Patch;
use lobe::material::glint::Grid;
use lobe::slope::direction::slope_of;
use lobe::{Kernel, PixelFilter, Psd};
use lobe_gpu::Gpu;
use lobe_report::shot::{Seen, Shot, non_overlap};

/// What a slope or a half vector may be off, relative: three quotients of 2.5 ulp and a root.
const ROUNDING: f32 = 16.0 / 16_777_216.0;

/// A ball's highlight is a pixel or less; on leather every pixel has its own frame.
static SHOTS: LazyLock<[Shot; 2]> = LazyLock::new(|| {
    [Shot::balls, Shot::leather].map(|scene| scene(lobe_report::QUICK_WIDTH, 0.01).unwrap())
});

/// Every scene on every driver; lavapipe must be there.
fn stages() -> impl Iterator<Item = Stage<'static>> {
    let _ = Gpu::lavapipe();
    SHOTS.iter().flat_map(|shot| Gpu::every().iter().map(move |gpu| Stage { shot, gpu }))
}

/// A pixel of the picture, the one beside it and the one below or above in its quad; its column and
/// row.
fn quad(shot: &Shot, index: usize) -> ([&Seen; 3], [usize; 2]) {
    let (x, y) = (index % shot.width, index / shot.width);
    (shot.quad(x, y), [x, y])
}

fn minus<const N: usize>(a: [f32; N], b: [f32; N]) -> [f32; N] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// The report's footprint with the signs of derivatives: in odd columns and rows its sides point
/// the other way.
fn derivatives(shot: &Shot, index: usize) -> [f32; 4] {
    let [u, v] = shot.footprints[index];
    let [s, t] = quad(shot, index).1.map(|place| if place % 2 == 1 { -1.0 } else { 1.0 });
    [s * u[0], s * u[1], t * v[0], t * v[1]]
}

#[test]
fn quad_differences_are_the_report_s() {
    for stage in stages() {
        let (shot, name) = (stage.shot, stage.gpu.name());
        let [fine, plain] = [QUAD, PLAIN_QUAD].map(|text| stage.picture(text).unwrap());
        let (mut equal, mut plainly, mut edges) = (0, 0, 0);
        for (index, got) in fine.iter().enumerate() {
            let want = derivatives(shot, index);
            let seen = quad(shot, index).0.map(|seen| seen.half);
            if seen.iter().any(|half| !(half[2] > 0.0)) {
                assert_eq!((*got, want), ([0.0; 4], [0.0; 4]), "{name} {index}");
                edges += usize::from(seen[0][2] > 0.0);
                continue;
            }
            let [here, beside, below] = seen.map(|half| slope_of(half).map(f32::abs));
            for k in 0..4 {
                let scale = here[k % 2] + if k < 2 { beside[k] } else { below[k - 2] };
                let off = (got[k] - want[k]).abs();
                assert!(off <= ROUNDING * scale, "{name} {index}: {got:?} for {want:?}");
            }
            equal += usize::from(*got == want);
            plainly += usize::from(plain[index] == want);
        }
        println!(
            "{}, {name}: {equal} pixels equal to the bit, {plainly} by plain dpdx, {edges} at an \
                edge",
            shot.name
        );
        // Edges of balls: a half vector above its horizon beside one that is not.
        assert!(equal > 0 && (edges > 0) == std::ptr::eq(shot, &raw const SHOTS[0]));
    }
}

#[test]
fn filters_mend_as_much_as_the_report_says() {
    for stage in stages() {
        let (shot, name) = (stage.shot, stage.gpu.name());
        let shaded = stage.picture(SHADED).unwrap();
        let methods = [&shot.plain, &shot.widened, &shot.exact];
        let mut errors = [0.0; 3];
        for (k, method) in methods.iter().enumerate() {
            let picture: Vec<f32> = shaded.iter().map(|pixel| pixel[k]).collect();
            errors[k] = shot.errors(&picture, method).rmse;
            let off = picture.iter().zip(&method.picture).map(|(&got, &want)| {
                let (got, want) = (f64::from(got), f64::from(want));
                if got == want { 0.0 } else { (got - want).abs() / want.abs() }
            });
            let off: Vec<f64> = off.collect();
            // Means over footprints miss by up to 5e-4 in rare branches, and take over what slopes
            // miss.
            let share = off.iter().filter(|&&off| !(off <= 1e-4)).count() as f64 / off.len() as f64;
            let ratio = errors[k] / errors[0];
            let stated = method.errors.rmse / shot.plain.errors.rmse;
            let most = Spread::of(&off, &shot.judged).most;
            println!(
                "{}, {name}, {}: RMSE {:.4}, {ratio:.4} of the unfiltered one, {stated:.4} in the \
                    report; {:.3} % of \
                 pixels differ by more than 1e-4, at most {most:.1e}",
                shot.name,
                method.name,
                errors[k],
                100.0 * share
            );
            assert!((ratio / stated - 1.0).abs() <= 0.05, "{name}: {ratio} for {stated}");
            assert!(k == 0 || ratio < 1.0, "{name}: {} does not mend", method.name);
            assert!(share <= 1e-3, "{name}: {share} of the pixels differ");
        }
    }
}

#[test]
fn kernels_on_the_disk_are_those_of_the_quad_s_half_vectors() {
    let filter = PixelFilter::TOKUYOSHI_KAPLANYAN;
    for stage in stages() {
        let (shot, name) = (stage.shot, stage.gpu.name());
        for (index, got) in stage.picture(DISK).unwrap().iter().enumerate() {
            let [here, beside, below] =
                quad(shot, index).0.map(|seen| [seen.half[0], seen.half[1]]);
            let (u, v) = (minus(beside, here), minus(below, here));
            let [a, b] = DiskKernel::of(u, v, filter).as_slopes().columns();
            let added = Psd::outer_sum(a, b);
            let [xx, xy, yy] = added.entries();
            let length: f32 = u.iter().chain(&v).map(|x| x.abs()).sum();
            let off = 2.0 * filter.variance() as f32 * ROUNDING * (4.0 * length + ROUNDING);
            for (got, want) in got.iter().zip([xx, xy, yy, added.root_det()]) {
                assert!((got - want).abs() <= off, "{name} {index}: {got} for {want}");
            }
        }
    }
}

#[test]
fn deferred_alphas_are_those_of_the_quad_s_normals() {
    let (filter, limit) =
        (PixelFilter::TOKUYOSHI_KAPLANYAN, Kernel::<f32>::ALPHA_SQUARED_LIMIT as f32);
    for stage in stages() {
        let (shot, name) = (stage.shot, stage.gpu.name());
        let mut widened = 0;
        for (index, got) in stage.picture(DEFERRED).unwrap().iter().enumerate() {
            let [here, beside, below] = quad(shot, index).0.map(|seen| seen.normal);
            let (u, v) = (minus(beside, here), minus(below, here));
            let alpha = shot.alpha as f32;
            let want = tokuyoshi_kaplanyan_deferred_alpha(alpha, u, v, filter, limit).unwrap();
            assert!((got[0] / want - 1.0).abs() <= 1e-6, "{name} {index}: {} for {want}", got[0]);
            widened += usize::from(want > 2.0 * alpha);
        }
        assert!(widened > 100, "{widened}");
    }
}

/// The cells that a pixel covers.
fn covered(patch: &Patch<f32>) -> Vec<([i64; 2], i32, f32)> {
    let mut cells = Vec::new();
    Grid::new(patch, 1e-6).visit(|cell| cells.push((cell.index, cell.exponent, cell.share)));
    cells
}

/// Coordinates of any kind will do; those of `wo` jump at edges, which no grid minds.
#[test]
fn patches_are_those_of_the_quad_s_coordinates() {
    for stage in stages() {
        let (shot, name) = (stage.shot, stage.gpu.name());
        let mut moving = 0;
        for (index, got) in stage.picture(PATCH).unwrap().iter().enumerate() {
            let (seen, place) = quad(shot, index);
            let [here, beside, below] = seen.map(|seen| [seen.wo[0], seen.wo[1]]);
            // The differences of a quad's pixels are one and the same, whichever of them asks.
            let [s, t] = place.map(|place| if place % 2 == 1 { -1.0 } else { 1.0 });
            let [right, up] =
                [minus(beside, here).map(|x| s * x), minus(below, here).map(|x| t * x)];
            let off = |(got, want): (&f32, f32)| (got - want).abs() > f32::MIN_POSITIVE;
            let wrong = got.iter().zip([right, up].concat()).any(off);
            assert!(!wrong, "{name} {index}: {got:?} for {right:?} {up:?}");
            let patch = Patch::new(here, right, up);
            let turned = Patch { up: up.map(|x| -x), ..patch };
            assert_eq!(covered(&patch), covered(&turned), "a grid looks at a side's sign");
            moving += usize::from(patch.area() > 0.0);
        }
        assert!(moving > 1000, "{name}: {moving}");
    }
}

/// Kaplanyan et al. 2016, Fig. 7: the matrix M from positions, distances and curvature, against
/// `dpdx`.
#[test]
fn footprints_by_matrix_and_by_quad_disagree_as_much_as_the_report_says() {
    for stage in stages().filter(|stage| std::ptr::eq(stage.shot, &raw const SHOTS[0])) {
        let (shot, name) = (stage.shot, stage.gpu.name());
        let [quad, matrix, difference] =
            [QUAD, MATRIX, DIFFERENCE].map(|text| stage.picture(text).unwrap());
        let [mut off, mut drawn, mut computed, mut overlaps] = [(); 4].map(|()| Vec::new());
        for (index, &got) in matrix.iter().enumerate() {
            let [u, v] = shot.analytic[index];
            let want = [u[0], u[1], v[0], v[1]];
            let length = |x: [f32; 4]| x.map(f64::from).iter().map(|x| x * x).sum::<f64>().sqrt();
            let relative = |x: [f32; 4]| length(x) / length(want).max(1e-30);
            off.push(relative(minus(got, want)));
            drawn.push(f64::from(difference[index][0]));
            computed.push(relative(minus(derivatives(shot, index), want)));
            overlaps.push(non_overlap(sides(quad[index]), sides(got)));
        }
        let spread = |values: &[f64]| Spread::of(values, &shot.judged);
        // The report goes through the world's coordinates; towards the horizon both lose digits.
        let off = spread(&off);
        println!(
            "{name}: M against the report's: median {:.1e}, most {:.1e}",
            off.median, off.most
        );
        assert!(off.high <= 1e-4 && off.most <= 1e-2, "{name}: {:e} {:e}", off.high, off.most);
        for (what, got, want) in
            [("sides", &drawn, &computed), ("areas", &overlaps, &shot.disagreement)]
        {
            let (got, want) = (spread(got), spread(want));
            let numbers = |of: &Spread| [of.median, of.high, of.share];
            println!("{name}: {what} {:.5?}, in the report {:.5?}", numbers(&got), numbers(&want));
            for (got, want) in numbers(&got).into_iter().zip(numbers(&want)) {
                assert!((got / want - 1.0).abs() <= 1e-3, "{name}: {what} {got} for {want}");
            }
        }
    }
}
