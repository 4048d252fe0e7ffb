// What is varied, and how.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scanshade/base/parallel.hpp"
#include "scanshade/report/speed_report.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

/// A variant for each value, made by a change of a copy.
template <class Value, class Change>
std::vector<ReportInput> each(const ReportInput& input, std::initializer_list<Value> values,
                              Change change) {
    std::vector<ReportInput> variants;
    for (const Value value : values) {
        variants.push_back(input);
        change(variants.back(), value);
    }
    return variants;
}

int scaled(int side, double factor) {
    return std::clamp(int(std::lround(side * factor)), 1, max_image_side);
}

/// Each has twice as many pixels as the one before.
std::vector<ReportInput> by_pixels(const ReportInput& input) {
    return each(input, {-4, -3, -2, -1, 0, 1}, [](ReportInput& variant, int power) {
        const double factor = std::exp2(power / 2.0);
        variant.settings.width = scaled(variant.settings.width, factor);
        variant.settings.height = scaled(variant.settings.height, factor);
    });
}

/// Point lights evenly on a ring above the scene, as bright together as one of them.
std::vector<Light> ring_of_lights(const Scene& scene, int count) {
    const Bounds bounds = scene.bounds();
    const double r = bounds.radius;
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        Light light;
        light.kind = LightKind::point;
        light.position =
            bounds.centre + r * glm::dvec3(2 * std::cos(angle), 1.5, 2 * std::sin(angle));
        light.intensity = glm::dvec3(1.0 / count);
        light.attenuation = {0.5, 0, 0.1 / (r * r)};
        lights.push_back(light);
    }
    return lights;
}

std::vector<ReportInput> by_lights(const ReportInput& input) {
    return each(input, {1, 2, 4, 8, 16, 32}, [](ReportInput& variant, int count) {
        variant.scene.lights = ring_of_lights(variant.scene, count);
    });
}

std::vector<ReportInput> by_samples(const ReportInput& input) {
    return each(input, {1, 4, 9, 16, 25},
                [](ReportInput& variant, int samples) { variant.settings.samples = samples; });
}

/// Powers of two below the machine's number of threads, and that number.
std::vector<ReportInput> by_threads(const ReportInput& input) {
    std::vector<ReportInput> variants;
    const int all = available_threads();
    for (int threads = 1;; threads *= 2) {
        variants.push_back(input);
        variants.back().settings.threads = std::min(threads, all);
        if (threads >= all) return variants;
    }
}

std::vector<ReportInput> by_triangles(const ReportInput& input) {
    std::vector<ReportInput> variants;
    for (const int tessellation : {8, 16, 32, 64, 128, 256})
        variants.push_back(triangle_scene(input.settings, tessellation));
    return variants;
}

constexpr SpeedAxis axes[] = {
    {"pixels", "pixel", "set xlabel 'pixels'\n", [](const SpeedAmounts& a) { return a.pixels; },
     [](const SpeedAmounts& a) { return a.pixels; }, by_pixels},
    {"lights", "lit sample and light", "set xlabel 'lights'\n",
     [](const SpeedAmounts& a) { return a.lights; },
     [](const SpeedAmounts& a) { return a.covered * a.lights; }, by_lights},
    {"samples", "sample", "set xlabel 'samples a pixel'\n",
     [](const SpeedAmounts& a) { return a.samples; },
     [](const SpeedAmounts& a) { return a.pixels * a.samples; }, by_samples},
    {"threads", "", "set xlabel 'threads'\n", [](const SpeedAmounts& a) { return a.threads; },
     nullptr, by_threads},
    {"triangles", "triangle", "set xlabel 'triangles'\n",
     [](const SpeedAmounts& a) { return a.triangles; },
     [](const SpeedAmounts& a) { return a.triangles; }, by_triangles},
};

}  // namespace

std::span<const SpeedAxis> speed_axes() { return axes; }

ReportInput triangle_scene(const Settings& settings, int tessellation) {
    ReportInput input{single_object_scene(std::make_shared<Mesh>(build_mesh(
                                              find_shape("sphere")->make(tessellation), {})),
                                          Material{}),
                      settings};
    input.scene.name = "sphere";
    return input;
}

}  // namespace scanshade
