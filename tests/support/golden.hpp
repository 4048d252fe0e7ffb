// The list of golden pictures, from golden/manifest.toml.
#pragma once

#include <string>
#include <vector>

#include "scanshade/scene/scene.hpp"

namespace scanshade {

struct GoldenPicture {
    std::string name;
    std::string scene_file;  // or the name of a text in the manifest
    Scene scene;
    Settings settings;
};

struct GoldenList {
    int max_delta = 0;
    std::uint64_t max_count = 0;
    std::vector<GoldenPicture> pictures;
};

/// Run from the top of the project.
GoldenList load_golden_list();

}  // namespace scanshade
