//! Every function of the WGSL port with its twin: the inputs, the WGSL expression, and the same in
//! Rust.

mod facets;
mod filters;
mod glint;
mod glitter;
mod input;
mod lanes;
mod material;
mod ndf;
mod number;
mod scalar;
mod slope;
mod value;

use lobe::probe::{Fused, Rounded};

use crate::arbitrary::Source;
use crate::{Job, needed};
use input::Drawn;
pub use input::Input;
pub use value::Reader;

/// Numbers at the ends of f32 and beyond them.
const ODD: [f32; 16] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    0.0,
    -0.0,
    1e-40,
    -1e-45,
    f32::MIN_POSITIVE,
    f32::MAX,
    f32::MIN,
    1e30,
    -1e30,
    1e-30,
    -1.0,
    1.0,
    2.0,
];

/// What expressions need beside the WGSL port.
const PUT_TOGETHER: &str = "
fn put_together(eigen: LobeEigen) -> vec3f {
    let c = eigen.axis.x;
    let s = eigen.axis.y;
    return vec3f(
        eigen.major * c * c + eigen.minor * s * s, (eigen.major - eigen.minor) * c * s,
        eigen.major * s * s + eigen.minor * c * c
    );
}
";
/// Pairs by rows, as Rust has them.
const FOUR: &str = "
fn four(v: vec4f) -> mat2x2f {
    return mat2x2f(v.x, v.z, v.y, v.w);
}
";

/// Glints with all their numbers, which Rust sets one by one.
const GLITTERING: &str = "
fn glittering(biscale: LobeBiscale, density: f32, variation: f32, share: f32, seed: u32) -> \
LobeGlints {
    let plain = lobe_glints_new(biscale, density);
    return LobeGlints(plain.biscale, plain.density, variation, share, plain.stretch, \
    plain.groove, seed);
}
";

/// Facets with all their numbers, which Rust sets one by one, and under a pixel, with the
/// dictionary of the buffer.
const PATCHED: &str = "
fn patched(facets: LobeMultiLobe, pixel: LobePatch) -> LobePatchNdf {
    return lobe_multi_lobe_ndf(facets, LobeDictionary(48u, 8u, 64u), pixel);
}
";
const FACETED: &str = "
fn faceted(roughness: LobeRoughness, density: f32, variation: f32, share: f32, seed: u32) -> \
LobeMultiLobe {
    return LobeMultiLobe(roughness, lobe_multi_lobe_new(roughness, density).density, variation, \
    share, seed);
}
";

