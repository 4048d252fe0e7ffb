// The up axis of mesh files.
#pragma once

#include <glm/mat4x4.hpp>

#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// From a file's axes to ours; exact, so that no coordinate is rounded.
inline glm::dmat4 up_rotation(UpAxis up) {
    if (up == UpAxis::y) return glm::dmat4(1);
    // (x, y, z) → (x, z, −y), written by column.
    return {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
}

}  // namespace scanshade
