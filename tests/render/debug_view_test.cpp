// Pictures of how a picture came about.
#include "scanshade/render/debug_view.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/pictures.hpp"

using namespace scanshade;

namespace {

/// Two squares on one another before the camera: the nearer one covers pixels [10, 20), the other
/// [10, 30) in x, both [5, 25) in y.
Scene squares(const PixelCamera& camera) {
    std::vector<glm::dvec3> corners;
    for (const auto& [right, w] : {std::pair{20.0, 2.0}, {30.0, 4.0}})
        for (const auto& [x, y] : {std::pair{10.0, 5.0}, {10.0, 25.0}, {right, 25.0}, {right, 5.0}})
            corners.push_back(camera.point(x, y, w));
    return make_scene(make_soup(corners, {{0, 1, 2, 3}, {4, 5, 6, 7}}), camera.camera);
}

std::uint32_t pixel(const DebugPicture& p, int x, int y) {
    return p.pixels.rgba()[std::size_t(y) * std::size_t(p.pixels.width) + std::size_t(x)];
}

std::uint32_t packed(const Rgb8& c) {
    return 0xff000000u | std::uint32_t(c[2]) << 16 | std::uint32_t(c[1]) << 8 | c[0];
}

}  // namespace

TEST_CASE("overdraw counts the faces on each pixel", "[debug-view]") {
    const PixelCamera camera(40, 30);
    const DebugPicture p = draw_debug_view(squares(camera), camera.settings(), DebugView::overdraw);
    REQUIRE(p.scale.has_value());
    CHECK(p.scale->high == 2);
    CHECK(pixel(p, 15, 15) == packed(false_colour(1)));
    CHECK(pixel(p, 25, 15) == packed(false_colour(0.5)));
    CHECK(pixel(p, 35, 15) == packed(false_colour(0)));
}

TEST_CASE("depth shows distances in units of the scene", "[debug-view]") {
    const PixelCamera camera(40, 30);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Scene scene = squares(camera);
        scene.camera->projection = projection;
        const DebugPicture p = draw_debug_view(scene, camera.settings(), DebugView::depth);
        REQUIRE(p.scale.has_value());
        CHECK(p.scale->low == Approx(2).epsilon(1e-3));
        CHECK(p.scale->high == Approx(4).epsilon(1e-3));
    }
    const DebugPicture p = draw_debug_view(squares(camera), camera.settings(), DebugView::depth);
    CHECK(pixel(p, 15, 15) == packed(false_colour(0)));
    CHECK(pixel(p, 25, 15) == packed(false_colour(1)));
    CHECK(pixel(p, 35, 15) == packed({0, 0, 0}));
}

TEST_CASE("normals point at the viewer as blue, and are a face's where shading is flat",
          "[debug-view]") {
    const PixelCamera camera(40, 30);
    const DebugPicture p = draw_debug_view(squares(camera), camera.settings(), DebugView::normals);
    CHECK(pixel(p, 15, 15) == packed({128, 128, 255}));
    Settings settings = small_picture();
    const DebugPicture smooth = draw_debug_view(lit_sphere(), settings, DebugView::normals);
    settings.shading = Shading::flat;
    const DebugPicture flat = draw_debug_view(lit_sphere(), settings, DebugView::normals);
    const auto colours = [](const DebugPicture& picture) {
        return std::set(picture.pixels.rgba().begin(), picture.pixels.rgba().end()).size();
    };
    CHECK(colours(flat) < colours(smooth) / 2);
}

TEST_CASE("barycentric coordinates are the corners' weights", "[debug-view]") {
    const PixelCamera camera(40, 30);
    const Scene scene = make_scene(
        make_soup({camera.point(5, 5, 2), camera.point(5, 25, 2), camera.point(35, 25, 2)},
                  {{0, 1, 2}}),
        camera.camera);
    const DebugPicture p = draw_debug_view(scene, camera.settings(), DebugView::barycentrics);
    const std::uint32_t c = pixel(p, 15, 18);
    CHECK(int(c & 255) + int((c >> 8) & 255) + int((c >> 16) & 255) == Approx(255).margin(2));
    CHECK((pixel(p, 5, 7) & 255) > 200);
    CHECK(((pixel(p, 6, 23) >> 8) & 255) > 200);
    CHECK(((pixel(p, 32, 24) >> 16) & 255) > 200);
}

TEST_CASE("every debug view draws every interpolation and shading", "[debug-view]") {
    for (std::size_t view = 0; view < all_debug_views().size(); ++view)
        for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
            for (const Interpolation interpolation :
                 {Interpolation::perspective, Interpolation::edges, Interpolation::patch}) {
                Settings settings = small_picture();
                settings.shading = shading;
                settings.interpolation = interpolation;
                CAPTURE(view, int(shading), int(interpolation));
                const DebugPicture p = draw_debug_view(lit_sphere(), settings, DebugView(view));
                CHECK(p.pixels.width == 80);
                CHECK(std::set(p.pixels.rgba().begin(), p.pixels.rgba().end()).size() > 1);
                CHECK(p.legend.empty() == (DebugView(view) != DebugView::plan));
            }
}

TEST_CASE("errors against phong shading are none where it is, those against double are small",
          "[debug-view]") {
    Settings settings = small_picture();
    const auto largest = [&](DebugView view) {
        return draw_debug_view(lit_sphere(), settings, view).scale->high;
    };
    CHECK(largest(DebugView::error_phong) == 1);  // nothing: the scale's smallest range
    settings.shading = Shading::gouraud;
    CHECK(largest(DebugView::error_phong) > 1);
    settings.shading = Shading::phong;
    const DebugPicture p = draw_debug_view(lit_sphere(), settings, DebugView::error_f64);
    CHECK(pixel(p, 40, 30) != packed(false_colour(1)));
}

TEST_CASE("the wireframe marks where faces meet", "[debug-view]") {
    const PixelCamera camera(40, 30);
    const Scene scene = squares(camera);
    Framebuffer frame;
    Renderer(scene, camera.settings()).draw(frame);
    PixelBuffer pixels(40, 30);
    std::fill(pixels.edit().begin(), pixels.edit().end(), 0xffffffffu);
    draw_wireframe(scene, frame, pixels);
    const auto dark = [&](int x, int y) { return pixels.rgba()[frame.index(x, y)] == 0xff3f3f3fu; };
    CHECK(dark(19, 15));
    CHECK(dark(29, 15));
    CHECK(dark(9, 15));
    CHECK(dark(15, 4));
    // Triangles of one face are not parted.
    for (int x = 11; x < 19; ++x) CHECK_FALSE(dark(x, 15));
}
