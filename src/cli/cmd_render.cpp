// scanshade render: draws a scene into a PNG file.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
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
#include "scanshade/report/choose.hpp"
#include "scanshade/report/timing.hpp"

namespace scanshade {
namespace {

struct RenderArgs {
    std::string input, output, stats;
    Settings settings;
    long long repeat = 1;
    std::optional<double> max_error, budget_ms;
    bool verbose = false;
};

bool parse_args(OptionParser& options, char** args, RenderArgs& into) {
    options.positional("INPUT", into.input, "an .obj file or a .toml scene");
    options.required_text("-o,--output", "OUT.png", into.output,
                          "the picture; '-' is standard output");
    options.integer("--repeat", 1, 100'000, into.repeat,
                    "draw so many frames, each from the scene's arrays; the last is the picture");
    options.real("--max-error", "L", 0, 255, into.max_error,
                 "choose the cheapest method that shows at most 0.1 % of the covered pixels off by "
                 "more than L levels of 255 against the reference, and check it");
    options.real("--budget-ms", "T", 1e-3, 1e9, into.budget_ms,
                 "choose the best method whose frames take at most T milliseconds");
    options.text("--stats", "FILE.json", into.stats,
                 "times of frames and stages, counts, what was left out, rare events, peak memory; "
                 "'-' is standard output");
    options.flag("--verbose", into.verbose, "say the plan, the times and all rare events");
    options.shared(into.settings);
    return options.parse(args);
}

/// What a choice of the method would overrule.
void check_choice(const RenderArgs& args) {
    if (!args.max_error && !args.budget_ms) return;
    if (args.max_error && args.budget_ms)
        throw Error(Errc::usage,
                    "--max-error and --budget-ms exclude each other; give one of them");
    for (const char* option : {"shading", "renderer", "interpolation"})
        if (args.settings.is_given(option))
            throw Error(Errc::usage,
                        fmt::format("--{} is chosen by {}; leave one of them out", option,
                                    args.max_error ? "--max-error" : "--budget-ms"));
}

/// Chooses the method where that was asked for, and puts it into the settings.
std::optional<Choice> choose_method(const Scene& scene, RenderArgs& args, Progress& progress) {
    const Tell tell = [&](const std::string& what) { progress.text(what); };
    std::optional<Choice> choice;
    if (args.max_error) choice = choose_by_error(scene, args.settings, *args.max_error, tell);
    if (args.budget_ms) choice = choose_by_time(scene, args.settings, *args.budget_ms, tell);
    if (choice) args.settings = settings_of(*choice->method, args.settings);
    return choice;
}

/// Why the method was chosen, and whether the frames are as fast as promised.
void note_choice(const Choice& choice, const Run& run) {
    for (const std::string& sentence : choice.sentences)
        note(fmt::format("--{} {:g}: {}", choice.option, choice.limit, sentence));
    if (choice.option != "budget-ms") return;
    const auto kept =
        std::count_if(run.frames.begin(), run.frames.end(),
                      [&](const FrameStats& frame) { return frame.frame_ms <= choice.limit; });
    note(fmt::format("--budget-ms {:g}: kept in {} of {} frames", choice.limit, kept,
                     run.frames.size()));
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

std::vector<FrameStats> draw_frames(Renderer& renderer, const RenderArgs& args, PixelBuffer& pixels,
                                    Progress& progress) {
    if (args.budget_ms) renderer.draw(pixels);  // warms up: the budget is for frames in a row
    std::vector<FrameStats> frames;
    for (long long i = 0; i < args.repeat; ++i) {
        progress.text(args.repeat == 1 ? fmt::format("drawing {}", args.input)
                                       : fmt::format("drawing {}, frame {} of {}", args.input,
                                                     i + 1, args.repeat));
        frames.push_back(renderer.draw(pixels));
    }
    return frames;
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
    check_choice(args);
    check_outputs(args);

    Progress progress("loading " + args.input);
    const Timer load_timer;
    const Scene scene = load_scene(args.input, args.settings);
    const double reading_ms = load_timer.ms();
    const std::optional<Choice> choice = choose_method(scene, args, progress);
    const Timer prepare_timer;
    Renderer renderer(scene, args.settings);
    const double load_ms = reading_ms + prepare_timer.ms();
    PixelBuffer pixels;
    std::vector<FrameStats> frames = draw_frames(renderer, args, pixels, progress);
    progress.text("writing " + args.output);
    save_png(to_image(pixels), args.output);
    progress.finish();

    Run run =
        describe_run(args.input, scene, args.settings, renderer.plan(), load_ms, std::move(frames));
    run.choice = choice ? &*choice : nullptr;
    if (!args.stats.empty()) write_text(stats_json(run), args.stats);
    warn(scene.warnings);
    if (args.verbose) note_verbose(run);
    warn(event_warnings(run.events));
    if (choice) note_choice(*choice, run);
    note(summary(args, run));
    return exit_done;
}

}  // namespace scanshade
