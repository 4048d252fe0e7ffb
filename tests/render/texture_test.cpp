// Textured quadrilaterals in strong perspective against the analytic projection of (u, v).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>

#include "scanshade/image/texture.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

namespace {

constexpr int width = 120, height = 90;
constexpr glm::dvec3 tint{0.9, 0.6, 0.3};  // k_d, which the texture multiplies

/// A floor in y = 0 that runs away from the eye.
struct Floor {
    double x_left = -1, x_right = 1, z_near = 1, z_far = -8;
};
constexpr Floor in_view;
constexpr Floor under_the_eye{-1, 1, 6, -8};

Camera floor_camera() {
    Camera camera;
    camera.position = {0.3, 0.7, 2.5};
    camera.focal_point = {0.1, 0, 0};
    camera.view_up = {0.15, 1, 0};
    camera.view_angle_deg = 50;
    return camera;
}

struct Range {
    glm::dvec2 low, high;  // texture coordinates at (x_left, z_near) and (x_right, z_far)
    glm::dvec2 at(glm::dvec2 fraction) const { return low + (high - low) * fraction; }
};

Mesh floor_mesh(const Range& range, bool as_triangles, const Floor& floor = in_view) {
    PolygonSoup soup;
    soup.positions = {{floor.x_left, 0, floor.z_near},
                      {floor.x_right, 0, floor.z_near},
                      {floor.x_right, 0, floor.z_far},
                      {floor.x_left, 0, floor.z_far}};
    soup.texcoords = {
        range.low, {range.high.x, range.low.y}, range.high, {range.low.x, range.high.y}};
    soup.normals = {{0, 1, 0}};
    const auto add = [&](std::initializer_list<std::uint32_t> face) {
        for (const std::uint32_t i : face) soup.corners.push_back({i, i, 0});
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_material.push_back(0);
    };
    if (as_triangles)
        add({0, 1, 2}), add({0, 2, 3});
    else
        add({0, 1, 2, 3});
    return build_mesh(soup, {});
}

/// Bilinear look-up with both coordinates wrapped, in double: the texels whose centres surround
/// (u, v), (0, 0) being the lower left corner of the picture.
glm::dvec3 look_up(const Texture& texture, glm::dvec2 uv) {
    const MipLevel& picture = texture.levels[0];
    const double x = uv.x * picture.width - 0.5, y = (1 - uv.y) * picture.height - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto texel = [&](double column, double row) {
        const auto wrap = [](double i, int n) { return ((int(i) % n) + n) % n; };
        const int at =
            3 * (wrap(row, picture.height) * picture.width + wrap(column, picture.width));
        const float* t = &picture.texels[std::size_t(at)];
        return glm::dvec3(t[0], t[1], t[2]);
    };
    const double s = x - x0, t = y - y0;
    return (texel(x0, y0) * (1 - s) + texel(x0 + 1, y0) * s) * (1 - t) +
           (texel(x0, y0 + 1) * (1 - s) + texel(x0 + 1, y0 + 1) * s) * t;
}

/// Where the ray through (px, py) meets the floor, as fractions across and along it.
glm::dvec2 floor_point(double px, double py, const Floor& floor = in_view) {
    const Camera camera = floor_camera();
    const glm::dvec3 forward = glm::normalize(camera.focal_point - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.view_up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double pixel = 2 * std::tan(glm::radians(camera.view_angle_deg / 2)) / height;
    const glm::dvec3 w =
        forward + right * ((px - width / 2.0) * pixel) - up * ((py - height / 2.0) * pixel);
    if (w.y >= 0) return {-1, -1};  // above the horizon
    const glm::dvec3 P = camera.position - w * (camera.position.y / w.y);
    return {(P.x - floor.x_left) / (floor.x_right - floor.x_left),
            (P.z - floor.z_near) / (floor.z_far - floor.z_near)};
}

/// The outermost thousandth is left to the rules of coverage.
bool well_inside(glm::dvec2 at) { return std::min({at.x, at.y, 1 - at.x, 1 - at.y}) >= 1e-3; }

bool pixel_inside(double px, double py, const Floor& floor) {
    for (const double dx : {-0.5, 0.5})
        for (const double dy : {-0.5, 0.5})
            if (!well_inside(floor_point(px + dx, py + dy, floor))) return false;
    return true;
}

/// Texels of the picture from a pixel to its neighbours, the longer way: by differences.
double footprint(double px, double py, const Texture& texture, const Range& range,
                 const Floor& floor = in_view) {
    constexpr double h = 1e-4;
    const auto step = [&](double dx, double dy) {
        const glm::dvec2 uv = range.at(floor_point(px + dx, py + dy, floor)) -
                              range.at(floor_point(px - dx, py - dy, floor));
        return glm::length(uv * glm::dvec2(texture.width(), texture.height())) / (2 * h);
    };
    return std::max(step(h, 0), step(0, h));
}

Framebuffer draw(const Mesh& mesh, const Texture& texture, Interpolation interpolation,
                 RendererKind renderer, int samples = 1) {
    Material material;
    material.brdf = "unlit";
    material.set("kd", {tint.x, tint.y, tint.z});
    material.map_kd = std::make_shared<const Texture>(texture);
    Scene scene = single_object_scene(std::make_shared<const Mesh>(mesh), material);
    scene.camera = floor_camera();
    Settings settings;
    settings.width = width;
    settings.height = height;
    settings.interpolation = interpolation;
    settings.renderer = renderer;
    settings.samples = samples;
    Framebuffer frame;
    Renderer(scene, settings).draw(frame);
    return frame;
}

struct Comparison {
    int pixels = 0, uncovered = 0;
    int wrong = 0;  // off by more than the snapping of corners to 1/256 pixel can explain
    int far = 0;    // off by more than 0.1
};

Comparison compare(const Framebuffer& frame, const Texture& texture, const Range& range) {
    const auto expected = [&](double px, double py) {
        return tint * look_up(texture, range.at(floor_point(px, py)));
    };
    Comparison result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            if (!well_inside(floor_point(px, py))) continue;
            const std::size_t i = frame.index(x, y);
            result.uncovered += frame.id[i] == Framebuffer::no_triangle;
            // Where texels are smaller than pixels, levels are mixed.
            if (footprint(px, py, texture, range) > 0.99) continue;
            ++result.pixels;
            const glm::dvec3 value = expected(px, py);
            const glm::dvec3 got(frame.r[i], frame.g[i], frame.b[i]);
            constexpr double snap = 1.0 / 256;
            bool wrong = false, far = false;
            for (int c = 0; c < 3; ++c) {
                double allowed = 2e-5;
                for (const double s : {-snap, snap})
                    allowed += std::abs(expected(px + s, py)[c] - value[c]) +
                               std::abs(expected(px, py + s)[c] - value[c]);
                wrong |= !(std::abs(got[c] - value[c]) <= allowed);
                far |= !(std::abs(got[c] - value[c]) <= 0.1);
            }
            result.wrong += wrong;
            result.far += far;
        }
    return result;
}

/// Red is u and green is v between the centres of the outermost texels.
Texture gradient() {
    constexpr int n = 16;
    MipLevel picture{n, n, {}};
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (const double value : {(x + 0.5) / n, 1 - (y + 0.5) / n, 0.5})
                picture.texels.push_back(float(value));
    return make_texture(std::move(picture), "gradient");
}

Texture random_texture(int columns, int rows) {
    Rng rng(7);
    MipLevel picture{columns, rows, {}};
    for (int i = 0; i < 3 * columns * rows; ++i) picture.texels.push_back(float(rng.real(0, 1)));
    return make_texture(std::move(picture), "random");
}

/// Each level in a grey of its own, a sixteenth brighter than the one before.
Texture levels_shown(int width_of_it, int height_of_it) {
    MipLevel picture{width_of_it, height_of_it, {}};
    picture.texels.resize(3 * std::size_t(width_of_it) * std::size_t(height_of_it));
    Texture texture = make_texture(std::move(picture), "levels");
    for (std::size_t k = 0; k < texture.levels.size(); ++k)
        std::fill(texture.levels[k].texels.begin(), texture.levels[k].texels.end(), float(k) / 16);
    return texture;
}

/// Of a picture of levels_shown; the footprint of a sample is smaller where a pixel has many.
double worst_level_error(const Framebuffer& frame, const Texture& texture, const Range& range,
                         const Floor& floor, int samples) {
    double worst = 0;
    int pixels = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            if (!pixel_inside(px, py, floor)) continue;
            const double rho = footprint(px, py, texture, range, floor) / std::sqrt(samples);
            const double shown = double(frame.r[frame.index(x, y)]) / tint.x * 16;
            worst = std::max(worst, std::abs(shown - std::log2(rho)));
            ++pixels;
        }
    REQUIRE(pixels > 1500);
    return worst;
}

