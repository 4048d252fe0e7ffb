// Our illumination in GLSL.
#pragma once

#include <string>

#include "bench/cells.hpp"

namespace scanshade::bench {

struct ShaderPair {
    std::string vertex, fragment;
};

/// Attribute locations: 0 position (the mesh's own units), 1 normal, 2 centre of the face, 3 number
/// of the triangle. Gouraud and flat light vertices, flat at the face's centre; phong pixels.
/// `squarings`: the power by products, else by pow().
ShaderPair shaders_of(const Cell& cell, bool two_sided, bool squarings);

/// Draws the triangle's number as bytes.
ShaderPair id_shaders();

}  // namespace scanshade::bench
