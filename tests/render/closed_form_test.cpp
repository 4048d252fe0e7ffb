// Pictures of a sphere against the illumination formula, evaluated by hand at the exact point where
// the ray of each pixel meets the sphere.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>

#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

constexpr int side = 160;
constexpr glm::dvec3 centre{3, -1, 2};
constexpr double radius = 2.5;
constexpr glm::dvec3 kd{0.6, 0.4, 0.2}, ks{0.3, 0.25, 0.2}, ambient{0.05, 0.06, 0.08};
constexpr double shininess = 20;

Camera test_camera() {
    Camera camera;
    camera.position = centre + glm::dvec3(3, 2, 9);
    camera.focal_point = centre + glm::dvec3(0.1, -0.2, 0);
    camera.view_up = {0.2, 1, 0};
    camera.view_angle_deg = 34;
    return camera;
}

Light fill_light() {
    Light light;
    light.kind = LightKind::directional;
    light.direction = {3, -1, -2};
    light.intensity = {0.10, 0.15, 0.20};
    return light;
}

Light tested_light(LightKind kind) {
    Light light;
    light.kind = kind;
    light.position = centre + glm::dvec3(-2, 4, 5);
    light.direction = {1.7, -4.4, -5.2};
    light.intensity = {0.9, 0.8, 0.7};
    if (kind == LightKind::directional) return light;
    light.intensity *= 3.0;
    light.attenuation = {0.8, 0.15, 0.04};
    light.cutoff_deg = 19;
    return light;
}

