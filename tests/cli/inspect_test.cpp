// scanshade inspect: the numbers of one pixel, as text and as JSON.
#include <nlohmann/json.hpp>

#include "cli/process.hpp"
#include "scanshade/image/png.hpp"
#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("inspect prints the equation and the picture's byte", "[cli][inspect]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), png = folder.path / "a.png";
    const std::vector<std::string> size{"--resolution", "60,40", "--renderer", "scalar-f64"};
    auto args = size;
    args.insert(args.begin(), {"inspect", in, "--pixel", "30,20"});
    const Finished text = run_scanshade(args);
    CAPTURE(text.out, text.err);
    REQUIRE(text.status == 0);
    for (const char* part : {"N·L", "(N·H)ˢ", "(AB)_x", "N_AB", "(AC)_x", "N_AC", "N_X",
                             "k_d (N·L)", "f_att I", "light 2", "weight of A"})
        CHECK(text.out.find(part) != std::string::npos);

    args = size;
    args.insert(args.begin(), {"render", in, "-o", png});
    REQUIRE(run_scanshade(args).status == 0);
    const Image picture = load_image(png);
    args = size;
    args.insert(args.begin(), {"inspect", in, "--pixel", "30,20", "--json"});
    const Finished json = run_scanshade(args);
    const auto document = nlohmann::json::parse(json.out);
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(document["byte"]["double"][c] == picture.pixel(30, 20)[c]);
    CHECK(document["sections"].size() > 5);
    CHECK(document["pixel"] == nlohmann::json{30, 20});
}

TEST_CASE("inspect shows what each shading, interpolation and kind of light computes",
          "[cli][inspect]") {
    const struct {
        std::vector<std::string> args;
        std::vector<std::string> shown;
    } rows[] = {
        {{"quad-rotation", "20,36", "--interpolation", "patch", "--shading", "gouraud"},
         {"C7 at corner D", "position in the patch, (C2)", "I_X", "emission", "2: spot"}},
        {{"quad-rotation", "20,36", "--shading", "flat"}, {"C7 in the middle of the face"}},
        {{"quad-rotation", "20,36", "--interpolation", "edges", "--shading", "phong"},
         {"(AB)_x", "(C5)", "N_X"}},
        {{"textures", "48,60"}, {"texture", "factor of k_d and k_a"}},
        {{"textures", "48,60", "--shading", "gouraud"}, {"with the texture"}},
        {{"quad-rotation", "48,36"}, {"nothing is there but the background"}},
        // The first sample of a pixel in full, of the others the sum.
        {{"textures", "48,60", "--samples", "4"},
         {"sample at 48.25, 60.25", "sample at 48.75, 60.75"}},
    };
    for (const auto& row : rows) {
        std::vector<std::string> args{"inspect",      "models/scenes/" + row.args[0] + ".toml",
                                      "--resolution", "96,72",
                                      "--pixel",      row.args[1]};
        args.insert(args.end(), row.args.begin() + 2, row.args.end());
        const Finished run = run_scanshade(args);
        CAPTURE(args, run.err, run.out);
        CHECK(run.status == 0);
        for (const std::string& part : row.shown) CHECK(run.out.find(part) != std::string::npos);
    }
}

TEST_CASE("inspect says what --pixel takes", "[cli][inspect]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder);
    CHECK(run_scanshade({"inspect", in}).status == 2);
    for (const char* pixel : {"3", "3,4,5", "a,b", "-1,2", "960,0"}) {
        const Finished run = run_scanshade({"inspect", in, "--pixel", pixel});
        CAPTURE(pixel, run.err);
        CHECK(run.status == 2);
        CHECK(run.err.find("pixel") != std::string::npos);
    }
}
