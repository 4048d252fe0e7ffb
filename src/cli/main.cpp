// scanshade COMMAND ...: finds the command and runs it.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"

namespace {

using namespace scanshade;

constexpr Command commands[] = {
    {"render", "INPUT -o OUT.png [options]", "draw a picture into a PNG file", run_render},
    {"view", "INPUT [options]", "look at it from all sides in a window", run_view},
    {"info", "INPUT [options]", "what is in the input: counts, materials, lights, defects",
     run_info},
    {"explain", "INPUT [options]", "every stage of drawing, run or left out, and why", run_explain},
    {"inspect", "INPUT --pixel X,Y [options]",
     "the equation at one pixel with its numbers, in float and in double", run_inspect},
    {"sheet", "INPUT -o OUT.png [options]", "one picture of every shading with every brdf",
     run_sheet},
    {"report", "error|plan|speed|stability [INPUT...] -o DIR [options]",
     "measure what approximations cost, what the plan saves, what a frame takes, or where numbers "
     "are in danger",
     run_report},
    {"compare", "A.png B.png [options]", "how much two pictures differ", run_compare},
    {"brdf", "list | show NAME [-o DIR] [--set NAME=V]",
     "the reflection models: equation, parameters, promises, values, a page of plots", run_brdf},
    {"lesson", "list | NAME | all -o DIR", "pages that teach shading, with pictures and plots",
     run_lesson},
};

std::string help() {
    std::vector<std::vector<std::string>> rows;
    for (const Command& command : commands)
        rows.push_back({fmt::format("  scanshade {} {}", command.name, command.usage),
                        std::string(command.summary)});
    return "Draws polygon meshes with classic local illumination, on the CPU.\n\nUsage:\n" +
           table(rows) +
           "\nINPUT is an .obj file or a .toml scene. 'scanshade COMMAND --help' lists a command's "
           "options.\n\n"
           "Exit status:\n"
           "  0  done\n"
           "  1  pictures differ by more than allowed, or a check failed\n"
           "  2  usage: an unknown command or option, a value out of range\n"
           "  3  file: cannot be read or written\n"
           "  4  format: the content of a file is damaged or not supported\n"
           "  5  scene: it cannot be drawn as described, or memory does not suffice\n"
           "  130  interrupted, 143 terminated; a report holds what was measured so far\n";
}

int unknown(std::string_view word) {
    std::vector<std::string_view> names;
    for (const Command& command : commands) names.push_back(command.name);
    if (word.starts_with('-'))
        throw Error(Errc::usage,
                    fmt::format("option '{}' is unknown before a command; 'scanshade --help' "
                                "lists the commands",
                                word));
    if (word.ends_with(".obj") || word.ends_with(".toml"))
        throw Error(Errc::usage,
                    fmt::format("'{}' is no command; 'scanshade render {} -o OUT.png' draws it",
                                word, word));
    throw Error(Errc::usage,
                fmt::format("command '{}' is unknown{}", word, suggestion(word, names)));
}

int run(int argc, char** argv) {
    const std::string_view word = argc > 1 ? argv[1] : "--help";
    if (word == "--help" || word == "-h" || word == "help") {
        print(help());
        return exit_done;
    }
    if (word == "--version") {
        print(fmt::format("scanshade {}\n", program_version));
        return exit_done;
    }
    for (const Command& command : commands) {
        if (command.name != word) continue;
        OptionParser options(fmt::format("scanshade {}", word), command.usage, command.summary);
        return command.run(options, argv + 2);
    }
    return unknown(word);
}

}  // namespace

int main(int argc, char** argv) {
    end_in_order_on_signals();
    return run_program("scanshade", [&] { return run(argc, argv); });
}
