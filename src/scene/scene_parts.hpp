// The tables of a scene file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "scanshade/scene/scene.hpp"
#include "scene/toml_reader.hpp"

namespace scanshade {

Camera read_camera(const TomlReader& reader);
Light read_light(const TomlReader& reader);
Material read_material(const TomlReader& reader, const std::filesystem::path& folder);

/// Reads [[object]] tables into a scene whose named materials are there already. A mesh file or
/// shape that several objects use is made once.
class ObjectReader {
public:
    ObjectReader(std::filesystem::path folder, const Settings& settings, Scene& scene)
        : folder_(std::move(folder)),
          settings_(settings),
          scene_(scene),
          named_materials_(scene.materials.size()) {}

    void read(const TomlReader& reader);

private:
    /// A mesh and the scene's numbers for the materials of its file.
    struct Source {
        std::shared_ptr<const Mesh> mesh;
        std::vector<std::uint32_t> materials;
    };
    const Source& file_source(const TomlReader& reader, const std::string& name);
    const Source& shape_source(const TomlReader& reader, const std::string& name);
    std::uint32_t material_index(const TomlReader& reader) const;

    std::filesystem::path folder_;
    const Settings& settings_;
    Scene& scene_;
    std::size_t named_materials_;
    std::map<std::string, Source> sources_;
};

}  // namespace scanshade
