// Random meshes: shapes, and soups of what is hard to draw.
#pragma once

#include <memory>

#include "scanshade/image/texture.hpp"
#include "scanshade/scene/mesh.hpp"
#include "support/random.hpp"

namespace scanshade {

/// A mesh about one unit in radius whose faces use `materials` materials in turn, at random.
std::shared_ptr<const Mesh> make_random_mesh(Rng& rng, std::uint32_t materials);

std::shared_ptr<const Texture> make_random_texture(Rng& rng);

}  // namespace scanshade
