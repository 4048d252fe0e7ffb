#include "render/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/num/target.hpp"

namespace scanshade {
namespace {

void assign(const glm::dvec3& from, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The power of two that brings far points so near that their squares are finite in float.
double near_scale(const glm::dvec3& p) {
    const double reach = largest(p);
    return reach < 0x1p20 ? 1.0 : std::exp2(-std::ilogb(reach));
}

/// Unit length, for vectors of any length but 0.
glm::dvec3 unit(const glm::dvec3& v) { return glm::normalize(v / largest(v)); }

void set_emission(const Light& light, LightTerm<double>& term) {
    term.emission = LightEmission::uniform;
    if (light.kind == LightKind::point) return;
    assign(unit(light.direction), term.axis);
    if (light.kind == LightKind::cosine) term.emission = LightEmission::cosine;
    if (light.kind != LightKind::spot) return;
    term.emission = LightEmission::spot;
    term.cos_cutoff = std::cos(glm::radians(light.cutoff_deg));
    const double inner = std::cos(glm::radians(light.cutoff_deg - light.penumbra_deg));
    term.inv_penumbra = light.penumbra_deg > 0 ? 1 / (inner - term.cos_cutoff) : 0;
}

LightTerm<double> make_term(const Light& light) {
    LightTerm<double> term{};
    assign(light.intensity * pi, term.irradiance);
    set_emission(light, term);
    if (light.kind == LightKind::directional) {
        assign(-unit(light.direction), term.position);
        term.attenuation[0] = 1;
        return term;
    }
    const double s = near_scale(light.position);
    term.point_scale = s;
    assign(light.position * s, term.position);
    assign({light.attenuation.x, light.attenuation.y / s, light.attenuation.z / (s * s)},
           term.attenuation);
    term.radius = light.radius.value_or(0) * s;
    term.touches = true;
    return term;
}

Lighting<double> seen_from(const View& view) {
    Lighting<double> lighting{};
    if (view.orthographic) {
        // The rotation's last row points backward, towards the viewer.
        assign(glm::transpose(view.rotation) * glm::dvec3(0, 0, 1), lighting.eye);
        return lighting;
    }
    lighting.eye_scale = near_scale(view.eye);
    assign(view.eye * lighting.eye_scale, lighting.eye);
    return lighting;
}

template <std::size_t N>
void narrow(const double (&from)[N], float (&to)[N]) {
    for (std::size_t i = 0; i < N; ++i) to[i] = static_cast<float>(from[i]);
}

}  // namespace

Lighting<double> make_lighting(const Scene& scene, const View& view) {
    Lighting<double> lighting = seen_from(view);
    assign(scene.ambient, lighting.ambient);
    for (const Light& light : scene.lights) lighting.lights.push_back(make_term(light));
    return lighting;
}

Lighting<double> make_unlit_lighting(const View& view) {
    Lighting<double> lighting = seen_from(view);
    assign(glm::dvec3(1), lighting.ambient);
    return lighting;
}

Lighting<float> to_float(const Lighting<double>& lighting) {
    Lighting<float> out{};
    narrow(lighting.eye, out.eye);
    out.eye_scale = static_cast<float>(lighting.eye_scale);
    narrow(lighting.ambient, out.ambient);
    for (const LightTerm<double>& from : lighting.lights) {
        LightTerm<float> to{};
        narrow(from.position, to.position);
        to.point_scale = static_cast<float>(from.point_scale);
        narrow(from.axis, to.axis);
        narrow(from.irradiance, to.irradiance);
        narrow(from.attenuation, to.attenuation);
        to.radius = static_cast<float>(from.radius);
        to.cos_cutoff = static_cast<float>(from.cos_cutoff);
        to.inv_penumbra = static_cast<float>(from.inv_penumbra);
        to.emission = from.emission;
        to.constant = from.constant;
        to.touches = from.touches;
        out.lights.push_back(to);
    }
    return out;
}

}  // namespace scanshade
