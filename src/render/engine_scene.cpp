#include "render/engine_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/surface.hpp"

namespace scanshade {
namespace {

/// Bounds of a cluster after a linear map. The cone survives rotation, reflection and equal scaling;
/// otherwise nothing is said of the sides.
ClusterBounds world_bounds(const Cluster& cluster, const glm::dmat3& linear,
                           const glm::dvec3& origin) {
    const glm::dmat3 gram = glm::transpose(linear) * linear;
    const double scale2 = gram[0][0];
    double off = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            off = std::max(off, std::abs(gram[i][j] - (i == j ? scale2 : 0)));
    const bool similar = off <= 1e-6 * scale2;
    // A bound of the largest stretch: the matrix' Frobenius norm, or the scale where there is one.
    const double stretch =
        similar ? std::sqrt(scale2) : std::sqrt(gram[0][0] + gram[1][1] + gram[2][2]);
    const auto map = [&](const std::array<float, 3>& v) {
        return linear * glm::dvec3(double(v[0]), double(v[1]), double(v[2]));
    };
    ClusterBounds out{};
    out.centre = glm::vec3(map(cluster.centre) + origin);
    out.radius = float(double(cluster.radius) * stretch * (1 + 1e-5) + 1e-6);
    out.sin_cone = similar ? cluster.sin_cone : 1.0f;
    // A reflection turns normals as it turns positions, times the sign of its determinant; what is
    // asked is the side that the picture shows, and that goes with it.
    out.axis = out.sin_cone < 1 ? glm::normalize(map(cluster.axis)) : glm::dvec3(0);
    out.least_height = similar ? float(double(cluster.least_height) * std::sqrt(scale2)) : 0.0f;
    return out;
}

/// Whether two vertex normals of a cluster may be a right angle apart or more. Otherwise no
/// interpolated normal is shorter than 1/√3: all products of Σ λ_i n_i with itself are positive.
bool normals_disagree(const EngineObject& object, const Cluster& cluster) {
    const auto normal = [&](std::uint32_t i) {
        const std::uint32_t slot = cluster.first_vertex + i;
        return glm::vec3(object.normal[0][slot], object.normal[1][slot], object.normal[2][slot]);
    };
    glm::vec3 sum(0);
    for (std::uint32_t i = 0; i < cluster.vertex_count; ++i) sum += normal(i);
    const float length = glm::length(sum);
    for (std::uint32_t i = 0; i < cluster.vertex_count; ++i)
        // Within 40° of one axis: within 80° of each other. Not so where something is no number.
        if (!(glm::dot(normal(i), sum) > 0.766f * length)) return true;
    return false;
}

/// From the mesh's own units to the world.
struct MeshMap {
    explicit MeshMap(const Object& object)
        : linear(glm::dmat3(object.to_world) * object.mesh->unit),
          origin(glm::dmat3(object.to_world) * object.mesh->origin +
                 glm::dvec3(object.to_world[3])) {}
    glm::dmat3 linear;
    glm::dvec3 origin;
};

std::vector<ClusterBounds> bounds_of(const ClusteredMesh& mesh, const MeshMap& map) {
    std::vector<ClusterBounds> bounds;
    for (const Cluster& cluster : mesh.clusters)
        bounds.push_back(world_bounds(cluster, map.linear, map.origin));
    return bounds;
}

EngineObject make_object(const Object& object, Interpolation interpolation) {
    EngineObject out{};
    out.mesh = &clusters_of(*object.mesh, draws_whole(interpolation));
    const ObjectSurface surface(object);
    const std::size_t slots = out.mesh->x.size();
    for (auto& axis : out.normal) axis.reserve(slots);
    for (const std::uint32_t v : out.mesh->vertex) {
        const glm::dvec3 n = surface.vertex_normal(v);
        for (int c = 0; c < 3; ++c) out.normal[c].push_back(float(n[c]));
    }
    for (const Cluster& cluster : out.mesh->clusters)
        out.normals_disagree.push_back(normals_disagree(out, cluster));
    const MeshMap map(object);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            out.to_world[row][column] = float(map.linear[column][row]);
        out.to_world[row][3] = float(map.origin[row]);
    }
    out.bounds = bounds_of(*out.mesh, map);
    return out;
}

/// From the light to the nearest sphere around triangles; those of faces of any number of corners.
double distance_to(const Light& light, const std::vector<ClusterBounds>& bounds) {
    double distance = double(INFINITY);
    if (light.kind == LightKind::directional) return distance;
    for (const ClusterBounds& b : bounds)
        distance = std::min(distance,
                            glm::distance(light.position, glm::dvec3(b.centre)) - double(b.radius));
    return distance;
}

}  // namespace

EngineScene::EngineScene(const Scene& scene, Interpolation interpolation)
    : nearest_light(double(INFINITY)) {
    light_distance.assign(scene.lights.size(), double(INFINITY));
    for (const Object& object : scene.objects) {
        objects.push_back(make_object(object, interpolation));
        const auto bounds = bounds_of(clusters_of(*object.mesh), MeshMap(object));
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            light_distance[i] =
                std::min(light_distance[i], std::max(distance_to(scene.lights[i], bounds), 0.0));
    }
    for (const double distance : light_distance) nearest_light = std::min(nearest_light, distance);
}

}  // namespace scanshade
