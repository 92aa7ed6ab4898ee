//! What is seen of a minified map, in numbers.

use super::{percent, sweep};
use crate::method::Distribution;
use crate::minify::{GRAZED, Minified, Panel, RATIOS, name};
use crate::page::table::significant;

/// What is seen, of GGX at the first alpha.
pub(super) fn finding(map: &Minified) -> String {
    let panels: Vec<_> = sweep(map, Distribution::Ggx).collect();
    let [Some(last), Some(middle), Some(lowest)] = [
        panels.last().copied(),
        panels.iter().copied().find(|panel| panel.ratio == GRAZED),
        map.of(Distribution::Ggx, map.alpha()).min_by(|a, b| a.elevation.total_cmp(&b.elevation)),
    ] else {
        return String::new();
    };
    let span = |name: &str| {
        let errors = panels.iter().map(|panel| panel.rmse(name));
        let (least, most) = errors.fold((f64::INFINITY, 0.0_f64), |(l, m), e| (l.min(e), m.max(e)));
        format!("{} to {}", significant(least), significant(most))
    };
    let over_best = |panel: &&Panel| panel.best().map_or(0.0, |row| panel.noise / row.errors.rmse);
    let noise = panels.iter().map(over_best).fold(0.0, f64::max);
    // The largest of a ratio of errors over the sweep.
    let most = |name: &str, over: &str| {
        panels.iter().map(|panel| panel.rmse(name) / panel.rmse(over)).fold(0.0, f64::max)
    };
    [
        format!(
            "From {} to {} texels per pixel plain mips are wrong by {} times the mean radiance, \
                in the end with {} times \
             the light; Toksvig by {}, LEAN by {}, LEAN with anisotropic lookups by {}, 16 \
             samples by {}.",
            RATIOS[0],
            last.ratio,
            span(name::MIPS),
            significant(last.energy(name::MIPS)),
            span(name::TOKSVIG),
            span(name::LEAN),
            span(name::ALONG),
            span(name::SIXTEEN),
        ),
        format!(
            "At {} texels per pixel LEAN\u{2019}s error of {} becomes {} with anisotropic \
                lookups, {} with narrow probes \
             and {} with the moments of the pixel\u{2019}s own slopes.",
            middle.ratio,
            significant(middle.rmse(name::LEAN)),
            significant(middle.rmse(name::ALONG)),
            significant(middle.rmse(name::NARROW)),
            significant(middle.rmse(name::EXACT)),
        ),
        format!(
            "Seen from {} degrees narrow probes give {} of the light, over the base\u{2019}s \
                visibility {}.",
            lowest.elevation,
            percent(lowest.energy(name::NARROW)),
            percent(lowest.energy(name::UNMASKED)),
        ),
        format!(
            "The half vector moves by {} alphas a pixel; its kernel changes LEAN\u{2019}s error \
                by {} at most; the \
             shading frame\u{2019}s kernel, which counts the map twice, makes it up to {} times \
             as large, and instead of \
             the covariance {} times.",
            significant(map.motion / map.alpha()),
            percent(
                (most(name::KERNEL, name::LEAN) - 1.0)
                    .abs()
                    .max((most(name::LEAN, name::KERNEL) - 1.0).abs())
            ),
            significant(most(name::TWICE, name::LEAN)),
            significant(most(name::SHADED, name::LEAN)),
        ),
        format!(
            "The reference\u{2019}s noise is at most {} of the least error of a single sample.",
            percent(noise),
        ),
    ]
    .join(" ")
}
