#include "report/picture_scene_parts.hpp"

#include <memory>

#include "scanshade/scene/shapes.hpp"

namespace scanshade {

SceneBuilder::SceneBuilder() {
    input_.settings.width = case_width;
    input_.settings.height = case_height;
    input_.scene.ambient = glm::dvec3(0.15);
    input_.scene.materials.push_back(coloured(0.8, 0.8, 0.8));
}

SceneBuilder& SceneBuilder::camera(const glm::dvec3& position, const glm::dvec3& focal_point,
                                   double degrees) {
    Camera camera;
    camera.position = position;
    camera.focal_point = focal_point;
    camera.view_angle_deg = degrees;
    input_.scene.camera = camera;
    return *this;
}

SceneBuilder& SceneBuilder::pixel_camera(double near, double far) {
    return camera({0, 0, 0}, {0, 0, -1}, 90).depth(near, far);
}

SceneBuilder& SceneBuilder::depth(double near, double far) {
    input_.scene.camera->near = near;
    input_.scene.camera->far = far;
    return *this;
}

SceneBuilder& SceneBuilder::front_light() { return light(directional_light({0.4, -0.5, -1}, 0.9)); }

SceneBuilder& SceneBuilder::light(const Light& light) {
    input_.scene.lights.push_back(light);
    return *this;
}

SceneBuilder& SceneBuilder::material(const Material& material) {
    input_.scene.materials.push_back(material);
    return *this;
}

SceneBuilder& SceneBuilder::object(const PolygonSoup& soup, const glm::dmat4& to_world,
                                   const NormalOptions& normals) {
    Object object;
    object.mesh = std::make_shared<Mesh>(build_mesh(soup, normals));
    object.to_world = to_world;
    object.materials = {std::uint32_t(input_.scene.materials.size() - 1)};
    input_.scene.events += object.mesh->events;
    input_.scene.objects.push_back(std::move(object));
    return *this;
}

glm::dvec3 pixel_point(double px, double py, double w) {
    constexpr double half = case_height / 2.0;  // pixels a unit at w = 1
    return {(px - case_width / 2.0) / half * w, (half - py) / half * w, -w};
}

Material coloured(double red, double green, double blue) {
    Material material;
    material.set("kd", {red, green, blue});
    return material;
}

Material palette(std::size_t number) {
    constexpr double colours[][3] = {{0.75, 0.75, 0.72}, {0.80, 0.30, 0.05}, {0.05, 0.35, 0.70},
                                     {0.10, 0.55, 0.25}, {0.75, 0.55, 0.05}, {0.45, 0.15, 0.50}};
    const auto& c = colours[number % std::size(colours)];
    return coloured(c[0], c[1], c[2]);
}

PolygonSoup shape(std::string_view name, int tessellation) {
    return find_shape(name)->make(tessellation);
}

void add_face(PolygonSoup& soup, const std::vector<glm::dvec3>& corners,
              const std::vector<glm::dvec3>& normals) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto position = std::uint32_t(soup.positions.size());
        soup.positions.push_back(corners[i]);
        const auto normal = normals.empty() ? no_index : std::uint32_t(soup.normals.size());
        if (!normals.empty()) soup.normals.push_back(normals[i]);
        soup.corners.push_back({position, no_index, normal});
    }
    soup.face_begin.push_back(std::uint32_t(soup.corners.size()));
    soup.face_material.push_back(0);
}

Light point_light(const glm::dvec3& position, double intensity, const glm::dvec3& attenuation) {
    Light light;
    light.position = position;
    light.intensity = glm::dvec3(intensity);
    light.attenuation = attenuation;
    return light;
}

Light directional_light(const glm::dvec3& direction, double intensity) {
    Light light;
    light.kind = LightKind::directional;
    light.direction = direction;
    light.intensity = glm::dvec3(intensity);
    return light;
}

}  // namespace scanshade
