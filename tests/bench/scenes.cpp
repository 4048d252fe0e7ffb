#include "bench/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <numbers>

#include "scanshade/base/error.hpp"
#include "scanshade/scene/obj.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade::bench {
namespace {

constexpr NormalOptions smooth{.source = NormalSource::average, .crease_deg = 180};

/// Height of a boulder over the unit sphere: three octaves of bumps, each finer and lower.
double bump(const glm::dvec3& p) {
    double height = 0;
    for (const double frequency : {3.0, 7.0, 17.0}) {
        const glm::dvec3 q = frequency * p;
        height += 0.3 / frequency *
                  (std::sin(q.x + 1.3) * std::sin(q.y + 0.4) + std::sin(q.z + 2.1) * std::sin(q.x));
    }
    return height;
}

/// A closed mesh of 12 n² triangles, about equal in size: a cube blown up to a sphere, with bumps
/// that hide one another as those of scanned objects do. Normals are averaged from its faces.
PolygonSoup make_boulder(int n) {
    PolygonSoup soup = find_shape("cube")->make(n);
    for (glm::dvec3& p : soup.positions) {
        p = glm::normalize(p);
        p *= 1 + bump(p);
    }
    for (PolygonSoup::Corner& corner : soup.corners) corner.texcoord = corner.normal = no_index;
    return soup;
}

constexpr int layer_count = 20;
constexpr double layers_view_angle_deg = 30;

/// Rectangles that fill the view of a camera at the origin that looks down −z, one behind the
/// other; their normals lean outward, so that light differs from pixel to pixel.
PolygonSoup make_layers(bool near_first) {
    constexpr double wider = 1.1, aspect = 16.0 / 9;
    PolygonSoup soup;
    soup.name = "layers";
    for (int k = 0; k < layer_count; ++k) {
        const double distance = 1 + 0.05 * (near_first ? k : layer_count - 1 - k);
        const double y = wider * distance * std::tan(glm::radians(layers_view_angle_deg) / 2);
        const double x = aspect * y;
        const auto first = std::uint32_t(soup.positions.size());
        for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            soup.positions.push_back({sx * x, sy * y, -distance});
            soup.normals.push_back(glm::normalize(glm::dvec3(0.3 * sx, 0.3 * sy, 1)));
        }
        for (std::uint32_t c = first; c < first + 4; ++c) soup.corners.push_back({c, no_index, c});
        soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
        soup.face_material.push_back(0);
    }
    return soup;
}

Camera layers_camera() {
    Camera camera;
    camera.position = {0, 0, 0};
    camera.focal_point = {0, 0, -1};
    camera.view_angle_deg = layers_view_angle_deg;
    return camera;
}

/// A camera that sees the bounds `times` as far away as would just fill the picture.
Camera camera_at(const Scene& scene, double times) {
    const Bounds bounds = scene.bounds();
    Camera camera = framed_camera(bounds, 1);
    camera.position = bounds.centre + times * (camera.position - bounds.centre);
    return camera;
}

struct SceneInfo {
    const char* name;
    PolygonSoup (*make)();
    NormalOptions normals;
    Camera (*camera)(const Scene&);
};

// The distances make the objects cover about 289 k and 221 k pixels of a picture of 1080 lines.
constexpr auto boulder_camera = [](const Scene& scene) { return camera_at(scene, 0.94); };
constexpr auto teapot_camera = [](const Scene& scene) { return camera_at(scene, 0.888); };
constexpr auto front_camera = [](const Scene&) { return layers_camera(); };

constexpr SceneInfo scenes[] = {
    {"mesh-70k", [] { return make_boulder(76); }, smooth, boulder_camera},
    {"teapot", [] { return find_shape("teapot")->make(10); }, {}, teapot_camera},
    {"mesh-1.1M", [] { return make_boulder(304); }, smooth, boulder_camera},
    {"layers-near-to-far", [] { return make_layers(true); }, {}, front_camera},
    {"layers-far-to-near", [] { return make_layers(false); }, {}, front_camera},
};

Material surface() {
    Material material;
    material.set("kd", {surface_kd[0], surface_kd[1], surface_kd[2]});
    material.set("ks", {surface_ks});
    material.set("shininess", {surface_shininess});
    return material;
}

Scene scene_of(const PolygonSoup& soup, const NormalOptions& normals) {
    Scene scene;
    Object object;
    object.mesh = std::make_shared<Mesh>(build_mesh(soup, normals));
    const auto& materials = object.mesh->face_material;
    if (materials.empty()) throw Error(Errc::format, "the mesh has no face that can be drawn");
    object.materials.assign(*std::max_element(materials.begin(), materials.end()) + 1u, 0);
    scene.objects.push_back(std::move(object));
    scene.materials.push_back(surface());
    scene.ambient = glm::dvec3(0.05);
    return scene;
}

/// Evenly over the half sphere on the camera's side, at twice the radius; the golden angle keeps
/// them apart.
std::vector<Light> lights_around(const Scene& scene, int count) {
    const Bounds bounds = scene.bounds();
    const glm::dmat3 to_world = glm::transpose(eye_rotation(*scene.camera));
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const double towards_viewer = 1 - 0.5 * (i + 0.5) / count;
        const double aside = std::sqrt(1 - towards_viewer * towards_viewer);
        const double angle = 0.6 + i * std::numbers::pi * (3 - std::sqrt(5.0));
        const glm::dvec3 from(aside * std::cos(angle), aside * std::sin(angle), towards_viewer);
        Light light;
        light.position = bounds.centre + 2 * bounds.radius * (to_world * from);
        const glm::dvec3 tint = i % 2 == 0 ? glm::dvec3(1, 0.95, 0.9) : glm::dvec3(0.9, 0.95, 1);
        light.intensity = tint * (1.2 / std::pow(count, 0.8));
        light.attenuation = {0.3, 0, 0.2 / (bounds.radius * bounds.radius)};
        lights.push_back(light);
    }
    return lights;
}

}  // namespace

std::vector<std::string> scene_names(const std::filesystem::path& mesh_file) {
    if (!mesh_file.empty()) return {mesh_file.stem().string()};
    std::vector<std::string> names;
    for (const SceneInfo& info : scenes) names.push_back(info.name);
    return names;
}

Scene make_scene(const std::string& name, const std::filesystem::path& mesh_file) {
    if (!mesh_file.empty()) {
        Scene scene = scene_of(load_obj(mesh_file).soup, {});
        scene.camera = camera_at(scene, 1);
        return scene;
    }
    const auto info = std::find_if(std::begin(scenes), std::end(scenes),
                                   [&](const SceneInfo& row) { return row.name == name; });
    SCANSHADE_CHECK(info != std::end(scenes));
    Scene scene = scene_of(info->make(), info->normals);
    scene.camera = info->camera(scene);
    return scene;
}

Scene lit_scene(const Scene& scene, const Cell& cell) {
    Scene lit = scene;
    lit.lights = lights_around(scene, cell.lights);
    lit.materials[0].brdf = cell.brdf;
    return lit;
}

}  // namespace scanshade::bench