/// What the light sends towards P, as a factor of its intensity, and whether P is so close to the
/// rim of a hard spot that the tessellation decides.
double emitted(const Light& light, const glm::dvec3& to_surface, bool& on_rim) {
    const glm::dvec3 axis = glm::normalize(light.direction);
    const double cosine = glm::dot(to_surface, axis);
    if (light.kind == LightKind::cosine) return std::max(cosine, 0.0);
    if (light.kind != LightKind::spot) return 1;
    const double angle = glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    on_rim |= std::abs(angle - light.cutoff_deg) < 0.01 * light.cutoff_deg;
    if (light.penumbra_deg == 0) return angle < light.cutoff_deg ? 1 : 0;
    const double rim = std::cos(glm::radians(light.cutoff_deg));
    const double inner = std::cos(glm::radians(light.cutoff_deg - light.penumbra_deg));
    const double t = std::clamp((cosine - rim) / (inner - rim), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// The factor of k_s.
double highlight(const std::string& brdf, const glm::dvec3& n, const glm::dvec3& l,
                 const glm::dvec3& v) {
    if (brdf == "lambert") return 0;
    const glm::dvec3 mirrored = 2 * glm::dot(n, l) * n - l;
    const double cosine =
        brdf == "phong" ? glm::dot(mirrored, v) : glm::dot(n, glm::normalize(l + v));
    return std::pow(std::max(cosine, 0.0), shininess);
}

struct Expected {
    glm::dvec3 radiance;
    bool at_jump;  // the formula jumps here: rim of a spot, or a highlight cut off at N·L = 0
};

/// I_a k_a + Σ f_att I [k_d (N·L) + k_s cosⁿ] at a point of the sphere.
Expected illumination(const Scene& scene, const std::string& brdf, const glm::dvec3& P,
                      const glm::dvec3& v) {
    const glm::dvec3 n = (P - centre) / radius;
    Expected out{ambient * kd, false};
    for (const Light& light : scene.lights) {
        const bool far = light.kind == LightKind::directional;
        const glm::dvec3 to_light = far ? -light.direction : light.position - P;
        const double d = glm::length(to_light);
        const glm::dvec3 l = to_light / d;
        const glm::dvec3& a = light.attenuation;
        const double f_att = far ? 1 : 1 / (a.x + a.y * d + a.z * d * d);
        const double factor = f_att * emitted(light, -l, out.at_jump);
        const double cos_i = glm::dot(n, l), specular = highlight(brdf, n, l, v);
        out.at_jump |= std::abs(cos_i) < 0.01 && specular > 1e-3;
        if (cos_i > 0) out.radiance += factor * light.intensity * (kd * cos_i + ks * specular);
    }
    return out;
}

/// Direction of the ray through the centre of a pixel, unit.
glm::dvec3 ray(const Camera& camera, int x, int y) {
    const glm::dvec3 forward = glm::normalize(camera.focal_point - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.view_up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double pixel = 2 * std::tan(glm::radians(camera.view_angle_deg / 2)) / side;
    return glm::normalize(forward + right * ((x + 0.5 - side / 2.0) * pixel) -
                          up * ((y + 0.5 - side / 2.0) * pixel));
}

Scene sphere_scene(const std::string& brdf, const Light& light) {
    static const auto mesh =
        std::make_shared<const Mesh>(build_mesh(find_shape("sphere")->make(96), {}));
    Material material;
    material.brdf = brdf;
    material.set("kd", {kd.x, kd.y, kd.z});
    if (brdf != "lambert") {
        material.set("ks", {ks.x, ks.y, ks.z});
        material.set("shininess", {shininess});
    }
    Scene scene = single_object_scene(mesh, material);
    scene.objects[0].to_world =
        glm::scale(glm::translate(glm::dmat4(1), centre), glm::dvec3(radius));
    scene.camera = test_camera();
    scene.ambient = ambient;
    scene.lights = {light, fill_light()};
    return scene;
}

struct Comparison {
    int pixels = 0, at_jump = 0, uncovered = 0, lit = 0;
    double worst = 0;  // in 8-bit levels after the transfer curve
};

Comparison compare(const Scene& scene, const std::string& brdf) {
    Settings settings;
    settings.width = settings.height = side;
    settings.renderer = RendererKind::scalar_f64;
    Framebuffer frame;
    Renderer(scene, settings).draw(frame);

    Comparison result;
    const auto level = [](double L) { return 255 * srgb_encode(std::clamp(L, 0.0, 1.0)); };
    const glm::dvec3 from_centre = scene.camera->position - centre;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 w = ray(*scene.camera, x, y);
            const double b = glm::dot(from_centre, w);
            const double under = b * b - glm::dot(from_centre, from_centre) + radius * radius;
            if (under <= 0) continue;
            const glm::dvec3 P = scene.camera->position + w * (-b - std::sqrt(under));
            if (glm::dot((P - centre) / radius, -w) <= 0.3) continue;
            ++result.pixels;
            const std::size_t i = frame.index(x, y);
            result.uncovered += frame.id[i] == Framebuffer::no_triangle;
            const Expected expected = illumination(scene, brdf, P, -w);
            result.at_jump += expected.at_jump;
            if (expected.at_jump) continue;
            result.lit += expected.radiance.g > 2 * ambient.g * kd.g;
            const glm::dvec3 got(frame.r[i], frame.g[i], frame.b[i]);
            for (int c = 0; c < 3; ++c)
                result.worst =
                    std::max(result.worst, std::abs(level(got[c]) - level(expected.radiance[c])));
        }
    return result;
}

void require_formula(const std::string& brdf, const Light& light) {
    const Comparison result = compare(sphere_scene(brdf, light), brdf);
    CAPTURE(brdf, light_kind_names()[std::size_t(light.kind)], light.penumbra_deg);
    CAPTURE(result.pixels, result.at_jump, result.lit);
    CHECK(result.pixels > 8000);
    CHECK(result.at_jump < result.pixels / 20);
    CHECK(result.lit > result.pixels / 4);
    CHECK(result.uncovered == 0);
    CHECK(result.worst < 0.5);
}

}  // namespace

TEST_CASE("a sphere shows the illumination formula at every pixel", "[render][closed-form]") {
    for (const char* brdf : {"lambert", "phong", "blinn-phong"})
        for (const LightKind kind : {LightKind::point, LightKind::directional, LightKind::cosine})
            require_formula(brdf, tested_light(kind));
}

TEST_CASE("a sphere under a spot shows its cone, hard and with a penumbra",
          "[render][closed-form]") {
    for (const char* brdf : {"lambert", "phong", "blinn-phong"})
        for (const double penumbra : {0.0, 8.0}) {
            Light light = tested_light(LightKind::spot);
            light.penumbra_deg = penumbra;
            require_formula(brdf, light);
        }
}
