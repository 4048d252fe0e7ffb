// Light at the vertices (Gouraud) and faces (flat) that are seen, for the vector renderer.
#pragma once

#include <vector>

#include "kernels/engine_data.hpp"
#include "render/engine_scene.hpp"
#include "render/engine_shade.hpp"

namespace scanshade {

/// Lit points of one object: two a vertex slot or face, the front's and the back's.
struct EngineLitPoints {
    std::vector<float> radiance[3], dark[3];
    std::vector<std::uint8_t> needed;
};

/// Collects what is seen, lights it once, and hands the radiance to batches and records.
class EngineLight {
public:
    EngineLight(const TileShading& shading, const EngineScene& scene, BatchStore& batches,
                std::vector<Record>& records);

    /// Nothing is seen yet. Keeps memory from frame to frame.
    void reset();
    /// Notes what a complete tile shows. May run for several tiles at once.
    void see(const TileBuffer& tile);
    /// Everything in batches is taken as seen.
    void see_all();
    /// Lights all that was seen. Points: of them, and of all.
    struct Counts {
        std::uint64_t lit = 0, all = 0;
    };
    Counts light(EventCounts& events);

    bool concerns(std::uint32_t object) const {
        return shading_.objects[object].shading != Shading::phong &&
               !shading_.objects[object].scalar;
    }

private:
    void mark_batch(std::uint32_t number);
    void mark(std::uint32_t object, std::size_t point);
    void light_cluster(std::size_t object, std::size_t cluster, Batch<float>& points,
                       EventCounts& events);
    void light_faces(std::size_t object, std::size_t begin, std::size_t end, Batch<float>& points,
                     EventCounts& events);
    void finish(std::size_t object, std::uint32_t material, Batch<float>& points,
                EventCounts& events);
    void fill(std::uint32_t number);
    void light_record(Record& record, EventCounts& events) const;

    const TileShading& shading_;
    const EngineScene& scene_;
    BatchStore& batches_;
    std::vector<Record>& records_;
    std::vector<EngineLitPoints> points_;      // [object]
    std::vector<std::uint8_t> seen_triangle_;  // [batch · lanes + lane]
    std::vector<std::uint8_t> seen_record_;
};

}  // namespace scanshade
