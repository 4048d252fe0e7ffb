#include "scanshade/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;

namespace {

/// A quadrilateral in z = 0 of two triangles around `centre`.
std::shared_ptr<const Mesh> quad(const glm::dvec3& centre, double half_width, double half_height) {
    PolygonSoup soup;
    soup.name = "quad";
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        soup.positions.push_back(centre + glm::dvec3(x * half_width, y * half_height, 0));
    for (std::uint32_t i = 0; i < 4; ++i) soup.corners.push_back({i, no_index, no_index});
    soup.face_begin = {0, 4};
    soup.face_material = {0};
    return std::make_shared<const Mesh>(build_mesh(soup, {}));
}

const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

struct Refusal {
    Errc code{};
    std::string sentence = "taken";
};

Refusal refusal(const std::filesystem::path& path) {
    Settings settings;
    try {
        load_scene(path, settings);
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    return {};
}

/// Scene with every kind of thing that normalisation moves.
Scene everything(double size) {
    Scene scene = single_object_scene(quad(glm::dvec3(3, 4, 5) * size, 2 * size, size), {});
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].to_world =
        glm::dmat4(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7 * size, 0, size, 1);
    Light light;
    light.position = glm::dvec3(1, 2, 3) * size;
    light.attenuation = glm::dvec3(1, 0.5 / size, 0.25 / size / size);
    light.radius = 0.125 * size;
    Light without_radius = light;
    without_radius.radius.reset();
    scene.lights = {light, without_radius};
    Camera camera;
    camera.position = glm::dvec3(0, 1, 20) * size;
    camera.focal_point = glm::dvec3(3, 4, 5) * size;
    camera.near = 2 * size;
    camera.far = 300 * size;
    scene.camera = camera;
    return scene;
}

}  // namespace

TEST_CASE("bounds are the sphere around the box of all vertices in world space", "[scene]") {
    Scene scene = single_object_scene(quad({0, 0, 0}, 3, 4), {});
    CHECK(scene.bounds().centre == glm::dvec3(0));
    CHECK(scene.bounds().radius == 5);
    scene.objects[0].to_world = glm::dmat4(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1);
    CHECK(scene.bounds().centre == glm::dvec3(10, 20, 30));
    CHECK(scene.bounds().radius == 10);
    CHECK(Scene{}.bounds().radius == 1);
    const Scene far_away = single_object_scene(quad({1e9, -1e9, 1e9}, 3, 4), {});
    CHECK(far_away.bounds().radius == Approx(5).epsilon(1e-6));
    const Scene huge = single_object_scene(quad({0, 0, 0}, 3e90, 4e90), {});
    CHECK(huge.bounds().radius == Approx(5e90));
}

TEST_CASE("triangles are counted once for each object", "[scene]") {
    Scene scene = single_object_scene(quad({0, 0, 0}, 1, 1), {});
    CHECK(scene.triangle_count() == 2);
    scene.objects.push_back(scene.objects[0]);
    CHECK(scene.triangle_count() == 4);
}

TEST_CASE("a single object is lit and every mesh material is the one given", "[scene]") {
    Material material;
    material.name = "chalk";
    const Scene scene = single_object_scene(quad({0, 0, 0}, 1, 1), material);
    CHECK(scene.lights.size() == 3);
    CHECK(scene.ambient.x > 0);
    CHECK_FALSE(scene.camera);
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].name == "chalk");
    CHECK(scene.objects[0].materials == std::vector<std::uint32_t>{0});
}

TEST_CASE("three-point lighting exposes well and burns nothing", "[scene][light]") {
    const std::uint64_t seed = 1;
    CAPTURE(seed);
    Rng rng(seed);
    const Scene scene = single_object_scene(quad({7, 8, 9}, 3, 4), {});
    const Bounds bounds = scene.bounds();
    const Camera camera = framed_camera(bounds, 1);
    double brightest = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const glm::dvec3 v(rng.real(-1, 1), rng.real(-1, 1), rng.real(-1, 1));
        // Only what the camera may see.
        if (glm::dot(v, camera.position - bounds.centre) <= 0) continue;
        const glm::dvec3 n = glm::normalize(v);
        glm::dvec3 radiance = scene.ambient;
        for (const Light& light : scene.lights) {
            CHECK(light.attenuation == glm::dvec3(1, 0, 0));
            const glm::dvec3 to_light = light.kind == LightKind::directional
                                            ? -light.direction
                                            : light.position - bounds.centre;
            radiance += light.intensity * std::max(0.0, glm::dot(n, glm::normalize(to_light)));
        }
        brightest = std::max({brightest, radiance.x, radiance.y, radiance.z});
    }
    CHECK(brightest > 0.8);
    CHECK(brightest < 1);
}

