#include "render/texture_planes.hpp"

namespace scanshade {

TexturePlanes::TexturePlanes(const Frame& frame, std::size_t object, std::uint32_t triangle) {
    const Mesh& mesh = *frame.scene.objects[object].mesh;
    const auto& corner = mesh.triangle[triangle];
    VertexState state[3];
    for (std::size_t i = 0; i < 3; ++i) state[i] = frame.vertex(object, corner[i]);
    const ClipVertex* const clip[3] = {&state[0].clip, &state[1].clip, &state[2].clip};
    const HomogeneousEdges edges = homogeneous_edges(clip);
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
        const auto value = [&](int i) { return double(coordinate[corner[i]]); };
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
