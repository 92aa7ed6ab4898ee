// Kernels on the projected disk, and GGX widened there. Rust: src/filter/projected.rs.

// Rust: `DiskKernel`.
struct LobeDiskKernel {
    as_slopes: LobeKernel,
}

// Rust: `DiskKernel::of`, with a filter's variance.
fn lobe_disk_kernel_of(u: vec2f, v: vec2f, variance: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_of(LobeFootprint(u, v), variance));
}

// Rust: `DiskKernel::of_bounding`, with a filter's variance.
fn lobe_disk_kernel_of_bounding(u: vec2f, v: vec2f, variance: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_of(lobe_footprint_bounding(LobeFootprint(u, v)), variance));
}

// Rust: `DiskKernel::from_covariance`.
fn lobe_disk_kernel_from_covariance(covariance: LobePsd) -> LobeDiskKernel {
    return LobeDiskKernel(LobeKernel(covariance));
}

// Rust: `DiskKernel::capped`.
fn lobe_disk_kernel_capped(kernel: LobeDiskKernel, limit: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_capped(kernel.as_slopes, limit));
}

// Rust: `DiskKernel::add`.
fn lobe_disk_kernel_add(kernel: LobeDiskKernel, other: LobeDiskKernel) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_add(kernel.as_slopes, other.as_slopes));
}

// Rust: `Kernel::tokuyoshi_forward`.
fn lobe_kernel_tokuyoshi_forward(u: vec2f, v: vec2f) -> LobeKernel {
    return lobe_kernel_of(LobeFootprint(u, v), LOBE_PIXEL_FILTER_KAPLANYAN);
}

// Rust: `Roughness::widened_on_disk`.
fn lobe_roughness_widened_on_disk(
    roughness: LobeRoughness, kernel: LobeDiskKernel
) -> LobeRoughness {
    let added = lobe_projected_bounded(lobe_psd_mul(kernel.as_slopes.covariance, 2.0));
    let psd = roughness.psd;
    let complement = 1.0 - lobe_psd_trace(psd) + lobe_psd_det(psd);
    if lobe_psd_trace(psd) < 2.0 && complement >= 0.125 {
        return LobeRoughness(lobe_projected_filtered(psd, added, complement));
    }
    let eigen = lobe_psd_eigen(psd);
    if eigen.major < 1.0 {
        return LobeRoughness(
            lobe_projected_from_disk(lobe_psd_add(lobe_projected_to_disk(eigen), added))
        );
    }
    if !(eigen.minor < 1.0) {
        return roughness;
    }
    let turn = eigen.axis;
    let across = lobe_projected_filtered_square(
        eigen.minor, lobe_psd_quadratic(added, vec2f(-turn.y, turn.x))
    );
    return LobeRoughness(lobe_psd_from_axes(sqrt(eigen.major), sqrt(across), turn.x, turn.y));
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
fn lobe_projected_filtered(psd: LobePsd, added: LobePsd, complement: f32) -> LobePsd {
    let det = lobe_psd_det(psd);
    let spread = lobe_max(lobe_psd_mixed_det(psd, added) - det * lobe_psd_trace(added), 0.0);
    let both = spread + complement * lobe_psd_det(added);
    let inverse = 1.0 / (1.0 + complement * lobe_psd_trace(added) + both);
    return LobePsd(
        (psd.xx + complement * added.xx + both) * inverse,
        (psd.xy + complement * added.xy) * inverse,
        (psd.yy + complement * added.yy + both) * inverse,
        sqrt((det + both) * inverse)
    );
}

// Rust: `to_disk`.
fn lobe_projected_to_disk(eigen: LobeEigen) -> LobePsd {
    let p = eigen.major / (1.0 - eigen.major);
    let q = eigen.minor / (1.0 - eigen.minor);
    let cosine = eigen.axis.x;
    let sine = eigen.axis.y;
    return LobePsd(
        p * cosine * cosine + q * sine * sine,
        (p - q) * cosine * sine,
        p * sine * sine + q * cosine * cosine,
        sqrt(p) * sqrt(q)
    );
}

// Rust: `from_disk`.
fn lobe_projected_from_disk(projected: LobePsd) -> LobePsd {
    let det = lobe_psd_det(projected);
    let inverse = 1.0 / (1.0 + projected.xx + projected.yy + det);
    return LobePsd(
        (projected.xx + det) * inverse,
        projected.xy * inverse,
        (projected.yy + det) * inverse,
        projected.root_det * sqrt(inverse)
    );
}

// Rust: `bounded`.
fn lobe_projected_bounded(psd: LobePsd) -> LobePsd {
    return lobe_psd_mul(psd, LOBE_LARGEST / lobe_max(lobe_psd_trace(psd), LOBE_LARGEST));
}