constexpr Range inside{{0.04, 0.04}, {0.96, 0.96}};  // between texel centres of the gradient
constexpr Range wrapped{{-1.25, -2.5}, {2.5, 1.75}};

}  // namespace

TEST_CASE("a gradient in perspective shows the u and v of the point behind each pixel",
          "[render][texture]") {
    const Texture texture = gradient();
    for (const bool as_triangles : {false, true}) {
        const Mesh mesh = floor_mesh(inside, as_triangles);
        const Framebuffer frame =
            draw(mesh, texture, Interpolation::perspective, RendererKind::scalar_f64);
        // Without any look-up: the colour is (u, v).
        double worst = 0;
        int pixels = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = frame.index(x, y);
                const glm::dvec2 at = floor_point(x + 0.5, y + 0.5);
                if (!well_inside(at) || footprint(x + 0.5, y + 0.5, texture, inside) > 1) continue;
                const glm::dvec2 uv = inside.at(at);
                const glm::dvec2 next = floor_point(x + 0.5, y - 0.5);
                const double a_pixel = next.x < 0 ? 0.1 : std::abs(next.y - at.y);
                worst = std::max({worst,
                                  std::abs(double(frame.r[i]) / tint.x - uv.x) / (0.01 + a_pixel),
                                  std::abs(double(frame.g[i]) / tint.y - uv.y) / (0.01 + a_pixel)});
                ++pixels;
            }
        CAPTURE(as_triangles, pixels);
        CHECK(pixels > 2000);
        CHECK(worst < 0.02);  // of a hundredth and the change from one row to the next
    }
}

