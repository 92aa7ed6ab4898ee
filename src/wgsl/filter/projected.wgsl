// GGX widened on the projected disk. Rust: src/filter/projected.rs.

// Rust: `Roughness::widened_on_disk`.
fn lobe_roughness_widened_on_disk(
    roughness: LobeRoughness, kernel: LobeDiskKernel
) -> LobeRoughness {
    let added = lobe_kernel_added(kernel.as_slopes);
    let psd = roughness.psd;
    let complement = 1.0 - lobe_psd_trace(psd) + lobe_psd_det(psd);
    if lobe_psd_trace(psd) < 2.0 && complement >= 0.125 {
        return LobeRoughness(lobe_projected_filtered(psd, added, complement));
    }
    let eigen = lobe_psd_eigen(psd);
    if eigen.major < 1.0 {
        let bounded = lobe_projected_bounded(added);
        return LobeRoughness(
            lobe_projected_from_disk(
                lobe_psd_with_columns(lobe_projected_to_disk(eigen), bounded.u, bounded.v)
            )
        );
    }
    if !(eigen.minor < 1.0) {
        return roughness;
    }
    let turn = eigen.axis;
    let along_u = turn.x * added.u.y - turn.y * added.u.x;
    let along_v = turn.x * added.v.y - turn.y * added.v.x;
    let across = lobe_projected_filtered_square(
        eigen.minor, along_u * along_u + along_v * along_v
    );
    return LobeRoughness(lobe_psd_from_axes(sqrt(eigen.major), sqrt(across), turn.x, turn.y));
}

// Rust: `DiskKernel::widen`.
fn lobe_disk_kernel_widen(kernel: LobeDiskKernel, shape: LobeIsotropic) -> LobeWidened {
    let added = kernel.as_slopes;
    let u = added.u;
    let v = added.v;
    let square = shape.alpha * shape.alpha;
    let rest = lobe_max(1.0 - square, 0.0);
    let trace = u.x * u.x + u.y * u.y + (v.x * v.x + v.y * v.y);
    let cross = rest * (u.x * v.y - u.y * v.x);
    let det = cross * cross;
    let root = sqrt(1.0 / (1.0 + rest * trace + det));
    let alpha = sqrt(square + square * rest * trace + det) * root;
    let scale = rest * root;
    return LobeWidened(
        lobe_isotropic_new(alpha), vec2f(u.x * scale, u.y * scale), vec2f(v.x * scale, v.y * scale)
    );
}

// Rust: `projected_alpha`. Numbers beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_projected_alpha(alpha: f32, added: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    if a < 1.0 {
        return sqrt(lobe_projected_filtered_square(a * a, lobe_magnitude(added)));
    }
    return a;
}

// Rust: `filtered_square`.
fn lobe_projected_filtered_square(square: f32, added: f32) -> f32 {
    let seen = (1.0 - square) * added;
    return (square + seen) / (1.0 + seen);
}

// Rust: `filtered`.
fn lobe_projected_filtered(psd: LobePsd, added: LobeKernel, complement: f32) -> LobePsd {
    let root = sqrt(complement);
    let u = vec2f(added.u.x * root, added.u.y * root);
    let v = vec2f(added.v.x * root, added.v.y * root);
    let mixed = lobe_psd_adjugate_form(psd, added.u) + lobe_psd_adjugate_form(psd, added.v);
    let squares = lobe_projected_squares(added.u) + lobe_projected_squares(added.v);
    let spread = lobe_max(mixed - lobe_psd_det(psd) * squares, 0.0);
    let cross = root * (added.u.x * added.v.y - added.u.y * added.v.x);
    let both = spread + cross * cross;
    let inverse = 1.0 / (1.0 + lobe_projected_squares(u) + lobe_projected_squares(v) + both);
    let side = sqrt(both);
    return lobe_psd_mul(
        lobe_psd_with_columns(lobe_psd_with_columns(psd, u, v), vec2f(side, 0.0), vec2f(0.0, side)),
        inverse
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_projected_squares(v: vec2f) -> f32 {
    return v.x * v.x + v.y * v.y;
}

// Rust: `to_disk`.
fn lobe_projected_to_disk(eigen: LobeEigen) -> LobePsd {
    let p = eigen.major / (1.0 - eigen.major);
    let q = eigen.minor / (1.0 - eigen.minor);
    let cosine = eigen.axis.x;
    let sine = eigen.axis.y;
    let entries = vec3f(
        p * cosine * cosine + q * sine * sine,
        (p - q) * cosine * sine,
        p * sine * sine + q * cosine * cosine
    );
    return lobe_psd_with_root_det(entries, sqrt(p) * sqrt(q));
}

// Rust: `from_disk`.
fn lobe_projected_from_disk(projected: LobePsd) -> LobePsd {
    let entries = lobe_psd_entries(projected);
    let det = lobe_psd_det(projected);
    let inverse = 1.0 / (1.0 + entries.x + entries.z + det);
    return lobe_psd_with_root_det(
        vec3f((entries.x + det) * inverse, entries.y * inverse, (entries.z + det) * inverse),
        lobe_psd_root_det(projected) * sqrt(inverse)
    );
}

// Rust: `bounded`.
fn lobe_projected_bounded(added: LobeKernel) -> LobeKernel {
    let u = added.u;
    let v = added.v;
    let trace = u.x * u.x + u.y * u.y + v.x * v.x + v.y * v.y;
    let factor = sqrt(LOBE_LARGEST / lobe_max(trace, LOBE_LARGEST));
    return LobeKernel(vec2f(u.x * factor, u.y * factor), vec2f(v.x * factor, v.y * factor));
}
