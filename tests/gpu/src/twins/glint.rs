//! Twins of `src/material/glint` and `src/shade/glints.rs`.

use std::hash::{Hash, Hasher};

use lobe::material::Fresnel;
use lobe::material::cells::{Cell, Patch};
use lobe::material::glint::{Binomial, GlintNdf, Grid, hue_wheel, light_blur};
use lobe::shade::{GlintMaterial, GlintShading};
use lobe::{Kernel, Real, SlopeMoments};

use super::slope::moments;
use super::value::{Flat, Reader};

/// How often a count is another, at most.
///
/// A uniform number is compared with a distribution function, and the numbers that lie between two
/// such functions are as many as their means differ. Inversion serves means up to 9, of a
/// probability e^-y with y up to 25, whose own rounding, those of y and of 24 steps are less than
/// 100 in all: 9 * 100 * 2^-24 for one machine, as much for the other, for each of two points of
/// the lattice, 2.2e-4. Where failures are counted their probability is 1 less a number of 2
/// roundings, so that of n trials their mean is off by 2 n 2^-24: for the two in a hundred inputs
/// with a probability of 1, on both machines and on average over n up to 4e6, from where on one
/// more or less is a rounding, 2e-4.
const COUNTS: f64 = 2.2e-4 + 2e-4;

/// The same of [`Input::Tail`](super::Input::Tail), of which one in 64 is rare, 1e-10 to 1e-3: most
/// of them lie below the error of a distribution function near 1, 1e-5, and leave the count to
/// chance.
const RARE: f64 = COUNTS + 0.75 / 64.0;

/// How often a grid is that of the next size, at most: sizes are spread over octaves, and fewer
/// than 40 roundings on either machine are 80 * 2^-24 / ln(2) of one.
pub(super) const SIZES: f64 = 1e-5;

/// How often a pixel has a cell that decides otherwise.
///
/// Averages are over these inputs, counted: a pixel has 14 cells. Each floors two bins of 1.3 after
/// fewer than 30 roundings on either machine, 2 * 1.3 * 60 * 2^-24 = 1e-5, and draws a count, as
/// [`COUNTS`] has it of a mean of 2 at most, 5e-5. Where nearly all details reflect, n cells 2^-24
/// is 2.1e-4, of 2 roundings on either machine.
const PIXELS: f64 = 14.0 * 6e-5 + 4.0 * 2.1e-4;

/// A number that no driver rounds: to the bit, whatever [`Rounded`](lobe::probe::Rounded) would
/// allow.
fn exact<R: Real>(x: R) -> R {
    R::lit(x.to_f64())
}

/// A cell's words in halves, which floats hold.
struct Words<R>([R; 8]);

impl<R: Real> Words<R> {
    fn of(cell: &Cell) -> Self {
        let mut seen = Seen(Vec::new());
        cell.hash(&mut seen);
        let halves: Vec<R> = seen.0.chunks(2).map(half).collect();
        let (_, words) = halves.split_at(halves.len() - 8);
        Self(std::array::from_fn(|k| words[k]))
    }
}

/// A half of a word, from bytes in the machine's order.
fn half<R: Real>(bytes: &[u8]) -> R {
    R::lit(f64::from(u16::from_ne_bytes([bytes[0], bytes[1]])))
}

/// What a hasher is told: the words are a cell's own business, but no secret to hashers.
struct Seen(Vec<u8>);

impl Hasher for Seen {
    fn finish(&self) -> u64 {
        0
    }
    fn write(&mut self, bytes: &[u8]) {
        self.0.extend(bytes);
    }
}

impl<R: Real> Flat<R> for Words<R> {
    const WGSL: &'static str = "let w = r.words;
        put(0u, f32(w.x & 0xffffu)); put(1u, f32(w.x >> 16u)); put(2u, f32(w.y & 0xffffu)); \
        put(3u, f32(w.y >> 16u));
        put(4u, f32(w.z & 0xffffu)); put(5u, f32(w.z >> 16u)); put(6u, f32(w.w & 0xffffu)); \
        put(7u, f32(w.w >> 16u));";
    fn flat(self, out: &mut Vec<R>) {
        out.extend(self.0);
    }
}

impl<R: Real> Flat<R> for Grid<R> {
    const WGSL: &'static str = "put(0u, f32(r.exponent)); put(1u, r.coarser);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend([R::lit(f64::from(self.exponent())), self.coarser()]);
    }
}

fn cell(x: &mut Reader<'_>) -> Cell {
    let index = x.index();
    Cell::at(index, x.word().cast_signed(), x.word())
}

/// A material under a pixel.
fn pixel<R: Real>(x: &mut Reader<'_>) -> GlintNdf<R> {
    let glints = x.glints::<R>();
    glints.ndf(&x.patch())
}

