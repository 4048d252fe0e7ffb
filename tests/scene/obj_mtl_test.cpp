// Material libraries, through the OBJ files that use them.
#include <filesystem>
#include <string>

#include "scanshade/image/image.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/image/texture.hpp"
#include "scanshade/scene/obj.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

ObjFile load(const std::string& text, const std::string& mtl, bool mtl_ambient = false) {
    const TempFolder folder;
    folder.write("m.mtl", mtl);
    return load_obj(folder.write("a.obj", text), mtl_ambient);
}

std::vector<double> parameter(const Material& material, std::string_view name) {
    const ParamSetting* setting = material.find(name);
    return setting ? setting->values : std::vector<double>{};
}

/// The material of a one-triangle file with this library.
Material material_of(const std::string& statements, bool mtl_ambient = false) {
    const ObjFile file = load("mtllib m.mtl\nusemtl a\n" + triangle + "f 1 2 3\n",
                              "newmtl a\n" + statements, mtl_ambient);
    REQUIRE(file.materials.size() == 1);
    CHECK(file.materials[0].name == "a");
    return file.materials[0];
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("materials are mapped to the parameters of blinn-phong", "[obj][mtl]") {
    const Material full =
        material_of("Kd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nNs 90\nKe 2 0 0\nKa 1 1 1\n");
    CHECK(full.brdf == "blinn-phong");
    CHECK(parameter(full, "kd") == Values{0.1, 0.2, 0.3});
    CHECK(parameter(full, "ks") == Values{0.4, 0.5, 0.6});
    CHECK(parameter(full, "shininess") == Values{90});
    CHECK(parameter(full, "emission") == Values{2, 0, 0});
    CHECK(full.find("ka") == nullptr);
    CHECK(full.place.find("m.mtl:1") != std::string::npos);
    CHECK(parameter(material_of("Ka 1 0.5 0\n", true), "ka") == Values{1, 0.5, 0});

    const Material empty = material_of("");
    CHECK(parameter(empty, "kd") == Values{0.8, 0.8, 0.8});
    CHECK(parameter(empty, "ks") == Values{0, 0, 0});
    CHECK(empty.find("emission") == nullptr);

    CHECK(parameter(material_of("Ks 1 1 1\n"), "ks") == Values{0, 0, 0});  // Ns absent
    CHECK(parameter(material_of("Ks 1 1 1\nNs 1\n"), "ks") == Values{1, 1, 1});
    CHECK(parameter(material_of("Ks 1 1 1\nNs 9\nillum 1\n"), "ks") == Values{0, 0, 0});
    CHECK(material_of("illum 0\n").brdf == "unlit");
    CHECK(material_of("illum 2\n").brdf == "blinn-phong");
    CHECK(parameter(material_of("Kd 0 0 0\n"), "kd") == Values{0, 0, 0});
    CHECK(parameter(material_of("Kd 0.5\n"), "kd") == Values{0.5, 0.5, 0.5});
    CHECK(parameter(material_of("Kd spectral a.rfl 1\n"), "kd") == Values{0.8, 0.8, 0.8});
}

TEST_CASE("material values out of range are clamped with a warning", "[obj][mtl]") {
    const ObjFile file = load("mtllib m.mtl\nusemtl a\n" + triangle + "f 1 2 3\n",
                              "newmtl a\nKd 1.5 -1 0.5\nKs 2 2 2\nNs 2e6\nd 0.5\n");
    const Material& m = file.materials[0];
    CHECK(parameter(m, "kd") == Values{1, 0, 0.5});
    CHECK(parameter(m, "ks") == Values{1, 1, 1});
    CHECK(parameter(m, "shininess") == Values{1e6});
    CHECK(file.warnings.size() == 7);  // two of Kd, three of Ks, Ns, d
    CHECK(file.warnings[0].find("material 'a': Kd 1.5 is outside 0 to 1; 1 is used") !=
          std::string::npos);
    CHECK(file.events[Event::transparency_ignored] == 1);
}

TEST_CASE("transparency is counted once a material, by d or by Tr", "[obj][mtl]") {
    const auto count = [](const std::string& statements) {
        return load("mtllib m.mtl\nusemtl a\n" + triangle + "f 1 2 3\nusemtl b\nf 1 2 3\n",
                    "newmtl a\n" + statements + "newmtl b\n")
            .events[Event::transparency_ignored];
    };
    CHECK(count("d 1\n") == 0);
    CHECK(count("d 0.9\n") == 1);
    CHECK(count("Tr 0.1\n") == 1);
    CHECK(count("Tr 0\n") == 0);
    CHECK(count("d 1\nTr 1\n") == 0);  // d counts
}

TEST_CASE("names that no library defines get the default material", "[obj][mtl]") {
    const ObjFile file = load("mtllib m.mtl\n" + triangle +
                                  "f 1 2 3\nusemtl none\nf 1 2 3\nf 1 2 3\nusemtl with blank \n"
                                  "f 1 2 3\n",
                              "newmtl with blank\t\nKd 1 0 0\nnewmtl unused\nKd 0 1 0\n");
    CHECK(file.soup.face_material == std::vector<std::uint32_t>{0, 1, 1, 2});
    REQUIRE(file.materials.size() == 3);
    CHECK(file.materials[0].name == "default");
    CHECK(file.materials[1].name == "none");
    CHECK(file.materials[1].parameters.empty());
    CHECK(parameter(file.materials[2], "kd") == Values{1, 0, 0});
    CHECK(file.events[Event::missing_material] == 2);
    CHECK(file.warnings.size() == 1);
}

TEST_CASE("libraries are found by names with blanks and backslashes, or missed", "[obj][mtl]") {
    const TempFolder folder;
    fs::create_directory(folder.path / "sub");
    folder.write("two words.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("sub/b.mtl", "newmtl b\nKd 0 1 0\nnewmtl a\nKd 0 0 0\n");
    const ObjFile file =
        load_obj(folder.write("x.obj", "mtllib two words.mtl\nmtllib none.mtl .\\sub\\b.mtl\n" +
                                           triangle + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n"));
    REQUIRE(file.materials.size() == 2);
    CHECK(parameter(file.materials[0], "kd") == Values{1, 0, 0});  // the first of two counts
    CHECK(parameter(file.materials[1], "kd") == Values{0, 1, 0});
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0].find("none.mtl: the file cannot be read") != std::string::npos);
}

TEST_CASE("textures are read beside the library, once", "[obj][mtl]") {
    const TempFolder folder;
    fs::create_directory(folder.path / "maps");
    Image image(2, 1);
    image.rgb = {255, 255, 255, 0, 0, 0};
    save_png(image, folder.path / "maps" / "two words.png");
    save_png(image, folder.path / "plain.png");
    folder.write("m.mtl",
                 "newmtl a\nmap_Kd maps\\two words.png\n"
                 "newmtl b\nKd 0 0 0\nmap_Kd -s 2 2 1 -clamp on maps/two words.png\n"
                 "newmtl c\nKd 0.5 0.5 0.5\nmap_Kd C:\\art\\plain.png\n"
                 "newmtl d\nKd 0 0 0\nmap_Kd none.png\nmap_Bump x.png\n");
    std::string text = "mtllib m.mtl\n" + triangle;
    for (const char* name : {"a", "b", "c", "d"})
        text += std::string("usemtl ") + name + "\nf 1 2 3\n";
    const ObjFile file = load_obj(folder.write("x.obj", text));
    const auto& m = file.materials;
    REQUIRE(m.size() == 4);
    REQUIRE(m[0].map_kd);
    CHECK(m[0].map_kd->width() == 2);
    CHECK(m[0].map_kd->levels[0].texels[0] == 1);
    CHECK(m[1].map_kd == m[0].map_kd);
    CHECK(m[2].map_kd);
    CHECK_FALSE(m[3].map_kd);
    CHECK(parameter(m[0], "kd") == Values{1, 1, 1});
    CHECK(parameter(m[1], "kd") == Values{1, 1, 1});
    CHECK(parameter(m[2], "kd") == Values{0.5, 0.5, 0.5});
    CHECK(parameter(m[3], "kd") == Values{0.8, 0.8, 0.8});
    std::string all;
    for (const std::string& w : file.warnings) all += w + "\n";
    CAPTURE(all);
    CHECK(file.warnings.size() == 3);
    CHECK(all.find("map_Bump are ignored") != std::string::npos);
    CHECK(all.find("material 'b': the options of map_Kd are ignored") != std::string::npos);
    CHECK(all.find("material 'd': drawn without its texture:") != std::string::npos);
}
