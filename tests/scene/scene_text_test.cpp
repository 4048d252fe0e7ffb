// A scene that was written shows the same picture when it is read again.
#include <filesystem>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"
#include "support/pictures.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

/// Writes the scene beside `input`'s folder, reads it, and compares pictures bit by bit.
void check_round_trip(const fs::path& input, Settings settings = {}) {
    CAPTURE(input.string());
    const TempFolder folder;
    const Scene scene = load_scene(input, settings);
    settings.width = 90, settings.height = 60, settings.samples = 1;
    const std::string text = scene_text(scene, settings, folder.path);
    CAPTURE(text);
    Settings again;
    again.allow_outside = true;  // it names files where they are
    const Scene back = load_scene(folder.write("saved.toml", text), again);
    const Drawn before = draw(scene, settings), after = draw(back, again);
    CHECK(before.frame.r == after.frame.r);
    CHECK(before.frame.g == after.frame.g);
    CHECK(before.frame.b == after.frame.b);
    CHECK(before.frame.depth == after.frame.depth);
    CHECK(before.frame.id == after.frame.id);
    CHECK(scene_text(back, again, folder.path) == text);
    CHECK(seen(before.frame) > 100);
}

constexpr const char* two_materials =
    "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl a\nf 1 2 3\nusemtl b \"\xff\"\nf "
    "1 "
    "3 4\n";
constexpr const char* library =
    "newmtl a\nKd 1 0 0\nNs 20\nKs 0.5 0.5 0.5\nnewmtl b \"\xff\"\nKd 0 0 1\n";

}  // namespace

TEST_CASE("every shipped scene survives being written and read", "[scene]") {
    for (const auto& entry : fs::directory_iterator("models/scenes"))
        if (entry.path().extension() == ".toml") check_round_trip(entry.path());
    check_round_trip("models/scenes/tiled-floor.obj");
}

TEST_CASE("what options choose is written with the scene", "[scene]") {
    const TempFolder folder;
    folder.write("m.mtl", library);
    const fs::path obj = folder.write("two \\ \"faces\".obj", two_materials);
    Settings settings;
    for (const auto& [name, value] : {std::pair{"shading", "gouraud"},
                                      {"brdf", "torrance-sparrow"},
                                      {"set", "m=0.5"},
                                      {"set", "distribution=beckmann"},
                                      {"interpolation", "edges"},
                                      {"up", "z"},
                                      {"background", "0.1,0.2,0.3"},
                                      {"exposure", "-0.5"},
                                      {"light", "spot:1,2,3:-1,-2,-3:40:1,0.5,0.2:1,0,0.1"},
                                      {"camera-position", "0.5,2,3"},
                                      {"crease", "12.5"},
                                      {"cull", "back"},
                                      {"transfer", "linear"}}) {
        find_option(name)->apply(settings, value);
        settings.given.insert(name);
    }
    check_round_trip(obj, settings);
    check_round_trip(obj);
}

TEST_CASE("each option shows what it takes", "[scene][options]") {
    const Settings standard;
    for (const OptionInfo& option : shared_options()) {
        if (option.show == nullptr) continue;
        CAPTURE(option.name);
        Settings settings;
        if (const std::string text = option.show(standard); !text.empty())
            option.apply(settings, text);
        CHECK(option.show(settings) == option.show(standard));
        if (option.control.kind == OptionControl::none) continue;
        const OptionControl& control = option.control;
        const std::string other =
            control.kind == OptionControl::choice
                ? std::string(control.choices.substr(control.choices.rfind('|') + 1))
            : control.kind == OptionControl::flag   ? "true"
            : control.kind == OptionControl::colour ? "0.5,0.25,1"
                                                    : "3";
        option.apply(settings, other);
        CHECK(option.show(settings) == other);
    }
}

TEST_CASE("a scene that a program made cannot be written", "[scene]") {
    CHECK_THROWS_AS(scene_text(lit_sphere(), {}, "."), Error);
}

TEST_CASE("an object's materials are named one by one", "[scene]") {
    const std::string head = "[[material]]\nname = \"a\"\n";
    Settings settings;
    for (const char* bad :
         {"materials = [\"a\", \"a\"]", "materials = [\"b\"]", "materials = \"a\"",
          "materials = [1]", "materials = [\"a\"]\nmaterial = \"a\""})
        CHECK_THROWS_AS(
            parse_scene(head + "[[object]]\nshape = \"sphere\"\n" + bad, "x.toml", settings),
            Error);
    const Scene scene = parse_scene(head + "[[object]]\nshape = \"sphere\"\nmaterials = [\"a\"]\n",
                                    "x.toml", settings);
    CHECK(scene.materials[scene.objects[0].materials[0]].name == "a");
}
