#include "support/random_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

glm::dvec3 in_cube(Rng& rng, double side) {
    return glm::dvec3{rng.real(-side, side), rng.real(-side, side), rng.real(-side, side)};
}

void add_face(PolygonSoup& soup, const std::vector<std::uint32_t>& positions) {
    for (const std::uint32_t p : positions) soup.corners.push_back({p, no_index, no_index});
    soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
    soup.face_material.push_back(0);
}

void add_points(PolygonSoup& soup, const std::vector<glm::dvec3>& points) {
    std::vector<std::uint32_t> face;
    for (const glm::dvec3& p : points) {
        face.push_back(std::uint32_t(soup.positions.size()));
        soup.positions.push_back(p);
    }
    add_face(soup, face);
}

/// Triangles over few points: shared edges, folds, faces that pass through each other.
void add_tangle(Rng& rng, PolygonSoup& soup) {
    const auto points = std::uint32_t(rng.integer(3, 40));
    // On a lattice many lie in one plane, and depths are equal.
    const bool lattice = rng.chance(0.4);
    const auto first = std::uint32_t(soup.positions.size());
    for (std::uint32_t i = 0; i < points; ++i) {
        const glm::dvec3 p = in_cube(rng, 1);
        soup.positions.push_back(lattice ? glm::round(p * 2.0) / 2.0 : p);
    }
    for (auto faces = rng.integer(1, 60); faces > 0; --faces) {
        std::vector<std::uint32_t> face;
        for (int k = 0; k < 3; ++k)
            face.push_back(first + std::uint32_t(rng.integer(0, points - 1)));
        add_face(soup, face);
    }
}

/// Polygons of up to eight corners: regular, bent out of their plane, concave.
void add_polygons(Rng& rng, PolygonSoup& soup) {
    const double bend = rng.chance(0.5) ? 0 : rng.real(0, 0.3);
    const double dent = rng.chance(0.6) ? 0 : rng.real(0, 0.8);
    for (auto faces = rng.integer(1, 20); faces > 0; --faces) {
        const glm::dvec3 middle = in_cube(rng, 1), a = in_cube(rng, 0.7);
        const glm::dvec3 b = glm::cross(a, in_cube(rng, 1));
        const auto corners = rng.integer(3, 8);
        std::vector<glm::dvec3> points;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * 3.141592653589793 * k / double(corners);
            const double radius = 1 - rng.real(0, dent);
            points.push_back(middle + radius * (a * std::cos(angle) + b * std::sin(angle)) +
                             in_cube(rng, bend));
        }
        add_points(soup, points);
    }
}

/// Long thin triangles, down to those without any area.
void add_needles(Rng& rng, PolygonSoup& soup) {
    for (auto faces = rng.integer(1, 30); faces > 0; --faces) {
        const glm::dvec3 a = in_cube(rng, 1), b = in_cube(rng, 1);
        const double width = std::exp2(rng.real(-26, -2));
        const glm::dvec3 beside = a + (b - a) * rng.real(-0.2, 1.2);
        add_points(soup, {a, b, beside + in_cube(rng, width)});
    }
}

/// Many triangles in little room.
void add_dust(Rng& rng, PolygonSoup& soup) {
    const glm::dvec3 middle = in_cube(rng, 0.5);
    const double size = std::exp2(rng.real(-9, -1));
    for (auto faces = rng.integer(50, 300); faces > 0; --faces) {
        const glm::dvec3 at = middle + in_cube(rng, size);
        add_points(soup, {at, at + in_cube(rng, size / 4), at + in_cube(rng, size / 4)});
    }
}

/// Some far larger than the rest of the scene.
void add_giants(Rng& rng, PolygonSoup& soup) {
    for (auto faces = rng.integer(1, 4); faces > 0; --faces) {
        const double size = std::exp2(rng.real(1, 12));
        add_points(soup, {in_cube(rng, size), in_cube(rng, size), in_cube(rng, size)});
    }
}

/// Faces again, with other first corners: equal depth everywhere.
void add_copies(Rng& rng, PolygonSoup& soup) {
    for (auto copies = rng.integer(1, 10); copies > 0; --copies) {
        const auto face = std::size_t(rng.integer(0, std::int64_t(soup.face_count()) - 1));
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = soup.face_begin[face]; c < soup.face_begin[face + 1]; ++c)
            corners.push_back(soup.corners[c].position);
        std::rotate(corners.begin(), corners.begin() + rng.integer(0, 2), corners.end());
        if (rng.chance(0.3)) std::reverse(corners.begin(), corners.end());
        add_face(soup, corners);
    }
}

PolygonSoup make_random_soup(Rng& rng) {
    constexpr void (*kinds[])(Rng&, PolygonSoup&) = {add_tangle, add_polygons, add_needles,
                                                     add_dust, add_giants};
    PolygonSoup soup;
    soup.name = "soup";
    do kinds[rng.integer(0, std::size(kinds) - 1)](rng, soup);
    while (rng.chance(0.4));
    if (rng.chance(0.4)) add_copies(rng, soup);
    // Normals of any direction, opposite ones too: some cancel in the middle of a face.
    const bool normals = rng.chance(0.4), texcoords = rng.chance(0.6);
    const double range = std::exp2(rng.real(-2, 6));
    for (PolygonSoup::Corner& corner : soup.corners) {
        if (normals) {
            corner.normal = std::uint32_t(soup.normals.size());
            soup.normals.push_back(rng.chance(0.3) ? glm::round(in_cube(rng, 1)) + 1e-3
                                                   : in_cube(rng, 1));
        }
        if (!texcoords) continue;
        corner.texcoord = std::uint32_t(soup.texcoords.size());
        soup.texcoords.push_back({rng.real(-range, range), rng.real(-range, range)});
    }
    return soup;
}

PolygonSoup make_random_shape(Rng& rng) {
    const auto shapes = all_shapes();
    const ShapeInfo& shape = shapes[std::size_t(rng.integer(0, std::int64_t(shapes.size()) - 1))];
    const int most = shape.name == "terrain" || shape.name == "plane" ? 24 : 6;
    return shape.make(int(rng.integer(1, most)));
}

}  // namespace

std::shared_ptr<const Mesh> make_random_mesh(Rng& rng, std::uint32_t materials) {
    PolygonSoup soup = rng.chance(0.5) ? make_random_shape(rng) : make_random_soup(rng);
    for (std::uint32_t& material : soup.face_material)
        material = std::uint32_t(rng.integer(0, materials - 1));
    NormalOptions options;
    options.source = NormalSource(rng.integer(0, 3));
    options.crease_deg = rng.chance(0.5) ? 60 : rng.real(0, 180);
    return std::make_shared<Mesh>(build_mesh(soup, options));
}

std::shared_ptr<const Texture> make_random_texture(Rng& rng) {
    MipLevel picture;
    picture.width = int(rng.integer(1, 9));
    picture.height = int(rng.integer(1, 9));
    for (int i = 0; i < 3 * picture.width * picture.height; ++i)
        picture.texels.push_back(float(rng.real(0, 1)));
    return std::make_shared<Texture>(make_texture(std::move(picture), "random"));
}

}  // namespace scanshade
