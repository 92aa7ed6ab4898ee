//! Twins of `src/ndf`, and of the facade's `evaluate`: every function of either distribution over
//! every shape.

use lobe::material::Fresnel;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::shade::Shading;
use lobe::slope::Widened;
use lobe::{
    Anisotropic, AxisAligned, Beckmann, Distribution, Isotropic, LobeShape, Ndf, NonCentered, Real,
};

use super::value::{Flat, Reader};
use super::{Input, Twin};

/// A shape as a table's rows have it.
trait Shaped {
    type Of<R: Real>: LobeShape<Scalar = R>;
    const NAME: &'static str;
    const INPUT: Input;
    /// The WGSL expression of the shape, from its input `$0`.
    const WGSL: &'static str;
    fn read<R: Real>(x: &mut Reader<'_>) -> Self::Of<R>;
}

macro_rules! shaped {
    ($(
        $name:ident $shape:ty, $text:literal, $input:ident, $wgsl:literal => |$x:ident| $read:expr;
    )*) => {
        $(
            struct $name;
            impl Shaped for $name {
                type Of<R: Real> = $shape;
                const NAME: &'static str = $text;
                const INPUT: Input = Input::$input;
                const WGSL: &'static str = $wgsl;
                fn read<R: Real>($x: &mut Reader<'_>) -> $shape {
                    $read
                }
            }
        )*
    };
}

shaped! {
    OfIsotropic Isotropic<R>, "isotropic", Alpha, "lobe_isotropic_new($0)" => |x| {
        Isotropic::new(x.f()).expect("a drawn alpha is in range")
    };
    OfAxisAligned AxisAligned<R>, "axis_aligned", Alphas, "lobe_axis_aligned_new($0.x, \
        $0.y)" => |x| {
        AxisAligned::new(x.f(), x.f()).expect("drawn alphas are in range")
    };
    OfAnisotropic Anisotropic<R>, "anisotropic", Roughness, "lobe_anisotropic_new($0)" => |x| {
        Anisotropic::new(x.roughness())
    };
    OfWidened Widened<Isotropic<R>>, "widened", Widened, "$0" => |x| x.widened();
    OfNonCentered NonCentered<Anisotropic<R>>, "non_centered", Lobe, "lobe_lobe_shape($0)" => |x| {
        x.lobe().shape()
    };
}

/// Writes the functions of `Ndf`: method, further inputs, the WGSL arguments over `SHAPE` and its
/// expression `MADE`.
macro_rules! methods {
    ($($method:ident $(as $name:literal)? ($($input:ident),*) $wgsl:literal;)*) => {
        fn over<D: Distribution, S: Shaped>(prefix: &str) -> Vec<Twin> {
            vec![$({
                fn flat<D: Distribution, S: Shaped, R: Real>(x: &mut Reader<'_>) -> Vec<R> {
                    let ndf = Ndf::<D, _>::new(S::read::<R>(x));
                    vec![ndf.$method($(x.$input()),*)]
                }
                // Names in WGSL do not end in a digit.
                let method = [$($name,)? stringify!($method)][0];
                let arguments = $wgsl.replace("SHAPE", S::NAME).replace("MADE", S::WGSL);
                Twin {
                    name: format!("{prefix}_{method}"),
                    by: S::NAME,
                    inputs: [vec![S::INPUT], further(stringify!($($input)*))].concat(),
                    flips: 0.0,
                    expression: format!("lobe_{prefix}_{method}({arguments})"),
                    statements: <f32 as Flat<f32>>::WGSL,
                    single: flat::<D, S, f32>,
                    fused: flat::<D, S, lobe::probe::Fused>,
                    rounded: flat::<D, S, lobe::probe::Rounded>,
                }
            }),*]
        }
    };
}

impl Reader<'_> {
    fn slope<R: Real>(&mut self) -> [R; 2] {
        self.vec()
    }
    fn direction<R: Real>(&mut self) -> [R; 3] {
        self.vec()
    }
    /// Half of a pair.
    fn first<R: Real>(&mut self) -> [R; 3] {
        self.vec()
    }
    /// The other half.
    fn second<R: Real>(&mut self) -> [R; 3] {
        self.vec()
    }
}

/// The inputs that the readers' names stand for.
fn further(readers: &str) -> Vec<Input> {
    let input = |name| match name {
        "slope" => Some(Input::Slope),
        "direction" => Some(Input::Direction),
        "first" => Some(Input::Pair),
        _ => None,
    };
    readers.split_whitespace().filter_map(input).collect()
}