TEST_CASE("key light comes from the left, fill from the right, rim from behind", "[scene][light]") {
    Camera camera;
    camera.position = {10, 0, 0};  // right of the picture is −z
    camera.focal_point = {0, 0, 0};
    const auto lights = three_point_lights({}, camera);
    REQUIRE(lights.size() == 3);
    const auto towards = [&](int i) {
        return lights[std::size_t(i)].kind == LightKind::directional
                   ? -lights[std::size_t(i)].direction
                   : lights[std::size_t(i)].position;
    };
    CHECK(towards(0).z > 0);
    CHECK(towards(0).x > 0);
    CHECK(towards(0).y > 0);
    CHECK(towards(1).z < 0);
    CHECK(towards(1).x > 0);
    CHECK(towards(2).x < 0);
    CHECK(lights[0].intensity.x > lights[1].intensity.x);
}

TEST_CASE("a normalised scene has a radius in [1, 2) and its origin at the eye or the centre",
          "[scene]") {
    for (const double size : {1e-30, 0.3, 1.0, 1e30}) {
        CAPTURE(size);
        Scene scene = everything(size);
        const Bounds given = scene.bounds();
        const auto bounds_for = [&](double radii) {
            scene.camera->position = given.centre + given.radius * radii * glm::dvec3(0.6, 0, 0.8);
            return normalised(scene).bounds();
        };
        for (const double radii : {0.0, 0.3, 1.0, 1.249}) {
            CAPTURE(radii);
            const Bounds bounds = bounds_for(radii);
            CHECK(normalised(scene).camera->position == glm::dvec3(0));
            CHECK(glm::length(bounds.centre) == Approx(radii * bounds.radius).margin(1e-12));
            CHECK(bounds.radius >= 1);
            CHECK(bounds.radius < 2);
        }
        for (const double radii : {1.251, 5.0, 1e60}) {
            CAPTURE(radii);
            CHECK(glm::length(bounds_for(radii).centre) < 1e-6);
            CHECK(glm::length(normalised(scene).camera->position) > 1.25);
        }
        scene.camera.reset();
        CHECK(glm::length(normalised(scene).bounds().centre) < 1e-6);
    }
}

TEST_CASE("normalisation loses no digit of what is close to the eye", "[scene]") {
    // A thing of 1e-7 beside the eye, in a scene of 1e7.
    Scene scene = single_object_scene(quad({0, 0, 0}, 1e7, 1e7), {});
    const glm::dvec3 eye(0x1.8p22, 0x1p20, 3), light = eye + glm::dvec3(0, 0x1p-25, 0);
    scene.lights.resize(1);
    scene.lights[0].kind = LightKind::point;
    scene.lights[0].position = light;
    scene.camera = Camera{};
    scene.camera->position = eye;
    const Scene n = normalised(scene);
    const double unit = scene.bounds().radius / n.bounds().radius;
    CHECK((n.lights[0].position - n.camera->position) * unit == light - eye);
    CHECK(glm::vec3(n.lights[0].position) != glm::vec3(n.camera->position));
}

TEST_CASE("normalisation keeps the picture", "[scene]") {
    const Scene scene = everything(3);
    const Scene n = normalised(scene);
    const Bounds bounds = scene.bounds();
    const double unit = bounds.radius / n.bounds().radius;
    CHECK(std::exp2(std::round(std::log2(unit))) == Approx(unit).epsilon(1e-12));
    const glm::dvec3 origin = bounds.centre - n.bounds().centre * unit;
    CHECK(glm::length(n.camera->position * unit + origin - scene.camera->position) < 1e-12);
    CHECK(glm::length(n.camera->focal_point * unit + origin - scene.camera->focal_point) < 1e-12);
    CHECK(*n.camera->near * unit == Approx(*scene.camera->near));
    CHECK(*n.camera->far * unit == Approx(*scene.camera->far));
    CHECK(*n.lights[0].radius * unit == Approx(*scene.lights[0].radius));
    CHECK(*n.lights[1].radius * unit == Approx(1e-4 * bounds.radius));
    const auto attenuation = [](const Light& light, const glm::dvec3& p) {
        const double d = glm::length(p - light.position);
        return light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d;
    };
    const glm::dvec3 p(0.3, -0.2, 0.7);
    CHECK(attenuation(n.lights[0], p) == Approx(attenuation(scene.lights[0], p * unit + origin)));
    CHECK(n.lights[0].intensity == scene.lights[0].intensity);
    CHECK(n.objects[1].mesh == scene.objects[1].mesh);
}

