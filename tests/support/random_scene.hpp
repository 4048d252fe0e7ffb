// Random scenes that look for trouble: what no person would put together in one picture.
#pragma once

#include <string>

#include "scanshade/scene/scene.hpp"
#include "support/random.hpp"

namespace scanshade {

struct RandomScene {
    Scene scene;
    Settings settings;
};

/// Everything follows from the numbers. Pictures are small, at most 96 samples a side.
RandomScene make_random_scene(Rng rng);
inline RandomScene make_random_scene(std::uint64_t seed) { return make_random_scene(Rng(seed)); }

/// The soup with texture coordinates at random, seen by the camera; with a texture or without.
Scene textured_scene(PolygonSoup soup, const Camera& camera, bool textured, Rng& rng);

/// What a person wants to know of a scene whose test failed, in a line.
std::string describe(const RandomScene& random);

}  // namespace scanshade
