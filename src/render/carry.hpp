// How values travel from the corners of a drawn face to a sample inside it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "render/faces.hpp"
#include "scanshade/eq/shading.hpp"

namespace scanshade {

/// One sample's place inside a drawn face, in the number type of the shading.
template <class R>
struct Place {
    enum class Kind : std::uint8_t { weights, scanline, patch } kind;
    R weight[3];               // weights: of the three corners, sum 1
    std::uint32_t a, b, c, d;  // scanline: left edge a–b, right edge c–d; patch: A B C D
    R a_y, b_y, c_y, d_y, y;   // scanline: heights in 1/256 pixel from the sample's row
    R ab_x, cd_x;              // scanline: where the edges cross, 1/256 pixel from the sample
    R u, v;                    // patch
};

/// The value at a place; `corner` is indexed as the drawn face's vertices (patch: the quad's).
template <class R, class Value>
Value carry(const Place<R>& at, const Value* corner) {
    if (at.kind == Place<R>::Kind::weights)
        return corner[0] * at.weight[0] + corner[1] * at.weight[1] + corner[2] * at.weight[2];
    if (at.kind == Place<R>::Kind::patch)
        return bilinear(corner[at.a], corner[at.b], corner[at.c], corner[at.d], at.u, at.v);
    return along_span(along_edge(corner[at.a], corner[at.b], at.a_y, at.b_y, at.y),
                      along_edge(corner[at.c], corner[at.d], at.c_y, at.d_y, at.y), at.ab_x,
                      at.cd_x, R(0));
}

/// The sample of pixel (x, y) on the picture.
inline SnappedPoint sample_point(int x, int y, SampleOffset sample) {
    return {x * subpixels + sample.x, y * subpixels + sample.y};
}

/// λ_i of an unclipped triangle at a sample, from exact edge functions: error ≤ 2 u of R each.
template <class R>
void triangle_weights(const DrawnFace& face, SnappedPoint p, R (&lambda)[3]) {
    for (int i = 0; i < 3; ++i) {
        const std::int64_t e = edge_function(face.point[(i + 1) % 3], face.point[(i + 2) % 3], p);
        lambda[i] = static_cast<R>(static_cast<double>(e) * face.inv_area);
    }
}

/// λ_i of a clipped triangle, unnormalised, in double; true where one had to be clamped to 0:
/// the sample is inside the snapped polygon but a hair outside the exact one.
bool homogeneous_weights(const DrawnFace& face, const View& view, SnappedPoint p,
                         double (&lambda)[3]);

/// (u, v) of a point in a quadrilateral A B C D with D opposite to A, in double: the inverse of
/// (C2). Nothing where there is no real root or the quadrilateral is not strictly convex.
struct PatchPlace {
    double u, v;
};
std::optional<PatchPlace> inverse_bilinear(const PictureCorner& A, const PictureCorner& B,
                                           const PictureCorner& C, const PictureCorner& D,
                                           const PictureCorner& p);

/// The place of a sample in a polygon: the two edges that its row crosses.
template <class R>
Place<R> polygon_place(std::span<const PictureCorner> corner, SnappedPoint p) {
    struct Crossing {
        std::uint32_t from, to;
        double from_y, to_y, x;
    };
    Crossing crossing[2] = {};
    std::size_t found = 0;
    const std::size_t n = corner.size();
    for (std::size_t i = 0; i < n && found < 2; ++i) {
        const std::size_t j = (i + 1) % n;
        const double from_y = corner[i].y - p.y, to_y = corner[j].y - p.y;
        if ((from_y > 0) == (to_y > 0)) continue;  // half open, as the walker has it
        const double from_x = corner[i].x - p.x, to_x = corner[j].x - p.x;
        crossing[found++] = {std::uint32_t(i), std::uint32_t(j), from_y, to_y,
                             (to_x * from_y - from_x * to_y) / (from_y - to_y)};
    }
    if (crossing[1].x < crossing[0].x) std::swap(crossing[0], crossing[1]);
    const auto& [ab, cd] = crossing;
    Place<R> at{};
    at.kind = Place<R>::Kind::scanline;
    at.a = ab.from, at.b = ab.to, at.c = cd.from, at.d = cd.to;
    at.a_y = R(ab.from_y), at.b_y = R(ab.to_y), at.ab_x = R(ab.x);
    at.c_y = R(cd.from_y), at.d_y = R(cd.to_y), at.cd_x = R(cd.x);
    at.y = R(0);
    return at;
}

/// The place of a sample in a drawn face that is not a patch. Counts clamped weights.
template <class R>
Place<R> place_in(const DrawnFace& face, const Frame& frame, SnappedPoint p, EventCounts& events) {
    if (face.carrier == Carrier::polygon) return polygon_place<R>(face.corner, p);
    const bool affine = frame.view.orthographic || frame.plan.interpolation == Interpolation::edges;
    Place<R> at{};
    at.kind = Place<R>::Kind::weights;
    if (face.carrier == Carrier::clipped) {
        double lambda[3];
        if (homogeneous_weights(face, frame.view, p, lambda)) events.add(Event::clamped_weight);
        // Clipping by the guard band alone does not change how `edges` interpolates: on the picture.
        if (affine && (face.outside & out_depth) == 0)
            for (std::size_t i = 0; i < 3; ++i) lambda[i] *= double(face.state[i].clip.w);
        const double sum = lambda[0] + lambda[1] + lambda[2];
        for (int i = 0; i < 3; ++i) at.weight[i] = R(lambda[i] / sum);
        return at;
    }
    triangle_weights(face, p, at.weight);
    if (affine) return at;
    // Hyperbolic: μ_i ∝ λ_i/w_i, and depth is near/w.
    R sum = R(0);
    for (std::size_t i = 0; i < 3; ++i) {
        at.weight[i] = at.weight[i] * R(face.state[i].depth);
        sum = sum + at.weight[i];
    }
    for (int i = 0; i < 3; ++i) at.weight[i] = at.weight[i] / sum;
    return at;
}

}  // namespace scanshade
