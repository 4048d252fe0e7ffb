// Radiance to bytes by the kernels: what the transfer curve in double says, for every instruction set.
#include <bit>
#include <cmath>

#include "kernels/engine_data.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// The byte that the double formula gives.
int byte_of(float v, bool srgb) {
    const double limited = v > 0 ? std::min(double(v), 1.0) : 0;
    if (!srgb) return int(float(limited) * 255.0f + 0.5f);
    return int(255 * srgb_encode(limited) + 0.5);
}

/// A subtile of 256 values on its way into a picture of 16 × 16.
class SubtileBytes {
public:
    explicit SubtileBytes(bool srgb) : surface_(std::make_unique<Surface>()), srgb_(srgb) {
        const int lanes = vector_lanes();
        surface_->vectors = std::uint32_t(subtile_samples / lanes);
        for (std::uint32_t v = 0; v < surface_->vectors; ++v) {
            const int in_subtile = int(v) * lanes;  // blocks of 16 samples, row by row
            const int block = in_subtile / block_samples;
            surface_->tile_at[v] =
                std::uint16_t(tile_index((block % 4) * block_side, (block / 4) * block_side) +
                              in_subtile % block_samples);
        }
        std::fill_n(surface_->counted, subtile_samples, 1.0f);
        view_.width = view_.height = subtile_side;
        view_.scale = 1;
        view_.srgb = srgb;
        view_.srgb_start = srgb_byte_starts().data();
    }

    /// How many of the values get another byte than the formula's; the first such one in `odd`.
    int wrong(const std::vector<float>& values, float& odd) {
        int count = 0;
        for (std::size_t from = 0; from < values.size(); from += subtile_samples) {
            for (int i = 0; i < subtile_samples; ++i) {
                const float v = values[std::min(from + std::size_t(i), values.size() - 1)];
                for (auto& channel : surface_->radiance) channel[i] = v;
            }
            std::uint32_t pixels[subtile_samples] = {};
            view_.rgba = pixels;
            write_radiance(view_, 0, 0, 0, *surface_);
            for (int i = 0; i < subtile_samples; ++i) {
                const float v = surface_->radiance[0][i];
                const int block = i / block_samples, in_block = i % block_samples;
                const int x = (block % 4) * block_side + in_block % block_side;
                const int y = (block / 4) * block_side + in_block / block_side;
                const auto byte = std::uint32_t(byte_of(v, srgb_));
                if (pixels[y * subtile_side + x] == (0xff000000u | byte * 0x010101u)) continue;
                if (count++ == 0) odd = v;
            }
        }
        return count;
    }

private:
    std::unique_ptr<Surface> surface_;
    PictureView view_{};
    const bool srgb_;
};

/// The floats around each place where a byte begins, and what is odd.
std::vector<float> near_thresholds() {
    std::vector<float> values = {0.0f, -0.0f, -1.0f, 1e-45f, -1e30f, 1.0f, 2.0f, 1e30f, 0.0031308f};
    for (std::size_t byte = 1; byte < 256; ++byte) {
        const std::uint32_t start = std::bit_cast<std::uint32_t>(srgb_byte_starts()[byte]);
        for (std::uint32_t bits = start - 300; bits < start + 300; ++bits)
            values.push_back(std::bit_cast<float>(bits));
    }
    return values;
}

std::vector<float> sweep() {
    std::vector<float> values;
    const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
    for (std::uint32_t bits = 0; bits < one; bits += 2503)
        values.push_back(std::bit_cast<float>(bits));
    return values;
}

}  // namespace

TEST_CASE("bytes are those of the double formula at every threshold and between", "[engine][isa]") {
    const std::vector<float> thresholds = near_thresholds(), all = sweep();
    for (const std::string& isa : instruction_sets()) {
        use_instruction_set(isa);
        for (const bool srgb : {true, false}) {
            SubtileBytes bytes(srgb);
            float odd = 0;
            CAPTURE(isa, srgb, odd);
            CHECK(bytes.wrong(thresholds, odd) == 0);
            CHECK(bytes.wrong(all, odd) == 0);
        }
    }
    use_instruction_set("");
}

TEST_CASE("encode has the double formula's bytes, too", "[engine]") {
    const std::vector<float> values = near_thresholds();
    Framebuffer frame(int(values.size() / 16), 16);
    for (auto plane : {&frame.r, &frame.g, &frame.b})
        std::copy_n(values.begin(), plane->size(), plane->begin());
    const Image image = encode(frame, Transfer::srgb, 0);
    int wrong = 0;
    for (std::size_t i = 0; i < frame.r.size(); ++i)
        wrong += image.rgb[3 * i] != byte_of(frame.r[i], true);
    CHECK(wrong == 0);
}
