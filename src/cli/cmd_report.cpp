// scanshade report: measurements, as a folder with a page, plots, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/shipped.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/report/error_report.hpp"
#include "scanshade/report/plan_report.hpp"
#include "scanshade/report/speed_report.hpp"
#include "scanshade/report/stability_report.hpp"

namespace scanshade {
namespace fs = std::filesystem;
namespace {

struct ReportArgs {
    std::string kind, folder;
    std::vector<std::string> inputs;
    Settings settings;
    long long runs = 9, seed = 1;
};

/// What a report came to.
struct Written {
    std::vector<std::string> warnings, faults;
    bool partial;
};

struct ReportKind {
    std::string_view name;
    bool shipped;  // without an INPUT, of the shipped scenes
    Written (*run)(const std::vector<ReportInput>&, const ReportArgs&, const Rounds&, const Watch&);
};

Written report_plan(const std::vector<ReportInput>& inputs, const ReportArgs& args,
                    const Rounds& rounds, const Watch& watch) {
    const PlanReport report = measure_plan(inputs, rounds, watch);
    return {write_plan_report(report, args.folder), report.faults(), report.partial};
}

Written report_speed(const std::vector<ReportInput>& inputs, const ReportArgs& args,
                     const Rounds& rounds, const Watch& watch) {
    const SpeedReport report = measure_speed(inputs, args.settings, rounds, watch);
    return {write_speed_report(report, args.folder), {}, report.partial};
}

Written report_stability(const std::vector<ReportInput>& inputs, const ReportArgs& args,
                         const Rounds&, const Watch& watch) {
    const StabilityReport report = measure_stability(inputs, args.settings, watch);
    return {write_stability_report(report, args.folder), report.faults(), report.partial};
}

Written report_error(const std::vector<ReportInput>& inputs, const ReportArgs& args,
                     const Rounds& rounds, const Watch& watch) {
    const auto keep = [&](const std::string& file, const Image& image) {
        save_png(image, fs::path(args.folder) / file);
    };
    const ErrorReport report = measure_error(inputs, args.settings, rounds, watch, keep);
    return {write_error_report(report, args.folder), {}, report.partial};
}

constexpr ReportKind kinds[] = {
    {"plan", true, report_plan},
    {"speed", true, report_speed},
    {"error", true, report_error},
    {"stability", false, report_stability},
};

const ReportKind& find_kind(const std::string& name) {
    std::vector<std::string_view> names;
    for (const ReportKind& kind : kinds) {
        if (kind.name == name) return kind;
        names.push_back(kind.name);
    }
    throw Error(Errc::usage,
                fmt::format("'report {}' is unknown{}", name, suggestion(name, names)));
}

// ---- scenes

std::vector<std::string> shipped_scenes() {
    std::vector<std::string> scenes;
    for (const auto& entry : fs::directory_iterator(shipped_folder("scenes", "name an INPUT")))
        if (entry.path().extension() == ".toml") scenes.push_back(entry.path().string());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

std::vector<ReportInput> load_inputs(const ReportArgs& args, const ReportKind& kind,
                                     Progress& progress) {
    std::vector<ReportInput> inputs;
    const bool shipped = args.inputs.empty() && kind.shipped;
    for (const std::string& path : shipped ? shipped_scenes() : args.inputs) {
        progress.text("loading " + path);
        inputs.push_back({{}, args.settings});
        inputs.back().scene = load_scene(path, inputs.back().settings);
    }
    return inputs;
}

// ---- what a person sees

std::string seconds(double s) {
    return s < 90 ? fmt::format("{:.0f} s", s) : fmt::format("{:.0f} min", s / 60);
}

/// Tells the progress line, with a guess of the time left from the time that was needed so far.
Watch watch_on(Progress& progress, const Timer& timer) {
    Watch watch;
    watch.stopped = Interrupt::came;
    watch.tell = [&progress, &timer](const std::string& what, std::size_t done, std::size_t all) {
        std::string text = fmt::format("measuring {}, {} of {}", what, done + 1, all);
        if (done > 0)
            text += fmt::format(", about {} left",
                                seconds(timer.ms() / 1000 * double(all - done) / double(done)));
        progress.text(std::move(text));
    };
    return watch;
}

bool parse_args(OptionParser& options, char** args, ReportArgs& into) {
    options.positional("KIND", into.kind,
                       "plan: what each row of the plan saves, and that it changes no picture; "
                       "speed: the time of all stages against pixels, triangles, lights, samples "
                       "and threads; error: what each approximation costs in error and saves in "
                       "time; stability: errors of equations and of pictures where numbers are in "
                       "danger");
    options.optional_positionals("INPUT", into.inputs,
                                 ".obj files or .toml scenes; else those of models/scenes, but for "
                                 "stability none besides its own hard cases");
    options.required_text("-o,--output", "DIR", into.folder,
                          "folder for index.html, report.json, a CSV and plots; made where it is "
                          "not there");
    options.integer("--runs", 1, 10'000, into.runs, "frames of each thing that is timed");
    options.integer("--seed", 0, 1'000'000'000, into.seed, "of the order in which they take turns");
    options.shared(into.settings);
    return options.parse(args);
}

}  // namespace

int run_report(OptionParser& options, char** argv) {
    ReportArgs args;
    if (!parse_args(options, argv, args)) return exit_done;
    const ReportKind& kind = find_kind(args.kind);
    const Interrupt interrupt;
    make_folder(args.folder);

    Progress progress("loading");
    const std::vector<ReportInput> inputs = load_inputs(args, kind, progress);
    const Timer timer;
    const Rounds rounds{1, std::size_t(args.runs), std::uint64_t(args.seed)};
    const Written written = kind.run(inputs, args, rounds, watch_on(progress, timer));
    progress.finish();

    for (const ReportInput& input : inputs) warn(input.scene.warnings);
    warn(written.warnings);
    for (const std::string& fault : written.faults) note("fault: " + fault);
    note(fmt::format("wrote {}{}", (fs::path(args.folder) / "index.html").string(),
                     written.partial ? ", partial because it was interrupted" : ""));
    if (!written.faults.empty()) return exit_different;
    return written.partial ? Interrupt::status() : int(exit_done);
}

}  // namespace scanshade
