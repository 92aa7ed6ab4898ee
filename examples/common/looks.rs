//! What a map's slopes look like: for the user to judge.

use lobe::SlopeMoments;
use lobe::material::lean::{ClippedTexels, MomentMap};

/// The largest component of a slope that codes of 8 bits may make of 0: (128, 128, 255) is 1/255,
/// and its z may be somewhat shorter.
const NEUTRAL: f32 = 1.5 / 255.0;
/// The slopes of a neutral texel encoded as sRGB, (188, 188, 255), and decoded as sRGB, (55, 55,
/// 255), and how far a map's mean may be from them.
const SRGB: f32 = -(2.0 * 188.0 - 255.0) / 255.0;
const LINEAR: f32 = -(2.0 * 55.0 - 255.0) / 255.0;
const BENT_NEAR: f32 = 0.06;
/// The part of texels that may be clipped without a word.
const CLIPPED: f64 = 0.01;
/// The correlation of both derivatives below which y is taken to point the other way.
const TURNED: f64 = -0.25;
/// Texels whose derivatives are looked at, at most.
const LOOKED_AT: usize = 1 << 20;

/// The moments of the whole map.
pub(crate) fn whole(map: &MomentMap<f32>) -> SlopeMoments<f32> {
    map.texel(map.levels() - 1, 0, 0)
}

/// The deviation of slopes along both axes together.
pub(crate) fn deviation(moments: &SlopeMoments<f32>) -> f32 {
    moments.covariance().trace().sqrt()
}

/// Texels that a cap has shortened, if they are many; `cap` is how the message names it.
pub(crate) fn clipped(clipped: ClippedTexels, cap: &str) -> Option<String> {
    let percent = 100.0 * clipped.fraction();
    (clipped.fraction() > CLIPPED).then(|| {
        format!("{percent:.1} % of the texels are steeper than {cap} and were shortened to it")
    })
}

/// A normal map's y: whether it was negated as it was read, and how a message says to read it the
/// other way.
#[derive(Clone, Copy)]
pub(crate) struct Green<'a> {
    pub(crate) flipped: bool,
    pub(crate) remedy: &'a str,
}

/// What a map's slopes look like, a line each; `green` is known of normal maps.
pub(crate) fn lines(map: &MomentMap<f32>, green: Option<Green<'_>>) -> Vec<String> {
    let whole = whole(map);
    let bent = green.and_then(|green| bent(&whole, green.flipped)).unwrap_or_default();
    let tilted = tilted(&whole).map(|line| line + bent);
    tilted.into_iter().chain(green.and_then(|green| turned(map, green))).collect()
}

/// A mean slope that is no rounding of 0, and more than what the map adds to it.
fn tilted(moments: &SlopeMoments<f32>) -> Option<String> {
    let [x, y] = moments.mean();
    let (neutral, deviation) = (x.abs() <= NEUTRAL && y.abs() <= NEUTRAL, deviation(moments));
    if neutral || x.hypot(y) <= deviation {
        return None;
    }
    Some(if deviation == 0.0 {
        format!("every slope is ({x:.4}, {y:.4}): the map tilts the whole surface")
    } else {
        let length = x.hypot(y);
        format!(
            "the mean slope ({x:.4}, {y:.4}) of length {length:.4} is larger than the deviation \
                {deviation:.4}: \
             the map tilts the whole surface"
        )
    })
}

/// The end of a message about a normal map whose mean slope is that of a neutral texel bent by a
/// color curve; `flipped` if the map's y was negated.
fn bent(moments: &SlopeMoments<f32>, flipped: bool) -> Option<&'static str> {
    let [x, y] = moments.mean();
    let y = if flipped { -y } else { y };
    let near = |slope: f32| (x - slope).abs() <= BENT_NEAR && (y - slope).abs() <= BENT_NEAR;
    if near(SRGB) {
        Some(
            ", as a neutral map does that was encoded as sRGB, (188, 188, 255): save it as linear \
                data",
        )
    } else if near(LINEAR) {
        Some(
            ", as a neutral map does that was decoded as sRGB, (55, 55, 255): save it without \
                color management",
        )
    } else {
        None
    }
}

/// What is said of normals whose y points the other way.
fn turned(map: &MomentMap<f32>, Green { flipped, remedy }: Green<'_>) -> Option<String> {
    let pointed = if flipped { "up" } else { "down" };
    turned_round(map).then(|| {
        format!(
            "green looks as if it pointed {pointed}: the slopes are those of a surface with y \
                negated ({remedy})"
        )
    })
}

/// Whether the slopes would be a surface's if y pointed the other way.
///
/// The slopes of a surface have equal mixed derivatives, d s_x / dy = d s_y / dx; with one axis
/// turned they are opposite.
fn turned_round(map: &MomentMap<f32>) -> bool {
    let ([width, height], slopes) = (map.size(0), map.slopes());
    if width < 3 || height < 3 {
        return false;
    }
    let step = (width * height).div_ceil(LOOKED_AT);
    let (mut both, mut first, mut second) = (0.0, 0.0, 0.0);
    for row in (1..height - 1).step_by(step) {
        for column in 1..width - 1 {
            let at = |row: usize, column: usize| slopes[row * width + column].map(f64::from);
            // Rows count down, y points up.
            let along_y = at(row - 1, column)[0] - at(row + 1, column)[0];
            let along_x = at(row, column + 1)[1] - at(row, column - 1)[1];
            both += along_y * along_x;
            first += along_y * along_y;
            second += along_x * along_x;
        }
    }
    both < TURNED * f64::sqrt(first * second)
}
