// Shading of a tile whose visible surfaces are known.
#pragma once

#include <vector>

#include "kernels/engine_data.hpp"
#include "render/face_values.hpp"
#include "render/frame.hpp"
#include "render/light_reach.hpp"
#include "render/lighting.hpp"

namespace scanshade {

/// What all tiles of a frame share.
struct TileShading {
    explicit TileShading(const Frame& frame);

    const Frame& frame;
    ResolveView resolve;                        // set by whoever makes the batches
    std::vector<ResolveObject> objects;         // [object]
    std::vector<ResolveMaterial> materials;     // [material]
    std::vector<MaterialParams<float>> params;  // [material]
    LightingPair<float> lighting;
    bool aimed_lights;  // some light may miss a tile
    LightTolerance tolerance;
    std::vector<ObjectSurface> surfaces;  // [object]
};

/// Shades tiles, one after another. Holds scratch memory: one for each worker.
class TileShader {
public:
    explicit TileShader(const TileShading& shading);

    /// `tile` is complete (complete_tile). Returns how many samples show a surface.
    std::uint64_t shade(int x, int y, const TileBuffer& tile);

    EventCounts events;
    PlanSavings saved;
    std::uint64_t tolerated_lights = 0;
    const Fallbacks& fallbacks() const { return face_.fallbacks; }

private:
    void choose_lights(int x, int y, const TileBuffer& tile);
    void drop_tolerated(const TileSphere& sphere);
    const Lighting<float>& lighting_for(const ResolvedMaterial& material) const;
    /// Fills surface_; false: the subtile shows nothing but the background.
    bool find_surface(int x, int y, int subtile, const TileBuffer& tile);
    void shade_subtile(int x, int y, int subtile, const TileBuffer& tile);
    void fill_open(int x, int y, const TileBuffer& tile);
    void fill_values(const Surface::Open& open, SnappedPoint p);
    void light_corners();
    Rgb<float> light_point(const Vec3<float>& P, const Vec3<float>& n, float albedo);
    void look_up_textures(int x, int y, const TileBuffer& tile);
    void begin_face(std::uint32_t element, const TileBuffer& tile);
    SnappedPoint sample_of(int x, int y, std::uint32_t element) const;
    int tile_at(std::uint32_t element) const;  // index in the tile
    void illuminate();
    void illuminate_all(std::uint32_t material, float* (&radiance)[3]);
    void write_visibility(int x, int y, const TileBuffer& tile) const;

    const TileShading& shading_;
    Surface surface_;
    FaceValues<float> face_;
    alignas(64) float mixed_[3][subtile_samples];  // radiance of one of several materials
    std::vector<std::uint32_t> materials_;         // in the subtile
    Lighting<float> lit_;                          // without lights that do not reach the tile
};

}  // namespace scanshade
