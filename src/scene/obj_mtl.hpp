// Material libraries of OBJ files.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "scanshade/scene/material.hpp"
#include "scanshade/scene/obj.hpp"

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
    MaterialLibraries(ObjFile& report, bool mtl_ambient)
        : report_(report), mtl_ambient_(mtl_ambient) {}

    /// Adds the materials of a library; of two with one name the first counts. A library that
    /// cannot be read is a warning.
    void read(const std::filesystem::path& file);

    bool defines(const std::string& name) const { return entries_.contains(name); }

    /// The material as reflection models see it, with its texture.
    Material make(const std::string& name);

private:
    struct Subject;  // the material that is being made

    void add(const std::filesystem::path& file, const std::string& text);
    std::shared_ptr<const Texture> texture(const Subject& subject);
    std::shared_ptr<const Texture> load_texture(const Subject& subject, const std::string& name);

    ObjFile& report_;
    bool mtl_ambient_;
    std::map<std::string, MtlEntry> entries_;
    std::set<std::filesystem::path> read_;
    std::map<std::string, std::shared_ptr<const Texture>> textures_;  // by path
};

}  // namespace scanshade
