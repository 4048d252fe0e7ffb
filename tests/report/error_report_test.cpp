// The error report: what is said of measurements, and its files.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/error_rows.hpp"
#include "scanshade/report/document.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

ErrorMethod named(const std::string& name, bool as_given = false) {
    ErrorMethod method;
    method.name = method.series = name;
    method.as_given = as_given;
    return method;
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("the front has the rows that none is better than", "[report]") {
    std::vector<ErrorRow> rows{
        row_with(named("fast"), 1, 0.5),      row_with(named("good"), 10, 0.01),
        row_with(named("beaten"), 11, 0.02),  row_with(named("between"), 3, 0.1),
        row_with(named("as fast"), 1, 0.6),   row_with(named("twin"), 3, 0.1),
        row_with(named("no time"), 0, 0.0001)};
    rows.back().time.reset();
    mark_front(rows);
    std::string front;
    for (const ErrorRow& row : rows)
        if (row.on_front) front += row.method.name + " ";
    CHECK(front == "fast good between twin ");
}

TEST_CASE("the verdict says what is as good and takes less time", "[report]") {
    const ErrorAxis& axis = axis_named("interpolation");
    ErrorSceneResult scene{"s", 8, 8, {{&axis, {}, {}, 0, {}, {}, {}}}, {}};
    std::vector<ErrorRow>& rows = scene.axes[0].rows;
    rows = {row_with(named("X"), 1, 0.101), row_with(named("Y", true), 3, 0.1),
            row_with(named("Z"), 9, 0.01)};
    CHECK(
        verdict_of(scene).at(0) ==
        "Interpolation: for this scene, X is as good as Y at a third of the time (1 ms instead of "
        "3 ms). Z has 0.1 of the error of what it asks for, at 3 times the time.");
    rows[0] = row_with(named("X"), 1, 0.11);  // too far off
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0] = row_with(named("X"), 12, 0.09);
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0] = row_with(named("X"), 12, 0.099);
    CHECK(verdict_of(scene).at(0).find("Y is as good as X at a quarter of the time (3 ms instead "
                                       "of 12 ms). Nothing as good is faster.") !=
          std::string::npos);
    rows[0] = row_with(named("X"), 1, 0.2, 0);  // whatever its error, nobody sees it
    CHECK(verdict_of(scene).at(0).find("X is as good as Y") != std::string::npos);
    CHECK(verdict_of(scene).at(0).find("no pixel is off by more than a level") !=
          std::string::npos);
    // Half of the runs say the opposite: that may be chance.
    rows[0].run_ms = {1, 9, 1, 9, 1, 1, 9, 1, 1};
    rows[1].run_ms = {3, 3, 3, 3, 3, 3, 3, 3, 3};
    CHECK(verdict_of(scene).at(0).find("nothing as good as Y is faster") != std::string::npos);
    rows[0].run_ms = {1, 9, 1, 1, 1, 1, 1, 1, 1};
    CHECK(verdict_of(scene).at(0).find("X is as good as Y") != std::string::npos);
    for (ErrorRow& row : rows) row.time.reset();
    CHECK(verdict_of(scene).empty());
}

TEST_CASE("the verdict on a sphere says what finer polygons bring", "[report]") {
    const ErrorStudy study = convergence_studies({}).front();
    ErrorSceneResult scene{"s", 8, 8, {{study.axis, {}, {}, 0, {}, {}, {}}}, {}};
    for (const double n : {4, 8, 16}) {
        ErrorMethod method = named("phong", n == 8);
        method.amount = n;
        scene.axes[0].rows.push_back(row_with(method, n, 1 / n));
        scene.axes[0].rows.back().regions[1].values[metric_index("mae")] = 1 / (n * n);
    }
    finish_orders(scene.axes[0]);
    REQUIRE(verdict_of(scene).size() == 1);
    CHECK(verdict_of(scene)[0].find("what both pictures cover by 4.0 (phong).") !=
          std::string::npos);
}

TEST_CASE("the error report's files have every row, and say when they are partial", "[report]") {
    ErrorReport report{provenance({}, 1), true, {}};
    report.scenes.push_back({"a <b>", 80, 60, {measured("aliasing", matt_teapot()).result}, {}});
    report.scenes.back().verdict = verdict_of(report.scenes.back());
    report.scenes.push_back({"early", 80, 60, {}, {}});
    const TempFolder folder;
    CHECK(write_error_report(report, folder.path).empty());
    const Json json = Json::parse(text_of(folder.path / "report.json"));
    CHECK(json["report"] == "error");
    CHECK(json["partial"] == true);
    const Json& scene = json["scenes"][0];
    CHECK(scene["references"][0]["own_rmse"] > 0.0);
    REQUIRE(scene["rows"].size() == 4);
    for (const Json& row : scene["rows"]) {
        CHECK(row["axis"] == "aliasing");
        CHECK(row["parameters"].contains("samples"));
        CHECK(row["time_ms"]["runs"] == 1);
        CHECK(row["efficiency"] > 0.0);
        for (const char* region : {"all", "covered", "interior", "silhouette"})
            for (const Metric& metric : all_metrics())
                CHECK(row["errors"][region].contains(std::string(metric.name)));
        CHECK(row["errors"]["all"].contains("rmse-g"));
    }
    CHECK(scene["orders"].size() >= 4);
    const std::string page = text_of(folder.path / "index.html");
    CHECK(page.find("is partial") != std::string::npos);
    CHECK(page.find("a &lt;b&gt;") != std::string::npos);
    CHECK(page.find("Verdict") < page.find("Reference: "));
    CHECK(page.find("http") == std::string::npos);
    CHECK(std::filesystem::file_size(folder.path / "aliasing-1.svg") > 2000);
    CHECK(text_of(folder.path / "error.csv").find("errors.silhouette.flip") != std::string::npos);
}

TEST_CASE("a stopped error report keeps the rows that it has", "[report]") {
    int asked = 0;
    Watch watch;
    watch.stopped = [&] { return ++asked > 3; };
    const std::vector<ReportInput> inputs{matt_teapot(), matt_teapot()};
    Settings small = small_picture();
    small.given.insert("resolution");
    const ErrorReport report =
        measure_error(inputs, small, {0, 1, 1}, watch, [](const std::string&, const Image&) {});
    CHECK(report.partial);
    REQUIRE(report.scenes.size() == 1);
    REQUIRE(report.scenes[0].axes.size() == 1);
    const std::vector<ErrorRow>& rows = report.scenes[0].axes[0].rows;
    REQUIRE(rows.size() >= 1);
    CHECK(rows.size() < 14);
    CHECK_FALSE(rows[0].time.has_value());
    CHECK_FALSE(rows[0].on_front);
    CHECK(std::isnan(rows[0].efficiency()));
}
