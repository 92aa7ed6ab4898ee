//! Maps and what is made of them: slopes within their cap, moments valid at every level and
//! everywhere between, sums and stored texels valid, displaced surfaces finite, whatever the
//! numbers.

use super::bytes::Bytes;
use super::valid;
use lobe::material::Fresnel;
use lobe::material::leadr::{Leadr, Normalization, Quadrature, Shadowing};
use lobe::material::lean::{
    Border, Float16, Float32, MomentMap, NormalTexel, SlopeCap, Storage, Unorm16,
};
use lobe::{Error, Psd, Real, SlopeMoments};

/// The law: one kind of map on one set of numbers, in one precision.
pub(crate) fn maps(bytes: &[u8]) {
    let mut input = Bytes::new(bytes);
    if input.byte() & 1 == 0 { any::<f32>(&mut input) } else { any::<f64>(&mut input) }
}

fn any<R: Real>(input: &mut Bytes) {
    match input.byte() % 5 {
        0 => texels::<R>(input),
        1 => chain::<R>(input),
        2 => reliefs::<R>(input),
        3 => stored(input),
        _ => relief::<R>(input),
    }
}

/// The slope of a texel is not steeper than the cap.
fn capped<R: Real>(cap: SlopeCap<R>, texel: impl NormalTexel + core::fmt::Debug) {
    let ([x, y], _) = cap.slope(texel);
    // By parts: squares of the largest slopes are in range, their sum need not be exact.
    let length = (x * x + y * y).sqrt();
    let most = cap.steepest() * (R::ONE + R::lit(8.0) * R::EPSILON);
    assert!(length <= most || x * x < R::MIN_POSITIVE, "{x} {y} of {texel:?}, cap {most}");
}

fn texels<R: Real>(input: &mut Bytes) {
    let steepest = input.number::<R>();
    let Ok(cap) = SlopeCap::new(steepest) else { return };
    capped(cap, input.triple::<f32>().map(f32::from));
    capped(cap, input.triple::<f64>());
    capped(cap, [input.byte(), input.byte(), input.byte()]);
    capped(cap, [input.byte(), input.byte()]);
    capped(cap, [u16::from(input.byte()) * 257, u16::from(input.byte())]);
}

fn valid_moments<R: Real>(moments: &SlopeMoments<R>, from: &dyn core::fmt::Debug) {
    let [x, y] = moments.mean();
    assert!(valid::moderate(x) && valid::moderate(y), "{moments:?} from {from:?}");
    valid::psd(&moments.covariance(), from);
}

fn chain<R: Real>(input: &mut Bytes) {
    let size = [1 + usize::from(input.byte() % 5), 1 + usize::from(input.byte() % 5)];
    let slopes: Vec<[R; 2]> = (0..size[0] * size[1]).map(|_| input.pair()).collect();
    let border = if input.byte() & 1 == 0 { Border::Wrap } else { Border::Clamp };
    let map = match MomentMap::from_slopes(size, slopes.clone(), border) {
        Ok(map) => map,
        Err(error) => {
            assert!(matches!(error, Error::Mean(_)), "{error}: {slopes:?}");
            return;
        }
    };
    for level in 0..map.levels() {
        let [width, height] = map.size(level);
        for place in 0..width * height {
            valid_moments(&map.texel(level, place % width, place / width), &(size, &slopes));
        }
    }
    let (uv, lod) = (input.pair(), input.number());
    valid_moments(&map.trilinear(uv, lod), &(uv, lod, size, &slopes));
    let (du, dv) = (input.pair(), input.pair());
    let most = [0, 1, 8, usize::MAX][usize::from(input.byte() % 4)];
    valid_moments(&map.anisotropic(uv, du, dv, most), &(uv, du, dv, size, &slopes));
}

/// Moments by a constructor, if it accepts.
fn moments<R: Real>(input: &mut Bytes) -> Option<SlopeMoments<R>> {
    let (mean, [xx, xy, yy]) = (input.pair(), input.triple());
    SlopeMoments::new(mean, Psd::new(xx, xy, yy).ok()?).ok()
}

fn reliefs<R: Real>(input: &mut Bytes) {
    let (Some(one), Some(other)) = (moments::<R>(input), moments::<R>(input)) else { return };
    let from = (one, other);
    valid_moments(&(one + other), &from);
    let matrix = [input.pair(), input.pair()];
    valid_moments(&one.plus_correlated(&other, matrix), &(from, matrix));
    let factor = input.number();
    valid_moments(&(one * factor), &(one, factor));
    valid_moments(&one.transformed(matrix), &(one, matrix));
    if let Ok(tilted) = one.tilted(input.pair()) {
        valid_moments(&tilted, &one);
    }
}

fn stored(input: &mut Bytes) {
    let word = |input: &mut Bytes| u16::from_le_bytes([input.byte(), input.byte()]);
    let codes = core::array::from_fn(|_| word(input));
    let range = input.number::<f32>();
    let check = |decoded: Result<SlopeMoments<f32>, Error>| {
        if let Ok(moments) = decoded {
            valid_moments(&moments, &(codes, range));
        }
    };
    if let Ok(layout) = Unorm16::new(range) {
        check(layout.decode(codes));
        if let Some(moments) = moments::<f32>(input) {
            check(layout.decode(layout.encode(&moments)));
        }
    }
    if let Ok(layout) = Float16::new(range) {
        check(layout.decode(codes));
    }
    if let Ok(layout) = Float32::new(range) {
        check(layout.decode(codes.map(f32::from)));
    }
    let (mean, second) = (input.pair(), input.triple());
    check(SlopeMoments::from_unorm(mean, second, range));
}

fn relief<R: Real>(input: &mut Bytes) {
    let (Some(moments), [x, y, z]) = (moments::<R>(input), input.triple::<R>()) else { return };
    let wo = lobe::slope::direction::normalize([x, y, z]);
    let wi = lobe::slope::direction::normalize(input.triple::<R>());
    let lobe = moments.lobe(lobe::Roughness::default());
    let alphas = lobe.roughness().alphas();
    if !(valid::in_domain(alphas.major) && valid::in_domain(alphas.minor)) {
        return;
    }
    let surface = Leadr::new(&lobe);
    let light = |_: [R; 3], _: R| [R::ONE; 3];
    for shadowing in [Shadowing::Both, Shadowing::MaskingOnly] {
        let specular = surface.brdf_cos(wo, wi, shadowing);
        assert!(
            specular >= R::ZERO && specular.is_finite(),
            "{specular} of {lobe:?} {wo:?} {wi:?}"
        );
        for normalization in [Normalization::Sum, Normalization::ProjectedArea] {
            let grid = Quadrature::<R, 3>::cells();
            let white = Fresnel::white();
            let [lit, ..] =
                surface.environment(wo, &grid, shadowing, normalization, &white, &light);
            assert!(lit >= R::ZERO && lit.is_finite(), "{lit} of {lobe:?} {wo:?}");
        }
    }
    let reaching = surface.light_reaching(wo, wi);
    assert!((R::ZERO..=R::ONE).contains(&reaching), "{reaching} of {lobe:?} {wo:?} {wi:?}");
}
