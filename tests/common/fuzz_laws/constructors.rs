//! Constructors refuse their arguments or yield a valid value, whatever the arguments.

use super::bytes::Bytes;
use super::{valid, widenings};
use lobe::filter::tokuyoshi_deferred_alpha;
use lobe::{
    AxisAligned, Footprint, Isotropic, Kernel, Lobe, NonCentered, PixelFilter, Psd, Real,
    Roughness, SlopeMoments, Vertex,
};

/// The law: one constructor on one set of arguments, in one precision.
pub(crate) fn constructors(bytes: &[u8]) {
    let mut input = Bytes::new(bytes);
    if input.byte() & 1 == 0 { any::<f32>(&mut input) } else { any::<f64>(&mut input) }
}

fn any<R: Real>(input: &mut Bytes) {
    let kind = input.byte();
    // The upper half of the bytes are the filters.
    if kind >= 128 {
        return match kind % 4 {
            0 => widenings::widening::<R>(input),
            1 => widenings::light::<R>(input),
            2 => widenings::alphas::<R>(input),
            _ => widenings::shaded::<R>(input),
        };
    }
    match kind % 10 {
        0 => matrix::<R>(input),
        1 => nearest::<R>(input),
        2 => alphas::<R>(input),
        3 => lobe::<R>(input),
        4 => shapes::<R>(input),
        5 => moments::<R>(input),
        6 => kernel::<R>(input),
        7 => footprint::<R>(input),
        8 => vertex::<R>(input),
        _ => deferred::<R>(input),
    }
}

/// A roughness by one of its constructors, if it accepts; checked.
fn roughness<R: Real>(input: &mut Bytes) -> Option<Roughness<R>> {
    let (kind, a, b, c) = (input.byte() % 5, input.number(), input.number(), input.number());
    let value = match kind {
        0 => Roughness::from_alpha(a),
        1 => Roughness::from_alphas(a, b, c),
        2 => Roughness::from_perceptual(a),
        3 => Roughness::from_sigma_rho(a, b, c),
        _ => Psd::new(a, b, c).map(Roughness::from_matrix),
    };
    let value = value.ok()?;
    valid::roughness(&value, &(kind, a, b, c));
    Some(value)
}

fn lobe<R: Real>(input: &mut Bytes) {
    let Some(roughness) = roughness::<R>(input) else { return };
    let mean = input.pair();
    match Lobe::new(mean, roughness) {
        Ok(lobe) => valid::lobe(&lobe, input, &mean),
        Err(error) => assert!(!mean.iter().all(|&x| valid::moderate(x)), "{error} for {mean:?}"),
    }
}

fn matrix<R: Real>(input: &mut Bytes) {
    let [xx, xy, yy] = input.triple::<R>();
    match Psd::new(xx, xy, yy) {
        Ok(matrix) => {
            valid::psd(&matrix, &[xx, xy, yy]);
            // Entries are products of the factor; an xx without digits for one counts as 0.
            let least = R::lit(4.0) * R::MIN_POSITIVE / R::EPSILON;
            let [a, b, c] = matrix.entries();
            let scale = [xx, (xx * yy).sqrt(), yy];
            for ((got, want), scale) in [a, b, c].into_iter().zip([xx, xy, yy]).zip(scale) {
                let slack = R::lit(8.0) * R::EPSILON * scale + least;
                let least = if scale < yy { (least * yy).sqrt() } else { R::ZERO };
                assert!((got - want).abs() <= slack + least, "{matrix:?} of {xx}, {xy}, {yy}");
            }
        }
        Err(error) => {
            let diagonal = xy == R::ZERO && [xx, yy].iter().all(|&x| valid::in_domain(x));
            assert!(!diagonal, "{error} for diag({xx}, {yy})");
        }
    }
}

/// The constructors that mend or trust, on entries of moderate size.
fn nearest<R: Real>(input: &mut Bytes) {
    let [xx, xy, yy] = input.triple::<R>();
    if [xx, xy, yy].iter().all(|&x| valid::moderate(x)) {
        valid::psd(&Psd::nearest(xx, xy, yy), &[xx, xy, yy]);
    }
    let (u, v) = (input.pair::<R>(), input.pair::<R>());
    if u.iter().chain(&v).all(|&x| valid::moderate(x)) {
        valid::psd(&Psd::outer_sum(u, v), &(u, v));
    }
}

/// Roughness read back is the roughness put in.
fn alphas<R: Real>(input: &mut Bytes) {
    let (x, y, angle) = (input.number::<R>(), input.number::<R>(), input.number::<R>());
    let known = valid::in_domain(x) && valid::in_domain(y);
    let close = |got: R, put: R| (got - put).abs() <= R::lit(64.0) * R::EPSILON * put;
    match Roughness::from_alphas(x, y, angle) {
        Ok(value) => {
            let back = value.alphas();
            let same = close(back.major, x.max(y)) && close(back.minor, x.min(y));
            assert!(same || !known, "{back:?} from ({x}, {y}) at {angle}");
        }
        Err(error) => assert!(!known || !angle.is_finite(), "{error} for ({x}, {y}) at {angle}"),
    }
    match Roughness::from_alpha(x) {
        Ok(value) => {
            let back = value.alphas();
            let same = close(back.major, x) && close(back.minor, x) && back.angle == R::ZERO;
            assert!(same || !valid::in_domain(x), "{back:?} from {x}");
        }
        Err(error) => assert!(!valid::in_domain(x), "{error} for {x}"),
    }
}

