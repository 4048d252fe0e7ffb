// scanshade explain: the plan, stage by stage and row by row.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/progress.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {
namespace {

std::string stages_table(const RenderPlan& plan, const FrameStats& frame) {
    std::vector<std::vector<std::string>> rows{{"stage", "", "worked on", "why"}};
    const std::vector<PlannedStage> stages = explain_stages(plan);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const StageStats& stats = frame.stages[i];
        rows.push_back({std::string(stages[i].name), stages[i].runs ? "runs" : "left out",
                        stats.ran ? fmt::format("{} {}", stats.items, stats.item_name) : "",
                        stages[i].reason});
    }
    return table(rows);
}

std::string rows_table(const RenderPlan& plan, const FrameStats& frame) {
    std::vector<std::vector<std::string>> rows{{"row of the plan", "", "saved", "why"}};
    for (const PlannedRow& row : explain_rows(plan, frame.saved))
        rows.push_back({std::string(row.info->name), row.left_out ? "left out" : "done",
                        row.left_out ? row.amount() : "", row.reason});
    return table(rows);
}

}  // namespace

int run_explain(OptionParser& options, char** args) {
    std::string input;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    Progress progress("loading " + input);
    const Scene scene = load_scene(input, settings);
    Renderer renderer(scene, settings);
    progress.text("drawing " + input);
    PixelBuffer pixels;
    const FrameStats frame = renderer.draw(pixels);
    progress.finish();
    warn(scene.warnings);

    const RenderPlan& plan = renderer.plan();
    print(stages_table(plan, frame));
    if (plan.renderer == RendererKind::simd) print("\n" + rows_table(plan, frame));
    print(fmt::format("\nCounts are those of one frame of {} × {} pixels and {} samples a pixel.\n",
                      plan.width, plan.height, plan.samples_side * plan.samples_side));
    return exit_done;
}

}  // namespace scanshade
