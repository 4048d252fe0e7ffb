// What the command report leaves in its folder.
#include <nlohmann/json.hpp>

#include "cli/process.hpp"
#include "scanshade/render/plan_rows.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

nlohmann::json report_in(const std::filesystem::path& folder) {
    return nlohmann::json::parse(read_file(folder / "report.json"));
}

}  // namespace

TEST_CASE("report plan writes a page, plots, JSON and CSV of every row", "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "deep" / "report";
    const Finished run =
        run_scanshade({"report", "plan", in, "-o", out, "--resolution", "64,48", "--runs", "2"});
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    CHECK(run.out.empty());
    CHECK(run.err == "wrote " + out + "/index.html\n");
    for (const char* file : {"index.html", "report.json", "plan.csv", "plan.svg", "frames.svg"}) {
        CAPTURE(file);
        CHECK(std::filesystem::file_size(std::filesystem::path(out) / file) > 500);
    }
    const nlohmann::json report = report_in(out);
    CHECK(report["partial"] == false);
    REQUIRE(report["scenes"].size() == 1);
    CHECK(report["scenes"][0]["name"] == "triangle");
    CHECK(report["scenes"][0]["rows"].size() == plan_row_count + 1);
}

TEST_CASE("report speed measures scenes and a sphere", "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "report";
    const Finished run =
        run_scanshade({"report", "speed", in, "-o", out, "--resolution", "64,48", "--runs", "1"});
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    const nlohmann::json report = report_in(out);
    REQUIRE(report["scenes"].size() == 2);
    CHECK(report["scenes"][0]["name"] == "triangle");
    CHECK(report["scenes"][1]["name"] == "sphere");
    CHECK(std::filesystem::exists(std::filesystem::path(out) / "pixels-1.svg"));
    CHECK(std::filesystem::exists(std::filesystem::path(out) / "triangles-2.svg"));
}

TEST_CASE("report stability needs no input, and measures equations, models and pictures",
          "[cli][report]") {
    const TempFolder folder;
    const std::string out = folder.path / "report";
    const Finished run = run_scanshade({"report", "stability", "-o", out});
    CAPTURE(run.err);
    CHECK(run.status == 0);
    const nlohmann::json report = report_in(out);
    CHECK(report["partial"] == false);
    REQUIRE(report["scenes"].size() > 2);
    CHECK(report["scenes"][0]["name"] == "equations");
    CHECK(report["scenes"][1]["name"] == "models");
    CHECK(report["scenes"][2]["rows"][0]["axis"] == "pictures");
    for (const char* file : {"index.html", "stability.csv", "equation-B17d-1.svg"})
        CHECK(std::filesystem::exists(std::filesystem::path(out) / file));
}

TEST_CASE("report error writes a page with a verdict, and a picture of every row",
          "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "report";
    const Finished run =
        run_scanshade({"report", "error", in, "-o", out, "--resolution", "64,48", "--runs", "1"});
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    const nlohmann::json report = report_in(out);
    REQUIRE(report["scenes"].size() == 3);
    CHECK(report["scenes"][0]["name"] == "triangle");
    CHECK(report["scenes"][1]["name"] == "diffuse sphere");
    std::size_t pictures = 0;
    for (const nlohmann::json& scene : report["scenes"]) {
        CHECK_FALSE(scene["verdict"].empty());
        for (const nlohmann::json& row : scene["rows"]) {
            const std::string file = row["picture"];
            CAPTURE(file);
            CHECK(std::filesystem::file_size(std::filesystem::path(out) / file) > 60);
            ++pictures;
        }
    }
    CHECK(pictures > 60);
    for (const char* plot : {"numerical-1.svg", "aliasing-1.svg", "convergence-2.svg"})
        CHECK(std::filesystem::exists(std::filesystem::path(out) / plot));
    CHECK(read_file(out + "/index.html").find("<h2>Verdict</h2>") != std::string::npos);
}

TEST_CASE("without an input the shipped scenes are found from any folder", "[cli][report]") {
    // Only found, not measured: the settings of no plan are refused after loading.
    const TempFolder folder;
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    const Finished run = run_scanshade({"report", "plan", "-o", "report", "--no-plan"});
    const std::string copy = folder.path / "scanshade";
    std::filesystem::copy_file(SCANSHADE_BINARY, copy);
    const Finished lost = run_scanshade({"report", "plan", "-o", "report"}, {}, copy);
    std::filesystem::current_path(here);
    CHECK(run.status == 2);
    CHECK(run.err.find("'cornell-box'") != std::string::npos);
    CHECK(lost.status == 3);
    CHECK(lost.err.find("models/scenes") != std::string::npos);
    CHECK(lost.err.find("name an INPUT") != std::string::npos);
}

TEST_CASE("an interrupted report is whole in itself, and says that it is partial",
          "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "report";
    for (const std::string kind : {"plan", "speed", "error", "stability"}) {
        const Finished run = run_scanshade_interrupted(
            {"report", kind, in, "-o", out + kind, "--runs", "10000"}, out + kind);
        CAPTURE(kind, run.err);
        CHECK(run.status == 130);
        CHECK(run.err.find("partial") != std::string::npos);
        const nlohmann::json report = report_in(out + kind);
        CHECK(report["partial"] == true);
        CHECK(report["scenes"].is_array());
        CHECK(read_file(out + kind + "/index.html").find("is partial") != std::string::npos);
    }
}

TEST_CASE("a report says on a terminal what is measured and how long it will take",
          "[cli][report]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "report";
    // More than any machine measures in the second after which the line comes.
    const Finished run = run_scanshade_on_terminal(
        {"report", "plan", in, "-o", out, "--resolution", "64,48", "--runs", "10000"}, " left (");
    CAPTURE(run.err);
    CHECK(run.status == 130);
    CHECK(run.err.find("measuring triangle: ") != std::string::npos);
}
