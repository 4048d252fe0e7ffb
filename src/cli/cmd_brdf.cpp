// scanshade brdf: the registry of reflection models, printed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/brdf/brdf.hpp"

namespace scanshade {
namespace {

std::string_view kind_name(ParamKind kind) {
    constexpr std::string_view names[] = {"R,G,B", "number", "exponent",
                                          "choice"};  // in the enum's order
    return names[std::size_t(kind)];
}

std::string list() {
    std::vector<std::vector<std::string>> rows;
    for (const BrdfInfo* brdf : all_brdfs())
        rows.push_back({std::string(brdf->name), std::string(brdf->title)});
    rows.push_back({"unlit", "no model: the diffuse colour, whatever the light"});
    return table(rows);
}

std::string parameters(const BrdfInfo& brdf) {
    std::vector<std::vector<std::string>> rows{
        {"  name", "symbol", "kind", "range", "default", "unit", "meaning"}};
    for (const ParamInfo& p : brdf.params)
        rows.push_back({fmt::format("  {}", p.name), std::string(p.symbol),
                        std::string(kind_name(p.kind)),
                        p.names.empty() ? fmt::format("{:g} to {:g}", p.min, p.max)
                                        : fmt::format("{}", fmt::join(p.names, " ")),
                        value_text(p, p.standard), std::string(p.unit.empty() ? "1" : p.unit),
                        std::string(p.meaning)});
    return table(rows);
}

std::string_view energy_text(Energy energy) {
    constexpr std::string_view texts[] = {
        "conserves energy: reflects at most what arrives",
        "conserves energy where the diffuse and the specular parameter sum to at most 1",
        "may reflect more energy than arrives, for some parameters in range",
    };  // in the enum's order
    return texts[std::size_t(energy)];
}

std::string show(const BrdfInfo& brdf) {
    const Promises& promises = brdf.promises;
    return fmt::format(
               "{}: {}\n\nEquation\n  {}\n\nParameters (--set NAME=VALUE, or in a [[material]])\n",
               brdf.name, brdf.title, brdf.equation) +
           parameters(brdf) +
           fmt::format("\nPromises\n  {}\n  {}\n\nSource\n  {}\n",
                       promises.reciprocal
                           ? "reciprocal: f_r(ω_i, ω_o) = f_r(ω_o, ω_i)"
                           : "not reciprocal: f_r(ω_i, ω_o) and f_r(ω_o, ω_i) may differ",
                       energy_text(promises.energy), brdf.source);
}

const BrdfInfo& known_brdf(std::string_view name) {
    if (const BrdfInfo* brdf = find_brdf(name)) return *brdf;
    std::vector<std::string_view> names;
    for (const BrdfInfo* brdf : all_brdfs()) names.push_back(brdf->name);
    throw Error(Errc::usage, fmt::format("brdf '{}' is unknown{}", name, suggestion(name, names)));
}

}  // namespace

int run_brdf(OptionParser& options, char** args) {
    std::string action, name;
    options.positional("ACTION", action, "'list' for all models, 'show' for one");
    options.optional_positional("NAME", name, "the model to show");
    if (!options.parse(args)) return exit_done;
    const bool is_show = action == "show";
    if (!is_show && action != "list") {
        const std::string_view actions[] = {"list", "show"};
        throw Error(Errc::usage,
                    fmt::format("'brdf {}' is unknown{}", action, suggestion(action, actions)));
    }
    if (is_show && name.empty())
        throw Error(Errc::usage, "'brdf show' needs a name; 'scanshade brdf list' shows them all");
    if (!is_show && !name.empty())
        throw Error(
            Errc::usage,
            fmt::format("'brdf list' takes no name; 'scanshade brdf show {}' shows one model",
                        name));
    print(is_show ? show(known_brdf(name)) : list());
    return exit_done;
}

}  // namespace scanshade
