//! Kaplanyan's Eq. 20 on the page: both forms of alpha', and the peaks they give.

use super::axis::Scale;
use super::chart::{Chart, Line, Range};
use super::escape;
use super::kernels::drawn;
use super::measure::signed_percent;
use super::table::significant;
use crate::kernels::Proxy;

/// One way to a widened alpha.
struct Form {
    name: &'static str,
    class: &'static str,
    alpha: fn(&Proxy) -> f64,
    /// Among [`Proxy::peak_ratios`].
    place: usize,
}

const FORMS: [Form; 3] = [
    Form { name: "re-derived", class: "peak", alpha: |proxy| proxy.exact, place: 0 },
    Form { name: "last form", class: "published", alpha: |proxy| proxy.last_form, place: 1 },
    Form {
        name: "\u{3b1}\u{b2} + w\u{b2}/\u{3c0}",
        class: "added third",
        alpha: |proxy| proxy.over_pi,
        place: 2,
    },
];

const WIDTH: Range = Range::new("w/\u{3b1}", Scale::Logarithmic, [0.01, 10.0]);

/// Figures and finding.
pub(super) fn html(proxies: &[Proxy]) -> String {
    let alphas = Chart {
        title: "alpha' over alpha by the width of the square".into(),
        x: WIDTH,
        y: Range::new("\u{3b1}\u{2032}/\u{3b1}", Scale::Logarithmic, [0.9, 12.0]),
        right: None,
        lines: lines(proxies, |form, proxy| (form.alpha)(proxy)),
    };
    let peaks = Chart {
        title: "peak over the exact peak by the width of the square".into(),
        x: WIDTH,
        y: Range::new("peak / exact peak", Scale::Linear, [0.25, 1.15]),
        right: Some(1.0),
        lines: lines(proxies, |form, proxy| proxy.peak_ratios[form.place]),
    };
    format!(
        "<h3>Kaplanyan\u{2019}s Eq. 20</h3>\n<p class=\"note\">{}</p>\n<div \
            class=\"plots\">\n{}{}</div>\n",
        escape(&finding(proxies)),
        drawn("Widened alpha", &alphas),
        drawn("Peak under the box pixel", &peaks),
    )
}

fn lines(proxies: &[Proxy], value: fn(&Form, &Proxy) -> f64) -> Vec<Line> {
    let line = |form: &Form| Line {
        name: form.name.into(),
        class: form.class.into(),
        points: proxies.iter().map(|proxy| [proxy.width, value(form, proxy)]).collect(),
    };
    FORMS.iter().map(line).collect()
}

/// How far the last form is from the first, and what would have been close.
pub(super) fn finding(proxies: &[Proxy]) -> String {
    let error = |proxy: &Proxy, form: usize| proxy.peak_ratios[form] - 1.0;
    let worst = |form: usize| {
        let errors = proxies.iter().map(|proxy| (error(proxy, form), proxy.width));
        errors.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).unwrap_or((f64::NAN, f64::NAN))
    };
    let from_one = |proxy: &&Proxy| proxy.width.ln().abs();
    let at_one = proxies.iter().min_by(|a, b| from_one(a).total_cmp(&from_one(b)));
    let ((last_form, width), (over_pi, _)) = (worst(1), worst(2));
    format!(
        "The paper calls the last form of Eq. 20 \u{201c}indistinguishable from the first \
            approximation\u{201d}: its \
         peak is wrong by {} where w is {} \u{3b1} and by {} where it is {} \u{3b1}; \
         \u{3b1}\u{b2} + w\u{b2}/\u{3c0} by at most {}.",
        signed_percent(at_one.map_or(f64::NAN, |proxy| error(proxy, 1))),
        significant(at_one.map_or(f64::NAN, |proxy| proxy.width)),
        signed_percent(last_form),
        significant(width),
        signed_percent(over_pi),
    )
}