fn shapes<R: Real>(input: &mut Bytes) {
    let ([x, y], mean) = (input.pair::<R>(), input.pair::<R>());
    let centered = mean.iter().all(|&m| valid::moderate(m));
    if let Ok(shape) = Isotropic::new(x) {
        valid::shape(shape, valid::in_domain(x), input, &x);
        if let Ok(tilted) = NonCentered::new(shape, mean) {
            valid::shape(tilted, valid::in_domain(x) && centered, input, &(x, mean));
        }
    }
    if let Ok(shape) = AxisAligned::new(x, y) {
        let known = valid::in_domain(x) && valid::in_domain(y);
        valid::shape(shape, known, input, &(x, y));
        if let Ok(tilted) = NonCentered::new(shape, mean) {
            valid::shape(tilted, known && centered, input, &(x, y, mean));
        }
    }
}

fn moments<R: Real>(input: &mut Bytes) {
    let (mean, second) = (input.pair::<R>(), input.triple::<R>());
    let Ok(raw) = SlopeMoments::from_raw(mean, second) else { return };
    valid::moments(&raw, &(mean, second));
    let (slope, weights) = (input.pair::<R>(), input.pair::<R>());
    let Ok(other) = SlopeMoments::new(slope, Psd::zero()) else { return };
    if let Ok(merged) = raw.merged(weights[0], &other, weights[1]) {
        valid::moments(&merged, &(raw, other, weights));
        let Some(base) = roughness(input) else { return };
        valid::lobe(&merged.lobe(base), input, &(merged, base));
    }
}

fn kernel<R: Real>(input: &mut Bytes) {
    let (u, v, variance) = (input.pair::<R>(), input.pair::<R>(), input.number::<f64>());
    let Ok(filter) = PixelFilter::with_variance(variance) else { return };
    assert!(filter.variance() == variance && variance >= 0.0, "{filter:?} from {variance}");
    if u.iter().chain(&v).all(|&x| valid::moderate(x)) {
        let kernel = Kernel::of(&Footprint::from_slopes(u, v), filter);
        valid::kernel(&kernel, input, &(u, v, filter));
    }
}

fn footprint<R: Real>(input: &mut Bytes) {
    let [here, right, up] = [input.triple::<R>(), input.triple(), input.triple()];
    let Ok(footprint) = Footprint::from_half_vectors(here, right, up) else { return };
    let sides = footprint.u.into_iter().chain(footprint.v);
    assert!(sides.clone().all(R::is_finite), "{footprint:?} from {here:?}, {right:?}, {up:?}");
    if sides.clone().all(valid::moderate) {
        let (area, diameter) = (footprint.area(), footprint.diameter());
        assert!(area >= R::ZERO && area.is_finite(), "area {area} of {footprint:?}");
        assert!(diameter.is_finite(), "diameter {diameter} of {footprint:?}");
        let limit = input.number::<R>().abs();
        if limit >= R::ZERO {
            let capped = footprint.capped(limit).diameter();
            let slack = limit * R::lit(16.0) * R::EPSILON + R::MIN_POSITIVE;
            assert!(capped <= limit + slack, "{capped} of {footprint:?} limited to {limit}");
        }
    }
}

fn vertex<R: Real>(input: &mut Bytes) {
    let position = input.triple::<R>();
    for vertex in [Vertex::at(position), Vertex::distant(position)].into_iter().flatten() {
        let square = vertex.direction.into_iter().fold(R::ZERO, |sum, x| sum + x * x);
        assert!(
            (square - R::ONE).abs() <= R::lit(8.0) * R::EPSILON
                && vertex.inverse_distance >= R::ZERO
                && vertex.inverse_distance.is_finite(),
            "{vertex:?} from {position:?}"
        );
    }
}

fn deferred<R: Real>(input: &mut Bytes) {
    let (alpha, limit) = (input.number::<R>(), input.number::<R>());
    let (dn_u, dn_v) = (input.triple::<R>(), input.triple::<R>());
    let filter = PixelFilter::KAPLANYAN;
    if let Ok(filtered) = tokuyoshi_deferred_alpha(alpha, dn_u, dn_v, filter, limit) {
        let lowest = alpha * (R::ONE - R::lit(4.0) * R::EPSILON) - R::lit(1e-15);
        assert!(
            filtered.is_finite() && filtered >= lowest,
            "{filtered} from {alpha}, {dn_u:?}, {dn_v:?}, limit {limit}"
        );
    }
}
