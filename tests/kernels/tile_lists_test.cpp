#include "kernels/engine_data.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace scanshade;

TEST_CASE("lists a tile give back what was pushed, in order", "[engine]") {
    Rng rng(11);
    TileLists lists;
    for (int round = 0; round < 20; ++round) {
        const auto tiles = std::size_t(rng.integer(1, 40));
        lists.reset(tiles);
        std::vector<std::vector<std::uint32_t>> expected(tiles);
        for (auto pushes = rng.integer(0, 5000); pushes > 0; --pushes) {
            // Most into few tiles, so that lists have one chunk, several and none.
            const auto tile = std::size_t(rng.integer(0, rng.integer(0, std::int64_t(tiles) - 1)));
            const auto ref = std::uint32_t(rng.bits());
            lists.push(tile, ref);
            expected[tile].push_back(ref);
        }
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            std::vector<std::uint32_t> found;
            lists.each(tile, [&](const std::uint32_t* refs, std::uint32_t count) {
                found.insert(found.end(), refs, refs + count);
            });
            CAPTURE(round, tile);
            CHECK(found == expected[tile]);
            CHECK(lists.empty(tile) == expected[tile].empty());
        }
    }
}

TEST_CASE("workers' runs of batches do not overlap, and rows begin on cache lines", "[engine]") {
    BatchStore store;
    store.reset(100, row_attributes + 3, 16);
    std::vector<bool> taken(100);
    for (const std::uint32_t count : {1u, 16u, 3u, 80u}) {
        const std::uint32_t first = store.take(count);
        for (std::uint32_t b = first; b < first + count; ++b) {
            REQUIRE(b < 100);
            CHECK(!taken[b]);
            taken[b] = true;
            CHECK(reinterpret_cast<std::uintptr_t>(store.batch(b)) % 64 == 0);
        }
    }
    CHECK(store.used() == 100);
    for (int x = 0; x < tile_side; ++x)
        for (int y = 0; y < tile_side; ++y) {
            // Blocks of 4 × 4 samples are whole cache lines of depths.
            const int at = tile_index(x, y);
            REQUIRE(at / block_samples == (y / 4) * (tile_side / 4) + x / 4);
            REQUIRE(at % block_samples == (y % 4) * 4 + x % 4);
        }
}
