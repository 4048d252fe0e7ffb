#include "scanshade/report/stability_report.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scanshade/base/files.hpp"

namespace scanshade {
namespace {

std::string page_text(const StabilityReport& report, bool drawn) {
    Page page(
        "Stability",
        "What becomes of equations and of pictures where numbers are in danger: parameters at "
        "their extremes, angles that graze, lengths that cancel, scenes that are huge, tiny, "
        "far away or broken.");
    const std::vector<std::string> faults = report.faults();
    page.verdict(equation_verdict(report.equations), faults.empty());
    if (report.partial)
        page.notice(
            "This report is partial: the measurement was interrupted, and equations and scenes "
            "are missing.");
    for (const std::string& fault : faults) page.notice("Fault: " + fault);
    add_equation_sections(report.equations, drawn, page);
    page.sources(report.provenance, {"report.json", "stability.csv"});
    return page.text();
}

}  // namespace

std::vector<std::string> StabilityReport::faults() const { return equations.faults(); }

StabilityReport measure_stability(const std::vector<ReportInput>&, const Settings& settings,
                                  const Watch& watch) {
    StabilityReport report;
    report.provenance = provenance(settings, 0);
    report.equations = measure_equation_stability(watch);
    report.partial = report.equations.partial;
    return report;
}

std::vector<std::string> write_stability_report(const StabilityReport& report,
                                                const std::string& folder) {
    const std::filesystem::path path(folder);
    const Json scenes = equation_scenes_json(report.equations);
    write_file(report_json("stability", report.provenance, report.partial, scenes),
               path / "report.json");
    write_file(report_csv(scenes), path / "stability.csv");
    std::vector<std::string> warnings;
    const std::vector<Plot> plots = equation_plots(report.equations);
    if (std::string reason = draw_plots(plots, folder); !reason.empty())
        warnings.push_back(std::move(reason));
    write_file(page_text(report, warnings.empty()), path / "index.html");
    return warnings;
}

}  // namespace scanshade
