#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/error.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/image/texture.hpp"
#include "scanshade/scene/scene.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

const std::string cube = "[[object]]\nshape = \"cube\"\n";

Scene parse(std::string_view text, const std::filesystem::path& folder = ".") {
    Settings settings;
    return parse_scene(text, folder / "s.toml", settings);
}

Settings settings_of(std::string_view text, std::set<std::string, std::less<>> given = {}) {
    Settings settings;
    settings.given = std::move(given);
    parse_scene(text, "s.toml", settings);
    return settings;
}

struct Refusal {
    Errc code{};
    std::string sentence = "taken";
};

Refusal refusal(std::string_view text) {
    try {
        parse(text);
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    return {};
}

glm::dvec3 placed(const Object& object, const glm::dvec3& p) {
    return glm::dvec3(object.to_world * glm::dvec4(p, 1));
}

}  // namespace

TEST_CASE("image and render tables hold options by their names", "[scene_file]") {
    const Settings s = settings_of(R"(
[image]
size = [320, 200]
background = [0, 0.5, 1.5]
samples = 16
[render]
shading = "flat"
brdf = "lambert"
set = ["kd=0.5", "ka=0.1,0.2,0.3"]
interpolation = "edges"
renderer = "scalar-f64"
transfer = "linear"
exposure = -1
camera-position = [1, 2.5, 3]
camera-view-angle = 45
projection = "orthographic"
light = ["point:1,2,3", "directional:0,-1,0"]
normals = "area"
crease = 90
cull = "back"
mtl-ambient = true
up = "z"
)");
    CHECK(s.width == 320);
    CHECK(s.height == 200);
    CHECK(s.background == glm::dvec3(0, 0.5, 1.5));
    CHECK(s.samples == 16);
    CHECK(s.shading == Shading::flat);
    CHECK(s.brdf == "lambert");
    CHECK(s.set.size() == 2);
    CHECK(s.set[1].place == "s.toml:9");
    CHECK(s.interpolation == Interpolation::edges);
    CHECK(s.renderer == RendererKind::scalar_f64);
    CHECK(s.transfer == Transfer::linear);
    CHECK(s.exposure_ev == -1);
    CHECK(s.camera_position == glm::dvec3(1, 2.5, 3));
    CHECK(s.camera_view_angle_deg == 45);
    CHECK(s.projection == Projection::orthographic);
    CHECK(s.lights.size() == 2);
    CHECK(s.normals.source == NormalSource::area);
    CHECK(s.normals.crease_deg == 90);
    CHECK(s.cull == Cull::back);
    CHECK(s.mtl_ambient);
    CHECK(s.up == UpAxis::z);
    CHECK(s.given.empty());
}

TEST_CASE("what the command line gave stands, and the file is checked all the same",
          "[scene_file]") {
    const std::string text =
        "[image]\nsize = [320, 200]\n[render]\nshading = \"flat\"\ncull = \"back\"\n"
        "light = \"point:1,2,3\"\n";
    const Settings s = settings_of(text, {"resolution", "shading", "light"});
    CHECK(s.width == 960);
    CHECK(s.shading == Shading::phong);
    CHECK(s.lights.empty());
    CHECK(s.cull == Cull::back);
    CHECK_THROWS_AS(settings_of("[render]\nshading = \"flt\"\n", {"shading"}), Error);
}

TEST_CASE("an object's shading is kept beside that of the render table", "[scene_file]") {
    Settings settings;
    const Scene scene = parse_scene(
        "[render]\nshading = \"gouraud\"\n[[object]]\nshape = \"cube\"\nshading = \"flat\"\n" +
            cube,
        "s.toml", settings);
    CHECK(settings.shading == Shading::gouraud);
    CHECK(scene.objects[0].shading == Shading::flat);
    CHECK_FALSE(scene.objects[1].shading);
}

