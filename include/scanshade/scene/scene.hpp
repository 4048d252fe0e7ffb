// A scene: what is in the picture. Plain data in world space, double, as its file gave it.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/base/events.hpp"
#include "scanshade/scene/camera.hpp"
#include "scanshade/scene/light.hpp"
#include "scanshade/scene/material.hpp"
#include "scanshade/scene/mesh.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// A placed mesh. Objects may share meshes.
struct Object {
    std::shared_ptr<const Mesh> mesh;
    glm::dmat4 to_world{1};                // affine, invertible
    std::vector<std::uint32_t> materials;  // mesh material number → index into Scene::materials
    std::optional<Shading> shading;        // instead of the settings', unless that was given as
                                           // an option
    std::filesystem::path mesh_file;       // where the mesh was read, or
    std::string shape;                     // the shape that it is; neither: made by a program
    int tessellation = 0;                  // of the shape
};

struct Scene {
    std::string name;             // file name without folder and extension
    std::vector<Object> objects;  // drawn in this order: equal depth, first wins
    std::vector<Material> materials;
    std::vector<Light> lights;
    glm::dvec3 ambient{0};              // I_a, radiance
    std::optional<Camera> camera;       // none: framed on the bounds
    EventCounts events;                 // of loading, all meshes together
    std::vector<std::string> warnings;  // sentences for people, e.g. a texture not found

    std::size_t triangle_count() const;
    /// Sphere around the box of all vertices in world space; radius 1 where nothing is there.
    Bounds bounds() const;
};

/// Loads an .obj or a .toml scene. Settings of a scene file's [render], [image] tables are stored
/// into `settings` unless the same name was given as an option (settings.given).
/// Then applies what the settings override: lights and camera; an .obj without `--light` gets
/// three-point lighting. Throws Error.
Scene load_scene(const std::filesystem::path& input, Settings& settings);

/// A scene file's text, without what the options override. `file` is named in messages, and paths
/// in the text are relative to its folder.
Scene parse_scene(std::string_view toml, const std::filesystem::path& file, Settings& settings);

/// A scene file's text that shows the same picture, with what `settings` chooses in [render]; paths
/// are relative to `folder` where they can be. Throws Error(scene) for an object that is neither
/// from a file nor a shape.
std::string scene_text(const Scene& scene, const Settings& settings,
                       const std::filesystem::path& folder);

/// A scene with one object and one material, framed and lit by default: what tests, sheets and
/// the default view of an .obj use.
Scene single_object_scene(std::shared_ptr<const Mesh> mesh, Material material);

/// Key, fill and rim light around the bounds, as seen from the camera.
std::vector<Light> three_point_lights(const Bounds& bounds, const Camera& camera);

/// How a scene is moved and scaled to be drawn: p → (p − origin)/unit.
struct Normalisation {
    glm::dvec3 origin;
    double unit;  // world units in one of ours, a power of two
};
/// The eye is the origin, or the bounds' centre is, where that is more than 1.25 radii from the eye.
Normalisation normalisation(const Scene& scene);

/// The scene moved and scaled by its normalisation, to a radius in [1, 2); camera, lights,
/// attenuation, near and far follow. The picture is the same.
Scene normalised(const Scene& scene);

}  // namespace scanshade
