// Radiance into the picture: bytes, or planes of float, written once.
#define SCANSHADE_SIMD

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "kernels/engine_data.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/encode.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

/// Rows of a block that a vector spans, and samples of a row that it holds.
constexpr int vector_columns = std::min(N, block_side);

using TagRow = hn::CappedTag<std::int32_t, vector_columns>;
constexpr TagRow tag_row;

/// Whether pixels may go past the caches: nothing reads them before the frame is done, and fetching
/// a line only to overwrite it would cost as much again. That pays for whole lines only.
inline bool starts_line(const std::uint32_t* to) {
    return reinterpret_cast<std::uintptr_t>(to) % 64 == 0;
}

class SubtileWriter {
public:
    SubtileWriter(const PictureView& picture, int x, int y, const Surface& surface)
        : picture_(picture), x_(x), y_(y), surface_(surface) {}

    /// Vectors with a surface stand in the order of the samples.
    std::uint64_t run(int subtile) {
        const int sx = (subtile % 4) * subtile_side, sy = (subtile / 4) * subtile_side;
        std::uint32_t next = 0;
        for (int i = 0; i < subtile_samples; i += N) {
            const int block = i / block_samples;
            const int at = tile_index(sx + block % 4 * block_side, sy + block / 4 * block_side) +
                           i % block_samples;
            const bool seen = next < surface_.vectors && surface_.tile_at[next] == at;
            write_vector(i, at, seen ? next++ : none);
        }
        if (picture_.rgba != nullptr) write_pixels(x_ + sx, y_ + sy);
        return not_finite_;
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;

    void write_vector(int i, int at, std::uint32_t v) {
        VecF L[3];
        for (int c = 0; c < 3; ++c) L[c] = hn::Set(tag_f, picture_.background[c]);
        MaskF seen = hn::Lt(L[0], L[0]);
        if (v != none) {
            const std::uint32_t from = v * std::uint32_t(N);
            seen = hn::Gt(hn::Load(tag_f, surface_.counted + from), hn::Zero(tag_f));
            for (int c = 0; c < 3; ++c)
                L[c] = hn::IfThenElse(seen, hn::Load(tag_f, surface_.radiance[c] + from), L[c]);
            drop_not_finite(L, seen);
        }
        if (picture_.rgba != nullptr) write_bytes(i, L, seen);
        if (picture_.r == nullptr) return;
        add(at, picture_.r, L[0]);
        add(at, picture_.g, L[1]);
        add(at, picture_.b, L[2]);
    }

    /// What is not finite minus itself is not zero.
    void drop_not_finite(VecF (&L)[3], MaskF seen) {
        const VecF sum = hn::Add(hn::Add(L[0], L[1]), L[2]);
        const MaskF bad = hn::AndNot(hn::Eq(hn::Sub(sum, sum), hn::Zero(tag_f)), seen);
        if (hn::AllFalse(tag_f, bad)) return;
        for_each_lane(mask_bits(tag_f, bad), [&](std::uint32_t) { ++not_finite_; });
        for (VecF& channel : L) channel = hn::IfThenZeroElse(bad, channel);
    }

    void write_bytes(int i, const VecF (&L)[3], MaskF seen) {
        const VecI r = bytes_of(L[0]), g = bytes_of(L[1]), b = bytes_of(L[2]);
        const VecI alpha = hn::Set(tag_i, std::int32_t(0xff000000u));
        const VecI rgba =
            hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), hn::Or(hn::ShiftLeft<16>(b), alpha));
        const VecI background = hn::Set(tag_i, std::int32_t(picture_.background_rgba));
        hn::Store(hn::IfThenElse(hn::RebindMask(tag_i, seen), rgba, background), tag_i,
                  pixels_ + i);
    }

    /// From blocks to rows of the picture, whose pixel (x, y) is the subtile's first.
    void write_pixels(int x, int y) const {
        const int columns = std::min(subtile_side, picture_.width - x);
        const int rows = std::min(subtile_side, picture_.height - y);
        for (int row = 0; row < rows; ++row) {
            std::uint32_t* to =
                picture_.rgba + std::size_t(y + row) * std::size_t(picture_.width) + std::size_t(x);
            const std::int32_t* from = pixels_ + row / block_side * subtile_side * block_side +
                                       row % block_side * block_side;
            const bool line = columns == subtile_side && starts_line(to);
            for (int column = 0; column < columns; column += block_side, from += block_samples)
                if (line)
                    for (int i = 0; i < block_side; i += vector_columns)
                        hn::Stream(hn::Load(tag_row, from + i), tag_row, as_int(to + column + i));
                else
                    std::memcpy(to + column, from,
                                std::size_t(std::min(block_side, columns - column)) * sizeof *from);
        }
    }

    /// Nearest byte of the transfer curve. The double formula decides: a polynomial in √v comes
    /// within 0.25 of a level from below, and the table says whether the next byte has begun.
    VecI bytes_of(VecF radiance) const {
        const VecF zero = hn::Zero(tag_f), one = hn::Set(tag_f, 1.0f);
        const VecF exposed = hn::Mul(radiance, hn::Set(tag_f, picture_.scale));
        const VecF v = hn::Min(hn::IfThenElseZero(hn::Gt(exposed, zero), exposed), one);
        if (!picture_.srgb)
            return truncate(hn::Add(hn::Mul(v, hn::Set(tag_f, 255.0f)), hn::Set(tag_f, 0.5f)));
        const VecF s = hn::Sqrt(v);
        VecF curve = hn::Set(tag_f, -0.30957188f * 255);
        for (const float coefficient : {0.84279119f, -0.94486096f, 1.44789935f, -0.03700467f})
            curve = hn::MulAdd(curve, s, hn::Set(tag_f, coefficient * 255));
        const VecF line = hn::Mul(v, hn::Set(tag_f, 12.92f * 255));
        const VecF level = hn::IfThenElse(hn::Lt(v, hn::Set(tag_f, 0.0031308f)), line, curve);
        const VecI guess = truncate(hn::Max(hn::Add(level, hn::Set(tag_f, 0.25f)), zero));
        const VecF next = hn::GatherIndex(tag_f, picture_.srgb_start + 1, guess);
        return hn::Add(
            guess, hn::IfThenElseZero(hn::RebindMask(tag_i, hn::Ge(v, next)), hn::Set(tag_i, 1)));
    }

    void add(int at, float* plane, VecF value) const {
        alignas(64) float values[N];
        hn::Store(value, tag_f, values);
        for_each_row(at, [&](std::size_t to, int from, int columns) {
            for (int i = 0; i < columns; ++i) plane[to + std::size_t(i)] += values[from + i];
        });
    }

    /// Calls write(first pixel, first lane, columns) for the rows of a vector inside the picture.
    template <class Write>
    void for_each_row(int at, Write&& write) const {
        const int block = at / block_samples, first = at % block_samples;
        const int x = x_ + (block % (tile_side / block_side)) * block_side + first % block_side;
        const int y = y_ + (block / (tile_side / block_side)) * block_side + first / block_side;
        const int columns = std::min(vector_columns, picture_.width - x);
        if (columns <= 0) return;
        for (int row = 0; row < std::max(N / block_side, 1) && y + row < picture_.height; ++row)
            write(std::size_t(y + row) * std::size_t(picture_.width) + std::size_t(x),
                  row * block_side, columns);
    }

    const PictureView& picture_;
    const int x_, y_;
    const Surface& surface_;
    std::uint64_t not_finite_ = 0;
    alignas(64) std::int32_t pixels_[subtile_samples];  // block by block
};

