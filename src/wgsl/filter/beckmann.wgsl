// Beckmann over a rectangle along its axes. Rust: src/filter/beckmann.rs.

// Rust: `divide`: the quotient and its error.
fn lobe_beckmann_divide(x: f32, y: f32) -> vec2f {
    let quotient = lobe_kept(x / y);
    let product = lobe_two_product(quotient, y);
    return vec2f(quotient, (lobe_kept(x - product.x) - product.y) / y);
}

// Rust: `exp_minus_square`.
fn lobe_beckmann_exp_minus_square(x: f32, x_low: f32) -> f32 {
    let square = lobe_two_product(x, x);
    return lobe_exp(-square.x) * (1.0 - (square.y + 2.0 * x * x_low));
}

// Rust: `mean_along`.
fn lobe_beckmann_mean_along(slope: f32, width: f32, alpha: f32) -> f32 {
    let half = 0.5 * abs(width);
    if alpha >= LOBE_MIN_POSITIVE && half <= LOBE_GROOVE_LIMIT * alpha {
        return lobe_beckmann_unit_mean(slope, width, alpha) / alpha;
    }
    if half > 0.0 && alpha >= 0.0 {
        return lobe_groove_share(half - abs(slope)) / half * 0.5;
    }
    return 0.0;
}

// WGSL only: Rust has it as a closure.
fn lobe_beckmann_relative(half: f32, midpoint: f32, y: f32) -> f32 {
    let step = 2.0 * half * y;
    return lobe_exp(-(step * (2.0 * midpoint + step)));
}

// Rust: `unit_mean`.
fn lobe_beckmann_unit_mean(slope: f32, width: f32, alpha: f32) -> f32 {
    let midpoint = lobe_beckmann_divide(abs(slope), alpha);
    let half = lobe_beckmann_divide(0.5 * abs(width), alpha);
    if half.x * (1.0 + 2.0 * midpoint.x) <= 0.5 {
        let nodes = LOBE_GAUSS_FOUR;
        let relative = lobe_gauss_mean(vec4f(
            lobe_beckmann_relative(half.x, midpoint.x, nodes.x),
            lobe_beckmann_relative(half.x, midpoint.x, nodes.y),
            lobe_beckmann_relative(half.x, midpoint.x, nodes.z),
            lobe_beckmann_relative(half.x, midpoint.x, nodes.w)
        ));
        // 1/sqrt(pi).
        return 0.5641895835477563 * lobe_beckmann_exp_minus_square(midpoint.x, midpoint.y)
            * relative;
    }
    let far = midpoint.x + half.x;
    let end = lobe_two_sum(midpoint.x, -half.x);
    let near = lobe_two_sum(end.x, end.y + (midpoint.y - half.y));
    var mass = 0.0;
    if near.x >= 0.0 {
        let between = lobe_exp(-(4.0 * half.x * midpoint.x));
        mass = lobe_beckmann_exp_minus_square(near.x, near.y)
            * (lobe_erfcx(near.x) - lobe_erfcx(far) * between);
    } else {
        mass = 2.0 - lobe_erfc(-near.x) - lobe_erfc(far);
    }
    return mass / (4.0 * half.x);
}

// Rust: `beckmann_rectangle_mean`. 0 for NaN and for infinite slopes.
fn lobe_beckmann_rectangle_mean(alphas: vec2f, slope: vec2f, widths: vec2f) -> f32 {
    let known = lobe_is_finite(slope.x) && lobe_is_finite(slope.y) && lobe_is_number(widths.x)
        && lobe_is_number(widths.y);
    if !known {
        return 0.0;
    }
    let along_x = lobe_beckmann_mean_along(slope.x, widths.x, alphas.x);
    let along_y = lobe_beckmann_mean_along(slope.y, widths.y, alphas.y);
    return lobe_below_infinity(lobe_max(lobe_defined(along_x * along_y), 0.0));
}
