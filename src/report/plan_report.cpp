#include "scanshade/report/plan_report.hpp"

#include <fmt/format.h>

#include <bit>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

/// How many of the values differ, and where the first one stands.
template <class T>
std::string plane_change(std::string_view plane, const std::vector<T>& a, const std::vector<T>& b,
                         int width) {
    std::size_t count = 0, first = 0;
    for (std::size_t i = a.size(); i-- > 0;)
        if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]))
            ++count, first = i;
    if (count == 0) return {};
    return fmt::format("{} of {} pixels differ in {}, first ({}, {})", count, a.size(), plane,
                       first % std::size_t(width), first / std::size_t(width));
}

/// One scene on its way through the measurement.
class PlanMeasurement {
public:
    PlanMeasurement(const ReportInput& input, const Rounds& rounds, const MakeDrawing& make,
                    const std::function<bool()>& stopped)
        : input_(input),
          rounds_(rounds),
          make_(make),
          stopped_(stopped),
          planned_(make(input.scene, input.settings)),
          saved_(planned_.planes(picture_).saved),
          plan_(make_plan(normalised(input.scene), input.settings)) {}

    const RenderPlan& plan() const { return plan_; }
    std::vector<PlannedRow> rows() const { return explain_rows(plan_, saved_); }

    /// Compares with a drawing of other settings; nothing where it was stopped before the end.
    std::optional<PlanGain> measure(const Settings& without, std::string& change) {
        const Drawing other = make_(input_.scene, without);
        Framebuffer picture;
        other.planes(picture);
        change = picture_change(picture_, picture);
        PixelBuffer pixels[2];
        const std::function<FrameStats()> subjects[] = {[&] { return planned_.pixels(pixels[0]); },
                                                        [&] { return other.pixels(pixels[1]); }};
        const FrameTable frames = time_interleaved(subjects, rounds_, stopped_);
        if (frames[0].empty()) return std::nullopt;
        if (change.empty() && pixels[0].rgba() != pixels[1].rgba())
            change = "encoded pixels differ";
        const std::vector<double> with = frame_ms(frames[0]), others = frame_ms(frames[1]);
        PlanGain gain{times_of(with), times_of(others), paired_difference(others, with), 0};
        gain.share = gain.saved.median / gain.without.median;
        return gain;
    }

private:
    const ReportInput& input_;
    const Rounds& rounds_;
    const MakeDrawing& make_;
    const std::function<bool()>& stopped_;
    const Drawing planned_;
    Framebuffer picture_;
    const PlanSavings saved_;
    const RenderPlan plan_;
};

void check_settings(const ReportInput& input) {
    if (input.settings.renderer != RendererKind::simd || input.settings.no_plan)
        throw Error(Errc::usage,
                    fmt::format("the rows of the plan are those of --renderer simd without "
                                "--no-plan, but scene '{}' asks for something else",
                                input.scene.name));
}

std::size_t measurements(const RenderPlan& plan) { return plan.rows.count() + 1; }

/// Fills `scene`; stops with what there is when asked to.
void measure_rows(PlanMeasurement& measurement, const Settings& settings, Steps& steps,
                  PlanSceneResult& scene) {
    for (const PlannedRow& row : measurement.rows()) {
        if (steps.watch.stopped()) return;
        PlanRowResult result{row, std::nullopt, {}};
        if (row.left_out) {
            steps.tell(fmt::format("{}: {}", scene.name, row.info->name));
            Settings without = settings;
            without.kept_rows.emplace(row.info->name);
            result.gain = measurement.measure(without, result.change);
            ++steps.done;
        }
        scene.rows.push_back(std::move(result));
    }
    if (steps.watch.stopped()) return;
    steps.tell(scene.name + ": the whole plan");
    Settings none = settings;
    none.no_plan = true;
    scene.whole_plan = measurement.measure(none, scene.whole_change);
    ++steps.done;
}

}  // namespace

std::string picture_change(const Framebuffer& a, const Framebuffer& b) {
    if (a.width != b.width || a.height != b.height) return "the sizes differ";
    const std::string changes[] = {
        plane_change("red", a.r, b.r, a.width), plane_change("green", a.g, b.g, a.width),
        plane_change("blue", a.b, b.b, a.width), plane_change("depth", a.depth, b.depth, a.width),
        plane_change("triangle", a.id, b.id, a.width)};
    for (const std::string& change : changes)
        if (!change.empty()) return change;
    return {};
}

std::vector<std::string> PlanReport::faults() const {
    std::vector<std::string> sentences;
    const auto add = [&](const std::string& scene, std::string_view row, const std::string& how) {
        if (!how.empty())
            sentences.push_back(
                fmt::format("scene '{}': {} changes the picture: {}", scene, row, how));
    };
    for (const PlanSceneResult& scene : scenes) {
        for (const PlanRowResult& row : scene.rows)
            add(scene.name, fmt::format("row '{}'", row.row.info->name), row.change);
        add(scene.name, "the whole plan", scene.whole_change);
    }
    return sentences;
}

PlanReport measure_plan(const std::vector<ReportInput>& inputs, const Rounds& rounds,
                        const Watch& watch, const MakeDrawing& make) {
    Steps steps{watch};
    for (const ReportInput& input : inputs) {
        check_settings(input);
        steps.all += measurements(make_plan(normalised(input.scene), input.settings));
    }
    PlanReport report;
    report.provenance =
        provenance(inputs.empty() ? Settings{} : inputs.front().settings, rounds.seed);
    for (const ReportInput& input : inputs) {
        if (watch.stopped()) break;
        steps.tell(input.scene.name + ": the picture");
        PlanMeasurement measurement(input, rounds, make, watch.stopped);
        const RenderPlan& plan = measurement.plan();
        report.scenes.push_back({input.scene.name,
                                 plan.width,
                                 plan.height,
                                 plan.samples_side * plan.samples_side,
                                 plan.triangles,
                                 input.scene.lights.size(),
                                 {},
                                 {},
                                 {}});
        measure_rows(measurement, input.settings, steps, report.scenes.back());
    }
    report.partial = watch.stopped();
    return report;
}

}  // namespace scanshade
