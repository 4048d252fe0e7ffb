// What is wrong in a scene file, and what is said about it.
#include <fmt/format.h>

#include "scanshade/image/image.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/scene/shapes.hpp"
#include "scene/scene_file_text.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

TEST_CASE("faults in a scene file name the line and what would be right", "[scene_file]") {
    struct Case {
        std::string text;
        long line;
        std::string_view word;
    };
    const std::string light = "[[light]]\ntype = \"point\"\n";
    const std::string spot = "[[light]]\ntype = \"spot\"\n";
    const std::string material = "[[material]]\nname = \"m\"\n";
    const Case cases[] = {
        // unknown keys
        {"ambiant = 1\n", 1, "did you mean 'ambient'"},
        {"[cam]\n", 1, "camera"},
        {"[image]\nsizes = [1, 1]\n", 2, "did you mean 'size'"},
        {"[camera]\n\nfocalpoint = [0, 0, 0]\n", 3, "did you mean 'focal_point'"},
        {light + "color = 1\n", 3, "'color'"},
        {cube + "rotat = [0, 0, 0]\n", 3, "did you mean 'rotate'"},
        {"[render]\nshadng = \"flat\"\n", 2, "did you mean 'shading'"},
        // wrong kinds of tables
        {"light = 3\n", 1, "[[light]]"},
        {"[light]\n", 1, "[[light]]"},
        {"object = [1]\n", 1, "[[object]]"},
        {"camera = 1\n", 1, "[camera]"},
        {"[[render]]\n", 1, "[render]"},
        // options
        {"[render]\nsamples = 5\n", 2, "square number"},
        {"[render]\nexposure = inf\n", 2, "finite"},
        {"[render]\nshading = {}\n", 2, "number"},
        {"[render]\nlight = [\"point:1\"]\n", 2, "point:x,y,z"},
        {"[image]\nsize = [0, 10]\n", 2, "16384"},
        {"[image]\nsize = 10\n", 2, "width,height"},
        // numbers
        {"ambient = nan\n", 1, "finite"},
        {"ambient = -1\n", 1, "negative"},
        {"ambient = [1, 2]\n", 1, "3 numbers"},
        {"ambient = \"1\"\n", 1, "numbers"},
        // cameras
        {"[camera]\nposition = [0, 0]\n", 2, "3 numbers"},
        {"[camera]\nposition = [1e300, 0, 0]\n", 2, "1e+100"},
        {"[camera]\nview_angle = 180\n", 2, "179.9"},
        {"[camera]\nprojection = \"ortho\"\n", 2, "orthographic"},
        {"[camera]\nnear = 0\n", 2, "near"},
        {"\n[camera]\nposition = [1, 1, 1]\nfocal_point = [1, 1, 1]\n", 2, "two different"},
        {"\n[camera]\nview_up = [0, 0, 0]\n", 2, "view up"},
        {"\n[camera]\nnear = 2\nfar = 1\n", 4, "larger than near"},
        // lights
        {"[[light]]\nposition = [0, 0, 0]\n", 1, "type"},
        {"[[light]]\ntype = \"sun\"\n", 2, "directional"},
        {light + "intensity = -1\n", 3, "negative"},
        {light + "intensity = [1, 1]\n", 3, "numbers"},
        {light + "intensity = inf\n", 3, "finite"},
        {light + "attenuation = [0, 0, 0]\n", 3, "all 0"},
        {light + "attenuation = [1, -1, 0]\n", 3, "negative"},
        {light + "radius = 0\n", 3, "radius"},
        {spot + "direction = [0, 0, 0]\n", 3, "0, 0, 0"},
        {spot + "cutoff = 0\n", 3, "cutoff"},
        {spot + "cutoff = 181\n", 3, "180"},
        {spot + "cutoff = 20\npenumbra = 21\n", 4, "20"},
        {spot + "penumbra = -1\n", 3, "penumbra"},
        // materials
        {"[[material]]\nbrdf = \"phong\"\n", 1, "name"},
        {"[[material]]\nname = 3\n", 2, "text"},
        {material + "kd = true\n", 3, "number"},
        {material + "kd = [1, 2]\n", 3, "three"},
        {material + "kd = [1, inf, 0]\n", 3, "finite"},
        {material + "map_kd = \"no.png\"\n", 3, "no.png"},
        {material + material, 4, "'m'"},
        // objects
        {"[[object]]\n", 1, "mesh"},
        {cube + "mesh = \"a.obj\"\n", 1, "either"},
        {"[[object]]\nshape = \"cub\"\n", 2, "did you mean 'cube'"},
        {"[[object]]\nmesh = \"no-such.obj\"\n", 2, "no-such.obj"},
        {"[[object]]\nmesh = \"a.obj\"\ntessellation = 3\n", 3, "shapes"},
        {cube + "tessellation = 0\n", 3, "tessellation"},
        {cube + "tessellation = 1.5\n", 3, "whole"},
        {cube + "tessellation = 1e9\n", 3, "tessellation"},
        {cube + "material = \"m\"\n", 3, "'m'"},
        {material + cube + "material = \"n\"\n", 5, "'n'"},
        {cube + "shading = \"fat\"\n", 3, "did you mean 'flat'"},
        {cube + "scale = 0\n", 1, "0"},
        {cube + "scale = [1, 2]\n", 3, "numbers"},
        {cube + "scale = 1e200\n", 1, "1e100"},
        {cube + "translate = [1e200, 0, 0]\n", 3, "1e+100"},
        {cube + "matrix = [1, 0, 0]\n", 3, "16"},
        {cube + "matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]\n", 3, "last row"},
        {cube + "matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]\nscale = 2\n", 3, "not both"},
    };
    for (const Case& row : cases) {
        const Refusal r = refusal(row.text + (row.text.starts_with("[camera]") ? cube : ""));
        CAPTURE(row.text, r.sentence);
        CHECK(r.code >= Errc::file);
        CHECK(r.sentence.starts_with(fmt::format("./s.toml:{}: ", row.line)));
        CHECK(r.sentence.find(row.word) != std::string::npos);
    }
}

