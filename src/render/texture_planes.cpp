#include "render/texture_planes.hpp"

namespace scanshade {
namespace {

/// The edges of an unclipped triangle as it is drawn: between snapped corners. Small triangles are
/// moved a good part of their size by snapping.
bool snapped_edges(const View& view, const VertexState (&state)[3], HomogeneousEdges& e) {
    double x[3], y[3];
    std::int64_t area = 0;
    for (int i = 0; i < 3; ++i) {
        if (state[i].outcode != 0) return false;
        const SnappedPoint p = state[i].point, q = state[(i + 1) % 3].point;
        area += std::int64_t(p.x) * q.y - std::int64_t(p.y) * q.x;
        x[i] = double(p.x) / subpixels - view.width / 2.0;
        y[i] = double(p.y) / subpixels - view.height / 2.0;
    }
    for (int i = 0; i < 3; ++i) {
        const int p = (i + 1) % 3, q = (i + 2) % 3;
        // 1/w of the corner, times near
        const double z = view.orthographic ? 1 : double(state[i].depth);
        e.a[i] = z * (y[p] - y[q]);
        e.b[i] = z * (x[q] - x[p]);
        e.c[i] = z * (x[p] * y[q] - y[p] * x[q]);
    }
    return area != 0;
}

}  // namespace

TexturePlanes::TexturePlanes(const Frame& frame, std::size_t object, std::uint32_t triangle) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    const auto& corner = mesh.triangle[triangle];
    VertexState state[3];
    for (std::size_t i = 0; i < 3; ++i) state[i] = frame.vertex(object, corner[i]);
    const ClipVertex* const clip[3] = {&state[0].clip, &state[1].clip, &state[2].clip};
    HomogeneousEdges edges{};
    if (!snapped_edges(frame.view, state, edges)) edges = homogeneous_edges(clip);
    // Σ value_i λ_i
    const auto plane = [&](const double(&value)[3]) {
        Plane sum{};
        for (int i = 0; i < 3; ++i) {
            sum.x += value[i] * edges.a[i];
            sum.y += value[i] * edges.b[i];
            sum.constant += value[i] * edges.c[i];
        }
        return sum;
    };
    const auto from_first = [&](const std::vector<float>& coordinate) {
        const auto value = [&](std::size_t i) { return double(coordinate[corner[i]]); };
        return plane({0, value(1) - value(0), value(2) - value(0)});
    };
    u_ = from_first(mesh.u);
    v_ = from_first(mesh.v);
    q_ = plane({1, 1, 1});
}

TextureGradient TexturePlanes::gradient(const View& view, SnappedPoint p, double spacing) const {
    const double X = double(p.x) / subpixels - view.width / 2.0;
    const double Y = double(p.y) / subpixels - view.height / 2.0;
    const double Q = q_.at(X, Y);
    const double u = u_.at(X, Y) / Q, v = v_.at(X, Y) / Q, step = spacing / Q;
    return {float((u_.x - u * q_.x) * step), float((v_.x - v * q_.x) * step),
            float((u_.y - u * q_.y) * step), float((v_.y - v * q_.y) * step)};
}

}  // namespace scanshade
