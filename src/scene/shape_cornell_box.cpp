// The Cornell box by its published measurements (Cornell University Program of Computer Graphics,
// "Cornell Box Data": geometry in mm, reflectance spectra, camera).
#include <glm/geometric.hpp>

#include "scene/shape_parts.hpp"

namespace scanshade {
namespace {

/// In tenths of a millimetre: whole numbers, so that faces meet to the bit.
using Point = glm::ivec3;

constexpr int room_height = 5488, room_depth = 5592;
enum : std::uint32_t { white, green, red, lamp };

/// A grid over the quadrilateral a b c d, counter-clockwise; where its corners are in no plane, as
/// those of the red wall, over the bilinear patch.
void add_quad(ShapeBuilder& builder, int n, std::uint32_t material, const Point (&corner)[4]) {
    const Point &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    builder.use_material(material);
    builder.add_grid(n, n, [&](int row, int column) {
        const auto between = [n](const auto& from, const auto& to, int step) {
            return glm::dvec3(from) * double(n - step) + glm::dvec3(to) * double(step);
        };
        const glm::dvec3 sum = between(between(a, b, column), between(d, c, column), row);
        const glm::dvec3 right = between(b - a, c - d, row), up = between(d - a, c - b, column);
        // Units of half the depth, from the middle of the room.
        const glm::dvec3 middle(2780, room_height / 2, room_depth / 2);
        return SurfacePoint{(sum / double(n * n) - middle) / (room_depth / 2.0),
                            {double(column) / n, double(row) / n},
                            glm::normalize(glm::cross(right, up))};
    });
}

/// A block on the floor, by the corners of its top.
void add_block(ShapeBuilder& builder, int n, const Point (&top)[4]) {
    const auto below = [](const Point& p) { return Point(p.x, 0, p.z); };
    add_quad(builder, n, white, top);
    for (int i = 0; i < 4; ++i) {
        const Point &p = top[i], &q = top[(i + 1) % 4];
        add_quad(builder, n, white, {below(q), q, p, below(p)});
    }
}

Material diffuse(const char* name, double r, double g, double b) {
    Material material;
    material.name = name;
    material.brdf = "lambert";
    material.set("kd", {r, g, b});
    return material;
}

}  // namespace

PolygonSoup make_cornell_box(int n) {
    constexpr int top = room_height, back = room_depth;
    const Point floor[4] = {{5528, 0, 0}, {0, 0, 0}, {0, 0, back}, {5496, 0, back}};
    const Point ceiling[4] = {{5560, top, 0}, {5560, top, back}, {0, top, back}, {0, top, 0}};
    const Point light[4] = {
        {3430, top, 2270}, {3430, top, 3320}, {2130, top, 3320}, {2130, top, 2270}};

    ShapeBuilder builder("cornell-box");
    add_quad(builder, n, white, floor);
    add_quad(builder, n, white, {floor[3], floor[2], ceiling[2], ceiling[1]});
    add_quad(builder, n, green, {floor[2], floor[1], ceiling[3], ceiling[2]});
    add_quad(builder, n, red, {floor[0], floor[3], ceiling[1], ceiling[0]});
    // The ceiling around the lamp, so that the two do not lie in each other.
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        add_quad(builder, n, white, {ceiling[i], ceiling[j], light[j], light[i]});
    }
    add_quad(builder, n, lamp, light);
    add_block(builder, n,
              {{1300, 1650, 650}, {820, 1650, 2250}, {2400, 1650, 2720}, {2900, 1650, 1140}});
    add_block(builder, n,
              {{4230, 3300, 2470}, {2650, 3300, 2960}, {3140, 3300, 4560}, {4720, 3300, 4060}});
    return builder.take();
}

/// The measured spectra as linear RGB: approximations that many renderers share, as published in
/// B. Bitterli's "Rendering Resources" (2016). The lamp reflects 0.78 of all light.
std::vector<Material> cornell_box_materials() {
    Material shining = diffuse("cornell-lamp", 0.78, 0.78, 0.78);
    shining.set("emission", {17, 12, 4});
    return {diffuse("cornell-white", 0.725, 0.71, 0.68),
            diffuse("cornell-green", 0.14, 0.45, 0.091), diffuse("cornell-red", 0.63, 0.065, 0.05),
            shining};
}

}  // namespace scanshade
