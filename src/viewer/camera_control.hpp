// How gestures move a camera. Pure functions; distances on screen are in pixels, y down.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "scanshade/scene/camera.hpp"

namespace scanshade::viewer {

/// Turns the camera about the focal point as a turntable whose axis is view_up: a drag over the
/// window's height is a full turn. The distance stays; the elevation stops just before the poles,
/// so the picture never flips over.
Camera orbited(const Camera& camera, double dx, double dy, int window_height);

/// Moves position and focal point parallel to the picture so that a point at the focal point's
/// depth follows the cursor.
Camera panned(const Camera& camera, double dx, double dy, int window_height);

/// Scales the distance to the focal point by 0.9 for each step (negative: away), within
/// [1e-3, 1e3] radii of what is drawn. What is (x, y) pixels from the picture's middle, at the focal
/// point's depth, stays there.
Camera zoomed(const Camera& camera, double steps, double radius, double x, double y,
              int window_height);

/// Looks at the focal point from that direction, y up, the distance as before. Straight from above
/// or below the camera stands a hair aside, so that up stays up.
Camera seen_from(const Camera& camera, const glm::dvec3& direction);

/// Seen from the other side of the focal point.
Camera opposite(const Camera& camera);

/// Where a point is seen, in pixels from the upper left corner; nothing where it is not before the
/// eye.
std::optional<glm::dvec2> project(const Camera& camera, int width, int height,
                                  const glm::dvec3& point);

}  // namespace scanshade::viewer
