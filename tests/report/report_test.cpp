// Reports: what is measured, and what is written about it.
#include <stdlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scanshade/report/document.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/report/plan_report.hpp"
#include "scanshade/report/speed_report.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

std::vector<ReportInput> sphere_input(const std::string& name = "sphere") {
    std::vector<ReportInput> inputs{{lit_sphere(), small_picture()}};
    inputs.front().scene.name = name;
    return inputs;
}

constexpr Rounds few{0, 2, 1};

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A drawing that is damaged wherever a row of the plan is kept.
MakeDrawing damaged(const std::string& row,
                    const std::function<void(PixelBuffer&, Framebuffer&)>& damage) {
    return [=](const Scene& scene, const Settings& settings) {
        const Drawing whole = make_drawing(scene, settings);
        if (settings.kept_rows.count(row) == 0) return whole;
        return Drawing{[=](PixelBuffer& pixels) {
                           const FrameStats stats = whole.pixels(pixels);
                           Framebuffer none(pixels.width, pixels.height);
                           damage(pixels, none);
                           return stats;
                       },
                       [=](Framebuffer& frame) {
                           const FrameStats stats = whole.planes(frame);
                           PixelBuffer none(frame.width, frame.height);
                           damage(none, frame);
                           return stats;
                       }};
    };
}

/// PATH without anything, for as long as it lives.
struct NoPath {
    std::string before = ::getenv("PATH");
    NoPath() { ::setenv("PATH", "/nowhere", 1); }
    ~NoPath() { ::setenv("PATH", before.c_str(), 1); }
};

}  // namespace

TEST_CASE("the plan's report times every row that applies, with and without", "[report]") {
    const PlanReport report = measure_plan(sphere_input(), few, {});
    REQUIRE(report.scenes.size() == 1);
    const PlanSceneResult& scene = report.scenes.front();
    REQUIRE(scene.rows.size() == plan_row_count);
    for (std::size_t i = 0; i < plan_row_count; ++i) {
        const PlanRowResult& row = scene.rows[i];
        CAPTURE(row.row.info->name);
        CHECK(row.row.info == &all_plan_rows()[i]);
        CHECK(row.row.left_out == row.gain.has_value());
        CHECK(row.change.empty());
        if (!row.gain) continue;
        CHECK(row.gain->with.runs == 2);
        CHECK(row.gain->with.min > 0);
        CHECK(row.gain->with.min <= row.gain->with.median);
        CHECK(row.gain->saved.low <= row.gain->saved.median);
        CHECK(row.gain->share < 1);
        CHECK(row.row.saving.saved <= row.row.saving.of);
    }
    CHECK(scene.whole_plan.has_value());
    CHECK_FALSE(report.partial);
    CHECK(report.faults().empty());
}

TEST_CASE("a row that changes one bit of the picture is found and named", "[report]") {
    const struct {
        std::function<void(PixelBuffer&, Framebuffer&)> damage;
        const char* words;
    } rows[] = {
        {[](PixelBuffer&, Framebuffer& f) { f.g[f.index(3, 7)] = -f.g[f.index(3, 7)]; },
         "1 of 4800 pixels differ in green, first (3, 7)"},
        {[](PixelBuffer&, Framebuffer& f) { f.depth[f.index(0, 1)] += 1e-30f; }, "in depth"},
        {[](PixelBuffer&, Framebuffer& f) { f.id.back() ^= 1; }, "in triangle, first (79, 59)"},
        {[](PixelBuffer& p, Framebuffer&) { p.edit()[5] ^= 1; }, "encoded pixels differ"},
    };
    for (const auto& row : rows) {
        const PlanReport report =
            measure_plan(sphere_input(), few, {}, damaged("texture-coordinates", row.damage));
        REQUIRE(report.faults().size() == 1);
        const std::string fault = report.faults().front();
        CAPTURE(fault);
        CHECK(fault.find("scene 'sphere': row 'texture-coordinates'") != std::string::npos);
        CHECK(fault.find(row.words) != std::string::npos);

        const TempFolder folder;
        write_plan_report(report, folder.path);
        int differing = 0;
        const Json json = Json::parse(text_of(folder.path / "report.json"));
        for (const Json& each : json["scenes"][0]["rows"])
            differing += each.contains("identical") && each["identical"] == false;
        CHECK(differing == 1);
        CHECK(text_of(folder.path / "index.html").find("Fault: ") != std::string::npos);
    }
}

