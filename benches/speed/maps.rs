//! What maps cost: texels to slopes, slopes to a mip chain, reading it, and shading what was read.

use super::cases::{Case, case};
use super::samples::{COUNT, Regime, samples};
use lobe::material::leadr::{Leadr, Quadrature};
use lobe::material::lean::{Border, MomentMap, SlopeCap};
use lobe::{Beckmann, Lobe, Roughness, SlopeMoments};
use std::hint::black_box;

pub(crate) const GROUP: &str = "maps";

/// A pass that is no loop over samples.
fn whole(name: &'static str, pass: impl FnMut() + 'static) -> Case {
    Case { group: GROUP, name, pass: Box::new(pass), limit: None }
}

/// A case for each step from texels to radiance. A map has as many texels as other cases have
/// samples.
pub(crate) fn cases() -> Vec<Case> {
    let side = COUNT.isqrt();
    let samples = samples(Regime::Mixed);
    let slopes: Vec<[f32; 2]> = samples.iter().map(|s| s.slope).collect();
    let built = move |slopes: &[[f32; 2]]| {
        MomentMap::from_slopes([side, side], slopes.to_vec(), Border::Wrap).expect("a map")
    };
    let map = built(&slopes);
    let reading = |read: fn(&MomentMap<f32>, [f32; 2]) -> SlopeMoments<f32>| {
        let map = map.clone();
        move |&uv: &[f32; 2]| read(&map, uv).covariance().root_det()
    };
    // Texels: codes, and raw moments as a texture has them.
    let codes: Vec<[u8; 3]> =
        (0..COUNT).map(|k| [37, 91, 5].map(|p| (k * p % 251) as u8)).collect();
    let raw: Vec<_> = samples
        .iter()
        .map(|s| {
            let [xx, xy, yy] = Roughness::from_matrix(s.matrix).covariance().entries();
            let [x, y] = s.mean;
            (s.mean, [xx + x * x, xy + x * y, yy + y * y], s.wo, s.wi)
        })
        .collect();
    let relief: Vec<_> = samples
        .iter()
        .map(|s| {
            let lobe = Lobe::new(s.mean, Roughness::from_matrix(s.matrix)).expect("a mean");
            (Leadr::new(&lobe), s.wo)
        })
        .collect();
    let cap = SlopeCap::new(10.0_f32).expect("a cap");
    let base = Roughness::from_alpha(0.1_f32).expect("alpha");
    let (grid, mut copy) = (Quadrature::<f32, 5>::cells(), slopes.clone());
    let (source, texels) = (slopes.clone(), slopes.clone());
    vec![
        whole("copy", move || {
            copy.copy_from_slice(black_box(&source));
            black_box(&copy);
        }),
        case(GROUP, "texels_to_slopes", codes, move |&code| cap.slope(code).0[0]),
        whole("mip_chain", move || {
            black_box(built(black_box(&texels)));
        }),
        case(GROUP, "bilinear", slopes.clone(), reading(|map, uv| map.bilinear(1, uv))),
        case(GROUP, "trilinear", slopes.clone(), reading(|map, uv| map.trilinear(uv, 1.5))),
        case(
            GROUP,
            "along_eight_probes",
            slopes,
            reading(|map, uv| map.anisotropic(uv, [0.25, 0.0], [0.0, 0.031_25], 8)),
        ),
        case(GROUP, "raw_moments_shaded", raw, move |&(mean, second, wo, wi)| {
            SlopeMoments::from_raw(mean, second)
                .map_or(0.0, |moments| Beckmann::new(moments.lobe(base).shape()).brdf(wo, wi))
        }),
        case(GROUP, "facets_five_by_five", relief, move |(surface, wo)| {
            let mut sum = 0.0;
            for (j, k) in (0..5).flat_map(|j| (0..5).map(move |k| (j, k))) {
                let facet = surface.facet(*wo, grid.node(j, k));
                sum += facet.area * facet.wi[2];
            }
            sum
        }),
    ]
}
