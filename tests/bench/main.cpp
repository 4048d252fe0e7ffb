// scanshade-bench: our renderer beside Mesa's llvmpipe and Embree. `make bench` builds and runs it.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/kernels/isa.hpp"

namespace scanshade::bench {
namespace {

constexpr double busy_load = 0.5;  // processes that run beside us, before we start

struct Arguments {
    std::string cells = "all", commit = "unknown", build = "unknown";
    std::string mesh, folder = "build/bench";
    bool two_sided = false, keep_pictures = false;
};

int core_count() {
    cpu_set_t allowed;
    return ::sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
    return "unknown";
}

double load() {
    double average = 0;
    return ::getloadavg(&average, 1) == 1 ? average : 0;
}

void add_provenance(const Arguments& arguments, Report& report) {
    const auto add = [&](const char* key, std::string value) {
        report.provenance.emplace_back(key, std::move(value));
    };
    add("program", fmt::format("scanshade-bench {}", program_version));
    add("commit", arguments.commit);
    add("date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))));
    add("compiler", fmt::format("{}", __VERSION__));
    add("build", arguments.build);
    add("processor", processor());
    add("instruction sets", fmt::format("{}", fmt::join(instruction_sets(), " ")));
    add("threads", fmt::format("1 and {}", core_count()));
    add("load at the start", fmt::format("{:.2f}", load()));
    add("culling", arguments.two_sided ? "off for all" : "of back faces, for all");
}

/// Cells that share a scene and a number of threads.
std::vector<Group> groups_of(const std::vector<Cell>& cells, const Arguments& arguments) {
    std::vector<Group> groups;
    for (const Cell& cell : cells) {
        const int threads = cell.all_threads ? core_count() : 1;
        if (groups.empty() || groups.back().scene != cell.scene ||
            groups.back().cells.back().all_threads != cell.all_threads)
            groups.push_back({cell.scene,
                              arguments.mesh,
                              arguments.two_sided ? Cull::none : Cull::back,
                              threads,
                              {}});
        groups.back().cells.push_back(cell);
    }
    return groups;
}

int run(const Arguments& arguments) {
    const std::filesystem::path folder = arguments.folder;
    const std::vector<Cell> cells = select_cells(scene_names(arguments.mesh), arguments.cells);
    std::filesystem::create_directories(folder);
    Report report{{}, arguments.two_sided ? Cull::none : Cull::back, {}};
    add_provenance(arguments, report);
    if (load() > busy_load)
        note(fmt::format("warning: the machine is busy (load {:.2f}): times will be off", load()));
    const std::size_t known = report.provenance.size();
    for (const Group& group : groups_of(cells, arguments)) {
        Contest contest(group, folder, arguments.keep_pictures);
        if (report.provenance.size() == known)
            for (std::string& line : contest.about())
                report.provenance.emplace_back("rival", std::move(line));
        for (std::size_t i = 0; i < group.cells.size(); ++i) {
            note(fmt::format("{} of {}: {}", report.cells.size() + 1, cells.size(),
                             name_of(group.cells[i])));
            report.cells.push_back(contest.run(i));
        }
        write_files(report, folder);
    }
    for (const auto& [key, value] : report.provenance) print(fmt::format("{}: {}\n", key, value));
    print("\n" + text_table(report) + "\n");
    print(fmt::format("The same is in {0}/report.json, {0}/report.csv and {0}/report.md.\n",
                      folder.string()));
    print_finished();
    const std::vector<std::string> faults = disagreements(report);
    for (const std::string& fault : faults) note(fault);
    return faults.empty() ? exit_done : exit_different;
}

int run_with(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Scanshade beside llvmpipe and Embree: the same pictures, times and ratios.");
    app.add_option("--cells", arguments.cells, "all, quick, or patterns separated by commas");
    app.add_option("--mesh", arguments.mesh, "an OBJ file instead of the built-in scenes");
    app.add_flag("--two-sided", arguments.two_sided, "no culling, for all");
    app.add_flag("--pictures", arguments.keep_pictures, "write the pictures too");
    app.add_option("-o,--output", arguments.folder, "folder of the report");
    app.add_option("--commit", arguments.commit, "for the report: what was built");
    app.add_option("--build", arguments.build, "for the report: how it was built");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? exit_done : int(Errc::usage);
    }
    return run(arguments);
}

}  // namespace
}  // namespace scanshade::bench

int main(int argc, char** argv) {
    using namespace scanshade;
    return run_program("scanshade-bench", [&] { return bench::run_with(argc, argv); });
}
