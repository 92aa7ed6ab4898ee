//! What the figures of glints show, in numbers.

use super::tables::{half_name, is_sure, kinds, mean};
use crate::glints::{Contest, Entry, Glitter, Judged, Light, Model, Moments};
use crate::page::axis::plain;
use crate::page::table::significant;

/// Ends of some numbers.
fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

fn span(values: impl Iterator<Item = f64>) -> String {
    let [low, high] = ends(values).map(significant);
    format!("{low} to {high}")
}

/// How many cells, and what is lost.
pub(super) fn cells(glints: &Glitter) -> String {
    let at = |aspect: f64| glints.visited.iter().find(|v| v.aspect == aspect);
    let [Some(square), Some(long)] = [1.0, 16.0].map(at) else { return String::new() };
    let most = glints.visited.iter().map(|v| v.default[1]).fold(0.0, f64::max);
    let whole = glints.visited.iter().take_while(|v| v.lost[1] < 1e-9).last();
    let lost = ends(glints.visited.iter().filter(|v| v.aspect >= 16.0).map(|v| v.lost[0]));
    let worst = glints.visited.iter().map(|v| v.lost[1]).fold(0.0, f64::max);
    format!(
        "A square pixel asks {} cells in the mean, one 16 times as long {}, and none more than \
            {}. The published loops see \
         all of a pixel up to an aspect of {}; from 16 on they leave out {:.0} to {:.0} % of it \
         in the mean, {:.0} % at worst.",
        significant(square.default[0]),
        significant(long.default[0]),
        plain(most),
        whole.map_or(String::new(), |v| plain(v.aspect)),
        100.0 * lost[0],
        100.0 * lost[1],
        100.0 * worst,
    )
}

/// What an evaluation takes, and what it depends on.
pub(super) fn times(glints: &Glitter) -> String {
    let speed = &glints.speed;
    let of = |model: Model| {
        let growth = speed.growth(model).map(|g| g.map_or(String::new(), significant));
        let times = speed.views.iter().find(|t| t.model == model).map(|t| t.times);
        let [steep, grazing, _] = times.unwrap_or_default().map(significant);
        (steep, grazing, growth)
    };
    let (default, published) = (of(Model::Default), of(Model::Published));
    let lines = speed.by_cells.iter().map(|curve| {
        let (rate, off) = curve.line();
        format!(
            "{} {} ns per cell, on a line within {:.0} %",
            curve.model.name(),
            significant(rate),
            100.0 * off
        )
    });
    let over = |model: Model| {
        let curves = speed.by_details.iter().filter(move |curve| curve.model == model);
        curves.map(|curve| span(curve.points.iter().map(|p| 1e-3 * p[1]))).collect::<Vec<_>>()
    };
    let (ours, theirs) = (over(Model::Default), over(Model::Published));
    let [first, last] =
        [speed.points.first(), speed.points.last()].map(|p| p.copied().unwrap_or_default());
    format!(
        "The default takes {} ns steep and {} ns at 10 degrees, where it adds {} times as much to \
            the smooth lobe; published {} \
         and {} ns, {} times. Time grows with the cells: {}. It does not grow with the details: \
         over ten decades the default \
         takes {} \u{b5}s steep and {} at the limit, published {} and {}. What varies is the way \
         to draw a number, by inversion \
         below about 8 and by a quantile above; and of few details there are few cells. Points \
         take {} \u{b5}s for one \
         detail and {} for {}.",
        default.0,
        default.1,
        default.2[0],
        published.0,
        published.1,
        published.2[0],
        lines.collect::<Vec<_>>().join("; "),
        ours.first().map_or("", String::as_str),
        ours.last().map_or("", String::as_str),
        theirs.first().map_or("", String::as_str),
        theirs.last().map_or("", String::as_str),
        significant(1e-3 * first[1]),
        significant(1e-3 * last[1]),
        plain(last[0]),
    )
}

/// What a cell costs.
pub(super) fn counts(glints: &Glitter) -> String {
    let totals = glints.operations.iter().map(|counted| counted.cell.total());
    let ([all, arithmetic], [_, varied]) = (glints.instructions.cell, glints.instructions.varied);
    format!(
        "A cell costs {} operations on floats, the most where two ways to draw are blended. It \
            has {all} instructions, {arithmetic} \
         of them arithmetic; {varied} of these run only where numbers of details vary, as what is \
         drawn from is otherwise found \
         once for a level. The other {} stand beside the paper\u{2019}s 204.",
        span(totals),
        arithmetic.saturating_sub(varied),
    )
}

/// Whose mean is right.
pub(super) fn means(glints: &Glitter) -> String {
    let all = |light: Light, of: fn(&Judged) -> &Moments| {
        kinds(glints, light)
            .filter(|kinds| is_sure(kinds))
            .map(move |kinds| (mean(&kinds, of), kinds[0].material, kinds[0].half))
            .collect::<Vec<_>>()
    };
    let default: fn(&Judged) -> &Moments = |judged| &judged.default;
    let published: fn(&Judged) -> &Moments = |judged| &judged.published;
    let ours: Vec<_> = Light::ALL.into_iter().flat_map(|light| all(light, default)).collect();
    let off = ours.iter().map(|([value, error], ..)| value.abs() / error).fold(0.0, f64::max);
    let lowest = all(Light::Point, published).into_iter().min_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    // Where the mean is known to a tenth.
    let known = all(Light::Sun, published).into_iter().filter(|(mean, ..)| mean[1] < 0.1);
    let highest = known.max_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let place = |found: Option<([f64; 2], &str, f64)>| {
        found.map_or(String::new(), |(mean, material, half)| {
            format!("{:+.0} % ({material}, {})", 100.0 * mean[0], half_name(half))
                .replace('-', "\u{2212}")
        })
    };
    let gain = glints.gains.iter().max_by(|a, b| a.published.mean.total_cmp(&b.published.mean));
    format!(
        "The default\u{2019}s mean is that of the smooth lobe: of {} means none is off by more \
            than {} standard errors. The published \
         one is dark where 1/h_z\u{2074} is cut, {}, and adds a haze under the sun, {}; sizes \
         that vary brighten it up to {} times.",
        ours.len(),
        significant(off),
        place(lowest),
        place(highest),
        gain.map_or(String::new(), |gain| significant(gain.published.mean)),
    )
}

