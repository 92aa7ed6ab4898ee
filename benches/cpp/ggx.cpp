// GGX as engines ship it: the half vector normalized, then D (Filament, glTF's sample viewer) times
// the height-correlated visibility with one square root per direction. The twin of the rows
// `ggx_isotropic`, `ggx_axis_aligned` and `ggx_axis_aligned_aos`, for benches/speed/cpp.rs.
//
// Tangent frames, so a cosine with the normal is z. 1 - (n.h)^2 is written as x^2 + y^2, without
// which alphas of 0.01 have three digits in f32.
#include <cmath>
#include <cstddef>

namespace {

constexpr float INVERSE_PI = 0.318309886183790671538f;

struct Vector {
    float x, y, z;
};

inline Vector half_vector(Vector wo, Vector wi) {
    const Vector g = {wo.x + wi.x, wo.y + wi.y, wo.z + wi.z};
    const float inverse = 1.0f / std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
    return {g.x * inverse, g.y * inverse, g.z * inverse};
}

// The value where both directions lie above the surface. The comparison of one minimum leaves the
// compiler a select where two would be jumps.
inline float above(Vector wo, Vector wi, float value) {
    const float lowest = wo.z < wi.z ? wo.z : wi.z;
    return lowest > 0.0f ? value : 0.0f;
}

inline float isotropic(Vector wo, Vector wi, float alpha) {
    const Vector h = half_vector(wo, wi);
    const float a2 = alpha * alpha;
    const float k = alpha / (h.x * h.x + h.y * h.y + a2 * h.z * h.z);
    const float d = k * k * INVERSE_PI;
    const float lambda_o = wi.z * std::sqrt((1.0f - a2) * wo.z * wo.z + a2);
    const float lambda_i = wo.z * std::sqrt((1.0f - a2) * wi.z * wi.z + a2);
    return above(wo, wi, d * (0.5f / (lambda_o + lambda_i)));
}

inline float axis_aligned(Vector wo, Vector wi, float ax, float ay) {
    const Vector h = half_vector(wo, wi);
    const float a2 = ax * ay;
    const Vector f = {ay * h.x, ax * h.y, a2 * h.z};
    const float w2 = a2 / (f.x * f.x + f.y * f.y + f.z * f.z);
    const float d = a2 * w2 * w2 * INVERSE_PI;
    const auto length = [=](Vector w) {
        const float x = ax * w.x, y = ay * w.y;
        return std::sqrt(x * x + y * y + w.z * w.z);
    };
    const float lambda_o = wi.z * length(wo);
    const float lambda_i = wo.z * length(wi);
    return above(wo, wi, d * (0.5f / (lambda_o + lambda_i)));
}

} // namespace

extern "C" {

void lobe_bench_ggx_isotropic(std::size_t count, const float *__restrict wo_x,
                              const float *__restrict wo_y, const float *__restrict wo_z,
                              const float *__restrict wi_x, const float *__restrict wi_y,
                              const float *__restrict wi_z, const float *__restrict alpha,
                              float *__restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const Vector wo = {wo_x[i], wo_y[i], wo_z[i]};
        const Vector wi = {wi_x[i], wi_y[i], wi_z[i]};
        out[i] = isotropic(wo, wi, alpha[i]);
    }
}

void lobe_bench_ggx_axis_aligned(std::size_t count, const float *__restrict wo_x,
                                 const float *__restrict wo_y, const float *__restrict wo_z,
                                 const float *__restrict wi_x, const float *__restrict wi_y,
                                 const float *__restrict wi_z, const float *__restrict alpha_x,
                                 const float *__restrict alpha_y, float *__restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const Vector wo = {wo_x[i], wo_y[i], wo_z[i]};
        const Vector wi = {wi_x[i], wi_y[i], wi_z[i]};
        out[i] = axis_aligned(wo, wi, alpha_x[i], alpha_y[i]);
    }
}

// The layout of the bench's records: wo, wi, alphas.
struct Record {
    Vector wo, wi;
    float alpha_x, alpha_y;
};

void lobe_bench_ggx_axis_aligned_aos(std::size_t count, const Record *__restrict records,
                                     float *__restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const Record r = records[i];
        out[i] = axis_aligned(r.wo, r.wi, r.alpha_x, r.alpha_y);
    }
}

} // extern "C"
