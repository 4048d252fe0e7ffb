// One sample position of one frame on its way through the vector renderer.
#pragma once

#include <memory>
#include <vector>

#include "render/cluster_cull.hpp"
#include "render/engine.hpp"
#include "render/engine_light.hpp"
#include "render/engine_scene.hpp"
#include "render/engine_shade.hpp"
#include "render/records.hpp"

namespace scanshade {

/// Everything that one thread works with.
struct EngineWorker {
    SetupWorker setup;
    RecordList records;
    EventCounts events;
    PlanSavings saved;
    std::unique_ptr<TileBuffer> tile = std::make_unique<TileBuffer>();
    std::unique_ptr<TileShader> shader;
    std::uint64_t covered = 0, triangles = 0, tiles = 0;
};

struct Engine::State {
    State(const Scene& scene, const RenderPlan& plan);

    EngineScene scene;
    std::vector<EngineWorker> workers;
    BatchStore batches, fragments, quads;
    std::vector<Record> records;                     // of all workers
    std::vector<std::uint32_t> first_record;         // [worker]
    std::vector<std::unique_ptr<TileBuffer>> tiles;  // where light comes between depth and samples
    EngineLightMemory light;
};

class Engine::Pass {
public:
    Pass(State& state, Frame& frame);

    void set_up();
    void make_records();
    void raster();
    void light_points();
    void shade();
    void draw_background();

private:
    // engine_views.cpp: what all kernels read
    void make_setup_view();
    Attributes make_attributes(int first, int stride) const;
    void make_objects();
    void make_resolve_view();
    void make_lights();
    void drop_dark_lights();
    bool leaves_owned() const;
    bool position_from_depth() const;

    // engine_setup.cpp
    void reset_workers();
    void reset_batches();
    void set_up_clusters(std::size_t object, std::size_t begin, std::size_t end,
                         EngineWorker& worker);
    bool cull_cluster(std::size_t object, std::size_t cluster, EngineWorker& worker) const;
    void set_up_cluster(std::size_t object, std::size_t cluster, EngineWorker& worker);
    bool save(EngineWorker& worker, PlanRow row, bool saved, std::uint64_t amount) const;
    void leave_out_polygons();
    void make_records(EngineWorker& worker);

    // tiles
    template <class Draw>
    void each_tile(Draw&& draw);
    bool left_empty(std::size_t tile) const;
    PlanSaving write_empty(int x, int y) const;  // of unchanged_background
    void raster_tile(std::size_t number, int x, int y, TileBuffer& tile);
    void raster_record_in(const RecordList& list, std::uint32_t record, int x, int y,
                          TileBuffer& tile);
    void cover_rows(std::span<const SnappedPoint> polygon, int x, int y,
                    std::uint64_t (&rows)[tile_side]) const;
    void scalar_depths(const Record& record, const std::uint64_t (&rows)[tile_side], int x, int y,
                       float (&depth)[tile_samples]) const;

    std::size_t tile_count() const { return std::size_t(tiles_x_) * std::size_t(tiles_y_); }
    EngineWorker& worker(int number) { return state_.workers[std::size_t(number)]; }
    bool leaves_out(PlanRow row) const { return frame_.plan.leaves_out(row); }
    /// Only what the row saves: some work is not needed whatever the plan says.
    void count(PlanSavings& savings, PlanRow row, PlanSaving saving) const {
        if (leaves_out(row)) savings[row] += saving;
    }

    State& state_;
    Frame& frame_;
    TileShading shading_;
    const ClusterCull cull_;
    const int tile_, tiles_x_, tiles_y_;
    SetupView setup_{};
    std::vector<SetupObject> objects_;
    std::vector<std::vector<SetupMaterial>> materials_;  // [object][the mesh's material]
    EngineLight light_;
};

}  // namespace scanshade
