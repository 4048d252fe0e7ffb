// Material libraries of OBJ files.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scanshade/scene/material.hpp"
#include "scanshade/scene/obj.hpp"
#include "scene/scene_files.hpp"

namespace scanshade {

/// The statements of one `newmtl`: numbers by keyword, so that what is absent differs from what
/// is 0, and the texture.
struct MtlEntry {
    std::filesystem::path file;
    long line = 0;
    std::map<std::string, std::vector<double>, std::less<>> numbers;
    std::string map_kd;  // as the file spells it, with options
};

/// All materials that the libraries of one OBJ file define.
class MaterialLibraries {
public:
    /// Events and warnings go to `report`.
    MaterialLibraries(ObjFile& report, SceneFiles& files, bool mtl_ambient)
        : report_(report), files_(files), mtl_ambient_(mtl_ambient) {}

    /// Adds the materials of a library that a file in `folder` names; of two materials with one name
    /// the first counts. A library that cannot be read is a warning.
    void read(const std::filesystem::path& folder, const std::string& name);

    bool defines(const std::string& name) const { return entries_.contains(name); }

    /// The material as reflection models see it, with its texture.
    Material make(const std::string& name);

private:
    struct Subject;  // the material that is being made

    void add(const std::filesystem::path& file, const std::string& text);
    void add_texture(const Subject& subject, Material& material);
    /// Beside the library; also without the folders of the machine that wrote the file.
    std::filesystem::path find_texture(const Subject& subject, const std::string& name) const;

    ObjFile& report_;
    SceneFiles& files_;
    bool mtl_ambient_;
    std::map<std::string, MtlEntry> entries_;
    std::set<std::filesystem::path> read_;
};

}  // namespace scanshade
