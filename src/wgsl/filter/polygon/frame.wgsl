// A parallelogram along its longer side. Rust: src/filter/polygon/frame.rs.

// Rust: `Frame`.
struct LobeFrame {
    extent: f32,
    shear: f32,
    height: f32,
    square: f32,
    side: f32,
    n: f32,
    low: vec2f,
    high: vec2f,
    low_n: f32,
    high_n: f32,
    within_left: f32,
    within_right: f32,
    nearness: f32,
}

// Rust: `Frame::plain`: in whitened space as it is.
fn lobe_frame_plain(w: LobeWhitened, shape: LobeAnisotropic) -> LobeFrame {
    return lobe_frame_new(false, w, shape, w.midpoint, vec2f(0.0, 0.0), LobeFootprint(w.u, w.v));
}

// WGSL only: `LobeShape::whiten` of the lobe, or of the unit lobe.
fn lobe_frame_whiten(exact: bool, shape: LobeAnisotropic, v: vec2f, v_low: vec2f) -> vec2f {
    if exact {
        return lobe_anisotropic_whiten(shape, v, v_low);
    }
    return v;
}

// WGSL only: one coordinate of one corner, and its error.
fn lobe_frame_corner(exact: bool, offset: f32, offset_low: f32, along: f32, across: f32) -> vec2f {
    if exact {
        let first = lobe_two_sum(offset, along);
        let second = lobe_two_sum(first.x, across);
        return lobe_two_sum(second.x, first.y + second.y + offset_low);
    }
    return vec2f(offset + along + across, 0.0);
}

// Rust: `Frame::new`; exact from slope space, where that is asked for.
fn lobe_frame_new(
    exact: bool, w: LobeWhitened, shape: LobeAnisotropic, offset: vec2f, offset_low: vec2f,
    footprint: LobeFootprint
) -> LobeFrame {
    let zero = vec2f(0.0, 0.0);
    let u = footprint.u;
    let v = footprint.v;
    var swap = lobe_whitened_is_swapped(w);
    if exact {
        let sum = lobe_anisotropic_whiten(shape, vec2f(u.x + v.x, u.y + v.y), zero);
        swap = lobe_strip_dot(
            sum, lobe_anisotropic_whiten(shape, vec2f(v.x - u.x, v.y - u.y), zero)
        ) > 0.0;
    }
    let a = select(u, v, swap);
    let b = select(v, u, swap);
    let a_white = select(w.u, w.v, swap);
    let b_white = select(w.v, w.u, swap);
    let length = sqrt(lobe_strip_dot(a_white, a_white));
    let inverse_length = 1.0 / length;
    let axis = vec2f(a_white.x * inverse_length, a_white.y * inverse_length);
    let turn = lobe_cross(a, b);
    let lean = lobe_strip_dot(axis, b_white);
    let left = select(1.0, -1.0, turn < 0.0);
    let mirror = select(1.0, -1.0, left * lean < 0.0);
    let forward = vec2f(mirror * a.x, mirror * a.y);
    let back = vec2f(left * b.x, left * b.y);

    // Corners low left, low right, high right, high left.
    var t = vec4f(0.0, 0.0, 0.0, 0.0);
    var apart = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var k = 0u; k < 4u; k++) {
        let along = select(-0.5, 0.5, k == 1u || k == 2u);
        let across = select(-0.5, 0.5, k >= 2u);
        let x = lobe_frame_corner(
            exact, offset.x, offset_low.x, along * forward.x, across * back.x
        );
        let y = lobe_frame_corner(
            exact, offset.y, offset_low.y, along * forward.y, across * back.y
        );
        let white = lobe_frame_whiten(exact, shape, vec2f(x.x, y.x), vec2f(x.y, y.y));
        t[k] = mirror * (axis.x * white.x + axis.y * white.y);
        // Sides below, right, above and left.
        let side = select(back, a, (k & 1u) == 0u);
        if exact {
            let low = side.x * y.y - side.y * x.y;
            apart[k] = lobe_difference_of_products(side.x, y.x, side.y, x.x) + low;
        } else {
            apart[k] = side.x * y.x - side.y * x.x;
        }
    }
    let root_det = select(1.0, shape.root_det, exact);
    let inverse = 1.0 / root_det;
    let shear = abs(lean);
    let height = abs(turn) * inverse * inverse_length;
    let side = sqrt(shear * shear + height * height);
    let across = inverse * mirror / lobe_max(side, LOBE_MIN_POSITIVE);
    let along = inverse * inverse_length;
    let rest = lobe_frame_whiten(exact, shape, vec2f(forward.x - back.x, forward.y - back.y), zero);
    let square = mirror * lobe_strip_dot(axis, rest);
    let low_n = apart.x * along;
    let high_n = apart.z * along;
    return LobeFrame(
        length, shear, height, lobe_max(square, 0.0), side, 0.5 * (low_n + high_n), t.xy, t.wz,
        low_n, high_n,
        apart.w * across, -apart.y * across, lobe_strip_nearness(t.xz, vec2f(low_n, high_n))
    );
}
