// What render, sheet, explain and info give when all is well.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/lettering.hpp"
#include "cli/process.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/plan_rows.hpp"
#include "scanshade/scene/settings.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// Finished with status 0, or the test ends here with what the program said.
Finished run_well(const std::vector<std::string>& args) {
    const Finished run = run_scanshade(args);
    INFO(run.err);
    REQUIRE(run.status == 0);
    return run;
}

}  // namespace

TEST_CASE("render writes a picture of the size that was asked for and one line about it", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const Finished run = run_well({"render", in, "-o", out, "--resolution", "64,48"});
    CHECK(run.out.empty());
    CHECK(run.err.find("wrote " + out + ", 64 × 48, 1 triangles") != std::string::npos);
    const Image image = load_image(out);
    CHECK(image.width == 64);
    CHECK(image.height == 48);
    // Something is there, and it is not everywhere.
    const auto pixel = [&](int x, int y) {
        return std::vector<int>(image.pixel(x, y), image.pixel(x, y) + 3);
    };
    CHECK(pixel(32, 24) != pixel(0, 0));
}

TEST_CASE("a picture on standard output is alone there, and the same as in a file", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const std::vector<std::string> common{"render", in, "--resolution", "40,30", "--verbose", "-o"};
    auto to_file = common, to_stdout = common;
    to_file.push_back(out);
    to_stdout.push_back("-");
    run_well(to_file);
    const Finished run = run_well(to_stdout);
    CHECK(run.out == read_file(out));
    CHECK(run.out.starts_with("\x89PNG"));
    CHECK_FALSE(run.err.empty());
}

TEST_CASE("values that begin with a dash are values", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    run_well({"render", in, "-o", out, "--resolution", "8,8", "--exposure", "-1",
              "--camera-position", "-1,2,3", "--light", "directional:-1,-1,-1"});
    run_well({"render", in, "-o", out, "--resolution", "8,8", "--exposure", "-.5"});
    run_well({"render", in, "-o", out, "--resolution", "8,8", "--exposure=-.5"});
}

TEST_CASE("of an option given twice the last counts; lights add up", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    run_well({"render", in, "-o", out, "--resolution", "8,8", "--resolution", "16,9"});
    CHECK(load_image(out).width == 16);
    const std::string info =
        run_well({"info", in, "--light", "point:1,2,3", "--light", "directional:0,0,-1"}).out;
    CHECK(info.find("1, 2, 3") != std::string::npos);
    CHECK(info.find("directional") != std::string::npos);
}

TEST_CASE("--stats holds the documented keys, and the times are those of all frames", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const std::string path = folder.path / "stats.json";
    run_well({"render", in, "-o", out, "--resolution", "32,24", "--repeat", "3", "--stats", path});
    const nlohmann::json stats = nlohmann::json::parse(read_file(path));
    for (const char* key :
         {"program", "input", "width", "height", "samples", "renderer", "interpolation", "load_ms",
          "frames", "frame_ms", "stages", "counts", "left_out", "events", "peak_memory_bytes"}) {
        CAPTURE(key);
        CHECK(stats.contains(key));
    }
    CHECK(stats["width"] == 32);
    CHECK(stats["frames"] == 3);
    CHECK(stats["frame_ms"]["min"] > 0.0);
    CHECK(stats["frame_ms"]["min"] <= stats["frame_ms"]["median"]);
    CHECK(stats["counts"]["triangles"] == 1);
    CHECK(stats["counts"]["vertices"] == 3);
    CHECK(stats["counts"]["covered_samples"] > 10);
    CHECK(stats["counts"]["covered_samples"] < 32 * 24);
    CHECK(stats["peak_memory_bytes"] > 1'000'000);
    REQUIRE_FALSE(stats["stages"].empty());
    for (const auto& stage : stats["stages"])
        for (const char* key : {"name", "ran", "ms", "items", "item_name"})
            CHECK(stage.contains(key));
}

TEST_CASE("--stats - is JSON alone on standard output", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const Finished run =
        run_well({"render", in, "-o", out, "--resolution", "8,8", "--stats", "-", "--verbose"});
    CHECK(nlohmann::json::parse(run.out)["height"] == 8);
}

