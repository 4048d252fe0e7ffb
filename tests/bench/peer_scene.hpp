// A cell as the peers read it: our camera, lights, normals and material in float.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/cells.hpp"
#include "bench/peer_light.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade::bench {

using Float3 = std::array<float, 3>;

/// All in the normalised scene's space, where our renderer lights too.
struct PeerScene {
    const Mesh* mesh;  // its own (x, y, z) stand at origin + scale·(x, y, z)
    float scale;
    Float3 origin;
    Float3 placed(const Float3& own) const {
        return {origin[0] + scale * own[0], origin[1] + scale * own[1], origin[2] + scale * own[2]};
    }

    float to_clip[16];  // OpenGL's: columns, z and w in [−1, 1]; of the mesh's own x, y, z
    Float3 eye;
    Float3 ray_corner, ray_x, ray_y;  // direction through (x, y) of the picture, y down:
                                      // ray_corner + x ray_x + y ray_y, length 1 along the view

    Float3 base;                    // radiance without lights
    std::vector<PeerLight> lights;  // none where unlit
    Float3 background;
};

/// `scene` has one object, lights and a camera; its mesh outlives the result.
PeerScene make_peer_scene(const Scene& scene, const Settings& settings);

}  // namespace scanshade::bench
