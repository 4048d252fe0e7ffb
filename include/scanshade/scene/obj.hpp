// Wavefront OBJ and MTL files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scanshade/base/events.hpp"
#include "scanshade/scene/material.hpp"
#include "scanshade/scene/mesh.hpp"

namespace scanshade {

struct ObjFile {
    PolygonSoup soup;                 // all faces of the file in their order
    std::vector<Material> materials;  // at least one; face_material counts into it
    EventCounts events;
    std::vector<std::string> warnings;  // a material library or texture that is not there, ...
};

class SceneFiles;  // src/scene/scene_files.hpp

/// Reads an OBJ file, and of its material libraries and textures those that `files` allows.
/// Attributes are finite and indices in range afterwards. Throws Error: file (cannot be read), format
/// (with the line).
ObjFile load_obj(const std::filesystem::path& path, SceneFiles& files, bool mtl_ambient);

/// The same with what lies in the folder of the OBJ file.
ObjFile load_obj(const std::filesystem::path& path, bool mtl_ambient = false);

}  // namespace scanshade