TEST_CASE("pictures with the same bits do not differ, even where they are not numbers",
          "[report]") {
    Framebuffer a(2, 2);
    a.r[1] = std::numeric_limits<float>::quiet_NaN();
    CHECK(picture_change(a, a).empty());
    CHECK(picture_change(a, Framebuffer(2, 3)) == "the sizes differ");
    Framebuffer b = a;
    b.b[0] = -0.0f;
    CHECK_FALSE(picture_change(a, b).empty());
}

TEST_CASE("settings without a plan have no plan's report", "[report]") {
    auto inputs = sphere_input();
    inputs.front().settings.renderer = RendererKind::scalar_f32;
    CHECK_THROWS_WITH(measure_plan(inputs, few, {}), Catch::Matchers::Contains("--renderer simd"));
}

TEST_CASE("report.json has provenance, scenes and rows", "[report]") {
    const TempFolder folder;
    CHECK(write_plan_report(measure_plan(sphere_input(), few, {}), folder.path).empty());
    const Json json = Json::parse(text_of(folder.path / "report.json"));
    CHECK(json["report"] == "plan");
    for (const char* key : {"commit", "compiler", "flags", "cpu", "isa", "date"}) {
        CAPTURE(key);
        CHECK_FALSE(json["provenance"][key].get<std::string>().empty());
    }
    CHECK(json["provenance"]["threads"] >= 1);
    CHECK(json["provenance"]["seed"] == 1);
    CHECK(json["provenance"]["flags"].get<std::string>().find("-ffp-contract=off") !=
          std::string::npos);
    const Json& rows = json["scenes"][0]["rows"];
    CHECK(rows.back()["method"] == "whole-plan");
    for (const Json& row : rows) {
        CHECK(row["axis"] == "plan");
        CHECK(row["parameters"]["width"] == 80);
        CHECK(row.contains("time_ms") == (row.value("left_out", true)));
        if (!row.contains("time_ms")) continue;
        for (const char* key : {"median", "min", "runs"}) {
            CHECK(row["time_ms"].contains(key));
            CHECK(row["time_without_ms"].contains(key));
        }
        CHECK(row["identical"] == true);
    }
    // A line for each row, of as many fields as the head.
    std::istringstream csv(text_of(folder.path / "plan.csv"));
    std::string head, line;
    std::getline(csv, head);
    CHECK(head.starts_with("scene,axis,method,parameters.width,"));
    std::size_t lines = 0;
    while (std::getline(csv, line)) ++lines;
    CHECK(lines == rows.size());
}

TEST_CASE("what was stopped says so, and has what was measured until then", "[report]") {
    Watch watch;
    int told = 0;
    watch.tell = [&](const std::string& what, std::size_t done, std::size_t all) {
        ++told;
        CHECK(what.find("sphere") != std::string::npos);
        CHECK(done < all);
    };
    watch.stopped = [&] { return told >= 4; };
    const PlanReport report = measure_plan(sphere_input(), few, watch);
    CHECK(report.partial);
    REQUIRE(report.scenes.size() == 1);
    CHECK(report.scenes[0].rows.size() > 1);
    CHECK(report.scenes[0].rows.size() < plan_row_count);
    const TempFolder folder;
    write_plan_report(report, folder.path);
    CHECK(Json::parse(text_of(folder.path / "report.json"))["partial"] == true);
    CHECK(text_of(folder.path / "index.html").find("This report is partial") != std::string::npos);
}

