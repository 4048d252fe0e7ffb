// Lessons: complete pages, and numbers that are what the texts say.
#include "scanshade/report/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "scanshade/base/error.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

const std::filesystem::path scenes = "models/lessons";

std::string read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    REQUIRE(in.good());
    return {std::istreambuf_iterator<char>(in), {}};
}

/// All lessons, written once for all tests.
struct Booklet {
    TempFolder folder;
    LessonsWritten written = write_lessons(all_lessons(), scenes, folder.path, {});
    std::string page = read_file(folder.path / "index.html");
};
const Booklet& booklet() {
    static const Booklet all;
    return all;
}

/// The only fact of a lesson whose name begins so.
double fact(std::string_view lesson, std::string_view what) {
    std::vector<double> found;
    for (const LessonFact& f : booklet().written.facts)
        if (f.lesson == lesson && f.what.starts_with(what)) found.push_back(f.value);
    CAPTURE(lesson, what);
    REQUIRE(found.size() == 1);
    return found.front();
}

/// What stands between `before` and the next quotation mark, everywhere.
std::vector<std::string> values(const std::string& text, const std::string& before) {
    std::vector<std::string> out;
    for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at + 1)) {
        const std::size_t from = at + before.size();
        out.push_back(text.substr(from, text.find('"', from) - from));
    }
    return out;
}