TEST_CASE("lights have all their keys", "[scene_file]") {
    const Scene scene = parse(R"(
ambient = 0.25
[[light]]
type = "spot"
position = [1, 2, 3]
direction = [0, -1, 0.5]
intensity = [3, 2, 1]
attenuation = [1, 0.5, 0.25]
cutoff = 40
penumbra = 10
radius = 0.5
[[light]]
type = "directional"
intensity = 2
)");
    CHECK(scene.ambient == glm::dvec3(0.25));
    REQUIRE(scene.lights.size() == 2);
    const Light& spot = scene.lights[0];
    CHECK(spot.kind == LightKind::spot);
    CHECK(spot.position == glm::dvec3(1, 2, 3));
    CHECK(spot.direction == glm::dvec3(0, -1, 0.5));
    CHECK(spot.intensity == glm::dvec3(3, 2, 1));
    CHECK(spot.attenuation == glm::dvec3(1, 0.5, 0.25));
    CHECK(spot.cutoff_deg == 40);
    CHECK(spot.penumbra_deg == 10);
    CHECK(spot.radius == 0.5);
    CHECK(scene.lights[1].kind == LightKind::directional);
    CHECK(scene.lights[1].intensity == glm::dvec3(2));
}

TEST_CASE("a camera has all its keys", "[scene_file]") {
    const Scene scene = parse(
        "[camera]\nposition = [1, 2, 3]\nfocal_point = [4, 5, 7]\nview_up = [0, 0, 1]\n"
        "view_angle = 50\nprojection = \"orthographic\"\nnear = 0.5\nfar = 20\n" +
        cube);
    REQUIRE(scene.camera);
    CHECK(scene.camera->position == glm::dvec3(1, 2, 3));
    CHECK(scene.camera->focal_point == glm::dvec3(4, 5, 7));
    CHECK(scene.camera->view_up == glm::dvec3(0, 0, 1));
    CHECK(scene.camera->view_angle_deg == 50);
    CHECK(scene.camera->projection == Projection::orthographic);
    CHECK(scene.camera->near == 0.5);
    CHECK(scene.camera->far == 20);
}

TEST_CASE("what a camera leaves out is framed", "[scene_file]") {
    CHECK_FALSE(parse(cube).camera);
    const Scene scene = parse("[image]\nsize = [200, 400]\n[camera]\nview_angle = 50\n" + cube +
                              "translate = [100, 0, 0]\n");
    REQUIRE(scene.camera);
    CHECK(scene.camera->position == framed_camera(scene.bounds(), 0.5).position);
    CHECK(scene.camera->focal_point == scene.bounds().centre);
    CHECK(scene.camera->view_angle_deg == 50);
}

TEST_CASE("materials have a model, parameters with their places and a texture", "[scene_file]") {
    const TempFolder folder;
    save_png(Image(2, 1), folder.path / "map.png");
    const Scene scene = parse(R"([[material]]
name = "red"
brdf = "phong"
kd = [0.6, 0.1, 0]
ks = 0.25
shininess = 40
distribution = "ggx"  # a word: checked when the model is known for good
map_kd = "map.png"
[[object]]
shape = "cube"
material = "red"
)",
                              folder.path);
    REQUIRE(scene.materials.size() >= 1);
    const Material& red = scene.materials[scene.objects[0].materials[0]];
    CHECK(red.name == "red");
    CHECK(red.brdf == "phong");
    CHECK(red.place == (folder.path / "s.toml").string() + ":1");
    REQUIRE(red.find("kd"));
    CHECK(red.find("kd")->values == std::vector<double>{0.6, 0.1, 0});
    CHECK(red.find("ks")->values == std::vector<double>{0.25});
    CHECK(red.find("ks")->place == (folder.path / "s.toml").string() + ":5");
    CHECK(red.find("distribution")->word == "ggx");
    CHECK(red.find("distribution")->place == (folder.path / "s.toml").string() + ":7");
    REQUIRE(red.map_kd);
    CHECK(red.map_kd->width() == 2);
    // The second object has the default material.
    const Scene plain = parse(cube);
    CHECK(plain.materials[plain.objects[0].materials[0]].name == "default");
}

