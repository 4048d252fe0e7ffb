// Light sources.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace scanshade {

enum class LightKind {
    point,        // the same intensity in every direction
    directional,  // from infinitely far away; no attenuation
    spot,         // (A15): I₀ inside the cone ∠(ω, d) < τ, else 0
    cosine,       // (A14): I₀ (ω·d), 0 behind
};

/// Stable names, as scene files and options spell them; the order is that of LightKind.
std::span<const std::string_view> light_kind_names();

/// One light in world space. `intensity` is the radiance that a white Lambertian surface facing
/// the light would show: E = π f_att I.
struct Light {
    LightKind kind = LightKind::point;
    glm::dvec3 position{0};           // point, spot, cosine
    glm::dvec3 direction{0, -1, 0};   // directional, spot, cosine: where the light shines to;
                                      // any length but 0
    glm::dvec3 intensity{1};          // ≥ 0, a channel
    glm::dvec3 attenuation{1, 0, 0};  // c, l, q ≥ 0, not all 0: f_att = 1/(c + l d + q d²)
    double cutoff_deg = 30;           // spot: half angle τ of the cone, (0, 180]
    double penumbra_deg = 0;          // spot: width of the soft rim inside the cone, [0, cutoff]
    std::optional<double> radius;     // > 0: d is at least this; default 1e-4 of the scene's
};

}  // namespace scanshade
