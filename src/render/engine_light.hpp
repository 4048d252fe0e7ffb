// Light at the vertices (Gouraud) and faces (flat) that are drawn, for the vector renderer.
#pragma once

#include <vector>

#include "kernels/engine_data.hpp"
#include "render/engine_scene.hpp"
#include "render/engine_shade.hpp"

namespace scanshade {

/// What lighting an object's points takes; kept from frame to frame.
struct EngineLitObject {
    // Gouraud: [slot] seen from the front, then [slot] from behind
    std::vector<float> radiance[3], dark[3];
    std::vector<std::uint8_t> needed;
    // flat: [face slot]
    std::vector<float> centre[3], normal[3];
};

struct EngineLightMemory {
    std::vector<EngineLitObject> objects;
    std::vector<std::uint8_t> seen_triangle, seen_fragment, seen_quad;  // [batch · lanes + lane]
    std::vector<std::uint8_t> seen_record;
};

/// Collects what is seen, lights it once, and hands the radiance to batches and records.
class EngineLight {
public:
    struct Stores {
        BatchStore *batches, *fragments, *quads;
    };
    EngineLight(const TileShading& shading, const EngineScene& scene, const Stores& stores,
                std::vector<Record>& records, EngineLightMemory& memory);

    /// Nothing is seen yet.
    void reset();
    /// Notes what a complete tile shows. May run for several tiles at once.
    void see(const TileBuffer& tile);
    /// Everything that set-up has kept is taken as seen.
    void see_all();
    /// Lights all that was seen. Triangles of flat objects, vertices from both sides of the others:
    /// those lit, and all.
    struct Counts {
        std::uint64_t lit = 0, all = 0;
        void operator+=(const Counts& other) { lit += other.lit, all += other.all; }
    };
    Counts light(EventCounts& events);

    bool concerns(std::uint32_t object) const {
        return shading_.objects[object].shading != Shading::phong &&
               !shading_.objects[object].scalar;
    }

private:
    class Points;
    /// Batches of triangles, of fragments or of quadrilaterals.
    enum class Kind { triangles, fragments, quads };
    struct Lit {
        Kind kind;
        BatchStore& store;
        const Attributes& at;
        std::vector<std::uint8_t>& seen;

        const std::uint8_t* seen_in(std::uint32_t batch) const {
            return seen.data() + std::size_t(batch) * store.lanes();
        }
    };
    template <class Work>
    Counts each_batch(Shading shading, EventCounts& events, Work&& work);
    void reset_object(std::size_t object);
    void mark_vertices(const Lit& lit, std::uint32_t batch);
    Counts light_cluster(std::size_t object, std::size_t cluster, Points& points,
                         EventCounts& events);
    Counts light_vertices(std::size_t object, EventCounts& events);
    void light_faces(const Lit& lit, std::uint32_t batch, Points& points, EventCounts& events);
    void fill(const Lit& lit, std::uint32_t batch);
    void light_record(Record& record, EventCounts& events) const;
    void fill_rows(Record& record) const;

    const TileShading& shading_;
    const EngineScene& scene_;
    std::vector<Record>& records_;
    EngineLightMemory& memory_;
    bool sees_all_ = false;
    const Lit kinds_[3];
};

}  // namespace scanshade
