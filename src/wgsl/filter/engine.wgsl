// What engines ship. Rust: src/filter/engine.rs.

// Rust: `Engine::Filament`; places in `Engine::ALL`.
const LOBE_ENGINE_FILAMENT: u32 = 0u;
// Rust: `Engine::UnityHdrp`.
const LOBE_ENGINE_UNITY_HDRP: u32 = 1u;
// Rust: `Engine::Godot`.
const LOBE_ENGINE_GODOT: u32 = 2u;
// Rust: `Engine::O3de`.
const LOBE_ENGINE_O_THREE_DE: u32 = 3u;
// Rust: `Engine::ThreeJs`.
const LOBE_ENGINE_THREE_JS: u32 = 4u;
// Rust: `Engine::BabylonJs`.
const LOBE_ENGINE_BABYLON_JS: u32 = 5u;
// Rust: `Engine::BevyProposal`.
const LOBE_ENGINE_BEVY_PROPOSAL: u32 = 6u;

// Rust: `Engine::alpha`. Alpha beyond [0, 1e9] counts as the nearest, NaN as 0; so does an engine
// beyond the last.
fn lobe_engine_alpha(engine: u32, alpha: f32, dn_u: vec3f, dn_v: vec3f) -> f32 {
    let a = lobe_magnitude(alpha);
    let u = lobe_dot(dn_u, dn_u);
    let v = lobe_dot(dn_v, dn_v);
    let perceptual = sqrt(a);
    switch engine {
        case LOBE_ENGINE_FILAMENT: {
            return lobe_deferred_widened(a, 0.3 * (u + v), 0.04);
        }
        case LOBE_ENGINE_UNITY_HDRP: {
            return lobe_deferred_widened(a, 0.2 * (u + v), 0.04);
        }
        case LOBE_ENGINE_O_THREE_DE: {
            return lobe_deferred_widened(a, 0.5 * (u + v), 0.18);
        }
        case LOBE_ENGINE_BEVY_PROPOSAL: {
            return lobe_deferred_widened(a, 0.25 * (u + v), 0.18);
        }
        case LOBE_ENGINE_GODOT: {
            return lobe_min(a + lobe_min(lobe_max(0.5 * (u + v), 0.0), 0.18), 1.0);
        }
        case LOBE_ENGINE_THREE_JS: {
            let of_u = lobe_max(lobe_max(lobe_max(0.0, abs(dn_u.x)), abs(dn_u.y)), abs(dn_u.z));
            let largest = lobe_max(lobe_max(lobe_max(of_u, abs(dn_v.x)), abs(dn_v.y)), abs(dn_v.z));
            let r = lobe_min(lobe_max(perceptual, 0.0525) + lobe_defined(largest), 1.0);
            return r * r;
        }
        case LOBE_ENGINE_BABYLON_JS: {
            let largest = lobe_min(lobe_max(lobe_defined(u), lobe_defined(v)), 1.0);
            let r = lobe_max(perceptual, lobe_exp(0.333 * lobe_ln(largest)));
            return r * r + 0.0005;
        }
        default: {
            return 0.0;
        }
    }
}
