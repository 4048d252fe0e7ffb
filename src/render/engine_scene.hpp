// What the vector renderer keeps of a scene from frame to frame.
#pragma once

#include <vector>

#include "kernels/engine_data.hpp"
#include "scanshade/render/plan.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// A cluster's sphere and cone in normalised world space.
struct ClusterBounds {
    glm::vec3 centre;
    glm::dvec3 axis;  // unit: of a float's rounding the cosine would make a visible angle
    float radius;
    float sin_cone;      // 1: no common side
    float least_height;  // of its triangles
};

struct EngineObject {
    const ClusteredMesh* mesh;
    LargeVector<float> normal[3];                // [slot] unit, world
    std::vector<ClusterBounds> bounds;           // [cluster]
    std::vector<std::uint8_t> normals_disagree;  // [cluster] see SetupObject
    float to_world[3][4];                        // of the mesh's own units
};

struct EngineScene {
    EngineScene(const Scene& normalised_scene, Interpolation interpolation);

    std::vector<EngineObject> objects;
    /// Least distance of each light to the clusters' spheres, ≥ 0; infinite for directional ones.
    std::vector<double> light_distance;
    double nearest_light;  // the least of them
};

}  // namespace scanshade
