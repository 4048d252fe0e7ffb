// The speed report on drawings whose cost is known.
#include <nlohmann/json.hpp>

#include "scanshade/report/document.hpp"
#include "scanshade/report/speed_report.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

/// Takes 0.1 ms, 2 ns a sample, 5 ns a covered sample and light, 30 ns a triangle; a quarter of the
/// samples are covered. Draws nothing.
Drawing known_cost(const Scene& scene, const Settings& s) {
    const double samples = double(s.width) * s.height * s.samples, covered = samples / 4;
    const double lights = double(scene.lights.size());
    FrameStats stats;
    stats.covered_samples = std::uint64_t(covered);
    stats.stages = {{"set-up", true, 30e-6 * double(scene.triangle_count()), 1, "triangles"},
                    {"shade", true, 5e-6 * covered * lights, 1, "samples"},
                    {"never", false, 0, 0, "things"}};
    stats.frame_ms = 0.1 + 2e-6 * samples + stats.stages[0].ms + stats.stages[1].ms;
    const auto frame = [stats](auto&) { return stats; };
    return {frame, frame};
}

const SpeedAxisResult& axis_of(const SpeedReport& report, std::string_view name) {
    for (const SpeedSceneResult& scene : report.scenes)
        for (const SpeedAxisResult& axis : scene.axes)
            if (axis.axis->name == name) return axis;
    throw std::logic_error("no such axis");
}

const SpeedFit& fit_of(const SpeedAxisResult& axis, std::string_view stage) {
    for (const SpeedFit& fit : axis.fits)
        if (fit.stage == stage) return fit;
    throw std::logic_error("no such stage");
}

}  // namespace

TEST_CASE("the speed report finds the costs of drawings that it measures", "[report]") {
    const std::vector<ReportInput> inputs{{lit_sphere(), small_picture()}};
    const SpeedReport report = measure_speed(inputs, inputs[0].settings, {0, 3, 1}, {}, known_cost);
    REQUIRE(report.scenes.size() == 2);
    CHECK(report.scenes[0].axes.size() == 4);
    CHECK(report.scenes[1].axes.size() == 1);

    const SpeedAxisResult& triangles = axis_of(report, "triangles");
    CHECK(fit_of(triangles, "frame").cost->slope.value * 1e6 == Approx(30).epsilon(1e-6));
    CHECK(fit_of(triangles, "set-up").power->slope.value == Approx(1));
    const SpeedAxisResult& lights = axis_of(report, "lights");
    CHECK(fit_of(lights, "frame").cost->slope.value * 1e6 == Approx(5).epsilon(1e-6));
    CHECK(fit_of(lights, "shade").power->slope.value == Approx(1));
    CHECK(fit_of(lights, "set-up").power->slope.value == Approx(0).margin(1e-9));
    CHECK(lights.points.front().amounts.lights == 1);
    const double lit = 2 + 5.0 / 4 * double(inputs[0].scene.lights.size());
    CHECK(fit_of(axis_of(report, "samples"), "frame").cost->slope.value * 1e6 == Approx(lit));
    CHECK(fit_of(axis_of(report, "pixels"), "frame").cost->slope.value * 1e6 == Approx(lit));
    CHECK(fit_of(axis_of(report, "pixels"), "frame").power->slope.value < 1);
    CHECK_FALSE(fit_of(axis_of(report, "threads"), "frame").cost);
    CHECK_THROWS(fit_of(lights, "never"));
}

TEST_CASE("a stage that not all points have is not fitted", "[report]") {
    const SpeedAxis& axis = speed_axes().front();
    std::vector<SpeedPoint> points(3);
    for (std::size_t i = 0; i < 3; ++i) {
        points[i].amounts.pixels = double(i + 1);
        points[i].stages = {{"frame", times_of({double(i + 1)})}, {"odd", times_of({1})}};
    }
    points[1].stages.pop_back();
    const std::vector<SpeedFit> fits = fit_stages(axis, points);
    REQUIRE(fits.size() == 1);
    CHECK(fits[0].power->slope.value == Approx(1));
    CHECK(fit_stages(axis, {}).empty());
}

TEST_CASE("the speed report's JSON has times of stages, and fits with their units", "[report]") {
    const std::vector<ReportInput> inputs{{lit_sphere(), small_picture()}};
    const SpeedReport report = measure_speed(inputs, inputs[0].settings, {0, 1, 1}, {}, known_cost);
    const TempFolder folder;
    CHECK(write_speed_report(report, folder.path).empty());
    std::ifstream file(folder.path / "report.json");
    const Json json = Json::parse(file);
    const Json& scene = json["scenes"][0];
    for (const Json& row : scene["rows"]) {
        CHECK(row["method"] == "simd");
        CHECK(row["time_ms"]["runs"] == 1);
        CHECK(row["stages_ms"]["shade"]["median"] > 0.0);
        CHECK(row["parameters"]["pixels"] > 0.0);
    }
    bool found = false;
    for (const Json& fit : scene["fits"])
        if (fit["axis"] == "lights" && fit["stage"] == "shade") {
            found = true;
            CHECK(fit["cost_unit"] == "lit sample and light");
            CHECK(fit["cost_ns"]["value"].get<double>() == Approx(5));
            CHECK(fit["exponent"]["low"] <= fit["exponent"]["high"]);
        }
    CHECK(found);
    for (const char* plot : {"pixels-1", "lights-1", "samples-1", "threads-1", "triangles-2"})
        CHECK(std::filesystem::exists(folder.path / (std::string(plot) + ".svg")));
}

TEST_CASE("each variant has twice as many pixels as the one before", "[report]") {
    const std::vector<ReportInput> inputs{{lit_sphere(), small_picture()}};
    const SpeedAxis& pixels = speed_axes().front();
    const auto variants = pixels.variants(inputs[0]);
    CHECK(variants.size() == 6);
    for (std::size_t i = 1; i < variants.size(); ++i) {
        const auto area = [&](std::size_t v) {
            return double(variants[v].settings.width) * variants[v].settings.height;
        };
        CHECK(area(i) / area(i - 1) == Approx(2).epsilon(0.05));
    }
}