methods! {
    slope_pdf(slope) "lobe_SHAPE_normal(MADE, vec3f(-$1, 1.0))";
    d(direction) "lobe_SHAPE_normal(MADE, $1)";
    brdf(first, second) "lobe_SHAPE_pair(MADE, $1)";
    unshadowed_brdf_cos(first, second) "lobe_SHAPE_pair(MADE, $1)";
    projected_area(direction) "lobe_SHAPE_view(MADE, $1)";
    lambda(direction) "lobe_SHAPE_view(MADE, $1)";
    g1 as "masking" (direction) "lobe_SHAPE_view(MADE, $1)";
    g2 as "masking_shadowing" (direction, direction) "lobe_SHAPE_view(MADE, $1), \
        lobe_SHAPE_view(MADE, $2)";
    visibility(direction, direction) "lobe_SHAPE_view(MADE, $1), lobe_SHAPE_view(MADE, $2)";
}

/// The facade's `evaluate` of a shape, with Schlick's reflectance.
fn evaluate<D: Distribution, S: Shaped>(prefix: &str) -> Twin {
    fn flat<D: Distribution, S: Shaped, R: Real>(x: &mut Reader<'_>) -> Vec<R> {
        let ndf = Ndf::<D, _>::new(S::read::<R>(x));
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        let fresnel = Fresnel::schlick(x.vec()).expect("a drawn reflectance is in range");
        Shading::new(ndf, fresnel).evaluate(wo, wi).to_vec()
    }
    let pair = format!("lobe_{}_pair({}, $1)", S::NAME, S::WGSL);
    let reflectance = "lobe_fresnel_schlick($2, lobe_half_cosine($1))";
    Twin {
        name: format!("{prefix}_evaluate"),
        by: S::NAME,
        inputs: vec![S::INPUT, Input::Pair, Input::Reflectance],
        flips: 0.0,
        expression: format!("lobe_{prefix}_evaluate({pair}, {reflectance})"),
        statements: <[f32; 3] as Flat<f32>>::WGSL,
        single: flat::<D, S, f32>,
        fused: flat::<D, S, lobe::probe::Fused>,
        rounded: flat::<D, S, lobe::probe::Rounded>,
    }
}

/// What a distribution owes, by itself, and Walter's fit.
mod owed {
    use super::{Beckmann, BeckmannDistribution, Distribution, GgxDistribution};
    use lobe::Real;
    use lobe::slope::Extent;

    fn extent<R: Real>(root_det: R) -> Extent<R> {
        Extent { root_det, unit: root_det * root_det, scale: root_det }
    }

    super::super::twins! {
        "ggx_density" (Alpha, Alpha, Alpha, Alpha, Alpha) "lobe_ggx_density($0, \
            LobeExtent($1, $1 * $1, $1), $2, $3, $4)" => |x| {
            GgxDistribution::density(x.f::<R>(), extent(x.f()), x.f(), x.f(), x.f())
        };
        "ggx_excess" (Unit, Size) "lobe_ggx_excess($0, $1)" => |x| {
            GgxDistribution::excess(x.f::<R>(), x.f())
        };
        "ggx_even_area" (Cosine, Size) "lobe_ggx_even_area($0, $1)" => |x| {
            GgxDistribution::even_area(x.f::<R>(), x.f())
        };
        "beckmann_density" (Alpha, Alpha, Alpha, Alpha, Alpha) "lobe_beckmann_density($0, \
            LobeExtent($1, $1 * $1, $1), $2, $3, $4)" => |x| {
            BeckmannDistribution::density(x.f::<R>(), extent(x.f()), x.f(), x.f(), x.f())
        };
        "beckmann_excess" (Unit, Size) "lobe_beckmann_excess($0, $1)" => |x| {
            BeckmannDistribution::excess(x.f::<R>(), x.f())
        };
        "beckmann_even_area" (Cosine, Size) "lobe_beckmann_even_area($0, $1)" => |x| {
            BeckmannDistribution::even_area(x.f::<R>(), x.f())
        };
        "beckmann_lambda_walter" (Lobe, Direction)
            "lobe_beckmann_lambda_walter(lobe_non_centered_view(lobe_lobe_shape($0), $1))"
            => |x| {
            let beckmann = Beckmann::new(x.lobe::<R>().shape());
            beckmann.lambda_walter(x.vec())
        };
    }
}

pub(super) fn all_twins() -> Vec<Twin> {
    fn every<D: Distribution, S: Shaped>(prefix: &str) -> Vec<Twin> {
        let mut twins = over::<D, S>(prefix);
        twins.push(evaluate::<D, S>(prefix));
        twins
    }
    fn all<D: Distribution>(prefix: &str) -> Vec<Twin> {
        [
            every::<D, OfIsotropic>(prefix),
            every::<D, OfAxisAligned>(prefix),
            every::<D, OfAnisotropic>(prefix),
            every::<D, OfWidened>(prefix),
            every::<D, OfNonCentered>(prefix),
        ]
        .concat()
    }
    [all::<GgxDistribution>("ggx"), all::<BeckmannDistribution>("beckmann"), owed::twins()].concat()
}