/// A pair of twins: one expression in each language, over the same floats.
#[derive(Clone, Debug)]
pub struct Twin {
    /// The item of the WGSL port that it is about.
    pub name: String,
    /// What else it goes through, for names that appear more than once: a shape.
    pub by: &'static str,
    /// Its inputs.
    pub inputs: Vec<Input>,
    /// The largest share of inputs whose result may jump, where one rounding more makes the
    /// function decide otherwise. 0 for functions that decide nothing.
    pub flips: f64,
    expression: String,
    statements: &'static str,
    single: fn(&mut Reader<'_>) -> Vec<f32>,
    fused: fn(&mut Reader<'_>) -> Vec<Fused>,
    rounded: fn(&mut Reader<'_>) -> Vec<Rounded>,
}

impl Twin {
    /// Floats that one evaluation reads.
    pub fn reads(&self) -> usize {
        self.inputs.iter().map(|input| input.floats()).sum()
    }

    /// Floats that one evaluation writes.
    pub fn writes(&self) -> usize {
        self.statements.matches("put(").count()
    }

    /// The inputs of `count` evaluations, always the same.
    pub fn draw(&self, count: usize) -> Vec<f32> {
        let mut floats = Vec::with_capacity(count * self.reads());
        for seed in 0..count as u64 {
            let mut source = Source::from_seed(seed);
            let mut drawn = Drawn::default();
            for input in &self.inputs {
                input.draw(&mut source, &mut drawn, &mut floats);
            }
        }
        floats
    }

    /// The same, with numbers among them that no function promises anything for: in most items one
    /// in three, in one of four items all.
    pub fn draw_hostile(&self, count: usize) -> Vec<f32> {
        let mut floats = self.draw(count);
        for (seed, item) in (0..).zip(floats.chunks_mut(self.reads())) {
            // Not the words that the item itself was drawn from.
            let mut source = Source::from_seed(!seed);
            let all = source.pick(4) == 0;
            for x in item {
                if all || source.pick(3) == 0 {
                    *x = ODD[source.pick(ODD.len() as u64) as usize];
                }
            }
        }
        floats
    }

    /// What WGSL computes it with: the functions that it needs and no others of the WGSL port.
    pub fn library(&self) -> String {
        library(std::slice::from_ref(self))
    }

    /// The WGSL statements of one evaluation.
    pub fn body(&self) -> String {
        let mut text = format!("let r = {};\n{}", self.expression, self.statements);
        let mut base = 0;
        for (k, input) in self.inputs.iter().enumerate() {
            text = text.replace(&format!("${k}"), &input.wgsl(base));
            base += input.floats();
        }
        text
    }

    /// The job, over a library from [`Twin::library`] and a body from [`Twin::body`].
    pub fn job<'a>(&self, library: &'a str, body: &'a str) -> Job<'a> {
        let dictionary = if library.contains("lobe_dictionary:") { dictionary() } else { &[] };
        Job { library, body, inputs: self.reads(), outputs: self.writes(), dictionary }
    }

    /// Rust's results.
    pub fn single(&self, floats: &[f32]) -> Vec<f32> {
        (self.single)(&mut Reader::new(floats))
    }

    /// Rust's results where every a * b + c is fused.
    pub fn fused(&self, floats: &[f32]) -> Vec<f32> {
        (self.fused)(&mut Reader::new(floats)).into_iter().map(Fused::value).collect()
    }

    /// Rust's results with their scales: what rounding every operation once more could change, in
    /// units of 2^-24.
    pub fn rounded(&self, floats: &[f32]) -> Vec<Rounded> {
        (self.rounded)(&mut Reader::new(floats))
    }
}

/// Writes a table of twins: name, by what, share of flips, inputs, WGSL with `$k` for the inputs,
/// and Rust over a reader.
macro_rules! twins {
    ($(
        $name:literal $(by $by:literal)? $(flips $flips:ident)? ($($input:ident),*)
            $wgsl:literal => |$x:ident| $rust:expr;
    )*) => {
        pub(in crate::twins) fn twins() -> Vec<$crate::twins::Twin> {
            vec![$({
                fn eval<R: lobe::Real>(
                    $x: &mut $crate::twins::value::Reader<'_>,
                ) -> impl $crate::twins::value::Flat<R> + use<R> {
                    $rust
                }
                fn flat<R: lobe::Real>(x: &mut $crate::twins::value::Reader<'_>) -> Vec<R> {
                    let mut out = Vec::with_capacity(9);
                    $crate::twins::value::Flat::<R>::flat(eval::<R>(x), &mut out);
                    out
                }
                fn statements<R, F: $crate::twins::value::Flat<R>>(
                    _: fn(&mut $crate::twins::value::Reader<'_>) -> F,
                ) -> &'static str {
                    F::WGSL
                }
                $crate::twins::Twin {
                    name: String::from($name),
                    by: concat!($($by)?),
                    inputs: vec![$($crate::twins::Input::$input),*],
                    flips: [$($flips,)? 0.0][0],
                    expression: String::from($wgsl),
                    statements: statements::<f32, _>(eval::<f32>),
                    single: flat::<f32>,
                    fused: flat::<lobe::probe::Fused>,
                    rounded: flat::<lobe::probe::Rounded>,
                }
            }),*]
        }
    };
}
use twins;

/// What WGSL computes `twins` with: the functions that they need and no others of the WGSL port.
pub fn library(twins: &[Twin]) -> String {
    let bodies: String = twins.iter().map(Twin::body).collect();
    let helpers = [
        ("put_together(", PUT_TOGETHER),
        ("four(", FOUR),
        ("glittering(", GLITTERING),
        ("faceted(", FACETED),
        ("patched(", PATCHED),
    ];
    let helpers = helpers.iter().filter(|(call, _)| bodies.contains(call));
    let helpers: String = helpers.map(|(_, helper)| *helper).collect();
    needed(&(bodies + &helpers)) + &helpers
}

/// The nodes of the dictionary that twins of facets read.
pub fn dictionary() -> &'static [[f32; 2]] {
    facets::dictionary::<f32>().nodes()
}

/// All of them.
pub fn all() -> Vec<Twin> {
    let lobes = [scalar::twins(), slope::twins(), ndf::all_twins(), filters::twins()];
    [lobes.concat(), lanes::twins(), material::twins(), glint::twins(), facets::twins()].concat()
}
