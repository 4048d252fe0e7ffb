#include "bench/peer_scene.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "bench/scenes.hpp"
#include "scanshade/base/error.hpp"

namespace scanshade::bench {
namespace {

Float3 to_float3(const glm::dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

const glm::dvec3 kd(surface_kd[0], surface_kd[1], surface_kd[2]);

PeerLight peer_light(const Light& light) {
    SCANSHADE_CHECK(light.kind == LightKind::point && light.attenuation.y == 0);
    PeerLight out{};
    for (int i = 0; i < 3; ++i) {
        out.position[i] = float(light.position[i]);
        out.diffuse[i] = float(light.intensity[i] * kd[i]);
        out.specular[i] = float(light.intensity[i] * surface_ks);
    }
    out.c = float(light.attenuation.x);
    out.q = float(light.attenuation.z);
    return out;
}

/// Mesh → clip in double, relative to the eye, rounded once.
void set_to_clip(const Scene& scene, const glm::dmat3& rotation, double tangent, double aspect,
                 PeerScene& out) {
    const Object& object = scene.objects[0];
    const Camera& camera = *scene.camera;
    const glm::dmat3 linear = rotation * glm::dmat3(object.to_world) * object.mesh->unit;
    const glm::dvec3 offset =
        rotation *
        (glm::dvec3(object.to_world * glm::dvec4(object.mesh->origin, 1)) - camera.position);
    const auto [near, far] = depth_range(camera, scene.bounds());
    const double depth = (far + near) / (far - near), shift = -2 * far * near / (far - near);
    for (int column = 0; column < 4; ++column) {
        const glm::dvec3 p = column < 3 ? linear[column] : offset;
        float* clip = out.to_clip + 4 * column;
        clip[0] = float(p.x / (tangent * aspect));
        clip[1] = float(p.y / tangent);
        clip[2] = float(-p.z * depth + (column == 3 ? shift : 0));
        clip[3] = float(-p.z);
    }
}

void set_rays(const Camera& camera, const glm::dmat3& rotation, double tangent,
              const Settings& settings, PeerScene& out) {
    const glm::dmat3 to_world = glm::transpose(rotation);  // columns right, up, backward
    const double pixel = 2 * tangent / settings.height;
    const glm::dvec3 x = to_world[0] * pixel, y = to_world[1] * -pixel;
    out.eye = to_float3(camera.position);
    out.ray_x = to_float3(x);
    out.ray_y = to_float3(y);
    out.ray_corner =
        to_float3(-to_world[2] - x * (settings.width / 2.0) - y * (settings.height / 2.0));
}

}  // namespace

PeerScene make_peer_scene(const Scene& as_given, const Settings& settings) {
    const Scene scene = normalised(as_given);
    const Object& object = scene.objects[0];
    const double scale = object.to_world[0][0];
    SCANSHADE_CHECK(glm::dmat3(object.to_world) == glm::dmat3(scale));

    PeerScene out{};
    out.mesh = object.mesh.get();
    out.scale = float(scale * object.mesh->unit);
    out.origin = to_float3(glm::dvec3(object.to_world * glm::dvec4(object.mesh->origin, 1)));
    const glm::dmat3 rotation = eye_rotation(*scene.camera);
    const double tangent = std::tan(glm::radians(scene.camera->view_angle_deg) / 2);
    set_to_clip(scene, rotation, tangent, double(settings.width) / settings.height, out);
    set_rays(*scene.camera, rotation, tangent, settings, out);

    const bool unlit = scene.materials[0].brdf == "unlit";
    out.base = to_float3(unlit ? kd : scene.ambient * kd);
    for (const Light& light : scene.lights) out.lights.push_back(peer_light(light));
    out.background = to_float3(settings.background);
    return out;
}

}  // namespace scanshade::bench
