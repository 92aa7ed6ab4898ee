//! What glints cost: by the pixel's aspect, by the number of details, and what more choices cost;
//! many lobes.

use super::cases::{Case, case};
use super::samples::{Regime, samples};
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, Glints, ZirrKaplanyan, light_blur};
use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
use lobe::{Beckmann, Footprint, Kernel, PixelFilter, Roughness};
use std::time::Instant;

pub(crate) const GROUP: &str = "glints";

type Vector = [f32; 3];
type Input = (Patch<f32>, Vector, Vector);

/// Pixels of this aspect, turned by anything, all over a surface; with directions near the lobe.
fn pixels(aspect: f32) -> Vec<Input> {
    let inputs = samples(Regime::Mixed).into_iter().map(|s| {
        // Width 1 to 2: every place between two levels.
        let width = 1e-3 * (1.0 + s.wo[2]);
        let [x, y] = s.slope.map(|x| 10.0 * x);
        let length = (x * x + y * y).sqrt().max(1e-9);
        let (cos, sin) = (x / length, y / length);
        let (right, up) =
            ([width * cos, width * sin], [-aspect * width * sin, aspect * width * cos]);
        (Patch::new([x, y], right, up), s.wo, s.wi)
    });
    inputs.collect()
}

/// A case for each choice.
pub(crate) fn cases() -> Vec<Case> {
    let biscale = Biscale::from_fractions([0.3_f32, 0.3], [0.05, 0.05]).expect("in range");
    let with = |density: f32| Glints::new(biscale, density).expect("in range");
    let shaded = |name: &'static str, inputs: Vec<Input>, glints: Glints<f32>| {
        case(GROUP, name, inputs, move |&(patch, wo, wi)| glints.ndf(&patch).brdf(wo, wi, 0.005))
    };
    let steep = pixels(1.0);
    let smooth = Beckmann::new(with(1.0).ndf(&Patch::default()).smooth_lobe().shape());
    let published = ZirrKaplanyan::new(biscale, 1e9).expect("in range");
    let mut cases = vec![
        case(GROUP, "smooth_lobe", steep.clone(), move |&(_, wo, wi)| smooth.brdf(wo, wi)),
        shaded("steep", steep.clone(), with(1e9)),
        // 10 degrees above the surface, and the longest pixel that is followed.
        shaded("grazing", pixels(5.76), with(1e9)),
        shaded("longest", pixels(16.0), with(1e9)),
        shaded("few_details", steep.clone(), with(1e6)),
        shaded("many_details", steep.clone(), with(1e15)),
        shaded("varied", steep.clone(), with(1e9).with_variation(1.0).expect("in range")),
        case(GROUP, "published", steep.clone(), move |&(patch, wo, wi)| {
            let h = lobe::slope::direction::half_vector(wo, wi);
            let cosine = wi.iter().zip(h).map(|(a, b)| a * b).sum();
            published.d(&patch, h, cosine, 0.005) * smooth.visibility(wo, wi)
        }),
        case(GROUP, "light_blur", steep, |&(_, wo, wi)| light_blur(wo, wi, 0.005)),
    ];
    cases.extend(many_lobes());
    cases
}

/// The same of surfaces of facets, with and without a filter.
fn many_lobes() -> Vec<Case> {
    let dictionary: &'static _ =
        Box::leak(Box::new(Dictionary::<f32>::new(&Recipe::default()).expect("in range")));
    let roughness = Roughness::from_alpha(0.3).expect("in range");
    let with = move |density: f32| MultiLobe::new(roughness, density).expect("in range");
    let footprint = Footprint::from_slopes([0.02, 0.01], [-0.01, 0.02]);
    let kernel = Kernel::of(&footprint, PixelFilter::BOX);
    // Eight deviations of the lobe: six pieces.
    let long = Kernel::of(&Footprint::from_slopes([1.5, 0.75], [-0.01, 0.02]), PixelFilter::BOX);
    let shaded = |name: &'static str, aspect: f32, density: f32| {
        let facets = with(density);
        case(GROUP, name, pixels(aspect), move |&(patch, wo, wi)| {
            facets.ndf(dictionary, &patch).brdf(wo, wi)
        })
    };
    vec![
        shaded("many_lobes", 1.0, 1e9),
        shaded("many_lobes_longest", 8.0, 1e9),
        shaded("many_lobes_smooth", 1.0, 1e21),
        case(GROUP, "many_lobes_box", pixels(1.0), move |&(patch, wo, wi)| {
            with(1e9).ndf(dictionary, &patch).widened(&kernel).brdf(wo, wi)
        }),
        case(GROUP, "many_lobes_long_box", pixels(1.0), move |&(patch, wo, wi)| {
            with(1e9).ndf(dictionary, &patch).widened(&long).brdf(wo, wi)
        }),
        case(GROUP, "many_lobes_mips", pixels(1.0), move |&(patch, wo, wi)| {
            with(1e9).ndf(dictionary, &patch).with_mips(&footprint, 0.5).brdf(wo, wi)
        }),
        // With its pdf, which is a whole evaluation.
        case(GROUP, "many_lobes_sample", pixels(1.0), move |&(patch, wo, wi)| {
            let drawn = with(1e9).ndf(dictionary, &patch).sample(wo, [wi[0].abs(); 7]);
            drawn.map_or(0.0, |drawn| drawn.weight + drawn.pdf)
        }),
    ]
}

/// Prints the seconds that the default recipe's dictionary takes.
pub(crate) fn print_generation() {
    let start = Instant::now();
    let dictionary = Dictionary::<f32>::new(&Recipe::default()).expect("in range");
    let seconds = start.elapsed().as_secs_f64();
    println!("The default dictionary: {seconds:.2} s, {} KiB.", dictionary.bytes() / 1024);
}
