//! Grids over a Gaussian: rules with the right moments, and how much of an area they miss.
#![cfg(feature = "leadr")]
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use lobe::material::leadr::{Leadr, Quadrature};
use lobe::{Lobe, Roughness};

/// Largest |S/sigma - 1| of a grid over deviations from 0.05 to 4 and eyes from above to the mean
/// plane's horizon.
fn bias<const N: usize>(grid: &Quadrature<f64, N>) -> f64 {
    let mut worst = 0.0_f64;
    for step in 0..=12 {
        let sigma = 0.05 * 80.0_f64.powf(f64::from(step) / 12.0);
        let roughness = Roughness::from_sigma_rho(sigma, sigma, 0.0).expect("deviations");
        let surface = Leadr::new(&Lobe::centered(roughness));
        for (tilt, turn) in (0..=45).flat_map(|tilt| (0..4).map(move |turn| (tilt, turn))) {
            let (sin, cos) = (2.0 * f64::from(tilt)).to_radians().sin_cos();
            let (across, along) = (15.0 * f64::from(turn)).to_radians().sin_cos();
            let wo = [sin * along, sin * across, cos];
            let mut sum = 0.0;
            for (j, k) in (0..N).flat_map(|j| (0..N).map(move |k| (j, k))) {
                sum += surface.facet(wo, grid.node(j, k)).area;
            }
            worst = worst.max((sum / surface.ndf().projected_area(wo) - 1.0).abs());
        }
    }
    worst
}

#[test]
fn biases_are_as_documented() {
    // `Quadrature::cells`: largest errors of the area in percent, ours and the paper's.
    let ours = [
        bias(&Quadrature::<f64, 3>::cells()),
        bias(&Quadrature::<f64, 5>::cells()),
        bias(&Quadrature::<f64, 9>::cells()),
        bias(&Quadrature::<f64, 32>::cells()),
    ];
    let paper = [
        bias(&Quadrature::<f64, 3>::dupuy()),
        bias(&Quadrature::<f64, 5>::dupuy()),
        bias(&Quadrature::<f64, 9>::dupuy()),
        bias(&Quadrature::<f64, 32>::dupuy()),
    ];
    let documented = [[14.0, 36.0], [5.0, 12.0], [2.0, 5.0], [0.2, 1.0]];
    for ((ours, paper), stated) in ours.into_iter().zip(paper).zip(documented) {
        for (got, stated) in [ours, paper].into_iter().zip(stated) {
            let percent = 100.0 * got;
            assert!((0.8..1.15).contains(&(percent / stated)), "{percent} for {stated} %");
        }
    }
    assert!(bias(&Quadrature::<f64, 128>::cells()) < 2e-4);
}

/// Gauss and Hermite against the eigenvalues of the Jacobi matrix (Golub & Welsch).
fn against_eigenvalues<const N: usize>() {
    let grid = Quadrature::<f64, N>::hermite();
    let jacobi = nalgebra::DMatrix::from_fn(N, N, |i, k| {
        if i.abs_diff(k) == 1 { (i.max(k) as f64).sqrt() } else { 0.0 }
    });
    let eigen = nalgebra::SymmetricEigen::new(jacobi);
    let mut pairs: Vec<(f64, f64)> =
        (0..N).map(|k| (eigen.eigenvalues[k], eigen.eigenvectors[(0, k)].powi(2))).collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (k, (node, weight)) in pairs.into_iter().enumerate() {
        assert!((grid.nodes()[k] - node).abs() < 1e-12 * N as f64, "{N}: node {k}");
        assert!((grid.weights()[k] - weight).abs() < 1e-13, "{N}: weight {k}");
    }
    // Exact for polynomials up to 2 N - 1, here the moments up to 8.
    for (degree, want) in [(2_u8, 1.0), (4, 3.0), (6, 15.0), (8, 105.0)] {
        if 2 * N > usize::from(degree) {
            let nodes = grid.nodes().iter().zip(grid.weights());
            let got: f64 = nodes.map(|(p, w)| w * p.powi(degree.into())).sum();
            assert!((got - want).abs() < 1e-11 * want, "{N}: {got} for moment {degree}");
        }
    }
}

/// Weights that sum to 1, nodes that ascend, both symmetric.
fn sound<const N: usize>() {
    for grid in [Quadrature::<f64, N>::dupuy(), Quadrature::cells(), Quadrature::hermite()] {
        let sum: f64 = grid.weights().iter().sum();
        assert!((sum - 1.0).abs() < 1e-14);
        for k in 0..N {
            assert!((grid.nodes()[k] + grid.nodes()[N - 1 - k]).abs() < 1e-13);
            assert!((grid.weights()[k] - grid.weights()[N - 1 - k]).abs() < 1e-14);
            assert!(grid.widths()[k] >= 0.0 && grid.widths()[k].is_finite());
        }
        assert!(grid.nodes().windows(2).all(|pair| pair[0] < pair[1]));
    }
}

#[test]
fn grids_are_rules_for_a_gaussian() {
    against_eigenvalues::<1>();
    against_eigenvalues::<2>();
    against_eigenvalues::<5>();
    against_eigenvalues::<32>();
    against_eigenvalues::<128>();
    against_eigenvalues::<200>();
    sound::<1>();
    sound::<2>();
    sound::<9>();
    sound::<128>();
    // What a node stands for: its distance from the next, of equal ones.
    let even = Quadrature::<f64, 64>::uniform(0.2).expect("a spacing");
    assert!(even.widths().iter().all(|width| (width / 0.2 - 1.0).abs() < 1e-8));
    assert!(
        Quadrature::<f32, 5>::uniform(0.0).is_err() && Quadrature::<f32, 0>::uniform(0.5).is_err()
    );
}
