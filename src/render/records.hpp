// Faces that the vector set-up leaves to the driver.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/engine_data.hpp"
#include "render/faces.hpp"
#include "render/frame.hpp"
#include "render/surface.hpp"

namespace scanshade {

/// Records of one worker and the tiles that they may touch.
class RecordList {
public:
    void reset(std::size_t tiles) {
        records.clear();
        points.clear();
        lists.reset(tiles);
    }
    std::vector<Record> records;
    std::vector<SnappedPoint> points;  // corners of what is covered by rows
    TileLists lists;                   // numbers of records
};

/// Turns faces into records.
class RecordMaker {
public:
    /// Tiles of `tile` × `tile` samples, tiles_x of them in a row.
    RecordMaker(const Frame& frame, const std::vector<ObjectSurface>& surfaces, int tile,
                int tiles_x, RecordList& into, EventCounts& events)
        : frame_(frame),
          surfaces_(surfaces),
          tile_(tile),
          tiles_x_(tiles_x),
          into_(into),
          events_(events) {}

    void add_triangle(std::size_t object, std::uint32_t triangle);
    /// A face of an object that `edges` draws whole where it can: polygon or triangles.
    void add_face(std::size_t object, std::size_t face);

private:
    void add();
    void describe_edges(Record& r) const;
    void describe_depth(Record& r) const;
    void describe_values(Record& r) const;
    void put_into_tiles(const Record& r);

    const Frame& frame_;
    const std::vector<ObjectSurface>& surfaces_;
    const int tile_, tiles_x_;
    RecordList& into_;
    EventCounts& events_;
    DrawnFace face_;
    std::vector<SnappedPoint> point_;
};

}  // namespace scanshade
