#include "cli/stats.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/console.hpp"
#include "scanshade/base/memory.hpp"
#include "scanshade/report/timing.hpp"

namespace scanshade {
namespace {

using Json = nlohmann::ordered_json;

Json frame_json(const std::vector<FrameStats>& frames) {
    const Times times = times_of(frame_ms(frames));
    return {{"median", times.median}, {"min", times.min}};
}

/// Times are medians over the frames, stage by stage; counts are those of the last frame.
Json stages_json(const std::vector<FrameStats>& frames) {
    Json stages = Json::array();
    const std::vector<StageStats>& last = frames.back().stages;
    for (std::size_t s = 0; s < last.size(); ++s) {
        const auto ms = [s](const FrameStats& frame) { return frame.stages[s].ms; };
        stages.push_back({{"name", last[s].name},
                          {"ran", last[s].ran},
                          {"ms", median(of_frames(frames, ms))},
                          {"items", last[s].items},
                          {"item_name", last[s].item_name}});
    }
    return stages;
}

Json left_out_json(const RenderPlan& plan, const PlanSavings& saved) {
    Json rows = Json::array();
    for (const PlannedStage& stage : explain_stages(plan))
        if (!stage.runs) rows.push_back({{"name", stage.name}, {"reason", stage.reason}});
    for (const PlannedRow& row : explain_rows(plan, saved))
        if (row.left_out)
            rows.push_back({{"name", row.info->name},
                            {"reason", row.reason},
                            {"saved", row.saving.saved},
                            {"of", row.saving.of},
                            {"unit", row.info->unit}});
    return rows;
}

Json events_json(const std::vector<EventRow>& rows) {
    Json events = Json::array();
    for (const EventRow& row : rows)
        events.push_back({{"name", row.info->name},
                          {"meaning", row.info->meaning},
                          {"count", row.count},
                          {"rate", row.rate},
                          {"allowed_rate", row.info->allowed_rate},
                          {"among", row.info->among}});
    return events;
}

Json choice_json(const Choice& choice) {
    Json candidates = Json::array();
    for (const Candidate& candidate : choice.candidates) {
        Json row = {{"method", candidate.method->name}, {"predicted_ms", candidate.predicted_ms}};
        if (candidate.off) row["off"] = *candidate.off;
        if (candidate.slowest_ms) row["slowest_ms"] = *candidate.slowest_ms;
        candidates.push_back(std::move(row));
    }
    return {{"option", choice.option},
            {"limit", choice.limit},
            {"method", choice.method->name},
            {"fits", choice.fits},
            {"calibration_ms", choice.calibration_ms},
            {"trial_ms", choice.trial_ms},
            {"candidates", std::move(candidates)},
            {"covered", choice.covered},
            {"checked", choice.checked},
            {"allowed", choice.allowed}};
}

}  // namespace

Run describe_run(std::string input, const Scene& scene, const Settings& settings,
                 const RenderPlan& plan, double load_ms, std::vector<FrameStats> frames) {
    const EventTotals totals = event_totals(scene, frames.back().covered_samples);
    EventCounts counts = scene.events;
    counts += frames.back().events;
    return {std::move(input),
            settings,
            plan,
            load_ms,
            std::move(frames),
            totals,
            event_rows(counts, totals),
            scene.objects.size(),
            scene.lights.size()};
}

std::string stats_json(const Run& run) {
    Json json = {
        {"program", fmt::format("scanshade {}", program_version)},
        {"input", run.input},
        {"width", run.plan.width},
        {"height", run.plan.height},
        {"samples", run.plan.samples_side * run.plan.samples_side},
        {"renderer", renderer_names()[std::size_t(run.plan.renderer)]},
        {"interpolation", interpolation_names()[std::size_t(run.plan.interpolation)]},
        {"load_ms", run.load_ms},
        {"frames", run.frames.size()},
        {"frame_ms", frame_json(run.frames)},
        {"stages", stages_json(run.frames)},
        {"counts",
         {{"objects", run.objects},
          {"faces", run.totals.faces},
          {"triangles", run.totals.triangles},
          {"vertices", run.totals.vertices},
          {"materials", run.totals.materials},
          {"lights", run.lights},
          {"covered_samples", run.totals.samples}}},
        {"left_out", left_out_json(run.plan, run.frames.back().saved)},
        {"tolerated_lights_in_tiles", run.frames.back().tolerated_lights},
        {"events", events_json(run.events)},
        {"peak_memory_bytes", peak_memory_bytes()},
    };
    if (run.choice) json["choice"] = choice_json(*run.choice);
    // Names from files need not be UTF-8; what is not becomes U+FFFD.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scanshade
