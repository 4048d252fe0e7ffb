// Scenes in more or fewer polygons.
#include <algorithm>
#include <cmath>
#include <map>

#include "report/error_parts.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

int scaled_tessellation(const Mesh& mesh, double factor) {
    return std::clamp(int(std::lround(mesh.tessellation * factor)), 1,
                      mesh.shape->max_tessellation);
}

bool is_chosen(const Mesh& mesh, Retessellate which) {
    return mesh.shape != nullptr &&
           (which == Retessellate::shapes || mesh.shape->smooth != nullptr);
}

}  // namespace

Scene retessellated(const Scene& scene, double factor, Retessellate which) {
    Scene out = scene;
    std::map<const Mesh*, std::shared_ptr<const Mesh>> made;
    for (Object& object : out.objects) {
        const Mesh& mesh = *object.mesh;
        if (factor == 1 || !is_chosen(mesh, which)) continue;
        std::shared_ptr<const Mesh>& again = made[&mesh];
        if (!again) again = make_shape_mesh(*mesh.shape, scaled_tessellation(mesh, factor));
        object.mesh = again;
    }
    return out;
}

double predicted_triangles(const Scene& scene, double factor) {
    std::map<const Mesh*, double> triangles;
    for (const Object& object : scene.objects)
        if (is_chosen(*object.mesh, Retessellate::smooth))
            triangles[object.mesh.get()] =
                double(object.mesh->triangle_count()) *
                std::pow(
                    double(scaled_tessellation(*object.mesh, factor)) / object.mesh->tessellation,
                    2);
    double sum = 0;
    for (const auto& [mesh, count] : triangles) sum += count;
    return sum;
}

}  // namespace scanshade
