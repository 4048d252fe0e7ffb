#include "render/clip.hpp"

#include <utility>

namespace scanshade {
namespace {

/// A half space {v : value(v) ≥ 0}, in double: of floats, so the value is nearly exact.
struct Plane {
    Outcode bit;
    double x, y, d, w, constant;
    double value(const ClipVertex& v) const {
        return x * double(v.x) + y * double(v.y) + d * double(v.d) + w * double(v.w) + constant;
    }
};

ClipVertex between(const ClipVertex& inside, const ClipVertex& outside, double t) {
    const auto mix = [t](float a, float b) {
        return static_cast<float>(double(a) + t * (double(b) - double(a)));
    };
    return {mix(inside.x, outside.x), mix(inside.y, outside.y), mix(inside.d, outside.d),
            mix(inside.w, outside.w)};
}

void clip_against(const Plane& plane, std::vector<ClipVertex>& polygon) {
    std::vector<ClipVertex> kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex& a = polygon[i];
        const ClipVertex& b = polygon[(i + 1) % polygon.size()];
        const double value_a = plane.value(a), value_b = plane.value(b);
        if (value_a >= 0) kept.push_back(a);
        if (value_a >= 0 && value_b < 0)
            kept.push_back(between(a, b, value_a / (value_a - value_b)));
        if (value_a < 0 && value_b >= 0)
            kept.push_back(between(b, a, value_b / (value_b - value_a)));
    }
    polygon = std::move(kept);
}

}  // namespace

void clip_polygon(std::vector<ClipVertex>& polygon, std::uint8_t outside, const View& view) {
    const double g = double(guard_band);
    const Plane planes[] = {
        // Near comes first: behind it there is nothing that the others could divide by.
        {out_near, 0, 0, 1, 0, -double(view.near)},
        {out_far, 0, 0, -1, 0, double(view.far)},
        {out_left, 1, 0, 0, g, 0},
        {out_right, -1, 0, 0, g, 0},
        {out_top, 0, 1, 0, g, 0},
        {out_bottom, 0, -1, 0, g, 0},
    };
    // A vertex behind the eye may hide that its edge crosses the guard band, so a polygon that the
    // near plane cuts is clipped against all planes.
    if (outside & out_near) outside = 0xff;
    for (const Plane& plane : planes)
        if ((outside & plane.bit) != 0 && polygon.size() >= 3) clip_against(plane, polygon);
}

}  // namespace scanshade
