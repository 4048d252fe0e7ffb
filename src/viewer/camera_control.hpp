// How gestures move a camera. Pure functions; distances on screen are in pixels, y down.
#pragma once

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
/// [1e-3, 1e3] radii of what is drawn.
Camera zoomed(const Camera& camera, double steps, double radius);

}  // namespace scanshade::viewer
