// From what is seen to surface points, and from their radiance to the picture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/tile.hpp"
#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// What of a material and an object decides how a sample's values are found.
struct ResolveObject {
    Shading shading;
    bool scalar;  // values by the scalar renderers' functions: quadrilaterals in `patch`
};
struct ResolveMaterial {
    bool textured, reads_normal;
};

struct ResolveView {
    RasterView raster;
    Attributes attributes, quad_attributes;
    bool affine;
    float sample_spacing;      // pixels from a sample to the next
    bool position_from_depth;  // else it is an attribute
    std::uint32_t mostly;      // the bit of most refs: fragment_bit, quad_bit or 0; for speed alone
    bool shaded_alike;         // all samples by one material, or all lit before, and none textured
    const ResolveObject* objects;
    const ResolveMaterial* materials;
    // A point at distance d along the view: eye + d (ray + x ray_x + y ray_y) in perspective,
    // (ray + x ray_x + y ray_y) + d eye in orthographic projection, x and y pixels.
    float eye[3], ray[3], ray_x[3], ray_y[3];
};

inline constexpr int subtile_samples = subtile_side * subtile_side;

/// The visible surface in one subtile: vectors of samples one after another, those without any
/// surface left out. Lanes without a surface hold numbers of no meaning.
struct Surface {
    /// The samples of one vector that are shaded alike.
    struct Part {
        std::uint32_t vector, lanes;  // number of the vector; a bit a lane
        std::uint32_t material;
        bool lit;  // radiance is there already: Gouraud, flat
    };
    /// A sample whose values the driver finds.
    struct Open {
        std::uint32_t at, ref;  // element of the arrays
        bool zero_normal;       // only the normal is missing: it has no length
    };
    alignas(64) float normal[3][subtile_samples];
    alignas(64) float position[3][subtile_samples];
    alignas(64) float radiance[3][subtile_samples];
    alignas(64) float dark[3][subtile_samples];
    alignas(64) float texcoord[2][subtile_samples];
    alignas(
        64) float texstep[4][subtile_samples];  // du_dx, dv_dx, du_dy, dv_dy to the next sample;
                                                // the first not a number: the driver's task
    alignas(64) float albedo[3][subtile_samples];
    alignas(64) float counted[subtile_samples];  // 1: a surface, 0: none
    std::uint16_t tile_at[subtile_samples];      // [vector] of its first sample in the tile
    std::uint32_t vectors;
    Part part[subtile_samples];
    std::uint32_t part_count;
    std::uint32_t covered;  // samples that show a surface
    std::vector<Open> open;

    std::span<const Part> parts() const { return {part, part_count}; }
};

/// Finds the surface of subtile `subtile` of the tile at (x, y).
void resolve_subtile(const ResolveView& view, int x, int y, int subtile, const TileBuffer& tile,
                     Surface& surface);

// ---- from radiance to the picture

/// Where a frame's samples go; null where nobody asks for it. Rows of `width` values.
struct PictureView {
    int width, height;
    std::uint32_t* rgba;  // bytes r, g, b, 255
    // For each subtile of the picture, rows from the top: rgba shows the background and nothing else.
    // Kept by draw_background and whoever draws anything else; null: nobody asks.
    std::uint8_t* blank;
    float *r, *g, *b;  // radiance is added
    float* depth;
    std::uint32_t* id;
    float scale;  // 2^EV
    bool srgb;
    const float* srgb_start;  // [257] smallest radiance of each byte; the last is infinite
    float background[3];
    std::uint32_t background_rgba;
};

/// Writes the radiance of subtile `subtile` of the tile at (x, y), background where there is no
/// surface. Returns how many samples were not finite and so are black.
std::uint64_t write_radiance(const PictureView& picture, int x, int y, int subtile,
                             const Surface& surface);

/// Writes background into the samples [x, x + width) × [y, y + height), cut to the picture.
void write_background(const PictureView& picture, int x, int y, int width, int height);

/// What this thread has written becomes visible to the others.
void finish_writing();

}  // namespace scanshade