TEST_CASE("textures in perspective are wrapped and bilinear at every pixel", "[render][texture]") {
    const Texture texture = random_texture(5, 3);
    for (const RendererKind renderer : {RendererKind::scalar_f64, RendererKind::scalar_f32})
        for (const bool as_triangles : {false, true}) {
            const Mesh mesh = floor_mesh(wrapped, as_triangles);
            const Comparison result = compare(
                draw(mesh, texture, Interpolation::perspective, renderer), texture, wrapped);
            CAPTURE(renderer_names()[std::size_t(renderer)], as_triangles);
            CHECK(result.pixels > 2000);
            CHECK(result.uncovered == 0);
            CHECK(result.wrong == 0);
        }
}

TEST_CASE("interpolating along edges on the picture moves a texture, perspective does not",
          "[render][texture]") {
    const Texture texture = gradient();
    for (const bool as_triangles : {false, true}) {
        const Mesh mesh = floor_mesh(inside, as_triangles);
        const auto far = [&](Interpolation interpolation) {
            const Comparison result = compare(
                draw(mesh, texture, interpolation, RendererKind::scalar_f64), texture, inside);
            CHECK(result.uncovered == 0);
            return double(result.far) / result.pixels;
        };
        CHECK(far(Interpolation::perspective) == 0);
        CHECK(far(Interpolation::edges) > 0.3);
    }
}

TEST_CASE("the level of a texture is that of its footprint in perspective, in every interpolation",
          "[render][texture]") {
    const Texture texture = levels_shown(2048, 512);
    const Range range{{-2, 1}, {3, 4}};
    for (const Floor& floor : {in_view, under_the_eye})
        for (const bool as_triangles : {false, true})
            for (std::size_t mode = 0; mode < interpolation_names().size(); ++mode) {
                CAPTURE(floor.z_near, as_triangles, interpolation_names()[mode]);
                const Mesh mesh = floor_mesh(range, as_triangles, floor);
                const auto error = [&](RendererKind renderer, int samples) {
                    return worst_level_error(
                        draw(mesh, texture, Interpolation(mode), renderer, samples), texture, range,
                        floor, samples);
                };
                CHECK(error(RendererKind::scalar_f32, 1) < 0.01);
                // Four samples are half a pixel apart; the pixel shows their mean.
                CHECK(error(RendererKind::scalar_f64, 4) < 0.05);
            }
}

TEST_CASE("an orthographic picture has one level for a whole plane", "[render][texture]") {
    Material material;
    material.brdf = "unlit";
    material.set("kd", {1});
    material.map_kd = std::make_shared<const Texture>(levels_shown(1024, 1024));
    // Facing the camera, 2 units are 60 pixels high and 60 wide.
    Scene scene = single_object_scene(
        std::make_shared<const Mesh>(build_mesh(find_shape("plane")->make(1), {})), material);
    Camera camera;
    camera.position = {0, 5, 0};
    camera.view_up = {0, 0, -1};
    camera.projection = Projection::orthographic;
    camera.view_angle_deg = glm::degrees(2 * std::atan(1.5 / 5));
    scene.camera = camera;
    Settings settings;
    settings.width = width;
    settings.height = height;
    Framebuffer frame;
    Renderer(scene, settings).draw(frame);
    double worst = 0;
    for (int y = 20; y < 70; ++y)
        for (int x = 35; x < 85; ++x)
            worst = std::max(
                worst, std::abs(double(frame.r[frame.index(x, y)]) * 16 - std::log2(1024 / 60.0)));
    CHECK(worst < 1e-5);
}

TEST_CASE("squares smaller than pixels fade to their mean instead of making a pattern",
          "[render][texture]") {
    // Squares of one texel, black and white: nearly all of the floor has many in a pixel.
    MipLevel picture{512, 512, {}};
    for (int i = 0; i < 512 * 512; ++i)
        picture.texels.insert(picture.texels.end(), 3, float((i + i / 512) % 2));
    const Texture texture = make_texture(std::move(picture), "squares");
    const Range range{{0, 0}, {4, 9}};
    const Framebuffer frame = draw(floor_mesh(range, true), texture, Interpolation::perspective,
                                   RendererKind::scalar_f32);
    double worst = 0;
    int pixels = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!well_inside(floor_point(x + 0.5, y + 0.5))) continue;
            if (footprint(x + 0.5, y + 0.5, texture, range) < 2) continue;
            worst = std::max(worst, std::abs(double(frame.r[frame.index(x, y)]) - 0.5 * tint.x));
            ++pixels;
        }
    CHECK(pixels > 2000);
    CHECK(worst < 1e-6);
}
