// scanshade render: draws a scene into a PNG file.
#include <fmt/format.h>

#include <utility>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/events.hpp"
#include "cli/progress.hpp"
#include "cli/stats.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/timer.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/report/timing.hpp"

namespace scanshade {
namespace {

struct RenderArgs {
    std::string input, output, stats;
    Settings settings;
    long long repeat = 1;
    bool verbose = false;
};

bool parse_args(OptionParser& options, char** args, RenderArgs& into) {
    options.positional("INPUT", into.input, "an .obj file or a .toml scene");
    options.required_text("-o,--output", "OUT.png", into.output,
                          "the picture; '-' is standard output");
    options.integer("--repeat", 1, 100'000, into.repeat,
                    "draw so many frames, each from the scene's arrays; the last is the picture");
    options.text("--stats", "FILE.json", into.stats,
                 "times of frames and stages, counts, what was left out, rare events, peak memory; "
                 "'-' is standard output");
    options.flag("--verbose", into.verbose, "say the plan, the times and all rare events");
    options.shared(into.settings);
    return options.parse(args);
}

/// Before anything is drawn that could then not be written.
void check_outputs(const RenderArgs& args) {
    check_picture_output(args.output, args.input);
    if (args.stats.empty()) return;
    check_output(args.stats, args.input);
    if (args.stats == args.output)
        throw Error(Errc::usage, "--output and --stats are the same; give each a name of its own");
}

void note_verbose(const Run& run) {
    for (const PlannedStage& stage : explain_stages(run.plan))
        note(fmt::format("stage: {} {}: {}", stage.name, stage.runs ? "runs" : "is left out",
                         stage.reason));
    for (const PlannedRow& row : explain_rows(run.plan, run.frames.back().saved))
        note(row.left_out ? fmt::format("plan: {} left out, {}: {}", row.info->name, row.amount(),
                                        row.reason)
                          : fmt::format("plan: {} done: {}", row.info->name, row.reason));
    for (const StageStats& stage : run.frames.back().stages)
        if (stage.ran)
            note(fmt::format("time: {} {:.3f} ms, {} {}", stage.name, stage.ms, stage.items,
                             stage.item_name));
    for (const EventRow& row : run.events) note("event: " + sentence(row));
}

std::string summary(const RenderArgs& args, const Run& run) {
    const double ms = median(frame_ms(run.frames));
    const std::string frames =
        run.frames.size() == 1
            ? fmt::format("{:.1f} ms", ms)
            : fmt::format("{:.1f} ms a frame (median of {})", ms, run.frames.size());
    return fmt::format("wrote {}, {} × {}, {} triangles, {}",
                       args.output == "-" ? "standard output" : args.output, run.plan.width,
                       run.plan.height, run.plan.triangles, frames);
}

}  // namespace

int run_render(OptionParser& options, char** raw_args) {
    RenderArgs args;
    if (!parse_args(options, raw_args, args)) return exit_done;
    check_outputs(args);

    Progress progress("loading " + args.input);
    const Timer load_timer;
    const Scene scene = load_scene(args.input, args.settings);
    Renderer renderer(scene, args.settings);
    const double load_ms = load_timer.ms();
    PixelBuffer pixels;
    std::vector<FrameStats> frames;
    for (long long i = 0; i < args.repeat; ++i) {
        progress.text(args.repeat == 1 ? fmt::format("drawing {}", args.input)
                                       : fmt::format("drawing {}, frame {} of {}", args.input,
                                                     i + 1, args.repeat));
        frames.push_back(renderer.draw(pixels));
    }
    progress.text("writing " + args.output);
    save_png(to_image(pixels), args.output);
    progress.finish();

    const Run run =
        describe_run(args.input, scene, args.settings, renderer.plan(), load_ms, std::move(frames));
    if (!args.stats.empty()) write_text(stats_json(run), args.stats);
    warn(scene.warnings);
    if (args.verbose) note_verbose(run);
    warn(event_warnings(run.events));
    note(summary(args, run));
    return exit_done;
}

}  // namespace scanshade
