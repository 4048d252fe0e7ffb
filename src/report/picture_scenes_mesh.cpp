// Hard scenes: meshes.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "report/picture_scene_parts.hpp"
#include "report/picture_scenes.hpp"

namespace scanshade {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<glm::dvec3> corners_of(const PolygonSoup& soup, std::size_t face) {
    std::vector<glm::dvec3> corners;
    for (std::uint32_t i = soup.face_begin[face]; i < soup.face_begin[face + 1]; ++i)
        corners.push_back(soup.positions[soup.corners[i].position]);
    return corners;
}

ReportInput lit_scene(const PolygonSoup& soup, const glm::dvec3& eye, const Material& material,
                      const NormalOptions& normals = {}) {
    return SceneBuilder()
        .camera(eye, {0, 0, 0})
        .front_light()
        .material(material)
        .object(soup, glm::dmat4(1), normals)
        .take();
}

/// Point (x, y) of the plane z = 0, turned about the axis z, then about x.
glm::dvec3 turned(double x, double y, double about_z, double about_x) {
    const double cz = std::cos(about_z), sz = std::sin(about_z);
    const double u = cz * x - sz * y, v = sz * x + cz * y;
    return {u, v * std::cos(about_x), -v * std::sin(about_x)};
}

}  // namespace

ReportInput slivers(double width) {
    constexpr double radius = 44;
    const auto count = std::uint32_t(2 * pi * radius / width);
    PolygonSoup soup;
    soup.positions.push_back(pixel_point(64.3, 48.2, 1.5));
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = i * 2 * pi / count;
        soup.positions.push_back(pixel_point(64.3 + radius * std::cos(angle),
                                             48.2 - radius * std::sin(angle),
                                             2 + 0.3 * std::sin(5 * angle)));
        for (const std::uint32_t corner : {0u, 1 + i, 1 + (i + 1) % count})
            soup.corners.push_back({corner, no_index, no_index});
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_material.push_back(0);
    }
    return SceneBuilder()
        .pixel_camera(0.1, 100)
        .front_light()
        .material(palette(2))
        .object(soup)
        .take();
}

ReportInput needles(double width) {
    constexpr double left = 58, right = 70;
    const auto count = std::uint32_t((right - left) / width);
    PolygonSoup soup;
    for (std::uint32_t i = 0; i <= count; ++i) {
        const double x = left + i * width, w = 2 + 0.3 * std::sin(x / 6);
        soup.positions.push_back(pixel_point(x + 20, 8.3, w));
        soup.positions.push_back(pixel_point(x - 20, 87.6, 1.2 * w));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        for (const std::uint32_t corner : {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2})
            soup.corners.push_back({corner, no_index, no_index});
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_material.push_back(0);
    }
    return SceneBuilder()
        .pixel_camera(0.1, 100)
        .front_light()
        .material(palette(3))
        .object(soup)
        .take();
}

ReportInput t_junctions(double parts) {
    constexpr int strips = 30;
    PolygonSoup coarse, fine;
    for (int strip = 0; strip < strips; ++strip) {
        const int quads = strip % 2 == 0 ? 3 : 3 * int(parts);
        const double y0 = -0.9 + 1.8 * strip / strips, y1 = -0.9 + 1.8 * (strip + 1) / strips;
        for (int i = 0; i < quads; ++i) {
            const double x0 = -1.1 + 2.2 * i / quads, x1 = -1.1 + 2.2 * (i + 1) / quads;
            std::vector<glm::dvec3> corners;
            for (const auto& [x, y] : {std::pair(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}})
                corners.push_back(turned(x, y, 0.3, 0.7));
            add_face(strip % 2 == 0 ? coarse : fine, corners);
        }
    }
    return SceneBuilder()
        .camera({0, 0, 4}, {0, 0, 0})
        .front_light()
        .material(palette(0))
        .object(coarse)
        .material(palette(2))
        .object(fine)
        .take();
}