/// How much calmer than real details.
pub(super) fn variances(glints: &Glitter) -> String {
    let over = |aspect: f64, of: fn(&Judged) -> f64| {
        let kinds = glints.judged.iter().filter(move |judged| {
            judged.aspect == aspect && judged.light == Light::Point && judged.is_sure()
        });
        span(kinds.map(move |judged| of(judged) / judged.truth))
    };
    let default: fn(&Judged) -> f64 = |judged| judged.default.variance;
    // How far beyond the law's two ends, for sure.
    let beyond = glints.judged.iter().filter(|judged| judged.is_sure()).map(|judged| {
        let ([apart, together], got) = (judged.law, &judged.default);
        let [low, high] = [-2.0, 2.0].map(|k| got.variance + k * got.variance_error);
        (low / together).max(apart / high) - 1.0
    });
    let law = match beyond.fold(0.0, f64::max) {
        0.0 => "within two standard errors what its own law says".into(),
        beyond => format!(
            "up to {} % and two standard errors beyond its own law",
            significant(100.0 * beyond)
        ),
    };
    let of = |model: Model| {
        let found = glints.ripples.iter().find(|r| r.model == model && r.aspect == 1.0);
        found.map_or([f64::NAN; 2], |ripple| ends(ripple.points.iter().map(|p| p[1])))
    };
    let (square, published) = (of(Model::Default), of(Model::Published).map(significant));
    format!(
        "A pixel of the default has {} of the variance of real details at aspect 1, {} at 4 and \
            {} at 16, {law}. \
         Square pixels of many details have {} to {}, by their width: {} to {} times less than if \
         details reflected all or \
         nothing. Published ones have {} to {}, as normal draws have half their variance there. \
         Off the pole published pixels \
         are calmer by h_z\u{2074} more: that factor stands in the probability, so that more \
         details reflect, each of them \
         fainter.",
        over(1.0, default),
        over(4.0, default),
        over(16.0, default),
        significant(square[0]),
        significant(square[1]),
        significant(2.0 / square[1]),
        significant(2.0 / square[0]),
        published[0],
        published[1],
    )
}

/// What is near the truth, and what it costs.
pub(super) fn contests(glints: &Glitter) -> String {
    let entry = |contest: &Contest, model: Model| -> String {
        let entry = contest.of(model);
        let told = |entry: &Entry| {
            let hidden = if entry.distance < contest.noise { "at most " } else { "" };
            format!("{hidden}{}", significant(entry.distance.max(contest.noise)))
        };
        entry.map_or(String::new(), told)
    };
    let square = glints.contests.iter().filter(|contest| contest.aspect == 1.0);
    let details: Vec<_> = square.map(|contest| plain(contest.details)).collect();
    // Of few details, then of many.
    let both = |long: bool, model: Model| {
        let contests = glints.contests.iter().filter(|contest| (contest.aspect > 1.0) == long);
        contests.map(|contest| entry(contest, model)).collect::<Vec<_>>().join(" and ")
    };
    let prices = glints.contests.iter().filter_map(|contest| {
        let default = contest.of(Model::Default)?;
        Some(contest.points.last()?.time / default.time)
    });
    format!(
        "With {} details square pixels of the default are distributed {} of the mean from real \
            ones, published {}, the smooth lobe \
         {}; with four samples {}. Long ones are {} off, published {}, with four samples {}. {} \
         Drawing all points takes {} \
         times as long as the default.",
        details.join(" and "),
        both(false, Model::Default),
        both(false, Model::Published),
        both(false, Model::Smooth),
        both(false, Model::Four),
        both(true, Model::Default),
        both(true, Model::Published),
        both(true, Model::Four),
        samples(glints),
        span(prices),
    )
}

/// Whether four samples are worth their time.
fn samples(glints: &Glitter) -> &'static str {
    let nearer = |long: bool| {
        let contests = glints.contests.iter().filter(move |c| (c.aspect > 1.0) == long);
        let distance = |contest: &Contest, model: Model| {
            let entry = contest.of(model);
            entry.map_or(f64::NAN, |entry| entry.distance)
        };
        let nearer = contests.map(|c| distance(c, Model::Four) < distance(c, Model::Default));
        let nearer: Vec<_> = nearer.collect();
        // None where it depends on the number of details.
        let first = *nearer.first()?;
        nearer.iter().all(|x| *x == first).then_some(first)
    };
    match [nearer(false), nearer(true)] {
        [Some(true), Some(true)] => "Four samples come nearer than one.",
        [Some(true), Some(false)] => "Four samples come nearer in square pixels, one in long ones.",
        [Some(false), Some(true)] => "One sample comes nearer in square pixels, four in long ones.",
        [Some(false), Some(false)] => "Four samples come no nearer than one.",
        _ => "Whether four samples come nearer depends on the number of details.",
    }
}
