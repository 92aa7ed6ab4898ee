// The numbers of the trait `Real`, and its selects. Rust: src/scalar/real.rs.

// Rust: `Real::PI`.
const LOBE_PI: f32 = 3.1415927;
// Rust: `Real::EPSILON`.
const LOBE_EPSILON: f32 = 1.1920929e-7;
// Rust: `Real::MIN_POSITIVE`.
const LOBE_MIN_POSITIVE: f32 = 1.17549435e-38;
// Rust: `Real::MAX`.
const LOBE_MAX: f32 = 3.40282346e38;
// Rust: `Real::LARGEST`.
const LOBE_LARGEST: f32 = 1e9;

// Rust: `Real::min`. The builtin may return either if one is NaN.
fn lobe_min(a: f32, b: f32) -> f32 {
    return select(b, a, a < b);
}

// Rust: `Real::max`.
fn lobe_max(a: f32, b: f32) -> f32 {
    return select(b, a, a > b);
}

// Rust: `Real::is_finite`. By the bits: compilers that assume finite numbers fold a comparison.
fn lobe_is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7fffffffu) < 0x7f800000u;
}

// WGSL only: true unless NaN. By the bits: compilers that assume numbers fold `x == x`.
fn lobe_is_number(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7fffffffu) <= 0x7f800000u;
}

// WGSL only: where a Rust constructor refuses a number outside [0, 1e9], shaders get the nearest;
// NaN counts as 0.
fn lobe_magnitude(x: f32) -> f32 {
    return lobe_min(lobe_max(x, 0.0), LOBE_LARGEST);
}

// WGSL only: the same for [-limit, limit].
fn lobe_within(x: f32, limit: f32) -> f32 {
    return lobe_min(lobe_max(lobe_defined(x), -limit), limit);
}

// WGSL only: the same for two numbers.
fn lobe_both_within(v: vec2f, limit: f32) -> vec2f {
    return vec2f(lobe_within(v.x, limit), lobe_within(v.y, limit));
}

// WGSL only: the largest number in place of NaN: as far from a lobe as can be.
fn lobe_far(x: f32) -> f32 {
    return select(LOBE_MAX, x, lobe_is_number(x));
}

// WGSL only: 0 in place of NaN.
fn lobe_defined(x: f32) -> f32 {
    return select(0.0, x, lobe_is_number(x));
}

// WGSL only: the largest number in place of infinity; a negative number stays. By the bits:
// compilers that assume finite numbers may fold `lobe_min(x, LOBE_MAX)`.
fn lobe_below_infinity(x: f32) -> f32 {
    return bitcast<f32>(min(bitcast<i32>(x), 0x7f7fffff));
}

// WGSL only: the nearest finite number, the largest in place of NaN. By the bits, like
// `lobe_below_infinity`.
fn lobe_finite(x: f32) -> f32 {
    let size = min(bitcast<u32>(x) & 0x7fffffffu, 0x7f7fffffu);
    return bitcast<f32>((bitcast<u32>(x) & 0x80000000u) | size);
}

// Rust: `Internal::upper_half`.
fn lobe_upper_half(x: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(x) & 0xfffff000u);
}

// Rust: `Internal::floor`. Casts of what an integer does not hold are the driver's: the bound comes
// before.
fn lobe_floor(x: f32) -> i32 {
    let bounded = lobe_within(x, 1073741824.0);
    let cut = i32(bounded);
    return cut - select(0, 1, f32(cut) > bounded);
}

// Rust: `Internal::exponent`.
fn lobe_exponent(x: f32) -> i32 {
    return i32(bitcast<u32>(x) >> 23u) - 127;
}

// Rust: `Internal::power_of_two`.
fn lobe_power_of_two(k: i32) -> f32 {
    return bitcast<f32>(u32(k + 127) << 23u);
}

// Rust: `Internal::kept`. No compiler knows that no sum has the one pattern of bits that this
// changes, so none folds (a + b) - a, fuses a * b + c, factors a * b + a * c or takes (a / b) * (c
// / d) as one quotient. The minimum is of integers: a select between floats would let literals
// through.
fn lobe_kept(x: f32) -> f32 {
    return bitcast<f32>(min(bitcast<u32>(x), 0xfffffffeu));
}