ReportInput coplanar(double degrees) {
    const auto polygon = [&](int sides, double radius, double angle, double x) {
        PolygonSoup soup;
        std::vector<glm::dvec3> corners;
        for (int i = 0; i < sides; ++i) {
            const double a = angle + i * 2 * pi / sides;
            corners.push_back(
                turned(x + radius * std::cos(a), radius * std::sin(a), 0.2, degrees * pi / 180));
        }
        add_face(soup, corners);
        return soup;
    };
    return SceneBuilder()
        .camera({0, 0, 4}, {0, 0, 0})
        .front_light()
        .material(palette(0))
        .object(polygon(4, 1, 0.5, 0))
        .material(palette(1))
        .object(polygon(5, 0.8, 0.1, -0.5))
        .material(palette(2))
        .object(polygon(3, 0.9, 0.3, 0.5))
        .material(palette(3))
        .object(polygon(4, 1, 0.5, 0))
        .take();
}

ReportInput duplicated_vertices(double times) {
    const PolygonSoup sphere = shape("sphere", 6);
    PolygonSoup soup;
    for (std::size_t face = 0; face < sphere.face_count(); ++face)
        for (int i = 0; i < int(times); ++i) add_face(soup, corners_of(sphere, face));
    return lit_scene(soup, {1, 1, 4}, palette(3));
}

ReportInput zero_area_faces(double width) {
    PolygonSoup soup = shape("sphere", 6);
    for (int i = 0; i < 24; ++i) {
        const double angle = i * 2 * pi / 24;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0);
        const glm::dvec3 across(-out.y * width, out.x * width, 0);
        const std::vector<glm::dvec3> odd[] = {
            {out, 1.2 * out, out},                                              // a corner twice
            {out, 1.1 * out, 1.2 * out},                                        // a line
            {out, 1.2 * out, 1.2 * out + across},                               // a needle
            {out, 1.1 * out, 1.2 * out, 1.1 * out},                             // there and back
            {1.15 * out, 1.15 * out, 1.15 * out},                               // a point
            {out, 1.3 * out, 1.3 * out + 0.05 * glm::dvec3(-out.y, out.x, 0)},  // something to see
        };
        add_face(soup, odd[i % 6]);
        // In the middle of other faces, too.
        add_face(soup, {out * 0.5, out * 0.5 + glm::dvec3(0, 0, 1), out * 0.5});
    }
    return lit_scene(soup, {0, 0, 5}, palette(1));
}

ReportInput tiny_triangles(double per_pixel) {
    const PolygonSoup sphere = shape("sphere", 40);
    const double triangles = 2.0 * double(sphere.face_count());
    // Half of them face the camera, on a disc of so many pixels.
    const double radius = std::sqrt(triangles / 2 / per_pixel / pi);
    const double distance = case_height / 2.0 / std::tan(pi / 12) / radius;
    return lit_scene(sphere, {0, 0, distance}, palette(4));
}

