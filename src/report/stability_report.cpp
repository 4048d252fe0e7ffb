#include "scanshade/report/stability_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scanshade/base/files.hpp"

namespace scanshade {
namespace {

std::string picture_verdict(const PictureStability& pictures) {
    const std::size_t faults = pictures.faults().size(), cases = pictures.cases.size();
    if (cases == 0) return "No scene was drawn.";
    if (faults > 0) return fmt::format("{} bounds of {} hard scenes are broken.", faults, cases);
    return fmt::format(
        "{}{} hard scenes keep what they are held to, in every renderer and on every "
        "instruction set.",
        pictures.partial ? "" : "All ", cases);
}

std::string page_text(const StabilityReport& report, bool drawn) {
    Page page(
        "Stability",
        "What becomes of equations and of pictures where numbers are in danger: parameters at "
        "their extremes, angles that graze, lengths that cancel, scenes that are huge, tiny, "
        "far away or broken.");
    const std::vector<std::string> faults = report.faults();
    page.verdict(equation_verdict(report.equations) + " " + picture_verdict(report.pictures),
                 faults.empty());
    if (report.partial)
        page.notice(
            "This report is partial: the measurement was interrupted, and equations and scenes "
            "are missing.");
    for (const std::string& fault : faults) page.notice("Fault: " + fault);
    add_equation_sections(report.equations, drawn, page);
    add_picture_section(report.pictures, drawn, page);
    page.sources(report.provenance, {"report.json", "stability.csv"});
    return page.text();
}

}  // namespace

std::vector<std::string> StabilityReport::faults() const {
    std::vector<std::string> all = equations.faults();
    for (std::string& fault : pictures.faults()) all.push_back(std::move(fault));
    return all;
}

StabilityReport measure_stability(const std::vector<ReportInput>& scenes, const Settings& settings,
                                  const Watch& watch, const MakeDrawing& make) {
    StabilityReport report;
    report.provenance = provenance(settings, 0);
    report.equations = measure_equation_stability(watch);
    report.pictures = measure_picture_stability(scenes, watch, make);
    report.partial = report.equations.partial || report.pictures.partial;
    return report;
}

std::vector<std::string> write_stability_report(const StabilityReport& report,
                                                const std::string& folder) {
    const std::filesystem::path path(folder);
    Json scenes = equation_scenes_json(report.equations);
    for (Json& scene : picture_scenes_json(report.pictures)) scenes.push_back(std::move(scene));
    write_file(report_json("stability", report.provenance, report.partial, scenes),
               path / "report.json");
    write_file(report_csv(scenes), path / "stability.csv");
    write_pictures(report.pictures, folder);
    std::vector<Plot> plots = equation_plots(report.equations);
    for (Plot& plot : picture_plots(report.pictures)) plots.push_back(std::move(plot));
    std::vector<std::string> warnings;
    if (std::string reason = draw_plots(plots, folder); !reason.empty())
        warnings.push_back(std::move(reason));
    write_file(page_text(report, warnings.empty()), path / "index.html");
    return warnings;
}

}  // namespace scanshade
