//! Every method, with its source and what it stands for.

mod beckmann;
mod gbuffer;
mod ggx;

use core::marker::PhantomData;

use lobe::ndf::{BeckmannDistribution, GgxDistribution};

use super::count::counting;
use super::shading::{Plain, Shade};
use super::{Derivatives, Distribution, Family, Method, by_pixel};
use crate::window::PixelWindow;

/// Sample counts of the line to beat.
const SUPERSAMPLING: [u32; 5] = [1, 4, 16, 64, 256];

/// A filter before it is given derivatives.
struct Filter<F> {
    name: &'static str,
    source: &'static str,
    note: &'static str,
    distribution: Distribution,
    family: Family,
    window: PixelWindow,
    shade: F,
}

impl<F: Shade + Clone + Send + Sync + 'static> Filter<F> {
    /// With differences in quads.
    fn in_quads(&self) -> Method {
        self.with(self.name.into(), Derivatives::Quad)
    }

    /// With differences in quads, and with analytic derivatives.
    fn both(&self) -> [Method; 2] {
        let name = format!("{}, analytic", self.name);
        [self.in_quads(), self.with(name, Derivatives::Analytic)]
    }

    fn with(&self, name: String, derivatives: Derivatives) -> Method {
        Method {
            name,
            source: self.source,
            note: self.note,
            distribution: self.distribution,
            family: self.family,
            samples: 1,
            derivatives,
            window: self.window,
            shading: by_pixel(self.shade.clone(), derivatives),
            counting: counting(self.shade.clone(), derivatives),
        }
    }
}

/// Plain supersampling; one sample is what every engine starts from.
fn supersampling(distribution: Distribution, samples: u32) -> Method {
    let name = match samples {
        1 => "none (1 sample)".into(),
        many => format!("supersampling {many}"),
    };
    let (ggx, beckmann) =
        (Plain::<GgxDistribution>(PhantomData), Plain::<BeckmannDistribution>(PhantomData));
    let none = Derivatives::None;
    let (shading, counting) = match distribution {
        Distribution::Ggx => (by_pixel(ggx.clone(), none), counting(ggx, none)),
        Distribution::Beckmann => (by_pixel(beckmann.clone(), none), counting(beckmann, none)),
    };
    Method {
        name,
        source: "the line to beat",
        note: "Geometry and unfiltered shading at the points of a Hammersley net in the pixel.",
        distribution,
        family: Family::Supersampling,
        samples,
        derivatives: Derivatives::None,
        window: PixelWindow::Box,
        shading,
        counting,
    }
}

/// Every method, in the order of the tables.
pub(crate) fn all() -> Vec<Method> {
    let mut methods = Vec::from(SUPERSAMPLING.map(|n| supersampling(Distribution::Ggx, n)));
    methods.extend(ggx::widened());
    methods.extend(ggx::over_an_area());
    methods.extend(gbuffer::deferred());
    methods.extend(gbuffer::engines());
    methods.extend(SUPERSAMPLING.map(|n| supersampling(Distribution::Beckmann, n)));
    methods.extend(beckmann::filters());
    methods
}
