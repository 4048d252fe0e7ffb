// scanshade brdf: the registry of reflection models, printed.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "report/brdf_page.hpp"
#include "report/brdf_values.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/brdf/brdf.hpp"

namespace scanshade {
namespace {

std::string list() {
    std::vector<std::vector<std::string>> rows;
    for (const BrdfInfo* brdf : all_brdfs())
        rows.push_back({std::string(brdf->name), std::string(brdf->title)});
    rows.push_back({"unlit", "no model: the diffuse colour, whatever the light"});
    return table(rows);
}

std::string parameters(const BrdfInfo& brdf, const MaterialParams<double>& here) {
    std::vector<std::vector<std::string>> rows{
        {"  name", "symbol", "kind", "range", "default", "here", "unit", "meaning"}};
    for (std::size_t i = 0; i < brdf.params.size(); ++i) {
        const ParamInfo& p = brdf.params[i];
        rows.push_back({fmt::format("  {}", p.name), std::string(p.symbol),
                        std::string(kind_text(p)), range_text(p), value_text(p, p.standard),
                        value_text(p, here.value[i][0]), std::string(p.unit.empty() ? "1" : p.unit),
                        std::string(p.meaning)});
    }
    return table(rows);
}

/// f_r in the plane of incidence and the albedo, of the first channel.
std::string values(const BrdfInfo& brdf, const MaterialParams<double>& here) {
    constexpr double lights[] = {0, 30, 45, 60, 75, 85};
    constexpr double viewers[] = {-85, -60, -30, 0, 30, 45, 60, 75, 85};
    constexpr double degree = 3.14159265358979323846 / 180;
    std::vector<std::vector<std::string>> rows{{"  θ_o"}};
    for (const double light : lights) rows[0].push_back(fmt::format("θ_i = {:g}°", light));
    rows[0].push_back("albedo");
    for (const double viewer : viewers) {
        rows.push_back({fmt::format("  {:g}°", viewer)});
        const double theta_o = std::abs(viewer) * degree;
        for (const double light : lights) {
            const ViewedFrom at{light * degree, theta_o, viewer > 0 ? 180 * degree : 0};
            rows.back().push_back(
                fmt::format("{:.4g}", f_cos_at(brdf, here, at) / std::cos(at.theta_i)));
        }
        rows.back().push_back(fmt::format("{:.3f}", albedo(brdf, here, theta_o)));
    }
    return table(rows);
}

std::string show(const BrdfInfo& brdf, const MaterialParams<double>& here) {
    return fmt::format(
        "{}: {}\n\nEquation\n  {}\n\nParameters (--set NAME=VALUE, or in a [[material]])\n{}\n"
        "Promises\n  {}\n  {}\n\nValues of f_r in 1/sr, light and viewer on opposite sides of the "
        "normal, θ_o < 0 on the same\n{}\nSource\n  {}\n",
        brdf.name, brdf.title, brdf.equation, parameters(brdf, here),
        reciprocity_text(brdf.promises), energy_text(brdf.promises), values(brdf, here),
        brdf.source);
}

/// FOLDER/index.html; makes the folder where it is not there.
void write_page(const BrdfInfo& brdf, const std::vector<ParamSetting>& set,
                const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
        throw Error(Errc::file, fmt::format("the folder cannot be made: {}", failed.message()))
            .at(folder);
    const std::string path = (std::filesystem::path(folder) / "index.html").string();
    check_output(path, {});
    write_text(brdf_page(brdf, set), path);
    note(fmt::format("wrote {}", path));
}

const BrdfInfo& known_brdf(std::string_view name) {
    if (const BrdfInfo* brdf = find_brdf(name)) return *brdf;
    std::vector<std::string_view> names;
    for (const BrdfInfo* brdf : all_brdfs()) names.push_back(brdf->name);
    throw Error(Errc::usage, fmt::format("brdf '{}' is unknown{}", name, suggestion(name, names)));
}

}  // namespace

int run_brdf(OptionParser& options, char** args) {
    std::string action, name, folder;
    Settings settings;
    options.positional("ACTION", action, "'list' for all models, 'show' for one");
    options.optional_positional("NAME", name, "the model to show");
    options.text("-o,--output", "DIR", folder,
                 "write a page about the model into DIR/index.html: plots and lit spheres");
    constexpr std::string_view shared[] = {"set"};
    options.shared(settings, shared);
    if (!options.parse(args)) return exit_done;
    if (action == "list") {
        if (!name.empty())
            throw Error(
                Errc::usage,
                fmt::format("'brdf list' takes no name; 'scanshade brdf show {}' shows one model",
                            name));
        print(list());
        return exit_done;
    }
    if (action != "show") {
        constexpr std::string_view actions[] = {"list", "show"};
        throw Error(Errc::usage,
                    fmt::format("'brdf {}' is unknown{}", action, suggestion(action, actions)));
    }
    if (name.empty())
        throw Error(Errc::usage, "'brdf show' needs a name; 'scanshade brdf list' shows them all");
    const BrdfInfo& brdf = known_brdf(name);
    const ResolvedMaterial material = resolve_material({}, brdf.name, settings.set);
    if (!folder.empty()) write_page(brdf, settings.set, folder);
    print(show(brdf, material.params));
    for (const std::string& sentence : material.mapped) note(sentence);
    return exit_done;
}

}  // namespace scanshade
