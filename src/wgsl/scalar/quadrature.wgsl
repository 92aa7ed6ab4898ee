// Gauss-Legendre rules on the interval [-1/2, 1/2]: nodes and weights. Rust:
// src/scalar/quadrature.rs.

// Rust: `GAUSS_TWO`, whose weights are 1/2.
const LOBE_GAUSS_TWO = vec2f(-0.2886751345948129, 0.2886751345948129);
// Rust: `GAUSS_FOUR`.
const LOBE_GAUSS_FOUR = vec4f(
    -0.4305681557970263, -0.16999052179242813, 0.16999052179242813, 0.4305681557970263
);
// Rust: `GAUSS_FOUR`, its weights.
const LOBE_GAUSS_FOUR_WEIGHTS = vec4f(
    0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693
);
// Rust: `GAUSS_EIGHT`, the first four.
const LOBE_GAUSS_EIGHT = vec4f(
    -0.4801449282487681, -0.39833323870681337, -0.2627662049581645, -0.0917173212478249
);
// Rust: `GAUSS_EIGHT`, its weights.
const LOBE_GAUSS_EIGHT_WEIGHTS = vec4f(
    0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.181341891689181
);

// Rust: `Rule::points`: node and weight k of the rule of four or eight.
fn lobe_gauss_point(count: u32, k: u32) -> vec2f {
    if count == 4u {
        return vec2f(LOBE_GAUSS_FOUR[k & 3u], LOBE_GAUSS_FOUR_WEIGHTS[k & 3u]);
    }
    // The rule is symmetric.
    let low = select(7u - k, k, k < 4u) & 3u;
    let node = LOBE_GAUSS_EIGHT[low];
    return vec2f(select(-node, node, k < 4u), LOBE_GAUSS_EIGHT_WEIGHTS[low]);
}

// Rust: `Rule::mean`, of four values.
fn lobe_gauss_mean(values: vec4f) -> f32 {
    let weighted = LOBE_GAUSS_FOUR_WEIGHTS * values;
    return ((weighted.x + weighted.y) + weighted.z) + weighted.w;
}
