// The frame about the mean of slopes: where a relief leans, its own normal is +z. Rust:
// src/slope/mean_frame.rs.

// Rust: `MeanFrame`.
struct LobeMeanFrame {
    right: vec3f,
    up: vec3f,
    normal: vec3f,
}

// Rust: `MeanFrame::of`. Slopes beyond 1e9 count as that, NaN as 0.
fn lobe_mean_frame_of(mean: vec2f) -> LobeMeanFrame {
    let n = lobe_normal_of(lobe_both_within(mean, LOBE_LARGEST));
    let inverse = 1.0 / (1.0 + n.z);
    let skew = -n.x * n.y * inverse;
    return LobeMeanFrame(
        vec3f(1.0 - n.x * n.x * inverse, skew, -n.x), vec3f(skew, 1.0 - n.y * n.y * inverse, -n.y),
        n
    );
}

// Rust: `MeanFrame::to_local`. 0 for NaN.
fn lobe_mean_frame_to_local(frame: LobeMeanFrame, w: vec3f) -> vec3f {
    return vec3f(
        lobe_defined(lobe_dot(frame.right, w)), lobe_defined(lobe_dot(frame.up, w)),
        lobe_defined(lobe_dot(frame.normal, w))
    );
}

// Rust: `MeanFrame::to_tangent`. 0 for NaN.
fn lobe_mean_frame_to_tangent(frame: LobeMeanFrame, w: vec3f) -> vec3f {
    return vec3f(
        lobe_defined(lobe_dot(vec3f(frame.right.x, frame.up.x, frame.normal.x), w)),
        lobe_defined(lobe_dot(vec3f(frame.right.y, frame.up.y, frame.normal.y), w)),
        lobe_defined(lobe_dot(vec3f(frame.right.z, frame.up.z, frame.normal.z), w))
    );
}

// Rust: `MeanFrame::jacobian`. Columns first.
fn lobe_mean_frame_jacobian(frame: LobeMeanFrame) -> mat2x2f {
    let c = frame.normal.z;
    return mat2x2f(c * frame.right.x, c * frame.up.x, c * frame.right.y, c * frame.up.y);
}

// Rust: `MeanFrame::moments`.
fn lobe_mean_frame_moments(frame: LobeMeanFrame, moments: LobeSlopeMoments) -> LobeSlopeMoments {
    let centered = LobeSlopeMoments(vec2f(0.0, 0.0), moments.covariance);
    return lobe_slope_moments_transformed(centered, lobe_mean_frame_jacobian(frame));
}
