// The engine's set-up: clusters to batches and lists of tiles, and records of what they leave over.
#include <algorithm>
#include <array>

#include "render/engine_pass.hpp"
#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

constexpr std::size_t clusters_in_piece = 16;

}  // namespace

void Engine::Pass::reset_workers() {
    for (EngineWorker& worker : state_.workers) {
        worker.setup.triangles.reset(tile_count());
        worker.setup.special.clear();
        worker.setup.fragments.reset(tile_count());
        worker.setup.quads.reset(tile_count());
        worker.setup.batch_run = worker.setup.fragment_run = worker.setup.quad_run = {};
        worker.setup.events = {};
        worker.records.reset(tile_count());
        worker.events = {};
        worker.saved = {};
        worker.covered = worker.triangles = worker.tiles = 0;
        worker.shader = std::make_unique<TileShader>(shading_);
    }
}

void Engine::Pass::reset_batches() {
    const auto lanes = static_cast<std::uint32_t>(vector_lanes());
    // Runs that workers leave unfinished, and what they fetch early.
    const std::size_t spare = batches_in_run * state_.workers.size() + 1;
    std::size_t batches = spare, fragments = spare, quads = spare;
    for (const EngineObject& object : state_.scene.objects)
        for (const Cluster& cluster : object.mesh->clusters) {
            const std::size_t full = (cluster.face_count + lanes - 1) / lanes;
            (cluster.corners == 4 ? quads : batches) += full;
            if (cluster.corners == 3)
                fragments += (most_fragments * cluster.face_count + lanes - 1) / lanes;
        }
    state_.batches.reset(batches, setup_.attributes.rows, int(lanes));
    state_.quads.reset(quads, setup_.quad_attributes.rows, int(lanes));
    const bool gouraud = std::any_of(objects_.begin(), objects_.end(), [](const SetupObject& o) {
        return o.shading == Shading::gouraud;
    });
    state_.fragments.reset(fragments, gouraud ? fragment_gouraud_rows : fragment_rows, int(lanes));
}

void Engine::Pass::set_up() {
    reset_workers();
    reset_batches();
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        parallel_for(state_.scene.objects[i].bounds.size(), clusters_in_piece, frame_.plan.threads,
                     [&](std::size_t begin, std::size_t end, int w) {
                         set_up_clusters(i, begin, end, worker(w));
                     });
    }
    for (const EngineWorker& worker : state_.workers) {
        state_.batches.leave_empty(worker.setup.batch_run);
        state_.fragments.leave_empty(worker.setup.fragment_run);
        state_.quads.leave_empty(worker.setup.quad_run);
        frame_.items += worker.triangles;
    }
    shading_.resolve.mostly = state_.quads.used() > 0                           ? quad_bit
                              : state_.fragments.used() > state_.batches.used() ? fragment_bit
                                                                                : 0;
}

/// While one cluster is set up, the next one's numbers come from memory.
void Engine::Pass::set_up_clusters(std::size_t object, std::size_t begin, std::size_t end,
                                   EngineWorker& worker) {
    std::array<std::uint32_t, clusters_in_piece> seen;
    std::size_t count = 0;
    for (std::size_t c = begin; c < end; ++c)
        if (!cull_cluster(object, c, worker)) seen[count++] = static_cast<std::uint32_t>(c);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 1 < count) prefetch_cluster(objects_[object], seen[i + 1]);
        set_up_cluster(object, seen[i], worker);
    }
}

/// Counts `amount` as left out or not, and says which.
bool Engine::Pass::save(EngineWorker& worker, PlanRow row, bool saved, std::uint64_t amount) const {
    count(worker.saved, row, {saved ? amount : 0, amount});
    return saved;
}

/// Whether nothing of a cluster is seen.
bool Engine::Pass::cull_cluster(std::size_t object, std::size_t number,
                                EngineWorker& worker) const {
    const ClusterBounds& bounds = state_.scene.objects[object].bounds[number];
    const std::uint64_t triangles = objects_[object].mesh->clusters[number].face_count;
    return save(worker, PlanRow::clusters_outside,
                leaves_out(PlanRow::clusters_outside) && cull_.outside(bounds), triangles) ||
           save(worker, PlanRow::clusters_facing_away,
                leaves_out(PlanRow::clusters_facing_away) && cull_.facing_away(bounds), triangles);
}

void Engine::Pass::set_up_cluster(std::size_t object, std::size_t number, EngineWorker& worker) {
    const ClusterBounds& bounds = state_.scene.objects[object].bounds[number];
    const Cluster& cluster = objects_[object].mesh->clusters[number];
    const std::uint64_t triangles = cluster.face_count;
    const bool clip = !(leaves_out(PlanRow::clipping) && cull_.unclipped(bounds));
    save(worker, PlanRow::clipping, !clip, cluster.vertex_count);
    const SetupMaterial& material = objects_[object].material[cluster.material];
    // Gouraud's triangles carry light, never normals.
    if (objects_[object].shading != Shading::gouraud)
        save(worker, PlanRow::normals, !material.store_normals, triangles);
    save(worker, PlanRow::texcoords, !material.store_texcoords, triangles);
    worker.triangles += cluster.face_count;
    setup_cluster(setup_, objects_[object], static_cast<std::uint32_t>(number), clip,
                  {state_.batches, state_.fragments, state_.quads}, worker.setup);
}

/// Records of what set-up left over, all in one array.
void Engine::Pass::make_records() {
    leave_out_polygons();
    parallel_for(state_.workers.size(), 1, frame_.plan.threads,
                 [&](std::size_t begin, std::size_t end, int) {
                     for (std::size_t w = begin; w < end; ++w) make_records(state_.workers[w]);
                 });
    state_.records.clear();
    state_.first_record.clear();
    for (const EngineWorker& worker : state_.workers) {
        state_.first_record.push_back(static_cast<std::uint32_t>(state_.records.size()));
        state_.records.insert(state_.records.end(), worker.records.records.begin(),
                              worker.records.records.end());
    }
    shading_.resolve.raster.records = state_.records.data();
    frame_.items += state_.records.size();
}

/// Faces that no cluster has, shared out among the workers.
void Engine::Pass::leave_out_polygons() {
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < state_.scene.objects.size(); ++i) {
        const Mesh& mesh = *frame_.scene.objects[i].mesh;
        for (const std::uint32_t face : state_.scene.objects[i].mesh->left_out)
            state_.workers[next++ % state_.workers.size()].setup.special.push_back(
                {i, mesh.face_first_triangle[face]});
    }
}

void Engine::Pass::make_records(EngineWorker& worker) {
    RecordMaker maker(frame_, shading_.surfaces, setup_, worker.records, worker.events);
    for (const SpecialFace& special : worker.setup.special)
        maker.add(special.object, special.triangle);
    list_records(tile_, tiles_x_, worker.records);
}

}  // namespace scanshade
