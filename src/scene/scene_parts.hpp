// The tables of a scene file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/scene/scene.hpp"
#include "scene/scene_files.hpp"
#include "scene/toml_reader.hpp"

namespace scanshade {

/// `framed` with what the table says instead.
Camera read_camera(const TomlReader& reader, const Camera& framed);
Light read_light(const TomlReader& reader);
Material read_material(const TomlReader& reader, const std::filesystem::path& folder,
                       SceneFiles& files);

/// Reads [[object]] tables into a scene whose named materials are there already. A mesh file or
/// shape that several objects use is made once.
class ObjectReader {
public:
    ObjectReader(std::filesystem::path folder, SceneFiles& files, const Settings& settings,
                 Scene& scene)
        : folder_(std::move(folder)), files_(files), settings_(settings), scene_(scene) {
        for (const Material& material : scene.materials)
            names_.emplace(material.name, names_.size());
    }

    void read(const TomlReader& reader);

private:
    /// A mesh and the scene's numbers for the materials of its file.
    struct Source {
        std::shared_ptr<const Mesh> mesh;
        std::vector<std::uint32_t> materials;
        std::filesystem::path file;  // or
        std::string shape;
        int tessellation = 0;
    };
    const Source& file_source(const TomlReader& reader, const std::string& name);
    const Source& shape_source(const TomlReader& reader, const std::string& name);
    void add_materials(const TomlReader& reader, Source& source, std::vector<Material> materials);
    std::uint32_t material_index(const TomlReader& reader, const toml::node& at) const;
    /// `material` for all of the mesh, or `materials` one by one.
    void read_materials(const TomlReader& reader, Object& object) const;

    std::filesystem::path folder_;
    SceneFiles& files_;
    const Settings& settings_;
    Scene& scene_;
    std::map<std::string, std::size_t, std::less<>> names_;  // materials of the scene file
    std::map<std::string, Source> sources_;
    std::size_t triangles_ = 0;  // of all objects so far
};

}  // namespace scanshade