ReportInput tiny_coordinates(double tiny) {
    constexpr int n = 6;
    PolygonSoup soup;
    const auto at = [&](int i, int j) {
        const auto coordinate = [&](int k) { return k == 0 ? tiny : k == 1 ? -tiny : k / 4.0; };
        const double x = coordinate(i), y = coordinate(j);
        return glm::dvec3(x - 0.5, y - 0.5, (i + j) % 2 == 0 ? 0.2 : tiny);
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            add_face(soup, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    add_face(soup, {{tiny, 0, 0.5}, {tiny * 2, tiny, 0.5}, {0, tiny, 0.5}});
    add_face(soup, {{tiny, 0, 0.5}, {0.4, 0.1, 0.5}, {tiny, tiny, 0.5}});
    return lit_scene(soup, {1, 1, 4}, palette(5));
}

ReportInput odd_quads(double fold) {
    // Corners in a square of side 2: convex, dart, bow tie, three in a line, folded, a corner twice.
    const std::vector<glm::dvec3> quads[] = {
        {{-1, -0.9, 0}, {0.8, -1, 0}, {1, 0.7, 0}, {-0.7, 1, 0}},
        {{-1, -1, 0}, {-0.1, -0.2, 0}, {1, -1, 0}, {0, 1, 0}},
        {{-1, -1, 0}, {1, 0.9, 0}, {1, -0.8, 0}, {-1, 1, 0}},
        {{-1, -1, 0}, {0, -0.5, 0}, {1, 0, 0}, {-0.6, 1, 0}},
        {{-1, -1, fold}, {1, -1, -fold}, {1, 1, fold}, {-1, 1, -fold}},
        {{-1, -1, 0}, {1, -1, 0}, {0.5, 1, 0}, {0.5, 1, 0}}};
    PolygonSoup soup;
    for (int i = 0; i < 6; ++i) {
        const int column = i % 3, row = i / 3;
        const glm::dvec3 centre(-1.2 + 1.2 * column, 0.55 - 1.1 * row, 0);
        std::vector<glm::dvec3> corners, normals;
        for (const glm::dvec3& p : quads[i]) {
            corners.push_back(centre + 0.45 * turned(p.x, p.y, 0.25, 0) + glm::dvec3(0, 0, p.z));
            normals.push_back({0.6 * p.x, 0.6 * p.y, 1});
        }
        add_face(soup, corners, normals);
    }
    return lit_scene(soup, {0, 0, 5}, palette(4));
}

ReportInput normal_lengths(double length) {
    PolygonSoup soup = shape("sphere", 6);
    const double lengths[] = {1, 0, length, 1 / length, 1e-30};
    for (std::size_t i = 0; i < soup.normals.size(); ++i) soup.normals[i] *= lengths[i % 5];
    return lit_scene(soup, {1, 1, 4}, palette(2));
}

ReportInput opposite_normals(double degrees) {
    const double half = degrees * pi / 360;
    const glm::dvec3 left(-std::sin(half), 0, std::cos(half)), right(-left.x, 0, left.z);
    // Across the picture; up; and one corner against the three others.
    const std::vector<glm::dvec3> normals[] = {
        {left, right, right, left},
        {{0, left.x, left.z}, {0, left.x, left.z}, {0, right.x, right.z}, {0, right.x, right.z}},
        {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, 1}}};
    PolygonSoup soup;
    for (int i = 0; i < 3; ++i) {
        const double x = 1.1 * (i - 1);
        add_face(soup,
                 {{x - 0.5, -0.9, 0}, {x + 0.5, -0.9, 0}, {x + 0.5, 0.9, 0}, {x - 0.5, 0.9, 0}},
                 normals[i]);
    }
    return lit_scene(soup, {0.3, 0.2, 4}, palette(3));
}

ReportInput cancelling_normals(double lift) {
    // Front and back of a sheet share their corners; from sheet to sheet one is lifted less.
    constexpr int sheets = 5;
    PolygonSoup soup;
    for (int i = 0; i < sheets; ++i) {
        const double x = -1.25 + 0.52 * i;
        const auto first = std::uint32_t(soup.positions.size());
        const double z = i == 0 ? 0 : std::pow(lift, i / double(sheets - 1));
        for (const glm::dvec3& p :
             {glm::dvec3(x, -0.8, 0), glm::dvec3(x + 0.48, -0.8, 0), glm::dvec3(x + 0.48, 0.8, 0),
              glm::dvec3(x, 0.8, 0), glm::dvec3(x + 0.48, 0.8, z)})
            soup.positions.push_back(p);
        for (const std::uint32_t corner : {0u, 1u, 2u, 3u, 3u, 4u, 1u, 0u})
            soup.corners.push_back({first + corner, no_index, no_index});
        for (const std::uint32_t end : {4u, 8u})
            soup.face_begin.push_back(8 * std::uint32_t(i) + end);
        soup.face_material.insert(soup.face_material.end(), 2, 0);
    }
    return lit_scene(soup, {0.8, 0.5, 4}, palette(4), {NormalSource::average, 180});
}

}  // namespace scanshade