TEST_CASE("objects are scaled, turned about x, y and z, then moved", "[scene_file]") {
    const Scene scene =
        parse(cube + "scale = [2, 3, 4]\nrotate = [90, 90, 0]\n" + "translate = [10, 20, 30]\n" +
              cube + "scale = 2\n" + cube + "matrix = [1,2,3,4, 0,1,5,6, 0,0,1,7, 0,0,0,1]\n");
    // y·3 turns to z about x, and z to x about y.
    CHECK(glm::length(placed(scene.objects[0], {0, 1, 0}) - glm::dvec3(13, 20, 30)) < 1e-14);
    CHECK(glm::length(placed(scene.objects[0], {1, 0, 0}) - glm::dvec3(10, 20, 28)) < 1e-14);
    CHECK(placed(scene.objects[1], {1, 2, 3}) == glm::dvec3(2, 4, 6));
    CHECK(placed(scene.objects[2], {1, 10, 100}) == glm::dvec3(325, 516, 107));
}

TEST_CASE("an object may be thin but not flat", "[scene_file]") {
    CHECK(parse(cube + "scale = [1, 1e-9, 1e-9]\n").objects.size() == 1);
    CHECK(refusal(cube + "scale = [1, 0, 1]\n").code == Errc::scene);
    CHECK(refusal(cube + "matrix = [1,2,0,0, 2,4,0,0, 0,0,1,0, 0,0,0,1]\n").code == Errc::scene);
}

TEST_CASE("a mesh or shape that is used twice is made once", "[scene_file]") {
    const TempFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    const Scene scene = parse(cube + cube + cube + "tessellation = 2\n" +
                                  "[[object]]\nmesh = \"a.obj\"\n[[object]]\nmesh = \"a.obj\"\n",
                              folder.path);
    CHECK(scene.objects[0].mesh == scene.objects[1].mesh);
    CHECK(scene.objects[0].mesh != scene.objects[2].mesh);
    CHECK(scene.objects[3].mesh == scene.objects[4].mesh);
    CHECK(scene.events[Event::degenerate_face] == 1);
}

TEST_CASE("a mesh keeps its own materials unless its object names one", "[scene_file]") {
    const TempFolder folder;
    folder.write("a.mtl", "newmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n");
    folder.write("a.obj",
                 "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl green\nf 1 2 3\nusemtl "
                 "blue\nf 3 2 1\n");
    const Scene scene = parse(
        "[[material]]\nname = \"red\"\n[[object]]\nmesh = \"a.obj\"\n[[object]]\nmesh = "
        "\"a.obj\"\nmaterial = \"red\"\n",
        folder.path);
    REQUIRE(scene.objects[0].materials.size() == 2);
    CHECK(scene.materials[scene.objects[0].materials[0]].name == "green");
    CHECK(scene.materials[scene.objects[0].materials[1]].name == "blue");
    for (const std::uint32_t m : scene.objects[1].materials)
        CHECK(scene.materials[m].name == "red");
}

TEST_CASE("every shape of the table can be an object", "[scene_file]") {
    for (const ShapeInfo& shape : all_shapes()) {
        CAPTURE(shape.name);
        const Scene scene = parse(fmt::format("[[object]]\nshape = \"{}\"\n", shape.name));
        CHECK(scene.triangle_count() > 0);
    }
}

TEST_CASE("a shape brings its materials; the object's material goes before them", "[scene_file]") {
    const std::string box = "[[object]]\nshape = \"cornell-box\"\n";
    const Scene scene =
        parse("[[material]]\nname = \"red\"\n" + box + box + "material = \"red\"\n");
    std::vector<std::string> names;
    for (const std::uint32_t m : scene.objects[0].materials)
        names.push_back(scene.materials[m].name);
    CHECK(names == std::vector<std::string>{"cornell-white", "cornell-green", "cornell-red",
                                            "cornell-lamp"});
    REQUIRE(scene.objects[1].materials.size() == 4);
    for (const std::uint32_t m : scene.objects[1].materials)
        CHECK(scene.materials[m].name == "red");
}

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
