// From refs to surface points: the values that shading reads, at the samples of one subtile.
#define SCANSHADE_SIMD

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/resolve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/resolve_values.hpp"

SCANSHADE_TARGET_BEGIN;

class SubtileResolve : private SurfaceValues {
public:
    SubtileResolve(const ResolveView& view, int x, int y, const TileBuffer& tile, Surface& surface)
        : SurfaceValues(view, tile, surface), x_(x), y_(y) {}

    void run(int subtile) {
        out_.vectors = 0;
        out_.part_count = out_.covered = 0;
        out_.open.clear();
        const int sx = (subtile % 4) * subtile_side, sy = (subtile / 4) * subtile_side;
        if (!tile_.written[subtile])
            return resolve_owned(sx, sy, view_.raster.records[tile_.owner[subtile] & ~record_bit]);
        switch (view_.mostly) {
            case fragment_bit:
                return resolve_vectors<fragment_bit>(sx, sy);
            case quad_bit:
                return resolve_vectors<quad_bit>(sx, sy);
            default:
                return resolve_vectors<0>(sx, sy);
        }
    }

private:
    /// common: the bit of the refs that are resolved in line, with the vector's samples in registers.
    template <std::uint32_t common>
    void resolve_vectors(int sx, int sy) {
        for (int row = 0; row < subtile_side; row += block_side)
            for (int column = 0; column < subtile_side; column += block_side)
                for (int v = 0; v < block_samples / N; ++v)
                    resolve_vector<common>(sx + column, sy + row, v);
    }

    template <std::uint32_t common>
    SCANSHADE_INLINE void resolve_vector(int column, int row, int v) {
        const int at = tile_index(column, row) + v * N;
        const VecI ref = hn::Load(tag_i, as_int(tile_.ref + at));
        const MaskI covered = hn::Ne(ref, hn::Set(tag_i, std::int32_t(no_ref)));
        std::uint32_t pending = mask_bits(tag_i, covered);
        if (pending == 0) return;
        const std::uint32_t number = out_.vectors++;
        out_.covered += std::uint32_t(hn::CountTrue(tag_i, covered));
        out_.tile_at[number] = std::uint16_t(at);
        store(out_.counted, number,
              hn::IfThenElseZero(hn::RebindMask(tag_f, covered), hn::Set(tag_f, 1.0f)));
        const Samples s = samples_of(number);
        if (view_.position_from_depth) recover_position(s);
        while (pending != 0) {
            const std::uint32_t first = tile_.ref[at + __builtin_ctz(pending)];
            const bool in_line = (first & (record_bit | fragment_bit | quad_bit)) == common;
            pending &= ~(in_line ? resolve_lanes<common>(s, ref, first, pending)
                                 : resolve_others(number, first, pending));
        }
    }

    /// A vector that has its place in the tile.
    SCANSHADE_INLINE Samples samples_of(std::uint32_t number) const {
        const int at = out_.tile_at[number], block = at / block_samples;
        constexpr int columns = tile_side / block_side;
        Samples s;
        s.number = number;
        s.at = block_positions(x_ + block % columns * block_side, y_ + block / columns * block_side,
                               at % block_samples / N);
        const VecI ref = hn::Load(tag_i, as_int(tile_.ref + at));
        const MaskI covered = hn::Ne(ref, hn::Set(tag_i, std::int32_t(no_ref)));
        s.z = hn::IfThenElse(hn::RebindMask(tag_f, covered), hn::Load(tag_f, tile_.depth + at),
                             hn::Set(tag_f, 1.0f));
        s.inv_z = reciprocal(Lanes(s.z)).v;
        return s;
    }

    // Each resolves the lanes that show the same batch as `first`, or the same record, and returns them.

    template <std::uint32_t bit>
    SCANSHADE_INLINE std::uint32_t resolve_lanes(const Samples& s, VecI ref, std::uint32_t first,
                                                 std::uint32_t pending) {
        if constexpr (bit == record_bit) return resolve_record(s, ref, first, pending);
        if constexpr (bit == fragment_bit) return resolve_fragments(s, ref, first, pending);
        if constexpr (bit == quad_bit)
            return resolve_batch<QuadLookup<BatchRows>>(s, *view_.raster.quads,
                                                        view_.quad_attributes, ref, first, pending);
        return resolve_batch<PlaneLookup<BatchRows>>(s, *view_.raster.batches, view_.attributes,
                                                     ref, first, pending);
    }

    HWY_NOINLINE std::uint32_t resolve_others(std::uint32_t number, std::uint32_t first,
                                              std::uint32_t pending) {
        const VecI ref = hn::Load(tag_i, as_int(tile_.ref + out_.tile_at[number]));
        const Samples s = samples_of(number);
        if ((first & record_bit) != 0) return resolve_lanes<record_bit>(s, ref, first, pending);
        if ((first & fragment_bit) != 0) return resolve_lanes<fragment_bit>(s, ref, first, pending);
        if ((first & quad_bit) != 0) return resolve_lanes<quad_bit>(s, ref, first, pending);
        return resolve_lanes<0>(s, ref, first, pending);
    }

    /// A subtile that a record covers alone.
    void resolve_owned(int sx, int sy, const Record& r) {
        const VecF one = hn::Set(tag_f, 1.0f);
        const MaskF every = hn::Eq(one, one);
        const Shading shading = view_.objects[r.object].shading;
        for (int i = 0; i < subtile_samples; i += N) {
            const int block = i / block_samples, v = i % block_samples / N;
            const int column = sx + block % 4 * block_side, row = sy + block / 4 * block_side;
            Samples s;
            s.number = out_.vectors++;
            out_.tile_at[s.number] = std::uint16_t(tile_index(column, row) + v * N);
            store(out_.counted, s.number, one);
            s.at = block_positions(x_ + column, y_ + row, v);
            s.z = record_depth(view_.raster, r, s.at);
            s.inv_z = reciprocal(Lanes(s.z)).v;
            if (view_.position_from_depth) recover_position(s);
            resolve_rows(s, r, shading, false, every);
            out_.covered += std::uint32_t(N);
            add_part(s.number, all_lanes, r.material, shading);
        }
    }

