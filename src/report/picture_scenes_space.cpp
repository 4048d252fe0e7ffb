// Hard scenes: where things are.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numbers>

#include "report/picture_scene_parts.hpp"
#include "report/picture_scenes.hpp"
#include "scanshade/image/texture.hpp"

namespace scanshade {
namespace {

/// A ring that shows its hole to the camera.
PolygonSoup ring() {
    PolygonSoup soup = shape("torus", 6);
    for (std::vector<glm::dvec3>* vectors : {&soup.positions, &soup.normals})
        for (glm::dvec3& v : *vectors) v = {v.x, 0.8 * v.y + 0.6 * v.z, 0.8 * v.z - 0.6 * v.y};
    return soup;
}

/// The ring at a place; all else beside it.
ReportInput ring_scene(const PolygonSoup& soup, const glm::dmat4& to_world,
                       const glm::dvec3& centre, double size) {
    const auto at = [&](double x, double y, double z) {
        return centre + size * glm::dvec3(x, y, z);
    };
    return SceneBuilder()
        .camera(at(0, 2, 4), centre)
        .light(point_light(at(2, 3, 2), 2, {0.5, 0.1 / size, 0.05 / (size * size)}))
        .light(point_light(at(-0.2, 0.3, 0.5), 0.15, {0, 0, 1 / (size * size)}))
        .material(palette(1))
        .object(soup, to_world)
        .take();
}

/// A board across the view at distance w.
PolygonSoup board(double x0, double y0, double x1, double y1, double w) {
    PolygonSoup soup;
    add_face(soup, {pixel_point(x0, y1, w), pixel_point(x1, y1, w), pixel_point(x1, y0, w),
                    pixel_point(x0, y0, w)});
    return soup;
}

}  // namespace

ReportInput scaled_scene(double scale) {
    PolygonSoup soup = ring();
    for (glm::dvec3& p : soup.positions) p *= scale;
    return ring_scene(soup, glm::dmat4(1), glm::dvec3(0), scale);
}

ReportInput far_in_file(double offset) {
    PolygonSoup soup = ring();
    const glm::dvec3 centre(offset, -offset, offset);
    for (glm::dvec3& p : soup.positions) p += centre;
    return ring_scene(soup, glm::dmat4(1), centre, 1);
}

ReportInput far_placed(double offset) {
    const glm::dvec3 centre(offset, -offset, offset);
    return ring_scene(ring(), glm::translate(glm::dmat4(1), centre), centre, 1);
}

ReportInput far_pair(double distance) {
    const glm::dmat4 behind = glm::translate(glm::dmat4(1), {0, 0, -distance});
    return SceneBuilder()
        .camera({0, 0, 5}, {0, 0, 0})
        .depth(1, 3 * distance)
        .front_light()
        .material(palette(1))
        .object(ring())
        .material(palette(2))
        .object(ring(), glm::scale(behind, glm::dvec3(distance * 0.3)))
        .take();
}

ReportInput cut_by_near(double depth) {
    return SceneBuilder()
        .camera({0, 0.4, 3}, {0, 0, 0}, 45)
        .depth(3 - depth, 10)
        .front_light()
        .light(point_light({0, 0.2, 0.9}, 0.4, {1, 0, 0}))
        .material(palette(1))
        .object(shape("sphere", 8))
        .material(palette(2))
        .object(shape("sphere", 4), glm::scale(glm::dmat4(1), glm::dvec3(0.3)))
        .take();
}

ReportInput cut_by_both(double share) {
    ReportInput input = SceneBuilder()
                            .camera({0, 2, 4}, {0, 0, 0})
                            .depth(std::sqrt(20.0) - share, std::sqrt(20.0) + share)
                            .front_light()
                            .material(palette(2))
                            .object(ring())
                            .take();
    input.scene.camera->projection = Projection::orthographic;
    return input;
}

ReportInput inside_mesh(double angle) {
    return SceneBuilder()
        .camera({0.2, 0.1, 0.3}, {0, 0, -1}, angle)
        .light(point_light({-0.3, 0.4, 0}, 0.5, {1, 0, 0.5}))
        .material(palette(3))
        .object(shape("sphere", 8))
        .take();
}

ReportInput beyond_guard_band(double times) {
    const auto at = [times](double x, double y, double w) {
        return pixel_point(case_width / 2.0 + x * times, case_height / 2.0 + y * times, w);
    };
    PolygonSoup wall, floor, spike;
    add_face(wall, {at(-128, 96, 9), at(128, 90, 9), at(3, -90, 9)});
    add_face(floor, {at(-100, 1, 0.1), at(120, 2, 0.2), {0.1, 0.05, -20}});
    add_face(spike, {{0.4 * times, 0.3 * times, 1}, {0.2, 0.3, -2}, {0.5, 0.3, -2}});
    return SceneBuilder()
        .pixel_camera(0.01, 100)
        .front_light()
        .material(palette(0))
        .object(wall)
        .material(palette(1))
        .object(floor)
        .material(palette(2))
        .object(spike)
        .take();
}

ReportInput behind_eye(double w) {
    PolygonSoup one, two;
    add_face(one, {pixel_point(20, 20, 2), pixel_point(30, 80, 2), {0.7, -0.2, w}});
    add_face(one, {{-0.9, 0.4, w}, pixel_point(110, 12, 3), pixel_point(50, 8, 3)});
    add_face(two, {pixel_point(64, 60, 2), {-2, -1.5, w}, {1.5, -1.5, w}});
    add_face(two, {pixel_point(100, 50, 2.5), {3, 0.5, w}, {3, 1.5, w}});
    return SceneBuilder()
        .pixel_camera(0.01, 100)
        .front_light()
        .material(palette(1))
        .object(one)
        .material(palette(2))
        .object(two)
        .take();
}

namespace {

/// Seen from `height` · its nearest distance above.
PolygonSoup long_floor(double ratio) {
    const double reach = std::sqrt(ratio), height = 0.8 / reach;
    PolygonSoup soup;
    add_face(soup, {{-1.2 / reach, -height, -1 / reach},
                    {1.2 / reach, -height, -1 / reach},
                    {1.2 * reach, -height, -reach},
                    {-1.2 * reach, -height, -reach}});
    return soup;
}

ReportInput floor_scene(const PolygonSoup& floor, double ratio, const Material& material) {
    const double reach = std::sqrt(ratio);
    Light near_light = point_light({1e-3, 1e-3, -3e-3}, 3e-6, {0, 0, 1});
    near_light.radius = 1e-4;
    return SceneBuilder()
        .pixel_camera(0.5 / reach, 2 * reach)
        .light(directional_light({0.1, -0.6, -1}, 0.7))
        .light(near_light)
        .material(material)
        .object(floor)
        .take();
}

std::shared_ptr<const Texture> checkerboard() {
    constexpr int side = 64, squares = 8;
    Image image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool dark = (x * squares / side + y * squares / side) % 2 == 1;
            std::fill_n(image.pixel(x, y), 3, std::uint8_t(dark ? 60 : 250));
        }
    return std::make_shared<Texture>(make_texture(image, "checkerboard"));
}

}  // namespace

