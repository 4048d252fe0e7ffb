// Hard scenes: light and reflection.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "report/picture_scene_parts.hpp"
#include "report/picture_scenes.hpp"

namespace scanshade {
namespace {

constexpr double pi = std::numbers::pi;

/// A flat square whose normals turn as those of a sphere would, by up to `angle` at its sides.
PolygonSoup curved_looking(double x, double y, double half_side, double angle) {
    constexpr int n = 4;
    PolygonSoup soup;
    const auto at = [](int i) { return 2.0 * i / n - 1; };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            std::vector<glm::dvec3> corners, normals;
            for (const auto& [u, v] : {std::pair(at(i), at(j)),
                                       {at(i + 1), at(j)},
                                       {at(i + 1), at(j + 1)},
                                       {at(i), at(j + 1)}}) {
                corners.push_back({x + half_side * u, y + half_side * v, 0});
                normals.push_back({std::tan(angle * u), std::tan(angle * v), 1});
            }
            add_face(soup, corners, normals);
        }
    return soup;
}

/// Light and view along z, so that only normals decide how far a sample is from the highlight.
SceneBuilder highlight_scene() {
    SceneBuilder builder;
    builder.camera({0, 0, 5}, {0, 0, 0}).light(directional_light({0, 0, -1}, 1));
    return builder;
}

ReportInput seen_from_far(SceneBuilder& builder) {
    ReportInput input = builder.take();
    input.scene.camera->projection = Projection::orthographic;
    return input;
}

/// Turned out of the axes, so that coordinates have rounding errors.
glm::dmat4 slanted() {
    return glm::rotate(glm::dmat4(1), 0.3, glm::normalize(glm::dvec3(1, 0.4, 0.2)));
}

/// Two lights at that height above a slanted plane through the origin.
SceneBuilder plane_under_lights(double height) {
    const glm::dmat4 slant = slanted();
    const auto above = [&](double x, double z) {
        return glm::dvec3(slant * glm::dvec4(x, height, z, 1));
    };
    SceneBuilder builder;
    builder.camera({0, 2.2, 2.2}, {0, 0, 0}, 40)
        .light(point_light(above(-0.5, 0), 0.02, {0, 0, 1}))
        .light(point_light(above(0.35, 0.3), 0.02, {0, 0, 1}))
        .material(palette(1))
        .object(shape("plane", 4), slant);
    return builder;
}

}  // namespace

ReportInput exponent(double n) {
    SceneBuilder builder = highlight_scene();
    const double angle = std::min(4 / std::sqrt(n + 1e-9), pi / 3);
    for (const char* model : {"phong", "blinn-phong"}) {
        Material material = palette(2);
        material.brdf = model;
        material.set("ks", {0.8});
        material.set("shininess", {n});
        const double x = model[0] == 'p' ? -0.85 : 0.85;
        builder.material(material).object(curved_looking(x, 0, 0.8, angle));
    }
    return seen_from_far(builder);
}

ReportInput roughness(double m) {
    SceneBuilder builder = highlight_scene();
    int i = 0;
    for (const char* distribution : {"gaussian", "blinn", "beckmann", "ggx"}) {
        Material material;
        material.brdf = "torrance-sparrow";
        material.set("rho", {0.1, 0.2, 0.35});
        material.set("m", {m});
        material.set("f0", {std::min(4 * m * m, 0.5)});  // a highlight of about 1
        material.set_word("distribution", distribution);
        const int column = i % 2, row = i / 2;
        builder.material(material).object(
            curved_looking(-0.75 + 1.5 * column, 0.64 - 1.28 * row, 0.6, std::min(4 * m, pi / 3)));
        ++i;
    }
    return seen_from_far(builder);
}

ReportInput light_at_height(double height) { return plane_under_lights(height).take(); }

ReportInput light_off_origin(double height) {
    // Hidden by the plane: it moves the scene's middle away from it.
    const glm::dmat4 below = glm::translate(slanted(), glm::dvec3(0.1, -1, 0.2));
    return plane_under_lights(height)
        .object(shape("cube", 1), glm::scale(below, glm::dvec3(0.2)))
        .take();
}

ReportInput light_inside(double radius) {
    const glm::dmat4 size = glm::scale(glm::dmat4(1), glm::dvec3(radius));
    return SceneBuilder()
        .camera({radius, radius, 3 * radius}, {0, 0, 0}, 45)
        .depth(2.7 * radius, 6 * radius)
        .light(point_light({0, 0.1 * radius, 0}, 0.6, {0.5, 0, 0.5 / (radius * radius)}))
        .material(palette(4))
        .object(shape("sphere", 8), size)
        .object(shape("cube", 1), glm::scale(size, glm::dvec3(0.25)))
        .take();
}

ReportInput light_far(double distance) {
    // One as bright as ever, one that falls off with the square of its distance.
    return SceneBuilder()
        .camera({0, 2, 4}, {0, 0, 0})
        .light(point_light(glm::dvec3(0.6, 0.6, 0.5) * distance, 0.6, {1, 0, 0}))
        .light(point_light(glm::dvec3(-0.6, 0.2, 0.8) * distance, 0.4,
                           {0, 0, 1 / (distance * distance)}))
        .material(palette(5))
        .object(shape("torus", 6))
        .take();
}

ReportInput grazing(double angle) {
    SceneBuilder builder;
    builder.camera({0, 0.25, 3}, {0, 0, 0}).light(directional_light({0, -angle, 1}, 1));
    int i = 0;
    for (const char* distribution : {"gaussian", "beckmann", "ggx"})
        for (const char* shadowing : {"v-cavity", "smith"}) {
            Material material;
            material.brdf = "torrance-sparrow";
            material.set("m", {0.2});
            material.set_word("distribution", distribution);
            material.set_word("shadowing", shadowing);
            const glm::dmat4 place =
                glm::translate(glm::dmat4(1), glm::dvec3(-0.75 + 0.3 * i++, 0, 0));
            builder.material(material).object(shape("plane", 2),
                                              glm::scale(place, glm::dvec3(0.14, 1, 1)));
        }
    return builder.take();
}

ReportInput spot_rim(double degrees) {
    Light spot = point_light({0.4, 2, 0.3}, 1, {1, 0, 0});
    spot.kind = LightKind::spot;
    spot.direction = {-0.2, -1, -0.1};
    spot.cutoff_deg = degrees;
    return SceneBuilder()
        .camera({0, 2.5, 2.5}, {0, 0, 0}, 40)
        .light(spot)
        .material(palette(0))
        .object(shape("plane", 3), slanted())
        .take();
}

ReportInput bright(double intensity) {
    return SceneBuilder()
        .camera({0, 2, 4}, {0, 0, 0})
        .light(point_light({2, 2, 2}, intensity, {1, 0, 0}))
        .light(directional_light({1, -0.2, -0.5}, 0.5))
        .material(palette(2))
        .object(shape("torus", 6))
        .take();
}

}  // namespace scanshade