TEST_CASE("scaling the input by a power of two leaves the normalised scene alone", "[scene]") {
    const Scene plain = normalised(everything(1));
    for (const int exponent : {-60, -1, 1, 10, 60}) {
        CAPTURE(exponent);
        const Scene scaled = normalised(everything(std::exp2(exponent)));
        for (std::size_t i = 0; i < plain.objects.size(); ++i) {
            const Mesh &a = *plain.objects[i].mesh, &b = *scaled.objects[i].mesh;
            CHECK(a.x == b.x);
            CHECK(plain.objects[i].to_world[3] == scaled.objects[i].to_world[3]);
            for (int column = 0; column < 3; ++column)
                CHECK(plain.objects[i].to_world[column] * a.unit ==
                      scaled.objects[i].to_world[column] * b.unit);
        }
        for (std::size_t i = 0; i < plain.lights.size(); ++i) {
            CHECK(plain.lights[i].position == scaled.lights[i].position);
            CHECK(plain.lights[i].attenuation == scaled.lights[i].attenuation);
            CHECK(plain.lights[i].radius == scaled.lights[i].radius);
        }
        CHECK(plain.camera->position == scaled.camera->position);
        CHECK(plain.camera->focal_point == scaled.camera->focal_point);
        CHECK(plain.camera->near == scaled.camera->near);
        CHECK(plain.camera->far == scaled.camera->far);
    }
}

TEST_CASE("an OBJ file is lit by default and keeps its camera open", "[scene]") {
    const TempFolder folder;
    Settings settings;
    const Scene scene = load_scene(folder.write("Square.OBJ", square), settings);
    CHECK(scene.name == "Square");
    CHECK(scene.triangle_count() == 2);
    CHECK(scene.lights.size() == 3);
    CHECK(scene.ambient == glm::dvec3(0.12));
    CHECK_FALSE(scene.camera);
}

TEST_CASE("options of lights and camera override those of the scene", "[scene]") {
    const TempFolder folder;
    const auto path = folder.write("square.obj", square);
    Settings settings;
    settings.lights = {parse_light("point:0,0,9")};
    settings.projection = Projection::orthographic;
    const Scene scene = load_scene(path, settings);
    CHECK(scene.lights.size() == 1);
    REQUIRE(scene.camera);
    const Camera framed = framed_camera(scene.bounds(), 4.0 / 3);
    CHECK(scene.camera->projection == Projection::orthographic);
    CHECK(scene.camera->position == framed.position);

    Settings nowhere;
    nowhere.camera_position = glm::dvec3(0, 0, 0);
    nowhere.camera_focal_point = glm::dvec3(0, 0, 0);
    CHECK_THROWS_AS(load_scene(path, nowhere), Error);
}

TEST_CASE("the up axis z becomes y without rounding", "[scene]") {
    const TempFolder folder;
    Settings settings;
    settings.up = UpAxis::z;
    const Scene obj =
        load_scene(folder.write("up.obj", "v 0 0 0\nv 1 0 0\nv 0 0.1 0.7\nf 1 2 3\n"), settings);
    const Scene toml = load_scene(
        folder.write("up.toml", "[[object]]\nmesh = \"up.obj\"\ntranslate = [1, 0, 0]\n"),
        settings);
    CHECK(glm::dvec3(obj.objects[0].to_world * glm::dvec4(1, 2, 3, 1)) == glm::dvec3(1, 3, -2));
    CHECK(glm::dvec3(toml.objects[0].to_world * glm::dvec4(1, 2, 3, 1)) == glm::dvec3(2, 3, -2));
}

TEST_CASE("files that are no scenes are refused", "[scene]") {
    const TempFolder folder;
    struct Case {
        std::filesystem::path path;
        Errc code;
        std::string_view word;
    };
    std::filesystem::create_directory(folder.path / "folder.obj");
    folder.write("huge.obj", "v 0 0 0\nv 1e99 0 0\nv 0 1e99 0\nf 1 2 3\n");
    folder.write("tiny.obj", "v 0 0 0\nv 1e-99 0 0\nv 0 1e-99 0\nf 1 2 3\n");
    const Case cases[] = {
        {folder.path / "no.obj", Errc::file, "no such file"},
        {folder.path / "no.xyz", Errc::file, "no such file"},
        {folder.path / "folder.obj", Errc::file, "folder"},
        {folder.write("a.stl", "solid"), Errc::format, ".obj"},
        {folder.write("a", "solid"), Errc::format, ".obj"},
        {folder.write("points.obj", "v 0 0 0\n"), Errc::format, "no face that can be drawn"},
        {folder.write("empty.toml", ""), Errc::format, "no face that can be drawn"},
        {folder.write("zero.toml", std::string("a\0b", 3)), Errc::format, "no text"},
        {folder.write("huge.toml", "[[object]]\nmesh = \"huge.obj\"\nscale = 1e50\n"), Errc::scene,
         "radius"},
        {folder.write("tiny.toml", "[[object]]\nmesh = \"tiny.obj\"\nscale = 1e-50\n"), Errc::scene,
         "radius"},
    };
    for (const Case& row : cases) {
        const Refusal r = refusal(row.path);
        CAPTURE(row.path, r.sentence);
        CHECK(r.code == row.code);
        CHECK(r.sentence.starts_with(row.path.string()));
        CHECK(r.sentence.find(row.word) != std::string::npos);
    }
}