std::uint64_t write_here(const PictureView& picture, int x, int y, int subtile,
                         const Surface& surface) {
    return SubtileWriter(picture, x, y, surface).run(subtile);
}

/// `count` pixels of one colour.
void fill_pixels(std::uint32_t* to, std::size_t count, std::uint32_t rgba) {
    const VecI v = hn::Set(tag_i, std::int32_t(rgba));
    std::size_t i = 0;
    if (starts_line(to))
        for (; i + std::size_t(N) <= count; i += std::size_t(N))
            hn::Stream(v, tag_i, as_int(to + i));
    for (; i + std::size_t(N) <= count; i += std::size_t(N)) hn::StoreU(v, tag_i, as_int(to + i));
    for (; i < count; ++i) to[i] = rgba;
}

void background_here(const PictureView& picture, int x, int y, int width, int height) {
    width = std::min(width, picture.width - x);
    height = std::min(height, picture.height - y);
    for (int row = 0; row < height && width > 0; ++row) {
        const std::size_t from = std::size_t(y + row) * std::size_t(picture.width) + std::size_t(x);
        if (picture.rgba != nullptr)
            fill_pixels(picture.rgba + from, std::size_t(width), picture.background_rgba);
        if (picture.r == nullptr) continue;
        float* const planes[3] = {picture.r, picture.g, picture.b};
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < width; ++i)
                planes[c][from + std::size_t(i)] += picture.background[c];
    }
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {

HWY_EXPORT(write_here);
HWY_EXPORT(background_here);

std::uint64_t write_radiance(const PictureView& picture, int x, int y, int subtile,
                             const Surface& surface) {
    return HWY_DYNAMIC_DISPATCH(write_here)(picture, x, y, subtile, surface);
}

void finish_writing() { hwy::FlushStream(); }

void write_background(const PictureView& picture, int x, int y, int width, int height) {
    HWY_DYNAMIC_DISPATCH(background_here)(picture, x, y, width, height);
}

}  // namespace scanshade
#endif
