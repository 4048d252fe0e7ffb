// What a rival must do. Each draws in a process of its own, so none has another's memory, threads
// or environment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/cells.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade::bench {

/// A picture for the comparison, rows from the top.
struct Picture {
    static constexpr std::uint32_t no_triangle = 0xffffffffu;

    std::vector<std::uint32_t> rgba;  // R in the lowest byte
    std::vector<std::uint32_t> id;    // triangle of the mesh, or no_triangle
    double copy_out_ms = 0;           // of the colours, into our memory; not part of a frame
};

/// What all cells of one process have in common.
struct Ground {
    const Scene& scene;  // without lights
    Cull cull;
    int threads;  // ≥ 1
};

class Rival {
public:
    virtual ~Rival() = default;

    /// Library, version and instruction set.
    virtual std::string about() const = 0;

    /// Gets everything ready that does not change from frame to frame: buffers, programs, trees.
    /// Returns the ways in which it can draw the cell: each is measured. None: it cannot.
    virtual std::vector<std::string> prepare(const Cell& cell) = 0;

    /// One whole frame: clear, transform, visibility, shading; RGBA of 8 bits lies in memory when
    /// it returns.
    virtual void draw(std::size_t way) = 0;

    virtual Picture picture(std::size_t way) = 0;
};

std::unique_ptr<Rival> make_ours(const Ground& ground);
std::unique_ptr<Rival> make_llvmpipe(const Ground& ground);
std::unique_ptr<Rival> make_embree(const Ground& ground);

}  // namespace scanshade::bench
