#include "scanshade/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scanshade/base/error.hpp"
#include "scanshade/scene/obj.hpp"
#include "scene/limits.hpp"
#include "scene/obj_text.hpp"
#include "scene/scene_files.hpp"
#include "scene/up_axis.hpp"

namespace scanshade {

std::size_t Scene::triangle_count() const {
    std::size_t count = 0;
    for (const Object& object : objects) count += object.mesh->triangle_count();
    return count;
}

Bounds Scene::bounds() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(infinity), high(-infinity);
    for (const Object& object : objects) {
        const Mesh& mesh = *object.mesh;
        for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
            const glm::dvec3 local =
                mesh.origin + mesh.unit * glm::dvec3(mesh.x[i], mesh.y[i], mesh.z[i]);
            const glm::dvec3 p = glm::dvec3(object.to_world * glm::dvec4(local, 1));
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    if (!(low.x <= high.x)) return {};
    // Halves first: the sum of two huge coordinates need not be finite.
    const glm::dvec3 half = high / 2.0 - low / 2.0;
    const double radius = std::hypot(half.x, half.y, half.z);
    return {low / 2.0 + high / 2.0, radius > 0 ? radius : 1};
}

std::vector<Light> three_point_lights(const Bounds& bounds, const Camera& camera) {
    const glm::dmat3 to_world = glm::transpose(eye_rotation(camera));  // columns right, up, back
    struct Row {
        glm::dvec3 from;  // towards the light, in eye space
        glm::dvec3 intensity;
    };
    constexpr double warm = 0.92, cool = 0.94;
    const Row rows[] = {
        {{-0.55, 0.75, 0.75}, glm::dvec3(1, warm * 1.03, warm) * 0.8},
        {{0.9, 0.15, 0.6}, glm::dvec3(cool, cool * 1.02, 1) * 0.22},
        {{0.35, 0.7, -0.9}, glm::dvec3(1) * 0.45},
    };
    std::vector<Light> lights;
    for (const Row& row : rows) {
        Light light;
        light.kind = LightKind::directional;
        light.direction = -(to_world * glm::normalize(row.from));
        light.position = bounds.centre;
        light.intensity = row.intensity;
        lights.push_back(light);
    }
    return lights;
}

namespace {

/// Coordinates will be floats, whose steps are the finer the nearer the origin is. So that is the
/// eye, where something may be near it. From 1.25 radii on nothing is nearer than 0.25, and rounding
/// turns a view direction by no more than 1 + 2/0.25 = 9 u; then the centre keeps coordinates small.
/// A camera that is fitted to the bounds is farther away than that.
glm::dvec3 normalised_origin(const Scene& scene, const Bounds& bounds) {
    if (!scene.camera) return bounds.centre;
    const glm::dvec3& eye = scene.camera->position;
    return glm::distance(eye, bounds.centre) <= 1.25 * bounds.radius ? eye : bounds.centre;
}

}  // namespace

Normalisation normalisation(const Scene& scene) {
    const Bounds bounds = scene.bounds();
    return {normalised_origin(scene, bounds), std::exp2(std::ilogb(bounds.radius))};
}

Scene normalised(const Scene& scene) {
    const Normalisation to = normalisation(scene);
    const double unit = to.unit, usual_radius = 1e-4 * scene.bounds().radius;
    const auto point = [&](const glm::dvec3& p) { return (p - to.origin) / unit; };
    Scene out = scene;
    for (Object& object : out.objects) {
        for (int column = 0; column < 3; ++column)
            object.to_world[column] = glm::dvec4(glm::dvec3(object.to_world[column]) / unit, 0);
        object.to_world[3] = glm::dvec4(point(glm::dvec3(object.to_world[3])), 1);
    }
    for (Light& light : out.lights) {
        light.position = point(light.position);
        light.attenuation.y *= unit;
        light.attenuation.z *= unit * unit;
        light.radius = light.radius.value_or(usual_radius) / unit;
    }
    if (out.camera) {
        out.camera->position = point(out.camera->position);
        out.camera->focal_point = point(out.camera->focal_point);
        if (out.camera->near) *out.camera->near /= unit;
        if (out.camera->far) *out.camera->far /= unit;
    }
    return out;
}

namespace {

constexpr glm::dvec3 default_ambient(0.12);
constexpr double min_radius = 1e-100;

double aspect_of(const Settings& settings) {
    return double(settings.width) / double(settings.height);
}

/// What options say of camera and lights goes before what the scene says.
void apply_overrides(Scene& scene, const Settings& s) {
    if (!s.lights.empty()) scene.lights = s.lights;
    if (!s.camera_position && !s.camera_focal_point && !s.camera_view_up &&
        !s.camera_view_angle_deg && !s.projection)
        return;
    Camera camera = scene.camera ? *scene.camera : framed_camera(scene.bounds(), aspect_of(s));
    camera.position = s.camera_position.value_or(camera.position);
    camera.focal_point = s.camera_focal_point.value_or(camera.focal_point);
    camera.view_up = s.camera_view_up.value_or(camera.view_up);
    camera.view_angle_deg = s.camera_view_angle_deg.value_or(camera.view_angle_deg);
    camera.projection = s.projection.value_or(camera.projection);
    scene.camera = camera;
}

Scene load_obj_scene(const std::filesystem::path& path, const Settings& settings) {
    SceneFiles files(path.parent_path(), settings.allow_outside);
    ObjFile file = load_obj(path, files, settings.mtl_ambient);
    Scene scene;
    Object object;
    object.mesh = std::make_shared<Mesh>(build_mesh(file.soup, settings.normals));
    object.to_world = up_rotation(settings.up);
    object.mesh_file = path;
    for (std::uint32_t i = 0; i < file.materials.size(); ++i) object.materials.push_back(i);
    scene.events = file.events;
    scene.events += object.mesh->events;
    scene.materials = std::move(file.materials);
    scene.warnings = std::move(file.warnings);
    scene.objects.push_back(std::move(object));
    scene.ambient = default_ambient;
    return scene;
}

/// Bounds that the renderer's arithmetic can bear; false for what is not finite, too.
void check_extent(const Bounds& bounds, const std::filesystem::path& input) {
    if (max_abs(bounds.centre) <= max_coordinate && bounds.radius >= min_radius &&
        bounds.radius <= max_coordinate)
        return;
    throw Error(Errc::scene,
                fmt::format("the scene has a radius of {} and lies at {}, {}, {}; a radius from {} "
                            "to {} can be drawn, and a centre up to {}",
                            bounds.radius, bounds.centre.x, bounds.centre.y, bounds.centre.z,
                            min_radius, max_coordinate, max_coordinate))
        .at(input.string());
}

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

void check_file(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        throw Error(Errc::file, "there is no such file; give an .obj file or a .toml scene")
            .at(path.string());
    if (std::filesystem::is_directory(status))
        throw Error(Errc::file, "this is a folder; give an .obj file or a .toml scene in it")
            .at(path.string());
}

}  // namespace

Scene single_object_scene(std::shared_ptr<const Mesh> mesh, Material material) {
    Scene scene;
    scene.name = mesh->name;
    scene.events = mesh->events;
    const std::size_t materials =
        mesh->face_material.empty()
            ? 1
            : *std::max_element(mesh->face_material.begin(), mesh->face_material.end()) + 1;
    Object object;
    object.mesh = std::move(mesh);
    object.materials.resize(materials);
    scene.objects.push_back(std::move(object));
    scene.materials.push_back(std::move(material));
    scene.ambient = default_ambient;
    const Bounds bounds = scene.bounds();
    scene.lights = three_point_lights(bounds, framed_camera(bounds, 1));
    return scene;
}

Scene load_scene(const std::filesystem::path& input, Settings& settings) {
    check_file(input);
    const std::string extension = lower_extension(input);
    Scene scene;
    if (extension == ".obj")
        scene = load_obj_scene(input, settings);
    else if (extension == ".toml")
        scene = parse_scene(read_text(input, max_scene_bytes), input, settings);
    else
        throw Error(
            Errc::format,
            fmt::format("'{}' is no kind of scene; give an .obj file or a .toml scene", extension))
            .at(input.string());
    scene.name = input.stem().string();
    if (scene.triangle_count() == 0)
        throw Error(Errc::format, "the file has no face that can be drawn").at(input.string());
    check_extent(scene.bounds(), input);
    apply_overrides(scene, settings);
    if (scene.camera) {
        eye_rotation(*scene.camera);
        depth_range(*scene.camera, scene.bounds());
    }
    if (extension == ".obj" && settings.lights.empty()) {
        const Bounds bounds = scene.bounds();
        scene.lights = three_point_lights(
            bounds, scene.camera ? *scene.camera : framed_camera(bounds, aspect_of(settings)));
    }
    return scene;
}

}  // namespace scanshade
