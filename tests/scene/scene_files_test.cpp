// What a scene may read besides its own file, and how much of everything it may hold.
#include <fmt/format.h>

#include <functional>

#include "scanshade/base/error.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/scene/obj.hpp"
#include "scanshade/scene/scene.hpp"
#include "scene/limits.hpp"
#include "scene/scene_files.hpp"
#include "scene/toml_keys.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

/// outside.obj, outside.mtl and outside.png; scene/ with inside.* below, and links in it.
struct Folders {
    TempFolder top;
    fs::path scene = top.path / "scene";

    Folders() {
        fs::create_directories(scene / "below");
        for (const fs::path& place : {top.path / "outside", scene / "below" / "inside"}) {
            const std::string name = place.lexically_relative(top.path);
            top.write(name + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            top.write(name + ".mtl", "newmtl m\nKd 1 0 0\n");
            save_png(Image(2, 2), place.string() + ".png");
        }
        fs::create_symlink("../outside.png", scene / "link.png");
        fs::create_symlink("below/inside.png", scene / "good_link.png");
        fs::create_directory_symlink("..", scene / "up");
    }
};

/// "" where it is read, else why not.
std::string refusal(const std::function<void()>& read) {
    try {
        read();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string refusal_of_scene(const std::string& text, const fs::path& folder, bool outside) {
    return refusal([&] {
        Settings settings;
        settings.allow_outside = outside;
        parse_scene(text, folder / "s.toml", settings);
    });
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string out;
    out.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) out += text;
    return out;
}

}  // namespace

TEST_CASE("a scene reads what is below its folder, and what is outside only if that is allowed",
          "[scene_file][files]") {
    const Folders folders;
    struct Case {
        std::string name;
        bool inside;
    };
    const std::string absolute = (folders.top.path / "outside").string();
    const Case cases[] = {{"below/inside", true},
                          {"./below/../below/inside", true},
                          {"../scene/below/inside", true},
                          {"up/scene/below/inside", true},
                          {(folders.scene / "below/inside").string(), true},
                          {"../outside", false},
                          {"below/../../outside", false},
                          {"up/outside", false},
                          {absolute, false}};
    for (const Case& row : cases)
        for (const std::string kind : {"mesh", "map_kd"})
            for (const bool allowed : {false, true}) {
                const std::string text =
                    kind == "mesh"
                        ? "[[object]]\nmesh = \"" + row.name + ".obj\"\n"
                        : "[[material]]\nname = \"m\"\nmap_kd = \"" + row.name + ".png\"\n";
                const std::string why = refusal_of_scene(text, folders.scene, allowed);
                CAPTURE(row.name, kind, allowed, why);
                CHECK(why.empty() == (row.inside || allowed));
                if (!why.empty()) CHECK(why.find("--allow-outside") != std::string::npos);
            }
    const auto map = [](const char* name) {
        return fmt::format("[[material]]\nname = \"m\"\nmap_kd = \"{}\"\n", name);
    };
    CHECK(refusal_of_scene(map("good_link.png"), folders.scene, false).empty());
    CHECK(refusal_of_scene(map("link.png"), folders.scene, false).find("outside") !=
          std::string::npos);
    CHECK(refusal_of_scene(map("../outside.png\\u0000/../scene/x"), folders.scene, true)
              .find("byte of value 0") != std::string::npos);
}

TEST_CASE("an OBJ file's libraries and textures obey the same rule, and are missed aloud",
          "[obj][files]") {
    const Folders folders;
    const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    const auto load = [&](const std::string& library, bool outside) {
        SceneFiles files(folders.scene, outside);
        return load_obj(folders.top.write("scene/a.obj", "mtllib " + library + "\n" + faces), files,
                        false);
    };
    CHECK(load("below\\inside.mtl", false).warnings.empty());
    CHECK(load("../outside.mtl", true).warnings.empty());
    const ObjFile refused = load("../outside.mtl", false);
    REQUIRE(refused.warnings.size() == 2);  // and its material is missing
    CHECK(refused.warnings[0].find("--allow-outside") != std::string::npos);

    const auto map = [&](const std::string& name, bool outside) {
        folders.top.write("scene/m.mtl", "newmtl m\nmap_Kd " + name + "\n");
        return load("m.mtl", outside);
    };
    CHECK(map("below/inside.png", false).materials[0].map_kd);
    CHECK(map("../outside.png", true).materials[0].map_kd);
    const ObjFile plain = map("../outside.png", false);
    CHECK_FALSE(plain.materials[0].map_kd);
    REQUIRE(plain.warnings.size() == 1);
    CHECK(plain.warnings[0].find("--allow-outside") != std::string::npos);
    // One of the same name beside the library is taken instead, as for C:\art\outside.png.
    save_png(Image(3, 3), folders.scene / "outside.png");
    const ObjFile beside = map("../outside.png", false);
    REQUIRE(beside.materials[0].map_kd);
    CHECK(beside.materials[0].map_kd->width() == 3);
}

TEST_CASE("only the user allows what is outside", "[scene_file][files]") {
    CHECK(refusal_of_scene("[render]\nallow-outside = true\n", ".", false)
              .find("--allow-outside on the command line") != std::string::npos);
}

TEST_CASE("more than the limits is refused in a sentence that names the limit",
          "[scene_file][limits]") {
    struct Case {
        const char* what;
        std::string text;
        std::size_t limit;
    };
    const std::string light = "[[light]]\ntype=\"point\"\n";
    const std::string object = "[[object]]\nshape=\"cube\"\n";
    std::string materials;
    for (std::size_t i = 0; i <= max_materials; ++i)
        materials += fmt::format("[[material]]\nname=\"{}\"\n", i);
    std::string parameters = "[[material]]\nname=\"m\"\n";
    for (std::size_t i = 0; i < max_parameters; ++i) parameters += fmt::format("k{} = 1\n", i);
    const Case cases[] = {
        {"lights", repeated(light, max_lights + 1), max_lights},
        {"objects", repeated(object, max_objects + 1), max_objects},
        {"materials", materials, max_materials},
        {"parameters", parameters, max_parameters},
        {"settings", "[render]\nset = [" + repeated("\"ks=1\",", max_parameters + 1) + "]\n",
         max_parameters},
        {"lights in [render]",
         "[render]\nlight = [" + repeated("\"point:1,2,3\",", max_lights + 1) + "]\n", max_lights},
        {"parts of a key", repeated("a.", 300'000) + "a = 1\n", max_key_parts},
        {"a file's name", "[[object]]\nmesh = \"" + repeated("./", max_path_bytes) + "a.obj\"\n",
         max_path_bytes},
        {"triangles", repeated("[[object]]\nshape=\"terrain\"\ntessellation=255\n", 4200),
         max_scene_triangles},
    };
    for (const Case& row : cases) {
        const std::string why = refusal_of_scene(row.text, ".", false);
        CAPTURE(row.what, why);
        CHECK(why.find(fmt::format("{}", row.limit)) != std::string::npos);
    }
    CHECK(refusal_of_scene(repeated(light, max_lights), ".", false).empty());
}

TEST_CASE("files larger than their limits are refused before they are read", "[files][limits]") {
    const TempFolder folder;
    struct Case {
        const char* name;
        std::size_t limit;
    };
    for (const Case& row : {Case{"a.obj", max_obj_bytes}, Case{"a.toml", max_scene_bytes}}) {
        fs::resize_file(folder.write(row.name, ""), row.limit + 1);  // holes take no disk
        const std::string why = refusal([&] {
            Settings settings;
            load_scene(folder.path / row.name, settings);
        });
        CAPTURE(row.name, why);
        CHECK(why.find(fmt::format("at most {} are read", row.limit)) != std::string::npos);
    }
    fs::resize_file(folder.write("m.mtl", ""), max_mtl_bytes + 1);
    const ObjFile file = load_obj(folder.write("b.obj", "mtllib m.mtl\n"));
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0].find(fmt::format("at most {} are read", max_mtl_bytes)) !=
          std::string::npos);
}

TEST_CASE("what the TOML library does not expect is an error, too", "[scene_file]") {
    for (const char* text :
         {"[[[camera]\n", "[[[[", "[[ [a]]\n", "key × = 1\n", "é = 1\n", "a = 1 ж\n"}) {
        CAPTURE(text);
        CHECK(refusal_of_scene(text, ".", false).find("this is no TOML") != std::string::npos);
    }
}

TEST_CASE("long keys are found wherever they may stand, and nowhere else", "[scene_file][limits]") {
    const std::string four = "a . \"=\" .'.'. d";
    struct Case {
        std::string text;
        std::size_t line;  // of a key of more than three parts
    };
    const Case cases[] = {
        {"a.b.c = 1\n" + four + " = 1", 2},
        {"[" + four + "]", 1},
        {"[[" + four + "]]", 1},
        {"x = {" + four + " = 1}", 1},
        {"x = [\"\"\"\n\"\"\", {" + four + " = 1}]", 2},
        {"x = ['''\n\"''', {" + four + " = 1}]", 2},
        {"x = \"\\\"\"\n" + four, 2},
        {"# \"\n" + four, 2},
        {"x = \"a.b.c.d\" # a.b.c.d", 0},
        {"x = '''\na.b.c.d\n''' \n", 0},
        {"x = [0.1, 0.2, 0.3, 0.4, 0.5]", 0},
        {"a.b = 1.5\nc.d = 2.5", 0},
        {"x = \"open", 0},
        {"x = \"\"\"open", 0},
    };
    for (const Case& row : cases) {
        CAPTURE(row.text);
        CHECK(line_of_long_key(row.text, 3) == row.line);
    }
}

TEST_CASE("a texture is read once, and refused once", "[files]") {
    const TempFolder folder;
    save_png(Image(2, 2), folder.path / "a.png");
    fs::create_symlink("a.png", folder.path / "link.png");
    SceneFiles files(folder.path, false);
    const auto texture = files.texture(folder.path / "a.png");
    CHECK(files.texture(folder.path / "." / "a.png") == texture);
    CHECK(files.texture(folder.path / "link.png") == texture);
    const fs::path bad = folder.write("bad.png", "no picture");
    const std::string first = refusal([&] { files.texture(bad); });
    CHECK(first.find("bad.png: this is no complete picture") != std::string::npos);
    save_png(Image(2, 2), bad);
    CHECK(refusal([&] { files.texture(bad); }) == first);
}
