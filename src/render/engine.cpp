#include "render/engine.hpp"

#include <algorithm>

#include "render/background.hpp"
#include "render/engine_pass.hpp"
#include "render/visibility.hpp"
#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

int tiles_along(int size, int tile) { return (size + tile - 1) / tile; }

}  // namespace

Engine::State::State(const Scene& normalised_scene, const RenderPlan& plan)
    : scene(normalised_scene, plan.interpolation) {
    const int threads = plan.threads == 0 ? available_threads() : plan.threads;
    workers.resize(static_cast<std::size_t>(threads));
}

Engine::Engine(const Scene& scene, const RenderPlan& plan)
    : state_(std::make_unique<State>(scene, plan)) {}
Engine::~Engine() = default;

void Engine::set_up(Frame& frame) {
    pass_ = std::make_unique<Pass>(*state_, frame);
    pass_->set_up();
}
void Engine::make_records(Frame&) { pass_->make_records(); }
void Engine::raster(Frame&) { pass_->raster(); }
void Engine::light_points(Frame&) { pass_->light_points(); }
void Engine::shade(Frame&) { pass_->shade(); }
void Engine::draw_background(Frame& frame) {
    // Without a triangle no stage before this one runs.
    if (frame.plan.triangles == 0) {
        pass_ = std::make_unique<Pass>(*state_, frame);
        pass_->set_up();
    }
    pass_->draw_background();
}

Engine::Pass::Pass(State& state, Frame& frame)
    : state_(state),
      frame_(frame),
      shading_(frame),
      cull_(frame.view),
      tile_(frame.plan.tile),
      tiles_x_(tiles_along(frame.view.width, tile_)),
      tiles_y_(tiles_along(frame.view.height, tile_)),
      light_(shading_, state.scene, {&state.batches, &state.fragments, &state.quads}, state.records,
             state.light) {
    make_setup_view();
    make_objects();
    make_resolve_view();
    make_lights();
    shading_.resolve.raster.leaves_owned = leaves_owned();
}

// ---- tiles

bool Engine::Pass::left_empty(std::size_t tile) const {
    return leaves_out(PlanRow::empty_tiles) &&
           std::all_of(state_.workers.begin(), state_.workers.end(), [&](const EngineWorker& w) {
               return w.setup.triangles.empty(tile) && w.setup.fragments.empty(tile) &&
                      w.setup.quads.empty(tile) && w.records.lists.empty(tile);
           });
}

/// Calls draw(number, x, y, worker) for each tile that something may touch.
template <class Draw>
void Engine::Pass::each_tile(Draw&& draw) {
    parallel_for(tile_count(), 1, frame_.plan.threads,
                 [&](std::size_t begin, std::size_t end, int w) {
                     for (std::size_t tile = begin; tile < end; ++tile) {
                         if (left_empty(tile)) continue;
                         draw(tile, int(tile % std::size_t(tiles_x_)) * tile_,
                              int(tile / std::size_t(tiles_x_)) * tile_, worker(w));
                     }
                 });
}

void Engine::Pass::raster() {
    light_.reset();
    state_.tiles.resize(tile_count());
    each_tile([&](std::size_t tile, int x, int y, EngineWorker& worker) {
        std::unique_ptr<TileBuffer>& buffer = state_.tiles[tile];
        if (!buffer) buffer = std::make_unique<TileBuffer>();
        raster_tile(tile, x, y, *buffer);
        light_.see(*buffer);
        ++worker.tiles;
    });
    for (const EngineWorker& worker : state_.workers) frame_.items += worker.tiles;
}

void Engine::Pass::light_points() {
    const bool seen_only = leaves_out(PlanRow::unseen_points);
    if (!seen_only) {
        light_.reset();
        light_.see_all();
    }
    const EngineLight::Counts points = light_.light(frame_.events);
    frame_.items += points.lit;
    const std::uint64_t unlit = seen_only ? points.all - points.lit : 0;
    count(frame_.saved, PlanRow::unseen_points, {unlit, points.all});
}

void Engine::Pass::shade() {
    const bool rastered = leaves_out(PlanRow::unseen_points);
    each_tile([&](std::size_t tile, int x, int y, EngineWorker& worker) {
        if (!rastered) raster_tile(tile, x, y, *worker.tile);
        worker.covered += worker.shader->shade(x, y, rastered ? *state_.tiles[tile] : *worker.tile);
        finish_writing();
    });
    for (EngineWorker& worker : state_.workers) {
        frame_.items += worker.covered;
        frame_.events += worker.setup.events;
        frame_.events += worker.events;
        frame_.events += worker.shader->events;
        frame_.count(worker.shader->fallbacks());
        frame_.saved += worker.saved;
        frame_.saved += worker.shader->saved;
        frame_.tolerated_lights += worker.shader->tolerated_lights;
        count(frame_.saved, PlanRow::positions, {worker.covered, worker.covered});
    }
    const RenderPlan& plan = frame_.plan;
    if (frame_.first_sample)
        count(frame_.saved, PlanRow::specular, {plan.matt_materials, plan.used_materials});
}

