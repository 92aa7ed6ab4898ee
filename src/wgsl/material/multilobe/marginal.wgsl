// One even density of slopes along one axis, by its nodes. Rust:
// src/material/multilobe/marginal.rs.

// Rust: `Marginal::node`, with `Marginal::cumulative`: density and, odd about 0, cumulative.
fn lobe_marginal_node(marginal: LobeMarginal, k: i32) -> vec2f {
    let node = lobe_dictionary_node(marginal.begin + u32(abs(k)));
    return vec2f(node.x, select(node.y, -node.y, k < 0));
}

// Rust: `Marginal::within`.
fn lobe_marginal_within(marginal: LobeMarginal, k: i32, place: f32) -> f32 {
    let part = place - f32(k);
    let a = lobe_marginal_node(marginal, k).x;
    let b = lobe_marginal_node(marginal, k + 1).x;
    return lobe_max(a + part * (b - a), 0.0);
}

// Rust: `Marginal::interval`.
fn lobe_marginal_interval(marginal: LobeMarginal, place: f32) -> i32 {
    let k = lobe_floor(place);
    let last = marginal.intervals - 1;
    return select(last, k, k < last);
}

// Rust: `Marginal::density`. 0 for NaN.
fn lobe_marginal_density(marginal: LobeMarginal, x: f32) -> f32 {
    let end = f32(marginal.intervals);
    let place = abs(x) * (end / 4.0);
    if !(place <= end) {
        return 0.0;
    }
    return lobe_marginal_within(marginal, lobe_marginal_interval(marginal, place), place);
}

// Rust: `Marginal::mean`. 0 for NaN; a width of NaN counts as 0.
fn lobe_marginal_mean(marginal: LobeMarginal, x: f32, width: f32) -> f32 {
    let end = f32(marginal.intervals);
    let scale = end / 4.0;
    let place = abs(x) * scale;
    let half = 0.5 * (lobe_max(width, 0.0) * scale);
    let a = place - half;
    let b = place + half;
    if !(a < end) {
        return 0.0;
    }
    let whole = 2.0 * half;
    let inside = a >= -end && b <= end;
    let low = lobe_max(a, -end);
    let high = lobe_min(b, end);
    let share = select((high - low) / whole, 1.0, inside);
    let first = lobe_marginal_interval(marginal, low);
    let last = lobe_marginal_interval(marginal, high);
    if first == last {
        return lobe_defined(
            lobe_marginal_within(marginal, first, select(0.5 * (low + high), place, inside)) * share
        );
    }
    let after = f32(first + 1);
    let before = f32(last);
    if last == first + 1 {
        let f = lobe_marginal_node(marginal, first).x;
        let g = lobe_marginal_node(marginal, last).x;
        let h = lobe_marginal_node(marginal, last + 1).x;
        let bend = (high - before) * (high - before) * (h - g)
            - (after - low) * (after - low) * (g - f);
        return lobe_max(g * share + 0.5 * bend / whole, 0.0);
    }
    let left = (after - low) * lobe_marginal_within(marginal, first, 0.5 * (low + after));
    let right = (high - before) * lobe_marginal_within(marginal, last, 0.5 * (high + before));
    let cumulative =
        lobe_marginal_node(marginal, last).y - lobe_marginal_node(marginal, first + 1).y;
    return lobe_defined((left + right + cumulative * scale) / whole);
}

// Rust: `Marginal::quantile`. A number beyond [0, 1] counts as the nearest, NaN as 0.
fn lobe_marginal_quantile(marginal: LobeMarginal, u: f32) -> f32 {
    let offset = lobe_min(lobe_max(u, 0.0), 1.0) - 0.5;
    let goal = abs(offset);
    // The first node whose cumulative is above the goal, by halves: tables have 4097 nodes at most.
    var low = 0;
    var high = marginal.intervals + 1;
    for (var step = 0; step < 13; step++) {
        if low < high {
            let middle = (low + high) / 2;
            let below = lobe_marginal_node(marginal, middle).y <= goal;
            low = select(low, middle + 1, below);
            high = select(middle, high, below);
        }
    }
    let last = marginal.intervals - 1;
    let k = select(select(last, low - 1, low - 1 < last), 0, low == 0);
    let node = lobe_marginal_node(marginal, k);
    let next = lobe_marginal_node(marginal, k + 1);
    let scale = f32(marginal.intervals) / 4.0;
    let rest = lobe_max(goal - node.y, 0.0) * scale;
    let root = sqrt(lobe_max(node.x * node.x + 2.0 * (next.x - node.x) * rest, 0.0));
    let part = lobe_min(2.0 * rest / lobe_max(node.x + root, LOBE_MIN_POSITIVE), 1.0);
    let x = (f32(k) + part) / scale;
    return select(x, -x, offset < 0.0);
}
