// The stability report as files.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scanshade/report/stability_report.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Equations and models without a single picture.
StabilityReport equations_only() {
    StabilityReport report;
    report.provenance = provenance({}, 0);
    report.equations = measure_equation_stability({});
    return report;
}

std::string page_of(const StabilityReport& report) {
    const TempFolder folder;
    write_stability_report(report, folder.path);
    return text_of(folder.path / "index.html");
}

}  // namespace

TEST_CASE("the stability report has a row for each form in each type of number",
          "[stability][report]") {
    const TempFolder folder;
    const StabilityReport report = equations_only();
    const std::vector<std::string> warnings = write_stability_report(report, folder.path);
    CAPTURE(warnings);
    CHECK(warnings.empty());
    const auto json = nlohmann::json::parse(text_of(folder.path / "report.json"));
    CHECK(json["report"] == "stability");
    CHECK(json["partial"] == false);
    const auto& rows = json["scenes"][0]["rows"];
    CHECK(rows.size() == 4 * report.equations.equations.size());
    CHECK(rows[0]["axis"] == "equations");
    CHECK(rows[0]["method"] == "printed f32");
    CHECK(rows[0]["parameters"]["of"] == "A3");
    CHECK(rows[0]["error"]["ulp"] > 1e6);
    CHECK(rows[2]["method"] == "ours f32");
    CHECK(rows[2]["error"]["ulp"] < 6);
    CHECK(rows[2]["bound_ulp"]["most"] == 6);
    CHECK(rows[2]["bound_ulp"]["share"] < 1);
    const std::string csv = text_of(folder.path / "stability.csv");
    CHECK(csv.find("error.ulp") != std::string::npos);
    const std::string page = text_of(folder.path / "index.html");
    for (const Plot& plot : equation_plots(report.equations)) {
        CAPTURE(plot.file);
        CHECK(std::filesystem::file_size(folder.path / plot.file) > 2000);
        CHECK(page.find(plot.file) != std::string::npos);
    }
}

TEST_CASE("the stability page begins with its verdict", "[stability][report]") {
    StabilityReport report = equations_only();
    const std::string good = page_of(report);
    const std::size_t verdict = good.find("class=\"verdict\"");
    REQUIRE(verdict != std::string::npos);
    CHECK(verdict < good.find("<h2"));
    CHECK(good.find("keeps its error bound at all extremes") != std::string::npos);
    CHECK(good.find("is partial") == std::string::npos);

    report.equations.equations[1].ours_f64.over = 2;
    REQUIRE(report.faults().size() == 1);
    const std::string bad = page_of(report);
    CHECK(bad.find("class=\"verdict failed\"") != std::string::npos);
    CHECK(bad.find("Fault: A3 azimuth all around: 2 of ") != std::string::npos);
    report.partial = true;
    CHECK(page_of(report).find("is partial") != std::string::npos);
}

TEST_CASE("a stability report that was stopped at once is still a report", "[stability][report]") {
    Watch watch;
    watch.stopped = [] { return true; };
    const StabilityReport report = measure_stability({}, {}, watch);
    CHECK(report.partial);
    CHECK(report.faults().empty());
    const std::string page = page_of(report);
    CHECK(page.find("is partial") != std::string::npos);
    CHECK(page.find("No equation was measured. No scene was drawn.") != std::string::npos);
}
