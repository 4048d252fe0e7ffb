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

/// The plane of Σ a_i · weight_i of a planar record into its rows from `row` on.
void set_plane(Record& record, int row, float a0, float a1, float a2);

/// Puts the records into the lists of the tiles that they may touch, of `tile` × `tile` samples, tiles_x
/// in a row. The nearest first: they hide others, which then cost little. Their order changes no bit.
void list_records(int tile, int tiles_x, RecordList& into);

/// Turns faces into records.
class RecordMaker {
public:
    RecordMaker(const Frame& frame, const std::vector<ObjectSurface>& surfaces,
                const SetupView& setup, RecordList& into, EventCounts& events)
        : frame_(frame),
          surfaces_(surfaces),
          attributes_(setup.attributes),
          quad_attributes_(setup.quad_attributes),
          into_(into),
          events_(events) {}

    /// A triangle, or the face that it is the first of where `edges` draws faces whole.
    void add(std::size_t object, std::uint32_t triangle);

private:
    void add_triangle(std::size_t object, std::uint32_t triangle);
    void add_drawn();
    void describe_edges(Record& r) const;
    void describe_depth(Record& r) const;
    void describe_planes(Record& r) const;
    void describe_quad(Record& r) const;
    void describe_values(Record& r) const;
    void describe_corners(Record& r) const;

    const Frame& frame_;
    const std::vector<ObjectSurface>& surfaces_;
    const Attributes &attributes_, &quad_attributes_;
    RecordList& into_;
    EventCounts& events_;
    DrawnFace face_;
    std::vector<SnappedPoint> point_;
    bool falls_back_ = false;  // the face is not drawn whole, though `edges` would
};

}  // namespace scanshade