TEST_CASE("text that is no TOML is a fault of format with its line", "[scene_file]") {
    for (const std::string& text :
         {std::string("\n[camera\n"), std::string("\nx = \n"), std::string("\na = 1e999999\n"),
          std::string("\n\xff\xfe"), std::string("\na = 1\n").append("a = 2\n"),
          "\nx = " + std::string(100000, '[')}) {
        const Refusal r = refusal(text);
        CAPTURE(text.substr(0, 40), r.sentence);
        CHECK(r.sentence.starts_with("./s.toml:"));
        CHECK((r.code == Errc::format || r.code == Errc::scene));
        CHECK(r.sentence.find('\n') == std::string::npos);
    }
}

TEST_CASE("a mesh without a drawable face is refused where it is named", "[scene_file]") {
    const TempFolder folder;
    folder.write("points.obj", "v 0 0 0\n");
    Settings settings;
    try {
        parse_scene(cube + "[[object]]\nmesh = \"points.obj\"\n", folder.path / "s.toml", settings);
        FAIL("taken");
    } catch (const Error& error) {
        const std::string sentence = error.what();
        CAPTURE(sentence);
        CHECK(error.code() == Errc::format);
        CHECK(sentence.find("s.toml:4: ") != std::string::npos);
        CHECK(sentence.find("no face that can be drawn") != std::string::npos);
    }
}

TEST_CASE("a file of very many materials is read in a moment", "[scene_file]") {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += fmt::format("[[material]]\nname = \"m{}\"\n", i);
    CHECK(parse(text).materials.size() == 20000);
}

TEST_CASE("a scene with more triangles than can be drawn is refused while it is read",
          "[scene_file]") {
    std::string text;
    for (int i = 0; i < 1100; ++i) text += "[[object]]\nshape = \"sphere\"\ntessellation = 128\n";
    const Refusal refused = refusal(text);
    CHECK(refused.code == Errc::scene);
    CHECK(refused.sentence.find("more than 268435456 triangles") != std::string::npos);
}
