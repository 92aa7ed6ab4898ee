//! Facets: every number of a pixel is one, in range, whatever surface, pixel, map, kernel and
//! direction; bytes of no dictionary are refused.

use super::bytes::Bytes;
use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe, PatchNdf, Recipe};
use lobe::slope::direction::normalize;
use lobe::{Footprint, Kernel, PixelFilter, Psd, Real, Roughness, SlopeMoments};

/// The law: bytes as a dictionary, and one pixel of one surface, in one precision.
pub(crate) fn facets(bytes: &[u8]) {
    damaged(bytes);
    let mut input = Bytes::new(bytes);
    if input.byte() & 1 == 0 { any::<f32>(&mut input) } else { any::<f64>(&mut input) }
}

/// Bytes of a dictionary, cut off and with one byte changed.
fn damaged(bytes: &[u8]) {
    assert!(bytes.len() > 44 || Dictionary::from_bytes(bytes).is_err());
    let small = Dictionary::<f32>::new(&Recipe {
        marginals: 2,
        levels: 2,
        intervals: 64,
        ..Recipe::default()
    });
    let good = small.expect("in range").to_bytes();
    let mut input = Bytes::new(bytes);
    let at = (256 * usize::from(input.byte()) + usize::from(input.byte())) % good.len();
    assert!(Dictionary::from_bytes(&good[..at]).is_err(), "{at} bytes");
    let (mut changed, byte) = (good.clone(), input.byte());
    changed[at] ^= byte;
    assert_eq!(Dictionary::from_bytes(&changed).is_ok(), byte == 0, "byte {at} by {byte}");
}

fn number<R: Real>(x: R, from: &dyn core::fmt::Debug) {
    assert!(x >= R::ZERO && x.is_finite(), "{x} from {from:?}");
}

fn any<R: Real>(input: &mut Bytes) {
    let recipe = Recipe {
        marginals: 1 + u32::from(input.byte() % 8),
        levels: 1 + u32::from(input.byte() % 5),
        intervals: 64 << (input.byte() % 2),
        seed: input.byte().into(),
        ..Recipe::default()
    };
    let dictionary = Dictionary::<R>::new(&recipe).expect("in range");
    let marginal = dictionary.marginal(input.byte().into(), input.byte().into());
    let (x, width, u) = (input.number::<R>(), input.number::<R>(), input.number::<R>());
    number(marginal.density(x), &(recipe, x));
    number(marginal.mean(x, width), &(recipe, x, width));
    number(marginal.mip_mean(x, width), &(recipe, x, width));
    assert!(marginal.quantile(u).abs() <= R::lit(4.0), "quantile of {u} in {recipe:?}");

    let mut psd = || {
        let [xx, xy, yy] = input.triple();
        Psd::new(xx, xy, yy).unwrap_or_default()
    };
    let (roughness, covariance) = (Roughness::from_matrix(psd()), psd());
    let Ok(facets) = MultiLobe::new(roughness, input.number()) else { return };
    let facets = facets.with_variation(input.number()).unwrap_or(facets);
    let facets = facets.with_share(input.number()).unwrap_or(facets).with_seed(input.byte().into());
    let patch = Patch::new(input.pair(), input.pair(), input.pair());
    let moments = SlopeMoments::new(input.pair(), covariance).unwrap_or_default();
    let footprint = Footprint::from_slopes(input.pair::<R>(), input.pair::<R>());
    let pixel = facets.ndf(&dictionary, &patch).over(&moments);
    let widened = pixel.widened(&Kernel::of(&footprint, PixelFilter::BOX));
    let published = pixel.with_mips(&footprint, R::HALF);
    let (wo, wi) = (normalize(input.triple::<R>()), normalize(input.triple::<R>()));
    let numbers = [0; 7].map(|_| R::lit(input.between(0.0, 1.0 - 1e-9)));
    for pixel in [pixel, widened, published] {
        seen(&pixel, wo, wi, input.pair());
    }
    sampled(&widened, wo, numbers);
    let tiled = facets.ndf(&dictionary, &Patch { tile: input.tile(), ..patch }).over(&moments);
    seen(&tiled, wo, wi, input.pair());
    sampled(&tiled, wo, numbers);
}

/// What is drawn by a pixel.
fn sampled<R: Real>(pixel: &PatchNdf<'_, R>, wo: [R; 3], numbers: [R; 7]) {
    if let Some(drawn) = pixel.sample(wo, numbers) {
        number(drawn.pdf, &(pixel.exponent(), wo, numbers));
        number(drawn.weight, &(pixel.exponent(), wo, numbers));
        assert!(drawn.weight <= R::lit(1.001), "{drawn:?} of {wo:?}, {numbers:?}");
    }
}

/// What is asked of a pixel.
fn seen<R: Real>(pixel: &PatchNdf<'_, R>, wo: [R; 3], wi: [R; 3], slope: [R; 2]) {
    number(pixel.slope_pdf(slope), &(slope, wo));
    number(pixel.d(wi), &wi);
    number(pixel.brdf(wo, wi), &(wo, wi));
    number(pixel.pdf(wo, wi), &(wo, wi));
    let share = pixel.coarser();
    assert!(share >= R::ZERO && share <= R::ONE, "{share}");
}