    /// The values of a record that has rows as a batch has.
    SCANSHADE_INLINE void resolve_rows(const Samples& s, const Record& r, Shading shading,
                                       bool normals_disagree, MaskF mask) {
        const ResolveMaterial& material = view_.materials[r.material];
        const RecordRows rows(r);
        if (r.depth == Record::Depth::spans)
            resolve_values(s, QuadLookup<RecordRows>(rows, s, view_.quad_attributes), shading,
                           material, normals_disagree, mask);
        else
            resolve_values(s, PlaneLookup<RecordRows>(rows, s, view_.attributes), shading, material,
                           normals_disagree, mask);
    }

    /// The lanes whose number in `numbers` is `number`, of those pending.
    static MaskI lanes_of(VecI numbers, std::uint32_t number, std::uint32_t pending) {
        return hn::And(hn::Eq(numbers, hn::Set(tag_i, std::int32_t(number))),
                       mask_of(tag_i, pending));
    }

    // ---- batches
    template <class Lookup>
    SCANSHADE_INLINE std::uint32_t resolve_batch(const Samples& s, const BatchStore& store,
                                                 const Attributes& attributes, VecI ref,
                                                 std::uint32_t first, std::uint32_t pending) {
        const std::uint32_t number = (first & ~quad_bit) >> lane_shift;
        const MaskI mask = lanes_of(hn::ShiftRight<lane_shift>(ref), first >> lane_shift, pending);
        const std::uint32_t lanes = mask_bits(tag_i, mask);
        const BatchInfo& info = store.info(number);
        if (view_.objects[info.object].scalar) {
            leave_open(s.number, lanes, info.material, view_.objects[info.object].shading);
            return lanes;
        }
        const Lookup batch(BatchRows(store.batch(number), ref), s, attributes);
        resolve_values(s, batch, view_.objects[info.object].shading, view_.materials[info.material],
                       info.normals_disagree, hn::RebindMask(tag_f, mask));
        add_part(s.number, lanes, info.material, view_.objects[info.object].shading);
        return lanes;
    }

    // ---- fragments
    SCANSHADE_INLINE std::uint32_t resolve_fragments(const Samples& s, VecI ref,
                                                     std::uint32_t first, std::uint32_t pending) {
        const std::uint32_t number = (first & ~fragment_bit) >> lane_shift;
        const MaskI mask = lanes_of(hn::ShiftRight<lane_shift>(ref), first >> lane_shift, pending);
        const std::uint32_t lanes = mask_bits(tag_i, mask);
        const BatchInfo& info = view_.raster.fragments->info(number);
        const Shading shading = view_.objects[info.object].shading;
        const BatchRows rows(view_.raster.fragments->batch(number), ref);
        const MaskF mask_f = hn::RebindMask(tag_f, mask);
        const auto put_values = [&](float(&to)[3][subtile_samples], const VecF(&v)[3]) HWY_ATTR {
            for (int c = 0; c < 3; ++c) put(to[c], s.number, v[c], mask_f);
        };
        if (shading != Shading::phong || view_.materials[info.material].reads_normal) {
            const VecF value[3] = {rows.row(fragment_values), rows.row(fragment_values + 1),
                                   rows.row(fragment_values + 2)};
            if (shading == Shading::phong && info.normals_disagree)
                note_zero_normals(s, value, mask_f);
            put_values(shading == Shading::phong ? out_.normal : out_.radiance, value);
        }
        add_part(s.number, lanes, info.material, shading);
        return lanes;
    }

    // ---- records
    std::uint32_t resolve_record(const Samples& s, VecI ref, std::uint32_t first,
                                 std::uint32_t pending) {
        const MaskI mask = lanes_of(ref, first, pending);
        const std::uint32_t lanes = mask_bits(tag_i, mask);
        const Record& r = view_.raster.records[first & ~record_bit];
        const Shading shading = view_.objects[r.object].shading;
        if (r.scalar || view_.objects[r.object].scalar) {
            leave_open(s.number, lanes, r.material, shading);
            return lanes;
        }
        if (r.depth == Record::Depth::plane || r.depth == Record::Depth::spans) {
            resolve_rows(s, r, shading, r.normals_disagree, hn::RebindMask(tag_f, mask));
        } else {
            VecF w[3];
            record_weights(s, r, w);
            resolve_record_values(s, r, w, hn::RebindMask(tag_f, mask));
        }
        add_part(s.number, lanes, r.material, shading);
        return lanes;
    }

    static constexpr int lane_shift = N == 16 ? 4 : N == 8 ? 3 : N == 4 ? 2 : N == 2 ? 1 : 0;
    const int x_, y_;
};

void resolve_here(const ResolveView& view, int x, int y, int subtile, const TileBuffer& tile,
                  Surface& surface) {
    SubtileResolve(view, x, y, tile, surface).run(subtile);
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(resolve_here);

void resolve_subtile(const ResolveView& view, int x, int y, int subtile, const TileBuffer& tile,
                     Surface& surface) {
    HWY_DYNAMIC_DISPATCH(resolve_here)(view, x, y, subtile, tile, surface);
}

}  // namespace scanshade
#endif