TEST_CASE("rare events reach --stats with meaning and rate, and warnings where too many", "[cli]") {
    const TempFolder folder;
    const std::string in =
        folder.write("flat.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
    const std::string out = folder.path / "out.png";  // the second has no area
    const Finished run = run_well({"render", in, "-o", out, "--resolution", "8,8", "--stats", "-"});
    const nlohmann::json events = nlohmann::json::parse(run.out)["events"];
    REQUIRE(events.size() >= 1);
    CHECK(events[0]["name"] == "degenerate-face");
    CHECK(events[0]["count"] == 1);
    CHECK(events[0]["rate"] == 0.5);
    CHECK(events[0]["among"] == "faces");
    CHECK(events[0]["meaning"].get<std::string>().size() > 20);
    CHECK(run.err.find("warning: degenerate-face") != std::string::npos);
    CHECK(run_well({"info", in}).out.find("degenerate-face") != std::string::npos);
}

TEST_CASE("progress is shown on a terminal only", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    // No machine draws so many frames before the line is seen.
    const std::vector<std::string> long_run = {"render", in, "-o", out, "--repeat", "100000"};
    const Finished shown = run_scanshade_on_terminal(long_run, " of 100000 (1 s)");
    CAPTURE(shown.err);
    CHECK(shown.status == 130);
    const Finished piped = run_scanshade_interrupted(long_run, in, std::chrono::milliseconds(1500));
    CAPTURE(piped.err);
    CHECK(piped.status == 130);
    CHECK(piped.err.find(" of 100000 (") == std::string::npos);
    CHECK(piped.err.find('\r') == std::string::npos);
}

/// A sheet of cells of `side` × 30 pixels, and where they stand.
struct Sheet {
    static constexpr int gap = 8;
    Image image;
    int rows = 0, columns = 0, left = 0, top = 0, pitch = 0;
};

/// Where the first column of a sheet begins.
int cells_left() {
    int width = lettering_width("shading");
    for (const std::string_view name : shading_names())
        width = std::max(width, lettering_width(std::string(name)));
    return width + 2 * Sheet::gap;
}

Sheet draw_sheet(int side) {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    run_well({"sheet", in, "-o", out, "--resolution", std::to_string(side) + ",30"});
    Sheet sheet{load_image(out)};
    sheet.rows = int(shading_names().size());
    sheet.columns = int(all_brdfs().size()) + 1;
    sheet.left = cells_left();
    sheet.top = sheet.image.height - sheet.rows * (30 + Sheet::gap);
    sheet.pitch = (sheet.image.width - sheet.left) / sheet.columns;
    return sheet;
}

TEST_CASE("a sheet has a cell for every shading and reflection model", "[cli]") {
    const Sheet sheet = draw_sheet(40);
    REQUIRE(sheet.pitch >= 40 + Sheet::gap);
    // The middle of each cell shows the triangle: it differs from the cell's own corner.
    for (int r = 0; r < sheet.rows; ++r)
        for (int c = 0; c < sheet.columns; ++c) {
            CAPTURE(r, c);
            const int x = sheet.left + c * sheet.pitch, y = sheet.top + r * (30 + Sheet::gap);
            const std::uint8_t* corner = sheet.image.pixel(x, y);
            CHECK_FALSE(std::equal(corner, corner + 3, sheet.image.pixel(x + 20, y + 15)));
        }
}

TEST_CASE("without --resolution a sheet's cells are small, in the picture's proportions", "[cli]") {
    const TempFolder folder;
    const std::string out = folder.path / "out.png";
    const std::string scene =
        folder.write("a.toml", "[image]\nsize = [800, 200]\n[[object]]\nshape = \"cube\"\n");
    run_well({"sheet", scene, "-o", out});
    const Image sheet = load_image(out);
    const int rows = int(shading_names().size()), columns = int(all_brdfs().size()) + 1;
    CHECK(sheet.width == cells_left() + columns * (320 + Sheet::gap));
    CHECK(sheet.height == letter_height + 2 * Sheet::gap + rows * (80 + Sheet::gap));
}

TEST_CASE("info shows what lights and materials have", "[cli]") {
    const std::string lights = run_well({"info", "models/scenes/lights.toml"}).out;
    CHECK(lights.find("cutoff 21°, penumbra ") != std::string::npos);
    const std::string textures = run_well({"info", "models/scenes/textures.toml"}).out;
    CHECK(textures.find("map_kd models/scenes/textures/tiles.png, 96 × 96") != std::string::npos);
}

TEST_CASE("labels of a sheet are whole, however small its cells are", "[cli]") {
    const auto lettered = [](const Sheet& sheet) {
        const std::uint8_t* paper = sheet.image.pixel(0, 0);
        int pixels = 0;
        for (int y = 0; y < sheet.top; ++y)
            for (int x = sheet.left; x < sheet.image.width; ++x)
                pixels += !std::equal(paper, paper + 3, sheet.image.pixel(x, y));
        return pixels;
    };
    const Sheet wide = draw_sheet(400), narrow = draw_sheet(40);
    CHECK(wide.top == letter_height + 2 * Sheet::gap);
    CHECK(narrow.top > wide.top);
    CHECK(narrow.pitch < wide.pitch / 2);
    CHECK(lettered(narrow) == lettered(wide));
}

TEST_CASE("--stats says what each row of the plan saved, of how much, and --verbose too", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), out = folder.path / "out.png";
    const std::vector<std::string> args{"render",       in,        "-o",       out,
                                        "--resolution", "320,240", "--light",  "directional:0,0,-1",
                                        "--stats",      "-",       "--verbose"};
    const Finished run = run_well(args);
    const nlohmann::json left_out = nlohmann::json::parse(run.out)["left_out"];
    const auto entry = [&](const std::string& name) {
        for (const auto& row : left_out)
            if (row["name"] == name) return row;
        FAIL("left_out has no " + name);
        return nlohmann::json();
    };
    CHECK_FALSE(entry("average").contains("saved"));  // a stage
    CHECK(entry("texture-coordinates") ==
          nlohmann::json{{"name", "texture-coordinates"},
                         {"reason", "0 of 1 materials have a texture"},
                         {"saved", 1},
                         {"of", 1},
                         {"unit", "triangles"}});
    CHECK(entry("attenuation")["saved"] == 1);
    const auto tiles = entry("empty-tiles");
    CHECK(tiles["of"] == 5 * 4);
    CHECK(tiles["saved"] > 0);
    CHECK(tiles["saved"] < tiles["of"]);
    CHECK(run.err.find("plan: attenuation left out, 1 of 1 lights: ") != std::string::npos);
    CHECK(run.err.find("plan: clusters-facing-away done: ") != std::string::npos);
    CHECK(run.err.find("stage: shade runs: ") != std::string::npos);
}

