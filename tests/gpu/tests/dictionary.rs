//! A dictionary in a texture, as WebGL 2 has it: the same bits as from the buffer, and as in Rust.

use lobe::material::multilobe::{Dictionary, Recipe};
use lobe::wgsl::{Item, source, textured};
use lobe_gpu::{Gpu, Job, Mode};

/// Density, mean and quantile of a marginal: which one, on which level, and where.
const BODY: &str = "
    let all = LobeDictionary(MARGINALS, LEVELS, INTERVALS);
    let marginal = lobe_dictionary_marginal(all, bits_at(0), bits_at(1));
    put(0, lobe_marginal_density(marginal, at(2)));
    put(1, lobe_marginal_mean(marginal, at(2), 0.25));
    put(2, lobe_marginal_quantile(marginal, at(3)));";

#[test]
fn textures_hold_the_same_dictionary() {
    let recipe = Recipe { marginals: 24, levels: 6, ..Recipe::default() };
    let dictionary = Dictionary::<f32>::new(&recipe).expect("a recipe in range");
    let Recipe { marginals, levels, intervals, .. } = recipe;
    let sizes = [("MARGINALS", marginals), ("LEVELS", levels), ("INTERVALS", intervals)];
    let body = sizes
        .iter()
        .fold(BODY.to_owned(), |body, (name, size)| body.replace(name, &format!("{size}u")));
    let mut inputs = Vec::new();
    let mut want = Vec::new();
    // Every marginal on every level: every row of the texture is read, and the last node.
    for (index, level) in (0..marginals).flat_map(|k| (0..levels).map(move |l| (k, l))) {
        let marginal = dictionary.marginal(index, level);
        for x in [-4.0, -1.3, -0.02, 0.0, 0.07, 0.5, 0.9, 2.2, 3.999, 4.0, 5.0_f32] {
            let u = (x + 5.0) / 10.0;
            inputs.extend([f32::from_bits(index), f32::from_bits(level), x, u]);
            want.extend([marginal.density(x), marginal.mean(x, 0.25), marginal.quantile(u)]);
        }
    }
    let items = [Item::MarginalDensity, Item::MarginalMean, Item::MarginalQuantile];
    let buffer = source(&[&items[..], &[Item::DictionaryMarginal]].concat());
    let texture = textured(&buffer);
    assert_ne!(buffer, texture);
    for library in [&buffer, &texture] {
        let dictionary = dictionary.nodes();
        let job = Job { library, body: &body, inputs: 4, outputs: 3, dictionary };
        let got = job.run(Gpu::lavapipe(), Mode::Exact, &inputs).expect("valid WGSL");
        assert_eq!(got.len(), want.len());
        let differ = got.iter().zip(&want).filter(|(got, want)| got != want).count();
        assert_eq!(differ, 0, "of {} numbers", want.len());
    }
    assert!(want.iter().filter(|value| **value > 0.0).count() > want.len() / 2);
}
