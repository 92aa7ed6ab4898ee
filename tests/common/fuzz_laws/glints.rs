//! Glints: every number of a pixel is one, in range, whatever material, pixel, map, kernel, half
//! vector and light.

use super::bytes::Bytes;
use lobe::material::cells::Patch;
use lobe::material::glint::{Binomial, Biscale, Glints, Grid, ZirrKaplanyan, hue_wheel};
use lobe::slope::direction::normalize;
use lobe::{Footprint, Kernel, PixelFilter, Psd, Real, Roughness, SlopeMoments};

/// The law: one pixel of one material, in one precision.
pub(crate) fn glints(bytes: &[u8]) {
    let mut input = Bytes::new(bytes);
    if input.byte() & 1 == 0 { any::<f32>(&mut input) } else { any::<f64>(&mut input) }
}

fn number<R: Real>(x: R, from: &dyn core::fmt::Debug) {
    assert!(x >= R::ZERO && x.is_finite(), "{x} from {from:?}");
}

fn biscale<R: Real>(input: &mut Bytes) -> Biscale<R> {
    if input.byte() & 1 == 0 {
        Biscale::from_fractions(input.pair(), input.pair()).unwrap_or_default()
    } else {
        let mut roughness = || {
            let [xx, xy, yy] = input.triple();
            Roughness::from_matrix(Psd::new(xx, xy, yy).unwrap_or_default())
        };
        Biscale::new(roughness(), roughness())
    }
}

fn any<R: Real>(input: &mut Bytes) {
    let binomial = Binomial::new(input.number::<R>(), input.number());
    let drawn = binomial.draw(R::lit(input.between(1e-9, 1.0 - 1e-9)));
    number(drawn, &binomial);

    let biscale = biscale::<R>(input);
    let patch = Patch::new(input.pair(), input.pair(), input.pair());
    let density = input.number();
    let (h, blur) = (normalize(input.triple::<R>()), input.number::<R>());
    let whole = h.iter().all(|x| x.is_finite());
    if let Ok(mut published) = ZirrKaplanyan::new(biscale, density) {
        published.variation = R::lit(input.between(0.0, 100.0));
        let (cosine, gamma) = (R::lit(input.between(0.0, 1.0)), R::lit(input.between(0.0, 1.0)));
        for patch in [patch, Patch { tile: [i32::MAX, i32::MIN], ..patch }] {
            let d = published.d(&patch, h, cosine, gamma);
            assert!(
                !whole || d >= R::ZERO && d.is_finite(),
                "{d} from {published:?}, {patch:?}, {h:?}"
            );
        }
    }
    let Ok(glints) = Glints::new(biscale, density) else { return };
    let glints = glints.with_variation(input.number()).unwrap_or(glints);
    let glints = glints.with_share(input.number()).unwrap_or(glints).with_seed(input.byte().into());
    let [xx, xy, yy] = input.triple();
    let covariance = Psd::new(xx, xy, yy).unwrap_or_default();
    let moments = SlopeMoments::new(input.pair(), covariance).unwrap_or_default();
    let footprint = Footprint::from_slopes(input.pair::<R>(), input.pair::<R>());
    let kernel = Kernel::of(&footprint, PixelFilter::BOX);
    let wi = normalize(input.triple::<R>());
    for patch in [patch, Patch { tile: input.tile(), ..patch }] {
        let pixel = glints.ndf(&patch).over(&moments).widened(&kernel);
        covered(&patch, pixel.grid());
        if whole {
            let from = (&glints, &patch, &moments, &footprint, h, blur);
            let probability = pixel.probability(h, blur);
            number(probability, &from);
            assert!(probability <= R::ONE, "{probability} from {from:?}");
            number(pixel.sparkle(h, blur), &from);
            number(pixel.slope_pdf(h, blur), &from);
            number(pixel.brdf(h, wi, blur), &from);
            for channel in pixel.colored_sparkle(h, blur, hue_wheel) {
                number(channel, &from);
            }
        }
    }
}

/// A pixel has cells, whose shares sum to 1.
fn covered<R: Real>(patch: &Patch<R>, grid: &Grid<R>) {
    let (mut cells, mut shares) = (0, R::ZERO);
    grid.visit(|cell| {
        cells += 1;
        shares = shares + cell.share;
    });
    assert!((1..=104).contains(&cells), "{cells} cells of {patch:?}");
    assert!((shares - R::ONE).abs() < R::lit(1e-3), "shares of {patch:?} sum to {shares}");
}
