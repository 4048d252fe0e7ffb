// Scenes at the ends of what there can be: shown rightly, and in a time that has a reason. Each is
// held against something ordinary that is measured beside it, with a generous factor.
#include <algorithm>

#include "scanshade/base/timer.hpp"
#include "support/catch.hpp"
#include "support/level_check.hpp"

using namespace scanshade;

namespace {

Settings picture(int width, int height) {
    Settings s;
    s.width = width;
    s.height = height;
    s.threads = 1;
    return s;
}

/// The shortest of several frames, in milliseconds.
double frame_ms(const Scene& scene, const Settings& settings, int frames = 7) {
    Renderer renderer(scene, settings);
    PixelBuffer pixels;
    double best = 1e30;
    for (int i = 0; i < frames; ++i) {
        const Timer timer;
        renderer.draw(pixels);
        best = std::min(best, timer.ms());
    }
    return best;
}

/// "" where the vector renderer shows what scalar-f32 does.
std::string wrong(const Scene& scene, const Settings& settings) {
    Drawn drawn;
    LevelCounts counts;
    return scalar_difference(scene, settings, RendererKind::scalar_f32, drawn, counts);
}

Scene shape_scene(const char* shape, int tessellation) {
    Scene scene = single_object_scene(
        std::make_shared<Mesh>(build_mesh(find_shape(shape)->make(tessellation), {})), Material{});
    scene.camera = Camera{};
    scene.lights = three_point_lights(Bounds{}, *scene.camera);
    return scene;
}

/// The sphere so near that it fills the picture.
Scene filling_sphere() {
    Scene scene = shape_scene("sphere", 24);
    scene.camera->position = {0, 0, 1.5};
    scene.camera->view_angle_deg = 40;
    return scene;
}

/// One triangle around a point straight ahead; `size` times what the picture shows there.
Scene one_triangle(double size) {
    const PixelCamera camera(640, 480, 0.1, 100);
    const auto at = [&](double x, double y) {
        return camera.point(320 + x * size * 640, 240 + y * size * 480, 2);
    };
    Scene scene =
        make_scene(make_soup({at(-2, -1), at(0, 3), at(2, -1)}, {{0, 1, 2}}), camera.camera);
    scene.lights = three_point_lights(Bounds{}, Camera{});
    return scene;
}

}  // namespace

TEST_CASE("a camera inside a mesh", "[engine][extremes]") {
    Scene scene = filling_sphere();
    const Settings settings = picture(320, 240);
    const double outside = frame_ms(scene, settings);
    scene.camera->position = {0.2, 0.1, 0.3};
    scene.camera->focal_point = {0, 0, -1};
    scene.camera->view_angle_deg = 100;
    CHECK(wrong(scene, settings) == "");
    CHECK(seen(draw(scene, settings).frame) == 320u * 240u);
    // As many samples are shaded, and a few triangles take the slow way.
    CHECK(frame_ms(scene, settings) <= 6 * outside);
}

TEST_CASE("a mesh across the near plane", "[engine][extremes]") {
    Scene scene = filling_sphere();
    const Settings settings = picture(320, 240);
    const double whole = frame_ms(scene, settings);
    scene.camera->near = 0.9;  // the sphere's nearest point is 0.5 away
    scene.camera->far = 10;
    CHECK(wrong(scene, settings) == "");
    const Drawn drawn = draw(scene, settings);
    CHECK(drawn.stats.events[Event::near_clipped] > 0);
    CHECK(frame_ms(scene, settings) <= 6 * whole);
}

TEST_CASE("nothing in view, and nothing at all", "[engine][extremes]") {
    Scene scene = filling_sphere();
    const Settings settings = picture(640, 480);
    const double full = frame_ms(scene, settings);
    scene.camera->focal_point = {0, 0, 9};  // away from the sphere
    CHECK(wrong(scene, settings) == "");
    CHECK(seen(draw(scene, settings).frame) == 0);
    CHECK(frame_ms(scene, settings) <= full / 2);

    scene.objects.clear();
    CHECK(wrong(scene, settings) == "");
    const Drawn nothing = draw(scene, settings);
    CHECK(seen(nothing.frame) == 0);
    CHECK(nothing.frame.r == std::vector<float>(640 * 480, float(settings.background.x)));
    CHECK(frame_ms(scene, settings) <= full / 2);
}

TEST_CASE("an object without triangles, in every shading", "[engine][extremes]") {
    // A soup of degenerate faces gives a mesh without any.
    for (int shading = 0; shading < 3; ++shading) {
        Scene scene = make_scene(make_soup({{0, 0, -1}, {1, 0, -1}}, {{0, 1, 1}}),
                                 PixelCamera(32, 32).camera);
        Settings settings = picture(32, 32);
        settings.shading = Shading(shading);
        CHECK(wrong(scene, settings) == "");
        scene.objects.push_back(lit_sphere().objects[0]);
        scene.camera = Camera{};
        CHECK(wrong(scene, settings) == "");
        CHECK(seen(draw(scene, settings).frame) > 0);
    }
}

TEST_CASE("one triangle larger than the screen", "[engine][extremes]") {
    const Settings settings = picture(640, 480);
    const double fitting = frame_ms(one_triangle(1), settings);
    for (const double size : {3.0, 40.0, 1e4}) {
        CAPTURE(size);
        CHECK(wrong(one_triangle(size), settings) == "");
        CHECK(seen(draw(one_triangle(size), settings).frame) == 640u * 480u);
        // Clipped ones have their weights in double.
        CHECK(frame_ms(one_triangle(size), settings) <= 20 * fitting);
    }
}

TEST_CASE("a million triangles in one pixel", "[engine][extremes]") {
    Scene scene = shape_scene("plane", 708);
    REQUIRE(scene.triangle_count() > 1000000);
    scene.camera->position = {0, 2, 3};
    const Settings settings = picture(320, 240);
    const double spread = frame_ms(scene, settings, 3);
    scene.camera->position = {0, 2e3, 3e3};
    CHECK(wrong(scene, settings) == "");
    CHECK(seen(draw(scene, settings).frame) <= 4);
    CHECK(frame_ms(scene, settings, 3) <= 2 * spread);
}

TEST_CASE("no light, and 256 lights", "[engine][extremes]") {
    Scene scene = filling_sphere();
    const Settings settings = picture(160, 120);
    const std::vector<Light> three = scene.lights;
    scene.lights = {three[0]};
    const double one = frame_ms(scene, settings);
    scene.lights.clear();
    scene.ambient = {0.2, 0.3, 0.4};
    CHECK(wrong(scene, settings) == "");
    CHECK(frame_ms(scene, settings) <= 4 * one);
    for (int i = 0; i < 256; ++i) {
        Light light = three[std::size_t(i) % 3];
        light.position += glm::dvec3(i % 7, i % 11, i % 13) * 0.1;
        light.intensity /= 256.0;
        scene.lights.push_back(light);
    }
    CHECK(wrong(scene, settings) == "");
    CHECK(frame_ms(scene, settings) <= 4 * 256 * one);
}

TEST_CASE("pictures of one pixel, one row and one column", "[engine][extremes]") {
    const Scene scene = filling_sphere();
    const double square = frame_ms(scene, picture(128, 128));
    for (const auto& [width, height] : {std::pair{1, 1}, {16384, 1}, {1, 16384}}) {
        CAPTURE(width, height);
        CHECK(wrong(scene, picture(width, height)) == "");
        // As many samples as the square, in 256 tiles instead of its four; and room for a busy machine.
        CHECK(frame_ms(scene, picture(width, height)) <= 4 * (256.0 / 4) * square);
    }
}
