//! The tables of means and variances, and what their columns mean.

use crate::glints::{ASPECTS, Glitter, HALVES, Judged, Light, Moments};
use crate::page::axis::plain;
use crate::page::table::{Line, Table, significant};

pub(super) const MEANS_NOTE: &str = "Above: mean of the pixels over the smooth lobe, minus 1, in \
    %, with its standard error, over \
    aspects 1, 4 and 16; too rare: a sample met fewer than a hundred details that reflect. The \
    sun appears with a radius of 0.00465. Half vectors in \u{3b1}; of the rough surface they \
    stand 63 and 76 \
    degrees from the pole. Below: pixels of one cell at the pole, details of a tenth of \u{3b1}; \
    the default\u{2019}s variation ends \
    at 4, the published shader\u{2019}s snow has 100.";

pub(super) const VARIANCES_NOTE: &str = "Variance over the squared mean, point light, over that \
    of real details, whose lobes are \
    Gaussian; details that reflect all or nothing would vary twice as much (grooves 1.4 times), \
    1/(nP) of n details. Law: the \
    default\u{2019}s own, \u{2211} share\u{b2}(1 \u{2212} P)/(nP) over its cells, if levels draw \
    independently, and if cells that \
    both have draw in proportion. nP: details that reflect in a pixel. \u{2013}: too few \
    reflected to tell; published \
    0.00: all do, as the probability is cut.";

fn line(cells: Vec<String>) -> Line {
    Line { cells, class: "" }
}

/// Kinds of one material, half vector and light, one for each aspect.
pub(super) fn kinds(glints: &Glitter, light: Light) -> impl Iterator<Item = Vec<&Judged>> + Clone {
    let lit: Vec<_> = glints.judged.iter().filter(|judged| judged.light == light).collect();
    let count = lit.len() / ASPECTS.len();
    (0..count).map(move |k| lit[k * ASPECTS.len()..][..ASPECTS.len()].to_vec())
}

/// Whether details that reflect were met often enough: of fewer, a sample does not know its own
/// error.
pub(super) fn is_sure(kinds: &[&Judged]) -> bool {
    kinds.iter().all(|judged| judged.is_sure())
}

/// Mean over aspects, minus 1, and its standard error.
pub(super) fn mean(kinds: &[&Judged], of: fn(&Judged) -> &Moments) -> [f64; 2] {
    let count = kinds.len() as f64;
    let sum: f64 = kinds.iter().map(|judged| of(judged).mean - 1.0).sum();
    let squares: f64 = kinds.iter().map(|judged| of(judged).mean_error.powi(2)).sum();
    [sum / count, squares.sqrt() / count]
}

/// A number and its error with one digit of that; at most `most` decimals.
fn plus_minus([value, error]: [f64; 2], most: i32) -> String {
    let decimals = (-(1.05 * error).log10().floor()).clamp(0.0, most.into());
    // Small and not negative.
    #[allow(clippy::cast_sign_loss)]
    let decimals = decimals as usize;
    let text = format!("{value:.decimals$}");
    let text = match text.strip_prefix('-') {
        Some(digits) if digits.contains(|c: char| ('1'..='9').contains(&c)) => {
            format!("\u{2212}{digits}")
        }
        Some(digits) => digits.into(),
        None => text,
    };
    format!("{text} \u{b1} {error:.decimals$}")
}

pub(super) fn half_name(half: f64) -> String {
    match half {
        h if h == HALVES[0] => "pole".into(),
        h if h == HALVES[1] => "\u{3b1}".into(),
        h => format!("{h} \u{3b1}"),
    }
}

/// Means of both models under both lights.
pub(super) fn means(glints: &Glitter) -> Table {
    let lit = Light::ALL.map(|light| kinds(glints, light));
    let [point, sun] = lit;
    let rows = point.zip(sun).map(|(point, sun)| {
        let first = point[0];
        let of = |kinds: &[&Judged], moments: fn(&Judged) -> &Moments| {
            if is_sure(kinds) {
                plus_minus(mean(kinds, moments).map(|x| 100.0 * x), 2)
            } else {
                "too rare".into()
            }
        };
        line(vec![
            format!("{}, {}", first.material, half_name(first.half)),
            significant(first.reflecting),
            of(&point, |j| &j.default),
            of(&sun, |j| &j.default),
            of(&point, |j| &j.published),
            of(&sun, |j| &j.published),
        ])
    });
    let headers = &[
        "Material, half vector",
        "nP",
        "Default: point, %",
        "sun, %",
        "Published: point, %",
        "sun, %",
    ];
    Table { headers, rows: rows.collect() }
}

/// What varying sizes do to the mean.
pub(super) fn gains(glints: &Glitter) -> Table {
    let rows = glints.gains.iter().map(|gain| {
        let over = |m: &Moments| plus_minus([m.mean, m.mean_error], 4);
        line(vec![
            gain.variation.to_string(),
            plain(gain.details),
            over(&gain.published),
            over(&gain.default),
        ])
    });
    let headers = &["Variation", "Details in a cell", "Published: mean / smooth", "Default"];
    Table { headers, rows: rows.collect() }
}

/// Variances under the point light.
pub(super) fn variances(glints: &Glitter) -> Table {
    let rows = kinds(glints, Light::Point).map(|kinds| {
        let first = kinds[0];
        let cells = kinds.iter().flat_map(|judged| {
            let over = |x: f64| format!("{:.2}", x / judged.truth);
            let sure =
                |m: &Moments| if judged.is_sure() { over(m.variance) } else { "\u{2013}".into() };
            let [apart, together] = judged.law.map(over);
            [format!("{apart}\u{2013}{together}"), sure(&judged.default), sure(&judged.published)]
        });
        let starts = [
            format!("{}, {}", first.material, half_name(first.half)),
            significant(first.reflecting),
            significant(first.truth),
        ];
        line(starts.into_iter().chain(cells).collect())
    });
    let headers = &[
        "Material, half vector",
        "nP",
        "True",
        "Aspect 1: law",
        "default",
        "published",
        "4: law",
        "default",
        "published",
        "16: law",
        "default",
        "published",
    ];
    Table { headers, rows: rows.collect() }
}

#[cfg(test)]
mod tests {
    use super::{half_name, plus_minus};
    use crate::glints::HALVES;

    #[test]
    fn errors_decide_the_digits_and_nothing_has_no_sign() {
        let cases = [
            ([-1.234, 0.05], "\u{2212}1.23 \u{b1} 0.05"),
            ([40.2, 2.1], "40 \u{b1} 2"),
            ([-0.01, 0.3], "0.0 \u{b1} 0.3"),
            ([0.5, 0.098], "0.5 \u{b1} 0.1"),
            ([-56.514, 0.0], "\u{2212}56.51 \u{b1} 0.00"),
        ];
        for (numbers, text) in cases {
            assert_eq!(plus_minus(numbers, 2), text);
        }
    }

    #[test]
    fn half_vectors_have_names() {
        assert_eq!(HALVES.map(half_name), ["pole", "\u{3b1}", "2 \u{3b1}"]);
    }
}
