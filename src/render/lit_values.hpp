// Light that was evaluated at points, for the samples of a face.
#pragma once

#include <algorithm>

#include "render/face_values.hpp"

namespace scanshade {

template <class T>
void load_lit_point(Frame& frame, FaceValues<T>& face, std::uint64_t number) {
    const LitPoints<T>& points = lit_points<T>(frame)[face.drawn.object];
    const std::uint64_t key = lit_key(face.material, face.drawn.back, number);
    const auto at = static_cast<std::size_t>(
        std::lower_bound(points.key.begin(), points.key.end(), key) - points.key.begin());
    const auto rgb = [at](const std::vector<T>(&from)[3]) {
        return Rgb<T>{from[0][at], from[1][at], from[2][at]};
    };
    face.radiance.push_back(rgb(points.radiance));
    if (face.texture != nullptr) face.unreflecting.push_back(rgb(points.unreflecting));
}

/// Of a face that was just begun: the light of its middle (flat) or its corners (Gouraud).
template <class T>
void load_lit(Frame& frame, FaceValues<T>& face) {
    if (face.shading == Shading::flat) load_lit_point(frame, face, face.drawn.face);
    if (face.shading == Shading::gouraud)
        for (const std::uint32_t v : face.vertex) load_lit_point(frame, face, v);
}

}  // namespace scanshade