void Engine::Pass::draw_background() {
    std::size_t tiles = 0;
    for (std::size_t tile = 0; tile < tile_count(); ++tile) tiles += left_empty(tile);
    std::vector<PlanSaving> unchanged(state_.workers.size());
    parallel_for(tile_count(), 16, frame_.plan.threads,
                 [&](std::size_t begin, std::size_t end, int w) {
                     for (std::size_t tile = begin; tile < end; ++tile)
                         if (left_empty(tile) || frame_.plan.triangles == 0)
                             unchanged[std::size_t(w)] +=
                                 write_empty(int(tile % std::size_t(tiles_x_)) * tile_,
                                             int(tile / std::size_t(tiles_x_)) * tile_);
                     finish_writing();
                 });
    frame_.items += tiles;
    for (const PlanSaving& saving : unchanged)
        frame_.saved[PlanRow::unchanged_background] += saving;
    count(frame_.saved, PlanRow::empty_tiles, {tiles, tile_count()});
}

PlanSaving Engine::Pass::write_empty(int x, int y) const {
    const PictureView& picture = frame_.picture;
    const PlanSaving unchanged = scanshade::draw_background(picture, x, y, tile_);
    if (picture.id == nullptr || !frame_.first_sample) return unchanged;
    for (int row = y; row < std::min(y + tile_, picture.height); ++row) {
        const std::size_t from = std::size_t(row) * std::size_t(picture.width) + std::size_t(x);
        const int columns = std::min(tile_, picture.width - x);
        std::fill_n(picture.depth + from, columns, 0.0f);
        std::fill_n(picture.id + from, columns, Framebuffer::no_triangle);
    }
    return unchanged;
}

/// Records first: what they know of whole subtiles hides others.
void Engine::Pass::raster_tile(std::size_t number, int x, int y, TileBuffer& tile) {
    const RasterView& view = shading_.resolve.raster;
    clear_tile(tile);
    for (std::size_t w = 0; w < state_.workers.size(); ++w) {
        const RecordList& list = state_.workers[w].records;
        list.lists.each(number, [&](const std::uint32_t* records, std::uint32_t count) {
            for (std::uint32_t i = 0; i < count; ++i)
                raster_record_in(list, state_.first_record[w] + records[i], x, y, tile);
        });
    }
    using DrawRefs =
        void (*)(const RasterView&, int, int, const std::uint32_t*, std::uint32_t, TileBuffer&);
    const auto draw = [&](TileLists SetupWorker::*list, DrawRefs refs_into) {
        for (const EngineWorker& worker : state_.workers)
            (worker.setup.*list).each(number, [&](const std::uint32_t* refs, std::uint32_t count) {
                refs_into(view, x, y, refs, count, tile);
            });
    };
    draw(&SetupWorker::triangles, raster_triangles);
    draw(&SetupWorker::quads, raster_quads);
    draw(&SetupWorker::fragments, raster_fragments);
    complete_tile(view, x, y, tile);
}

void Engine::Pass::raster_record_in(const RecordList& list, std::uint32_t record, int x, int y,
                                    TileBuffer& tile) {
    const RasterView& view = shading_.resolve.raster;
    const Record& r = state_.records[record];
    if (r.coverage == Record::Coverage::edges) return raster_record(view, x, y, record, tile);
    std::uint64_t rows[tile_side] = {};
    cover_rows(std::span(list.points).subspan(r.first_point, r.point_count), x, y, rows);
    float depth[tile_samples];
    const bool scalar = r.depth == Record::Depth::scalar;
    if (scalar) scalar_depths(r, rows, x, y, depth);
    raster_rows(view, x, y, record, rows, scalar ? depth : nullptr, tile);
}

/// The samples of a tile that a polygon covers, by the scanline walker.
void Engine::Pass::cover_rows(std::span<const SnappedPoint> polygon, int x, int y,
                              std::uint64_t (&rows)[tile_side]) const {
    std::vector<SnappedPoint> moved(polygon.begin(), polygon.end());
    for (SnappedPoint& p : moved) p = {p.x - x * subpixels, p.y - y * subpixels};
    PolygonWalker walker;
    walker.walk(moved, twice_area(moved) > 0, frame_.sample, std::min(tile_, frame_.view.width - x),
                std::min(tile_, frame_.view.height - y), [&](int row, int begin, int end) {
                    const std::uint64_t upto_end = end == 64 ? ~0ull : (1ull << end) - 1;
                    rows[row] |= upto_end & ~((1ull << begin) - 1);
                });
}

/// Depths by the scalar renderers' own function, at the covered samples.
void Engine::Pass::scalar_depths(const Record& record, const std::uint64_t (&rows)[tile_side],
                                 int x, int y, float (&depth)[tile_samples]) const {
    DrawnFace face;
    describe_drawn(frame_, record.id, face);
    std::fill(std::begin(depth), std::end(depth), 0.0f);
    for (int row = 0; row < tile_side; ++row)
        for (std::uint64_t bits = rows[row]; bits != 0; bits &= bits - 1) {
            const int column = __builtin_ctzll(bits);
            depth[tile_index(column, row)] =
                depth_at(face, frame_, sample_point(x + column, y + row, frame_.sample));
        }
}

}  // namespace scanshade
