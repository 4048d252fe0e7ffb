#include "bench/shaders.hpp"

#include <fmt/format.h>

#include "bench/scenes.hpp"

namespace scanshade::bench {
namespace {

constexpr const char* version = "#version 330 core\n";

// (C7) with point lights. The power is raised from the square of the cosine: of n·h = (n·l + n·v)/
// √(2 + 2 l·v) the root is never needed, and one squaring is saved.
constexpr const char* illumination = R"(
uniform vec3 eye, base;
#if LIGHTS > 0
uniform vec3 light_position[LIGHTS], light_diffuse[LIGHTS], light_specular[LIGHTS];
uniform vec2 light_attenuation[LIGHTS];  // c, q

float power(float square) {
#if SQUARINGS
    for (int i = 1; i < SQUARINGS; ++i) square *= square;
    return square;
#else
    return pow(square, 0.5 * SHININESS);
#endif
}

vec3 radiance(vec3 P, vec3 n) {
    vec3 wo = normalize(eye - P);
    float n_o = dot(n, wo);
    vec3 L = base;
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 D = light_position[i] - P;
        float d2 = dot(D, D);
        float inv_d = inversesqrt(d2);
        float n_i = dot(n, D) * inv_d;
        float i_o = dot(wo, D) * inv_d;
#if BLINN
        float t = max(n_i + n_o, 0.0);
        float square = t * t / (2.0 + 2.0 * i_o);
#else
        float t = max(2.0 * n_i * n_o - i_o, 0.0);
        float square = t * t;
#endif
        float f_att = 1.0 / (light_attenuation[i].x + light_attenuation[i].y * d2);
        f_att = n_i > 0.0 ? f_att : 0.0;
        L += f_att * (light_diffuse[i] * n_i + light_specular[i] * power(square));
    }
    return L;
}
#else
vec3 radiance(vec3 P, vec3 n) { return base; }
#endif
)";

constexpr const char* place = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 centre;
uniform mat4 to_clip;
uniform vec4 place;  // origin, scale
vec3 in_scene(vec3 p) { return place.xyz + place.w * p; }
)";

constexpr const char* pixel_vertex = R"(
out vec3 P, N;
void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    P = in_scene(position);
    N = normal;
}
)";

constexpr const char* pixel_fragment = R"(
in vec3 P, N;
out vec4 colour;
void main() {
    vec3 n = normalize(N);
#if TWO_SIDED
    if (!gl_FrontFacing) n = -n;
#endif
    colour = vec4(radiance(P, n), 1.0);
}
)";

// CARRIED is smooth for Gouraud. Flat light comes from the last corner, which no other face has.
constexpr const char* vertex_vertex = R"(
CARRIED out vec3 front;
#if TWO_SIDED
CARRIED out vec3 back;
#endif
void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    vec3 P = in_scene(LIT_AT);
    front = radiance(P, normal);
#if TWO_SIDED
    back = radiance(P, -normal);
#endif
}
)";

constexpr const char* vertex_fragment = R"(
CARRIED in vec3 front;
#if TWO_SIDED
CARRIED in vec3 back;
#endif
out vec4 colour;
void main() {
#if TWO_SIDED
    colour = vec4(gl_FrontFacing ? front : back, 1.0);
#else
    colour = vec4(front, 1.0);
#endif
}
)";

constexpr const char* unlit_vertex =
    "void main() { gl_Position = to_clip * vec4(position, 1.0); }\n";
constexpr const char* unlit_fragment =
    "out vec4 colour;\nvoid main() { colour = vec4(radiance(vec3(0), vec3(0)), 1.0); }\n";

constexpr const char* id_vertex = R"(
layout(location = 3) in uint id;
flat out uint triangle;
void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    triangle = id;
}
)";

constexpr const char* id_fragment = R"(
flat in uint triangle;
out vec4 colour;
void main() {
    colour = vec4(uvec4(triangle, triangle >> 8, triangle >> 16, triangle >> 24) & 255u) / 255.0;
}
)";

}  // namespace

ShaderPair shaders_of(const Cell& cell, bool two_sided, bool squarings) {
    const bool flat = cell.shading == Shading::flat;
    const std::string constants = fmt::format(
        "#define LIGHTS {}\n#define BLINN {:d}\n#define SQUARINGS {}\n#define SHININESS {}.0\n"
        "#define TWO_SIDED {:d}\n#define CARRIED {}\n#define LIT_AT {}\n",
        cell.lights, cell.brdf == "blinn-phong", squarings ? specular_squarings : 0,
        surface_shininess, two_sided, flat ? "flat" : "smooth", flat ? "centre" : "position");
    const std::string top = version + constants;
    if (cell.lights == 0) return {top + place + unlit_vertex, top + illumination + unlit_fragment};
    if (cell.shading == Shading::phong)
        return {top + place + pixel_vertex, top + illumination + pixel_fragment};
    return {top + place + illumination + vertex_vertex, top + vertex_fragment};
}

ShaderPair id_shaders() {
    return {std::string(version) + place + id_vertex, std::string(version) + id_fragment};
}

}  // namespace scanshade::bench
