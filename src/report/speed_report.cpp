#include "scanshade/report/speed_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

SpeedAmounts amounts_of(const ReportInput& input, const FrameStats& frame) {
    const Settings& s = input.settings;
    return {double(s.width) * double(s.height),
            double(input.scene.triangle_count()),
            double(input.scene.lights.size()),
            double(s.samples),
            double(s.threads == 0 ? available_threads() : s.threads),
            double(frame.covered_samples)};
}

std::vector<StageTimes> stage_times(const std::vector<FrameStats>& frames) {
    std::vector<StageTimes> stages{{"frame", times_of(frame_ms(frames))}};
    for (std::size_t s = 0; s < frames.front().stages.size(); ++s) {
        const StageStats& stage = frames.front().stages[s];
        if (!stage.ran) continue;
        stages.push_back(
            {std::string(stage.name), times_of(of_frames(frames, [s](const FrameStats& frame) {
                 return frame.stages[s].ms;
             }))});
    }
    return stages;
}

/// All variants of one axis, in rounds.
std::vector<SpeedPoint> measure_points(const std::vector<ReportInput>& variants,
                                       const Rounds& rounds, const std::function<bool()>& stopped,
                                       const MakeDrawing& make) {
    std::vector<Drawing> drawings;
    std::vector<PixelBuffer> pixels(variants.size());
    std::vector<std::function<FrameStats()>> subjects;
    for (const ReportInput& variant : variants) {
        if (stopped()) return {};
        drawings.push_back(make(variant.scene, variant.settings));
    }
    for (std::size_t i = 0; i < variants.size(); ++i)
        subjects.emplace_back([&, i] { return drawings[i].pixels(pixels[i]); });
    const FrameTable frames = time_interleaved(subjects, rounds, stopped);
    std::vector<SpeedPoint> points;
    for (std::size_t i = 0; i < variants.size() && !frames[i].empty(); ++i)
        points.push_back({amounts_of(variants[i], frames[i].front()), stage_times(frames[i])});
    return points;
}

ReportInput with_one_sample(ReportInput input) {
    if (!input.settings.is_given("samples")) input.settings.samples = 1;
    return input;
}

/// The axes that a scene is measured along: the last one is the sphere's.
std::span<const SpeedAxis> axes_of_scenes() { return speed_axes().first(speed_axes().size() - 1); }
std::span<const SpeedAxis> axes_of_sphere() { return speed_axes().last(1); }

void measure_scene(const ReportInput& input, std::span<const SpeedAxis> axes, const Rounds& rounds,
                   const MakeDrawing& make, Steps& steps, SpeedSceneResult& scene) {
    for (const SpeedAxis& axis : axes) {
        if (steps.watch.stopped()) return;
        steps.tell(fmt::format("{}: {}", scene.name, axis.name));
        SpeedAxisResult result{&axis, {}, {}};
        result.points = measure_points(axis.variants(input), rounds, steps.watch.stopped, make);
        result.fits = fit_stages(axis, result.points);
        if (!result.points.empty()) scene.axes.push_back(std::move(result));
        ++steps.done;
    }
}

}  // namespace

const Times* SpeedPoint::find(std::string_view stage) const {
    for (const StageTimes& each : stages)
        if (each.name == stage) return &each.times;
    return nullptr;
}

std::vector<SpeedFit> fit_stages(const SpeedAxis& axis, const std::vector<SpeedPoint>& points) {
    std::vector<SpeedFit> fits;
    if (points.empty()) return fits;
    std::vector<double> amounts, work;
    for (const SpeedPoint& point : points) {
        amounts.push_back(axis.amount(point.amounts));
        if (axis.work) work.push_back(axis.work(point.amounts));
    }
    for (const StageTimes& stage : points.front().stages) {
        std::vector<double> ms;
        for (const SpeedPoint& point : points)
            if (const Times* times = point.find(stage.name)) ms.push_back(times->median);
        if (ms.size() != points.size()) continue;
        fits.push_back(
            {stage.name, fit_power(amounts, ms), axis.work ? fit_line(work, ms) : std::nullopt});
    }
    return fits;
}

SpeedReport measure_speed(const std::vector<ReportInput>& inputs, const Settings& settings,
                          const Rounds& rounds, const Watch& watch, const MakeDrawing& make) {
    SpeedReport report{provenance(settings, rounds.seed), false, {}};
    Steps steps{watch};
    steps.all = inputs.size() * axes_of_scenes().size() + axes_of_sphere().size();
    const auto measure = [&](const ReportInput& input, std::span<const SpeedAxis> axes) {
        if (watch.stopped()) return;
        const std::string_view renderer = renderer_names()[std::size_t(input.settings.renderer)];
        report.scenes.push_back({input.scene.name, std::string(renderer), {}});
        measure_scene(with_one_sample(input), axes, rounds, make, steps, report.scenes.back());
    };
    for (const ReportInput& input : inputs) measure(input, axes_of_scenes());
    measure(triangle_scene(settings, 1), axes_of_sphere());
    report.partial = watch.stopped();
    return report;
}

}  // namespace scanshade
