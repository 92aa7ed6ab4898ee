// Sums and products with their rounding errors. Rust: src/scalar/exact.rs.

// Rust: `two_sum`: the sum and its error.
fn lobe_two_sum(a: f32, b: f32) -> vec2f {
    let sum = lobe_kept(a + b);
    let b_part = lobe_kept(sum - a);
    let a_part = lobe_kept(sum - b_part);
    return vec2f(sum, lobe_kept(a - a_part) + lobe_kept(b - b_part));
}

// Rust: `two_product`: the product and its error.
fn lobe_two_product(a: f32, b: f32) -> vec2f {
    let product = lobe_kept(a * b);
    let a_high = lobe_upper_half(a);
    let b_high = lobe_upper_half(b);
    let a_low = a - a_high;
    let b_low = b - b_high;
    let first = lobe_kept(a_high * b_high - product);
    let second = lobe_kept(first + a_high * b_low);
    let third = lobe_kept(second + a_low * b_high);
    return vec2f(product, third + a_low * b_low);
}

// Rust: `sum_of_products`.
fn lobe_sum_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let p = lobe_two_product(a, b);
    let q = lobe_two_product(c, d);
    return lobe_kept(p.x + q.x) + (p.y + q.y);
}

// Rust: `difference_of_products`.
fn lobe_difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    return lobe_sum_of_products(a, b, -c, d);
}

// Rust: `add_products`.
fn lobe_add_products(x: f32, a: f32, b: f32, c: f32, d: f32) -> f32 {
    let p = lobe_two_product(a, b);
    let q = lobe_two_product(c, d);
    let s = lobe_two_sum(x, p.x);
    let t = lobe_two_sum(s.x, q.x);
    return t.x + ((p.y + q.y) + (s.y + t.y));
}

// Rust: `add_product`: high and low part.
fn lobe_add_product(x: f32, a: f32, b: f32) -> vec2f {
    let p = lobe_two_product(a, b);
    let s = lobe_two_sum(x, p.x);
    return vec2f(s.x, s.y + p.y);
}

// Rust: `cross`.
fn lobe_cross(u: vec2f, v: vec2f) -> f32 {
    return lobe_difference_of_products(u.x, v.y, u.y, v.x);
}
