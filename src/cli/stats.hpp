// What a run of `scanshade render` found out: --stats.
#pragma once

#include <string>
#include <vector>

#include "cli/events.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/report/choose.hpp"

namespace scanshade {

/// Everything that --stats and --verbose tell. `plan` and `settings` stay where they are.
struct Run {
    std::string input;
    const Settings& settings;
    const RenderPlan& plan;
    double load_ms;
    std::vector<FrameStats> frames;  // at least one
    EventTotals totals;
    std::vector<EventRow> events;  // of loading and of the last frame
    std::size_t objects, lights;
    const Choice* choice = nullptr;  // with --max-error or --budget-ms
};

Run describe_run(std::string input, const Scene& scene, const Settings& settings,
                 const RenderPlan& plan, double load_ms, std::vector<FrameStats> frames);

/// The JSON text. Its keys are stable, scripts read them:
///     program input width height samples renderer interpolation
///     load_ms            reading the input, building meshes, making the plan
///     frames             how many were drawn (--repeat)
///     frame_ms           {median, min} over the frames
///     stages             [{name, ran, ms, items, item_name}]; ms is the median over the frames
///     counts             {objects, faces, triangles, vertices, materials, lights, covered_samples}
///     left_out           [{name, reason}] of stages, then [{name, reason, saved, of, unit}] of rows
///                        of the plan: what the last frame did without
///     tolerated_lights_in_tiles   left out under --tolerance, summed over tiles
///     events             [{name, meaning, count, rate, allowed_rate, among}], those that happened
///     peak_memory_bytes
///     choice             only with --max-error or --budget-ms: {option, limit, method, fits,
///                        calibration_ms, trial_ms, candidates: [{method, predicted_ms, off,
///                        slowest_ms}] (what is known of each), covered, checked, allowed}
std::string stats_json(const Run& run);

}  // namespace scanshade
