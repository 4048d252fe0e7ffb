// scanshade explain: the plan, stage by stage.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/progress.hpp"
#include "scanshade/render/plan.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

int run_explain(OptionParser& options, char** args) {
    std::string input;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    Progress progress("loading " + input);
    const Scene scene = load_scene(input, settings);
    const RenderPlan plan = make_plan(normalised(scene), settings);
    progress.finish();
    warn(scene.warnings);

    std::vector<std::vector<std::string>> rows{{"stage", "", "why"}};
    for (const PlanLine& line : explain(plan))
        rows.push_back({std::string(line.stage), line.runs ? "runs" : "left out", line.reason});
    print(table(rows));
    return exit_done;
}

}  // namespace scanshade
