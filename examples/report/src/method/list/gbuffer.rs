//! Filters of GGX that know the normal only: the papers' and the engines'.

use lobe::filter::engine::Engine;

use super::super::deferred::Deferred;
use super::super::{Distribution, Family, Method};
use super::Filter;
use super::ggx::forward;
use crate::window::PixelWindow;

/// GGX whose roughness was filtered before the light was known.
pub(super) fn deferred() -> Vec<Method> {
    let form = |name, source, note, window, shade: Deferred| {
        Filter { family: Family::Deferred, ..forward(name, source, note, window, shade) }.in_quads()
    };
    let (quarter, unit_peak) = (PixelWindow::GaussianQuarter, PixelWindow::GaussianUnitPeak);
    vec![
        form(
            "deferred, sum",
            "Tokuyoshi 2017, Eq. 13; O3DE ships it",
            "alpha^2 + the sum of the normal kernel's eigenvalues, variance 1/4, at most 0.18.",
            quarter,
            Deferred::Sum,
        ),
        form(
            "deferred, largest",
            "Tokuyoshi 2017, Eq. 10",
            "The same with the largest eigenvalue in place of their sum.",
            quarter,
            Deferred::Largest,
        ),
        form(
            "deferred, mean",
            "Tokuyoshi & Kaplanyan 2021, Eq. 14 and Listing 5",
            "The same with the mean of the eigenvalues and the variance 1/(2 pi).",
            unit_peak,
            Deferred::Mean,
        ),
        form(
            "deferred, rectangle",
            "Kaplanyan et al. 2016, section 5.4",
            "The quad's average normal in each frame; its rectangle widens each axis, variance \
                1/4, at most 0.18.",
            quarter,
            Deferred::Rectangle,
        ),
        form(
            "deferred, widest",
            "Kaplanyan et al. 2016, section 5.4; Tokuyoshi 2017, Listing 3",
            "The same with the larger width for both axes.",
            quarter,
            Deferred::Widest,
        ),
    ]
}

/// What engines ship; O3DE's is the deferred sum.
pub(super) fn engines() -> Vec<Method> {
    let shipped = Engine::ALL.iter().copied().filter(|engine| *engine != Engine::O3de);
    let method = |engine: Engine| {
        Filter {
            name: engine.name(),
            source: "lobe::filter::engine, as shipped",
            note: engine.formula(),
            distribution: Distribution::Ggx,
            family: Family::Engine,
            window: PixelWindow::Box,
            shade: Deferred::Engine(engine),
        }
        .in_quads()
    };
    shipped.map(method).collect()
}
