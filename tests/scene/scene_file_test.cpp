#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/image/image.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/image/texture.hpp"
#include "scanshade/scene/shapes.hpp"
#include "scene/scene_file_text.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

Settings settings_of(std::string_view text, std::set<std::string, std::less<>> given = {}) {
    Settings settings;
    settings.given = std::move(given);
    parse_scene(text, "s.toml", settings);
    return settings;
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

TEST_CASE("vertex normals of a shape are its own, or made from its faces where that is asked for",
          "[scene_file]") {
    // At a cube's corners normals stand along an axis, or along the diagonal where its sides share one.
    const auto largest = [](const std::string& render) {
        const Scene scene =
            parse("[render]\n" + render + "[[object]]\nshape = \"cube\"\ntessellation = 1\n");
        const std::vector<float>& nx = scene.objects[0].mesh->nx;
        return *std::max_element(nx.begin(), nx.end());
    };
    const std::string average = "normals = \"average\"\n";
    CHECK(largest("") == 1);
    CHECK(largest(average) == 1);  // the sides meet at more than the crease angle
    CHECK(largest(average + "crease = 180\n") == Approx(std::sqrt(1 / 3.0)));
    CHECK(largest(average + "crease = 91\n") == Approx(std::sqrt(1 / 3.0)));
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
