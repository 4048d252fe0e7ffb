// How gestures move a light. Pure functions.
#pragma once

#include "scanshade/scene/camera.hpp"
#include "scanshade/scene/light.hpp"

namespace scanshade::viewer {

/// Turns the light about `centre` as a drag of (dx, dy) pixels turns a ball in front of the camera:
/// over the window's height by half a turn. A directional light keeps its place and turns where it
/// shines; spot and cosine lights go on to shine at what they shone at.
Light turned(const Light& light, const Camera& camera, const glm::dvec3& centre, double dx,
             double dy, int window_height);

/// Where a light is drawn: its position, or for a directional light where it comes from, `radius`
/// away from `centre`.
glm::dvec3 shown_position(const Light& light, const glm::dvec3& centre, double radius);

}  // namespace scanshade::viewer