TEST_CASE("without gnuplot there is everything but plots, and one sentence", "[report]") {
    const PlanReport report = measure_plan(sphere_input(), few, {});
    const TempFolder folder;
    write_plan_report(report, folder.path);
    CHECK(std::filesystem::exists(folder.path / "plan.svg"));
    CHECK(text_of(folder.path / "index.html").find("<img") != std::string::npos);
    const NoPath no_gnuplot;
    const std::vector<std::string> warnings = write_plan_report(report, folder.path);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("gnuplot") != std::string::npos);
    for (const char* file : {"report.json", "plan.csv", "index.html"})
        CHECK(std::filesystem::exists(folder.path / file));
    CHECK_FALSE(std::filesystem::exists(folder.path / "plan.svg"));
    CHECK(text_of(folder.path / "index.html").find("<img") == std::string::npos);
    // Nothing that was worked with is left.
    const auto files = std::distance(std::filesystem::directory_iterator(folder.path),
                                     std::filesystem::directory_iterator());
    CHECK(files == 3);
}

TEST_CASE("no name of a scene is more than a name", "[report]") {
    const char* names[] = {"\"); system(\"touch pwned\"); set title \"",
                           "'; !touch pwned; plot '",
                           "`touch pwned`",
                           "$(touch pwned)",
                           "a\\\nset output 'pwned'\n",
                           "tab\tand\nline\r\\n \\042",
                           "<script>alert(1)</script><b a=\"'>&amp;",
                           "=HYPERLINK(\"x\"),y",
                           "bytes \xff\xc3\x28 \x1b[31m",
                           "{/Symbol x}_2^3 @~",
                           "# no comment",
                           "  ",
                           ""};
    for (const std::string name : names) {
        CAPTURE(name);
        const TempFolder folder;
        const PlanReport report = measure_plan(sphere_input(name), few, {});
        CHECK(write_plan_report(report, folder.path).empty());
        CHECK_FALSE(std::filesystem::exists("pwned"));
        CHECK_FALSE(std::filesystem::exists(folder.path / "pwned"));
        for (const char* file : {"index.html", "plan.svg", "frames.svg"}) {
            const std::string text = text_of(folder.path / file);
            CAPTURE(file);
            CHECK(text.size() > 1000);
            CHECK(text.find("<script") == std::string::npos);
            CHECK(text.find("<b a") == std::string::npos);
            CHECK(text.find('\x1b') == std::string::npos);
            CHECK(text.find('\xff') == std::string::npos);
        }
        const Json json = Json::parse(text_of(folder.path / "report.json"));
        if (name.find('\xff') == std::string::npos) CHECK(json["scenes"][0]["name"] == name);
        // A scene's lines in the CSV: as many as rows, none begins with a formula.
        std::istringstream csv(text_of(folder.path / "plan.csv"));
        std::size_t lines = 0;
        for (std::string line; std::getline(csv, line); ++lines)
            CHECK((line.empty() || line[0] != '='));
        CHECK(lines == 1 + plan_row_count + 1);
    }
}

TEST_CASE("a folder that is not there is an error of one sentence", "[report]") {
    const TempFolder folder;
    PlanReport report;
    CHECK_THROWS_WITH(write_plan_report(report, folder.path / "nowhere"),
                      Catch::Matchers::Contains("could not be written"));
}

TEST_CASE("a page escapes all text", "[report]") {
    Page page("<t>", "a & b");
    page.table({"<h>"}, {{{"<c>"}, number_cell("1 < 2", "bad")}});
    const std::string text = page.text();
    CHECK(text.find("<title>&lt;t&gt;</title>") != std::string::npos);
    CHECK(text.find("a &amp; b") != std::string::npos);
    CHECK(text.find("<th>&lt;h&gt;</th>") != std::string::npos);
    CHECK(text.find("<td class=\"bad number\">1 &lt; 2</td>") != std::string::npos);
}