TEST_CASE("explain says of each stage and row: run or left out, why, and how much", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder);
    const std::string plan = run_well({"explain", in, "--samples", "4"}).out;
    CAPTURE(plan);
    for (const PlanRowInfo& row : all_plan_rows())
        CHECK(plan.find("\n" + std::string(row.name) + " ") != std::string::npos);
    CHECK(plan.find("\nraster        left out ") != std::string::npos);
    CHECK(plan.find("\nset-up        runs      4 triangles ") != std::string::npos);
    CHECK(plan.find("left out  4 of 4 triangles ") != std::string::npos);
    CHECK(plan.find("960 × 720 pixels and 4 samples") != std::string::npos);

    const std::string all = run_well({"explain", in, "--no-plan"}).out;
    CHECK(all.find("asked for") != std::string::npos);
    CHECK(all.find(" of 1 triangles") == std::string::npos);
    const std::string scalar = run_well({"explain", in, "--renderer", "scalar-f32"}).out;
    CHECK(scalar.find("row of the plan") == std::string::npos);
    CHECK(scalar.find("visibility") != std::string::npos);
}

TEST_CASE("info counts what is in the file and shows materials as they are drawn", "[cli]") {
    const TempFolder folder;
    folder.write("two.mtl", "newmtl red\nKd 0.5 0.25 0\nKs 0.125 0.125 0.125\nNs 77\n");
    const std::string in =
        folder.write("two.obj",
                     "mtllib two.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\n"
                     "f 1 2 3 4\nf 1 2 3\nf 1 2 3 5 4\n");
    const std::string info = run_well({"info", in}).out;
    CAPTURE(info);
    CHECK(info.find("3: 1 triangles, 1 quadrilaterals, 1 of more corners") != std::string::npos);
    CHECK(info.find("6 as drawn") != std::string::npos);
    CHECK(info.find("red") != std::string::npos);
    CHECK(info.find("kd 0.5,0.25,0") != std::string::npos);
    CHECK(info.find("ks 0.125") != std::string::npos);
    CHECK(info.find("77") != std::string::npos);
    CHECK(run_well({"info", in, "--brdf", "lambert"}).out.find("lambert") != std::string::npos);
}
