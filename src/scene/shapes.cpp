// The table of shapes, and those that are a formula.
#include "scanshade/scene/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "scene/shape_parts.hpp"

namespace scanshade {
namespace {

struct CosSin {
    double cos, sin;
};

/// Cosine and sine of `step` steps of 90°/n: the same bits after a full turn, and exact at
/// quarter turns.
CosSin turn(int step, int n) {
    const int quarter = ((step / n) % 4 + 4) % 4;
    const double angle = step % n * (std::numbers::pi / 2) / n;
    const double c = std::cos(angle), s = std::sin(angle);
    const CosSin rotated[] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
    return rotated[quarter];
}

/// Texture coordinates that run from 0 to 1 with the rows and columns of a grid.
glm::dvec2 texcoord(int row, int rows, int column, int columns) {
    return {double(column) / columns, double(row) / rows};
}

PolygonSoup make_sphere(int n) {
    ShapeBuilder builder("sphere");
    const int rows = 2 * n, columns = 4 * n;
    builder.add_grid(rows, columns, [&](int row, int column) {
        // From the south pole up; the seam is at the back, so that u = 0.5 faces +z.
        const auto [cos_longitude, sin_longitude] = turn(column + 2 * n, n);
        const auto [depth, radius] = turn(row, n);
        const glm::dvec3 p(radius * sin_longitude, -depth, radius * cos_longitude);
        return SurfacePoint{p, texcoord(row, rows, column, columns), p};
    });
    return builder.take();
}

/// Of u or v: a full turn from the seam, which is opposite to 0°.
double seam_angle(double parameter) { return std::numbers::pi * (2 * parameter + 1); }

SmoothPoint smooth_sphere(int, double u, double v) {
    const double a = seam_angle(u), b = std::numbers::pi * v;
    const double sa = std::sin(a), ca = std::cos(a), sb = std::sin(b), cb = std::cos(b);
    const glm::dvec3 p(sb * sa, -cb, sb * ca);
    return {p, 2 * std::numbers::pi * glm::dvec3(sb * ca, 0, -sb * sa),
            std::numbers::pi * glm::dvec3(cb * sa, sb, cb * ca), p};
}

PolygonSoup make_cube(int n) {
    static constexpr struct {
        double right[3], up[3];
    } sides[] = {{{1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}}, {{0, 0, -1}, {0, 1, 0}},
                 {{0, 0, 1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, -1}}, {{1, 0, 0}, {0, 0, 1}}};
    ShapeBuilder builder("cube");
    for (const auto& side : sides) {
        const glm::dvec3 right(side.right[0], side.right[1], side.right[2]);
        const glm::dvec3 up(side.up[0], side.up[1], side.up[2]);
        const glm::dvec3 out = glm::cross(right, up);
        builder.add_grid(n, n, [&](int row, int column) {
            // Exactly antisymmetric, so that sides meet to the bit.
            const double x = double(2 * column - n) / n, y = double(2 * row - n) / n;
            return SurfacePoint{out + right * x + up * y, texcoord(row, n, column, n), out};
        });
    }
    return builder.take();
}

PolygonSoup make_plane(int n) {
    ShapeBuilder builder("plane");
    builder.add_grid(n, n, [&](int row, int column) {
        const glm::dvec3 p(double(2 * column - n) / n, 0, double(n - 2 * row) / n);
        return SurfacePoint{p, texcoord(row, n, column, n), {0, 1, 0}};
    });
    return builder.take();
}

constexpr double ring_radius = 0.7, tube_radius = 0.3;

PolygonSoup make_torus(int n) {
    ShapeBuilder builder("torus");
    const int rows = 4 * n, columns = 8 * n;
    builder.add_grid(rows, columns, [&](int row, int column) {
        // Seams at the back and on the inside.
        const auto [cos_ring, sin_ring] = turn(column + columns / 2, 2 * n);
        const auto [cos_tube, sin_tube] = turn(row + rows / 2, n);
        const double radius = ring_radius + tube_radius * cos_tube;
        return SurfacePoint{{radius * sin_ring, tube_radius * sin_tube, radius * cos_ring},
                            texcoord(row, rows, column, columns),
                            {cos_tube * sin_ring, sin_tube, cos_tube * cos_ring}};
    });
    return builder.take();
}

SmoothPoint smooth_torus(int, double u, double v) {
    const double a = seam_angle(u), b = seam_angle(v), turn = 2 * std::numbers::pi;
    const double sa = std::sin(a), ca = std::cos(a), sb = std::sin(b), cb = std::cos(b);
    const double radius = ring_radius + tube_radius * cb;
    return {{radius * sa, tube_radius * sb, radius * ca},
            turn * radius * glm::dvec3(ca, 0, -sa),
            turn * tube_radius * glm::dvec3(-sb * sa, cb, -sb * ca),
            {cb * sa, sb, cb * ca}};
}

PolygonSoup make_cylinder(int n) {
    ShapeBuilder builder("cylinder");
    const int columns = 4 * n;
    builder.add_grid(n, columns, [&](int row, int column) {
        const auto [c, s] = turn(column + columns / 2, n);
        return SurfacePoint{
            {s, double(2 * row - n) / n, c}, texcoord(row, n, column, columns), {s, 0, c}};
    });
    for (const int side : {-1, 1})
        builder.add_grid(n, columns, [&](int row, int column) {
            // Rows go out from the centre below, in to the centre above, so both face outward.
            const auto [c, s] = turn(column + columns / 2, n);
            const double radius = double(side < 0 ? row : n - row) / n;
            const double x = radius * s, z = radius * c;
            return SurfacePoint{{x, side, z}, {0.5 + 0.5 * x, 0.5 - 0.5 * side * z}, {0, side, 0}};
        });
    return builder.take();
}

/// Patch 0 is the side; 1 and 2 the caps below and above, whose parameters are x and z.
SmoothPoint smooth_cylinder(int patch, double u, double v) {
    if (patch > 0) {
        const double side = patch == 1 ? -1 : 1;
        return {{2 * u - 1, side, side * (1 - 2 * v)}, {2, 0, 0}, {0, 0, -2 * side}, {0, side, 0}};
    }
    const double a = seam_angle(u), sa = std::sin(a), ca = std::cos(a);
    return {
        {sa, 2 * v - 1, ca}, 2 * std::numbers::pi * glm::dvec3(ca, 0, -sa), {0, 2, 0}, {sa, 0, ca}};
}

std::vector<Material> one_material() { return {Material{}}; }

constexpr ShapeInfo shapes[] = {
    {"sphere", "radius 1; n quads a quarter turn: 4n around, 2n from pole to pole", 24, 1024,
     make_sphere, one_material, 1, smooth_sphere},
    {"torus", "radii 0.7 and 0.3; n quads a quarter turn of the tube: 4n around it, 8n along it",
     12, 512, make_torus, one_material, 1, smooth_torus},
    {"teapot", "32 Bezier patches, open at spout and lid; n by n quads a patch, 1 means 2", 10, 512,
     make_teapot, one_material, 32, smooth_teapot},
    {"cube", "side 2, flat normals; n by n quads a side", 1, 1024, make_cube, one_material},
    {"cylinder", "radius 1, height 2, capped; 4n quads around, n up, n from rim to centre", 16,
     1024, make_cylinder, one_material, 3, smooth_cylinder},
    {"plane", "side 2 in y = 0, facing up, not closed; n by n quads", 1, 2048, make_plane,
     one_material},
    {"terrain", "hills over a square of side 2, always the same, not closed; n by n quads", 128,
     2048, make_terrain, one_material, 1, smooth_terrain},
    {"cornell-box",
     "the measured room with two blocks and a lamp, its own materials; n by n quads a face", 8, 512,
     make_cornell_box, cornell_box_materials},
};

}  // namespace

std::span<const ShapeInfo> all_shapes() { return shapes; }

std::shared_ptr<Mesh> make_shape_mesh(const ShapeInfo& shape, int tessellation,
                                      const NormalOptions& normals) {
    auto mesh = std::make_shared<Mesh>(build_mesh(shape.make(tessellation), normals));
    mesh->shape = &shape;
    mesh->tessellation = tessellation;
    return mesh;
}

const ShapeInfo* find_shape(std::string_view name) {
    const auto found = std::find_if(std::begin(shapes), std::end(shapes),
                                    [&](const ShapeInfo& shape) { return shape.name == name; });
    return found == std::end(shapes) ? nullptr : found;
}

}  // namespace scanshade