/// How many colours a picture has; two are enough.
std::size_t colours(const Image& image) {
    std::set<std::array<std::uint8_t, 3>> seen;
    for (std::size_t i = 0; i < image.rgb.size() && seen.size() < 2; i += 3)
        seen.insert({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    return seen.size();
}

void check_svg(const std::string& svg) {
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK((svg.find("<polyline") != svg.npos || svg.find("<polygon") != svg.npos));
    for (const char* wrong : {"nan", "inf"}) CHECK(svg.find(wrong) == svg.npos);
    CHECK(values(svg, "http").size() == 1);  // the name space
}

}  // namespace

TEST_CASE("every picture of every lesson is there and shows something", "[report][lesson]") {
    const std::vector<std::string> files = values(booklet().page, "<img src=\"");
    CHECK(files.size() > 3 * all_lessons().size());
    for (const std::string& file : files) {
        CAPTURE(file);
        const auto path = booklet().folder.path / file;
        REQUIRE(std::filesystem::exists(path));
        if (file.ends_with(".svg"))
            check_svg(read_file(path));
        else
            CHECK(colours(load_image(path)) > 1);
    }
    // No picture lies there that no lesson shows, and none is shown twice.
    const std::set<std::string> shown(files.begin(), files.end());
    CHECK(shown.size() == files.size());
    for (const auto& entry : std::filesystem::directory_iterator(booklet().folder.path))
        CHECK((entry.path().filename() == "index.html" || shown.contains(entry.path().filename())));
}

TEST_CASE("the page stands alone, and its contents lead to every lesson", "[report][lesson]") {
    const std::string& page = booklet().page;
    CHECK(page.find("http") == page.npos);
    for (const std::string& target : values(page, "href=\"")) {
        CAPTURE(target);
        CHECK(page.find(fmt::format("<h2 id=\"{}\">", target.substr(1))) != page.npos);
    }
    CHECK(values(page, "href=\"").size() == all_lessons().size());
    CHECK_FALSE(booklet().written.partial);
}

TEST_CASE("every lesson has a scene, pictures, numbers, commands and answered questions",
          "[report][lesson]") {
    const std::string equations = read_file("docs/equations.md");
    std::set<std::string_view> names;
    for (const LessonInfo* lesson : all_lessons()) {
        CAPTURE(lesson->name);
        CHECK(names.insert(lesson->name).second);
        Settings settings;
        const Scene scene = load_scene(scenes / fmt::format("{}.toml", lesson->name), settings);
        CHECK(scene.warnings.empty());
        CHECK(scene.camera.has_value());
        const auto& page = booklet().page;
        CHECK(values(page, fmt::format("<img src=\"{}-", lesson->name)).size() >= 2);
        for (const std::string& line : command_lines(*lesson))
            CHECK(page.find(escaped(line)) != page.npos);
        CHECK(lesson->questions.size() >= 2);
        for (const LessonQuestion& q : lesson->questions) {
            CHECK(q.question.ends_with('?'));
            CHECK(page.find(escaped(q.answer)) != page.npos);
        }
        const auto& facts = booklet().written.facts;
        CHECK(std::any_of(facts.begin(), facts.end(),
                          [&](const LessonFact& f) { return f.lesson == lesson->name; }));
        for (const LessonEquation& e : lesson->equations) {
            CAPTURE(e.number, e.function);
            const auto row = equations.find(fmt::format("| {} | [`{}`]", e.printed, e.function));
            REQUIRE(row != equations.npos);
            const auto line = equations.rfind('\n', row) + 1;
            CHECK(equations.substr(line, 8).find(fmt::format("| {} ", e.number)) == 0);
        }
    }
}

TEST_CASE("what the lessons on interpolation say is so", "[report][lesson]") {
    const char* peak = "brightest pixel, gouraud shading";
    CHECK(fact("highlight", std::string(peak) + ", 64") >
          0.8 * fact("highlight", "brightest pixel, phong"));
    CHECK(fact("highlight", "lowest peak while the sphere turns, gouraud") <
          0.5 * fact("highlight", "lowest peak while the sphere turns, phong"));
    CHECK(fact("shading", "flat: RMSE") > fact("shading", "gouraud: RMSE"));
    CHECK(fact("mach-bands", "gouraud: largest jump") >
          3 * fact("mach-bands", "phong: largest jump"));
    CHECK(fact("mach-bands", "flat: largest step") >
          10 * fact("mach-bands", "gouraud: largest step"));
    CHECK(fact("rotation", "edges") > 0.1);
    CHECK(fact("rotation", "patch") < 1e-5);
    CHECK(fact("rotation", "perspective") < 1e-5);
    CHECK(fact("perspective", "one quadrilateral") > 10);
    CHECK(fact("perspective", "128") < 0.1);
    CHECK(fact("lights", "gouraud shading: RMSE") > 2 * fact("lights", "gouraud shading, 64"));
}

TEST_CASE("what the lessons on models say is so", "[report][lesson]") {
    CHECK(fact("half-vector", "best factor for n = 60, light near") == Approx(4).margin(0.1));
    CHECK(fact("half-vector", "best factor for n = 60, light at 120") < 3);
    CHECK(fact("exponent", "half width at n = 100, drawn") ==
          Approx(fact("exponent", "half width at n = 100, by the equation")).epsilon(0.05));
    CHECK(fact("energy", "phong: largest") > 1.2);
    CHECK(fact("energy", "phong: albedo at n = 400") < 0.51);
    CHECK(fact("energy", "modified-phong: largest") == Approx(1).margin(2e-3));
    CHECK(fact("energy", "modified-phong, n = 20: middle") ==
          Approx(fact("energy", "modified-phong, n = 20: albedo")).epsilon(0.01));
    CHECK(fact("microfacets", "largest difference") > 8);
    CHECK(fact("rough-diffuse", "lambert") == Approx(std::sqrt(1 - 0.81)).epsilon(0.05));
    CHECK(fact("rough-diffuse", "σ = 1.2") > 0.95);
    CHECK(fact("fresnel", "water") == Approx(0.06).margin(0.002));  // as B19's docstring has it
    CHECK(fact("attenuation", "q = 1: pixels") > 100);
    CHECK(fact("attenuation", "c = 1, q = 1: largest difference") < 1e-3);
}

TEST_CASE("what the lessons on geometry say is so", "[report][lesson]") {
    CHECK(fact("normals", "box, average") == Approx(19.47).margin(0.01));
    CHECK(fact("normals", "box, angle") < 1e-4);
    CHECK(fact("normals", "normals of the sheet that cancelled") == 8);
    CHECK(fact("depth", "standard float against reversed") > 1000);
    CHECK(fact("depth", "24 bits: pixels") > 1000);
    CHECK(fact("depth", "float, reversed: pixels") == 0);
    CHECK(fact("fill-rule", "top-left rule: samples drawn twice") == 0);
    CHECK(fact("fill-rule", "top-left rule: samples on inner edges") == 0);
    CHECK(fact("fill-rule", "with all edges") > 20);
    CHECK(fact("fill-rule", "without edges") > 20);
    CHECK(fact("fill-rule", "torus: samples that are covered") > 1000);
    CHECK(fact("fill-rule", "torus: samples covered an odd number") == 0);
    CHECK(fact("plan", "kinds of work left out") >= 5);
    CHECK(fact("plan", "pixels that differ") == 0);
}

TEST_CASE("interrupted lessons leave a page of those that are done", "[report][lesson]") {
    const TempFolder folder;
    Watch watch;
    int asked = 0;
    watch.stopped = [&] { return asked++ == 1; };
    const LessonsWritten written =
        write_lessons(all_lessons().subspan(12, 3), scenes, folder.path, watch);
    CHECK(written.partial);
    const std::string page = read_file(folder.path / "index.html");
    CHECK(page.find("after 1 of 3 lessons") != page.npos);
    CHECK(page.ends_with("</html>\n"));
    CHECK(values(page, "<h2 id=\"") == std::vector<std::string>{"lights"});
}

TEST_CASE("an unknown lesson is an error that names the nearest", "[report][lesson]") {
    CHECK_THROWS_WITH(find_lesson("mach-band"),
                      "lesson 'mach-band' is unknown, did you mean 'mach-bands'?");
    CHECK(&find_lesson("fill-rule") == *(all_lessons().end() - 2));
}
