// The Utah teapot: 32 bicubic Bézier patches.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <iterator>

#include "scene/shape_parts.hpp"
#include "scene/teapot_data.hpp"

namespace scanshade {
namespace {

constexpr double body_radius = 2, height = 3.15;  // in Newell's frame

/// Newell's frame is z up; ours is y up, with the middle of the body at the origin and the spout
/// still along +x. A unit is one and a half radii of the body.
glm::dvec3 to_shape(const double (&p)[3]) {
    constexpr double unit = 1.5 * body_radius;
    return glm::dvec3(p[0], p[2] - height / 2, -p[1]) / unit;
}

/// Bernstein polynomials of degree 3 at t = step/n, and their derivatives.
struct Bernstein {
    double value[4], derivative[4];
};

/// The products of whole numbers are exact, so value[k] at t is value[3 - k] at 1 - t to the bit.
Bernstein bernstein(double t, double n) {
    const double s = n - t, n2 = n * n, n3 = n2 * n;
    return {{s * s * s / n3, 3 * t * s * s / n3, 3 * t * t * s / n3, t * t * t / n3},
            {-3 * s * s / n2, 3 * s * (s - 2 * t) / n2, 3 * t * (2 * s - t) / n2, 3 * t * t / n2}};
}

/// Summed from both ends: patches that share a border curve run along it in either direction.
glm::dvec3 blend(const double (&weight)[4], const glm::dvec3& p0, const glm::dvec3& p1,
                 const glm::dvec3& p2, const glm::dvec3& p3) {
    return (p0 * weight[0] + p3 * weight[3]) + (p1 * weight[1] + p2 * weight[2]);
}

class Patch {
public:
    explicit Patch(const std::uint16_t (&points)[16]) {
        for (std::size_t k = 0; k < 16; ++k)
            control_[k / 4][k % 4] = to_shape(teapot_points[points[k]]);
    }

    /// With derivatives along (row/n, column/n), of which the texture coordinates run against.
    SmoothPoint at(double row, double column, double n) const {
        const Bernstein across = bernstein(row, n), along = bernstein(column, n);
        std::array<glm::dvec3, 4> curve, slope;  // of each row at the column
        for (std::size_t r = 0; r < 4; ++r) {
            const auto& c = control_[r];
            curve[r] = blend(along.value, c[0], c[1], c[2], c[3]);
            slope[r] = blend(along.derivative, c[0], c[1], c[2], c[3]);
        }
        if (is_pole()) curve[0] = control_[0][0];  // blending equal points rounds
        const glm::dvec3 d_across =
            blend(across.derivative, curve[0], curve[1], curve[2], curve[3]);
        // A first row that is one point (lid, bottom) has no derivative along it: the normal is
        // the limit of the cross product, where the derivative of row 1 takes its place.
        const glm::dvec3 d_along =
            row == 0 && is_pole() ? slope[1]
                                  : blend(across.value, slope[0], slope[1], slope[2], slope[3]);
        return {blend(across.value, curve[0], curve[1], curve[2], curve[3]), -d_along, -d_across,
                glm::normalize(glm::cross(d_along, d_across))};
    }

private:
    bool is_pole() const { return control_[0][0] == control_[0][3]; }

    std::array<std::array<glm::dvec3, 4>, 4> control_;  // [row][column]
};

}  // namespace

PolygonSoup make_teapot(int n) {
    // A patch is half of the handle's or of the spout's tube: with one quad it would be flat.
    const int steps = std::max(n, 2);
    ShapeBuilder builder("teapot");
    for (const auto& points : teapot_patches) {
        const Patch patch(points);
        builder.add_grid(steps, steps, [&](int row, int column) {
            const SmoothPoint point = patch.at(row, column, steps);
            // Rows run down the body, clockwise seen from above: turned, an image stands upright.
            return SurfacePoint{point.position,
                                {1 - double(column) / steps, 1 - double(row) / steps},
                                point.normal};
        });
    }
    return builder.take();
}

SmoothPoint smooth_teapot(int patch, double u, double v) {
    static const std::vector<Patch> patches(std::begin(teapot_patches), std::end(teapot_patches));
    return patches[std::size_t(patch)].at(1 - v, 1 - u, 1);
}

}  // namespace scanshade