ReportInput w_ratio(double ratio) { return floor_scene(long_floor(ratio), ratio, palette(1)); }

ReportInput w_ratio_texture(double ratio) {
    PolygonSoup floor = long_floor(ratio);
    for (std::uint32_t i = 0; i < floor.corners.size(); ++i) {
        const glm::dvec3& p = floor.positions[i];
        floor.texcoords.push_back({4 * p.x, 4 * p.z});
        floor.corners[i].texcoord = i;
    }
    Material material = palette(0);
    material.map_kd = checkerboard();
    return floor_scene(floor, ratio, material);
}

ReportInput depth_range_scene(double near) {
    constexpr double far = 1e9;
    constexpr int boards = 12;
    SceneBuilder builder;
    builder.pixel_camera(near, far).front_light();
    for (int step = 0; step < boards; ++step) {
        // Not from front to back, nor from back to front.
        const int i = step * 5 % boards;
        const double w = 2 * near * std::pow(far / near / 4, i / double(boards - 1));
        builder.material(palette(std::size_t(i)))
            .object(board(6 + 9 * i, 4 + 6 * i, 30 + 8 * i, 70 + 2 * i, w));
    }
    return builder.take();
}

ReportInput z_fighting(double gap) {
    const auto tilted = [](double nearer) {
        PolygonSoup soup;
        add_face(soup, {pixel_point(8, 80, 2 * nearer), pixel_point(60, 86, 3 * nearer),
                        pixel_point(58, 10, 3.5 * nearer), pixel_point(12, 14, 2.4 * nearer)});
        return soup;
    };
    const auto crossing = [](double left, double right) {
        PolygonSoup soup;
        add_face(soup, {pixel_point(68, 84, left), pixel_point(122, 80, right),
                        pixel_point(120, 12, right), pixel_point(70, 16, left)});
        return soup;
    };
    return SceneBuilder()
        .pixel_camera(0.1, 100)
        .front_light()
        .material(palette(1))
        .object(tilted(1 + gap))
        .object(crossing(2, 8))
        .material(palette(2))
        .object(tilted(1))
        .object(crossing(6, 3))
        .take();
}

}  // namespace scanshade
