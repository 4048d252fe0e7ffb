// How fast texture coordinates move on the picture: what chooses the level of a texture.
#pragma once

#include "render/faces.hpp"
#include "scanshade/image/texture.hpp"

namespace scanshade {

/// (u, v) of one triangle on the picture. With Q = 1/w and U = u Q, all three affine there,
///
///     u = U/Q,   ∂u/∂x = (∂U/∂x − u ∂Q/∂x)/Q,   …
///
/// to a common factor of U, V and Q. Always the mapping in perspective, also where an
/// interpolation mode carries (u, v) in another way, so a level depends on triangle and sample
/// alone. Coordinates are taken relative to the first corner's, or far from 0 they would cancel.
class TexturePlanes {
public:
    TexturePlanes() = default;
    TexturePlanes(const Frame& frame, std::size_t object, std::uint32_t triangle);

    /// Steps of (u, v) from the sample at p to its neighbours, `spacing` pixels away. Not a number
    /// for a triangle without area.
    TextureGradient gradient(const View& view, SnappedPoint p, double spacing) const;

private:
    struct Plane {
        double x, y, constant;  // value at (X, Y), in pixels from the picture's centre
        double at(double X, double Y) const { return x * X + y * Y + constant; }
    };
    Plane u_{}, v_{}, q_{};
};

}  // namespace scanshade