/// The same with a Fresnel term, and what it is evaluated with: directions and a radius.
fn evaluated<R: Real>(
    x: &mut Reader<'_>,
    by: impl Fn(&GlintShading<R>, [R; 3], [R; 3], R) -> [R; 3],
) -> [R; 3] {
    let (glints, patch) = (x.glints::<R>(), x.patch());
    let (wo, wi, radius) = (x.vec(), x.vec(), x.f());
    let fresnel = Fresnel::schlick(x.vec()).expect("in range");
    let (flat, still) = (SlopeMoments::default(), Kernel::default());
    by(&GlintMaterial { glints, fresnel }.bake(&patch, &flat, &still), wo, wi, radius)
}

super::twins! {
    "binomial_new" flips RARE (Trials, Tail) "lobe_binomial_draw(lobe_binomial_new($0), \
        $1)" => |x| {
        let binomial = Binomial::new(x.f::<R>(), x.f());
        binomial.draw(x.f())
    };
    "binomial_draw" flips COUNTS (Trials, Word)
        "lobe_binomial_draw(lobe_binomial_new($0), lobe_cell_size(lobe_cell_at(vec2i(0, 0), 0, \
            $1)))" => |x| {
        let binomial = Binomial::new(x.f::<R>(), x.f());
        binomial.draw(Cell::at([0, 0], 0, x.word()).size())
    };
    "biscale_from_fractions" (Biscale) "$0" => |x| x.biscale::<R>();
    "biscale_global" (Biscale) "lobe_biscale_global($0)" => |x| x.biscale::<R>().global();
    "biscale_widened" (Biscale, Kernel) "lobe_biscale_widened($0, $1)" => |x| {
        let biscale = x.biscale::<R>();
        biscale.widened(&x.kernel())
    };
    "biscale_over" (Biscale, Mean, Psd) "lobe_biscale_over($0, lobe_slope_moments_new($1, \
        $2))" => |x| {
        let biscale = x.biscale::<R>();
        biscale.over(&moments(x))
    };
    "cell_at" (Whole, Level, Word) "lobe_cell_at($0, $1, $2)" => |x| Words::<R>::of(&cell(x));
    "cell_at_wide" (Whole, Whole, Level, Word)
        "lobe_cell_at_wide(vec4u(vec2u($0), vec2u($1)), $2, $3)" => |x| {
        let wide = |[low, high]: [i32; 2]| (i64::from(high) << 32) | i64::from(low.cast_unsigned());
        let [u, v] = [x.index(), x.index()].map(wide);
        Words::<R>::of(&Cell::at([u, v], x.word().cast_signed(), x.word()))
    };
    "cell_jitter" (Whole, Level, Word) "lobe_cell_jitter(lobe_cell_at($0, $1, $2))" => |x| {
        cell(x).jitter::<R>().map(exact)
    };
    "cell_size" (Whole, Level, Word) "lobe_cell_size(lobe_cell_at($0, $1, \
        $2))" => |x| exact(cell(x).size::<R>());
    "cell_turn" (Whole, Level, Word) "lobe_cell_turn(lobe_cell_at($0, $1, \
        $2))" => |x| exact(cell(x).turn::<R>());
    "cell_hue" (Whole, Level, Word) "lobe_cell_hue(lobe_cell_at($0, $1, \
        $2))" => |x| exact(cell(x).hue::<R>());
    "cell_count" (Whole, Level, Word, Whole) "lobe_cell_count(lobe_cell_at($0, $1, $2), \
        $3)" => |x| {
        let cell = cell(x);
        exact(cell.count::<R>(x.index()))
    };
    "hue_wheel" (Unit) "lobe_hue_wheel($0)" => |x| hue_wheel(x.f::<R>());
    "glints_new" (Glints, Patch, Half, Blur)
        "lobe_glint_ndf_probability(lobe_glints_ndf(lobe_glints_new($0.biscale, $0.density), $1), \
            $2, $3)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.probability(x.vec::<R, 3>(), x.f())
    };
    "glints_detail_size" flips SIZES (Glints) "lobe_glints_detail_size($0)" => |x| {
        x.glints::<R>().detail_size()
    };
    "glints_ndf" flips SIZES (Glints, Patch) "lobe_glints_ndf($0, \
        $1).grid" => |x| *pixel::<R>(x).grid();
    "patch_new" flips SIZES (Plain, Size) "lobe_grid_new(lobe_patch_new($0), $1)" => |x| {
        let patch = Patch::new(x.vec::<R, 2>(), x.vec::<R, 2>(), x.vec::<R, 2>());
        Grid::new(&patch, x.f())
    };
    "patch_in_tile" flips SIZES (Patch, Size) "lobe_grid_new($0, $1)" => |x| {
        let patch = x.patch::<R>();
        Grid::new(&patch, x.f())
    };
    "patch_extents" (Patch) "lobe_patch_extents($0)" => |x| x.patch::<R>().extents();
    "patch_area" (Patch) "lobe_patch_area($0)" => |x| x.patch::<R>().area();
    "patch_width" (Patch) "lobe_patch_width($0)" => |x| x.patch::<R>().width();
    "grid_new" flips SIZES (Patch, Size) "lobe_grid_new($0, $1)" => |x| {
        let patch = x.patch::<R>();
        Grid::new(&patch, x.f())
    };
    "grid_stretched" flips SIZES (Patch, Factors, Size) "lobe_grid_stretched($0, $1, $2)" => |x| {
        let patch = x.patch::<R>();
        Grid::stretched(&patch, x.vec(), x.f())
    };
    "glint_ndf_over" (Glints, Patch, Mean, Psd)
        "lobe_glint_ndf_smooth_lobe(lobe_glint_ndf_over(lobe_glints_ndf($0, $1), \
            lobe_slope_moments_new($2, $3)))" => |x| {
        let pixel = pixel::<R>(x);
        pixel.over(&moments(x)).smooth_lobe()
    };
    "glint_ndf_widened" (Glints, Patch, Kernel)
        "lobe_glint_ndf_smooth_lobe(lobe_glint_ndf_widened(lobe_glints_ndf($0, $1), $2))" => |x| {
        let pixel = pixel::<R>(x);
        pixel.widened(&x.kernel()).smooth_lobe()
    };
    "glint_ndf_smooth_lobe" (Glints, Patch) "lobe_glint_ndf_smooth_lobe(lobe_glints_ndf($0, \
        $1))" => |x| pixel::<R>(x).smooth_lobe();
    "glint_ndf_probability" (Glints, Patch, Kernel, Half, Blur)
        "lobe_glint_ndf_probability(lobe_glint_ndf_widened(lobe_glints_ndf($0, $1), $2), $3, \
            $4)" => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.widened(&x.kernel());
        pixel.probability(x.vec::<R, 3>(), x.f())
    };
    "glint_ndf_sparkle" flips PIXELS (Glints, Patch, Half, Blur)
        "lobe_glint_ndf_sparkle(lobe_glints_ndf($0, $1), $2, $3)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.sparkle(x.vec::<R, 3>(), x.f())
    };
    "glint_ndf_sparkle" by "over" flips PIXELS (Glints, Patch, Mean, Psd, Half, Blur)
        "lobe_glint_ndf_sparkle(lobe_glint_ndf_over(lobe_glints_ndf($0, $1), \
            lobe_slope_moments_new($2, $3)), $4, $5)"
        => |x| {
        let pixel = pixel::<R>(x);
        let pixel = pixel.over(&moments(x));
        pixel.sparkle(x.vec::<R, 3>(), x.f())
    };
    "glint_ndf_colored_sparkle" flips PIXELS (Glints, Patch, Half, Blur)
        "lobe_glint_ndf_colored_sparkle(lobe_glints_ndf($0, $1), $2, $3)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.colored_sparkle(x.vec::<R, 3>(), x.f(), hue_wheel)
    };
    "glint_ndf_slope_pdf" flips PIXELS (Glints, Patch, Half, Blur)
        "lobe_glint_ndf_slope_pdf(lobe_glints_ndf($0, $1), $2, $3)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.slope_pdf(x.vec::<R, 3>(), x.f())
    };
    "glint_ndf_brdf" flips PIXELS (Glints, Patch, Mirrored, Radius)
        "lobe_glint_ndf_brdf(lobe_glints_ndf($0, $1), $2, $3)" => |x| {
        let pixel = pixel::<R>(x);
        pixel.brdf(x.vec::<R, 3>(), x.vec::<R, 3>(), x.f())
    };
    "light_blur" (Pair, Radius) "lobe_light_blur($0, $1)" => |x| {
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        light_blur(wo, wi, x.f::<R>())
    };
    "glint_shading_evaluate" flips PIXELS (Glints, Patch, Mirrored, Radius, Reflectance)
        "lobe_glint_shading_evaluate(lobe_glints_ndf($0, $1), $2, $3, lobe_fresnel_schlick($4, \
            lobe_half_cosine($2)))" => |x| {
        evaluated::<R>(x, GlintShading::evaluate)
    };
    "glint_shading_evaluate_colored" flips PIXELS (Glints, Patch, Mirrored, Radius, Reflectance)
        "lobe_glint_shading_evaluate_colored(lobe_glints_ndf($0, $1), $2, $3, \
            lobe_fresnel_schlick($4, lobe_half_cosine($2)))"
        => |x| {
        evaluated::<R>(x, |shading, wo, wi, radius| {
            shading.evaluate_colored(wo, wi, radius, hue_wheel)
        })
    };
}
