// Visibility inside one tile: which triangle is seen at each sample, and how near.
#define SCANSHADE_SIMD

#include <algorithm>
#include <cstring>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/raster_quads.hpp"
#include "kernels/raster_records.hpp"
#include "kernels/raster_triangles.hpp"

SCANSHADE_TARGET_BEGIN;

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(draw_fragments);
HWY_EXPORT(draw_quads);
HWY_EXPORT(draw_triangles);
HWY_EXPORT(draw_record);
HWY_EXPORT(draw_rows);
HWY_EXPORT(write_owned);

void clear_tile(TileBuffer& tile) {
    std::fill(std::begin(tile.owner), std::end(tile.owner), no_ref);
    std::fill(std::begin(tile.written), std::end(tile.written), false);
    std::fill(std::begin(tile.nearest), std::end(tile.nearest), 0.0f);
    std::fill(std::begin(tile.farthest), std::end(tile.farthest), 0.0f);
}
void raster_triangles(const RasterView& view, int x, int y, const std::uint32_t* refs,
                      std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_triangles)(view, x, y, refs, count, tile);
}
void raster_fragments(const RasterView& view, int x, int y, const std::uint32_t* runs,
                      std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_fragments)(view, x, y, runs, count, tile);
}
void raster_quads(const RasterView& view, int x, int y, const std::uint32_t* refs,
                  std::uint32_t count, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_quads)(view, x, y, refs, count, tile);
}
void raster_record(const RasterView& view, int x, int y, std::uint32_t record, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_record)(view, x, y, record, tile);
}
void raster_rows(const RasterView& view, int x, int y, std::uint32_t record,
                 const std::uint64_t (&rows)[tile_side], const float* depth, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(draw_rows)(view, x, y, record, rows, depth, tile);
}
void complete_tile(const RasterView& view, int x, int y, TileBuffer& tile) {
    HWY_DYNAMIC_DISPATCH(write_owned)(view, x, y, tile);
}

}  // namespace scanshade
#endif
