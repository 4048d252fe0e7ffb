#include "render/engine.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <mutex>

#include "render/engine_light.hpp"
#include "render/engine_scene.hpp"
#include "render/engine_shade.hpp"
#include "render/records.hpp"
#include "render/visibility.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/base/timer.hpp"

namespace scanshade {
namespace {

/// Everything that one thread works with.
struct Worker {
    SetupWorker setup;
    RecordList records;
    EventCounts events;
    std::unique_ptr<TileBuffer> tile = std::make_unique<TileBuffer>();
    double raster_ms = 0, shade_ms = 0;
    std::uint64_t covered = 0;
};

int tiles_along(int size) { return (size + tile_side - 1) / tile_side; }

}  // namespace

struct Engine::State {
    State(const Scene& s, const RenderPlan& p) : scene(s), plan(p), engine(s) {
        const int threads = p.threads == 0 ? available_threads() : p.threads;
        workers.resize(static_cast<std::size_t>(threads));
    }
    const Scene& scene;
    const RenderPlan& plan;
    EngineScene engine;
    std::vector<Worker> workers;
    BatchStore batches;
    std::vector<Record> records;                     // of all workers
    std::vector<std::uint32_t> first_record;         // [worker]
    std::vector<std::unique_ptr<TileBuffer>> tiles;  // where light comes between depth and samples
    std::vector<std::vector<std::uint32_t>> materials;  // [object][the mesh's material]
};

Engine::Engine(const Scene& scene, const RenderPlan& plan)
    : state_(std::make_unique<State>(scene, plan)) {}
Engine::~Engine() = default;

/// One sample position of one frame.
class Engine::Pass {
public:
    Pass(State& state, Frame& frame, const PictureView& picture)
        : state_(state),
          frame_(frame),
          shading_(frame, picture),
          tiles_x_(tiles_along(frame.view.width)),
          tiles_y_(tiles_along(frame.view.height)) {
        make_setup_view();
        make_objects();
        make_resolve_view();
    }

    void set_up() {
        const std::size_t tiles = std::size_t(tiles_x_) * std::size_t(tiles_y_);
        for (Worker& worker : state_.workers) {
            worker.setup.small.reset(tiles);
            worker.setup.medium.reset(tiles);
            worker.setup.special.clear();
            worker.setup.next_batch = worker.setup.last_batch = 0;
            worker.setup.events = {};
            worker.setup.kept = 0;
            worker.records.reset(tiles);
            worker.events = {};
            worker.raster_ms = worker.shade_ms = 0;
            worker.covered = 0;
        }
        reset_batches();
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            if (by_faces(i)) {
                add_faces(i);
                continue;
            }
            parallel_for(state_.engine.objects[i].bounds.size(), 16, frame_.plan.threads,
                         [&](std::size_t begin, std::size_t end, int worker) {
                             for (std::size_t c = begin; c < end; ++c)
                                 set_up_cluster(i, c, state_.workers[std::size_t(worker)]);
                         });
        }
    }

    /// Records of what set-up left over, all in one array.
    void make_records() {
        parallel_for(state_.workers.size(), 1, frame_.plan.threads,
                     [&](std::size_t begin, std::size_t end, int) {
                         for (std::size_t w = begin; w < end; ++w) make_records(state_.workers[w]);
                     });
        state_.records.clear();
        state_.first_record.clear();
        for (const Worker& worker : state_.workers) {
            state_.first_record.push_back(static_cast<std::uint32_t>(state_.records.size()));
            state_.records.insert(state_.records.end(), worker.records.records.begin(),
                                  worker.records.records.end());
        }
        shading_.resolve.raster.records = state_.records.data();
        // What is left of the runs that workers took.
        for (const Worker& worker : state_.workers)
            for (std::uint32_t b = worker.setup.next_batch; b < worker.setup.last_batch; ++b)
                state_.batches.info(b).count = 0;
    }

    void draw_tiles() {
        if (frame_.plan.face_light || frame_.plan.vertex_light) return draw_tiles_in_turns();
        each_tile([&](std::size_t tile, int x, int y, Worker& worker) {
            raster(tile, x, y, *worker.tile);
            shade(x, y, *worker.tile, worker);
        });
    }

    /// Background where no tile was drawn.
    void draw_background() {
        parallel_for(std::size_t(tiles_x_) * std::size_t(tiles_y_), 16, frame_.plan.threads,
                     [&](std::size_t begin, std::size_t end, int) {
                         for (std::size_t tile = begin; tile < end; ++tile)
                             if (empty(tile))
                                 write_empty(int(tile % std::size_t(tiles_x_)) * tile_side,
                                             int(tile / std::size_t(tiles_x_)) * tile_side);
                     });
    }

    std::uint64_t finish(FrameStats& stats) {
        std::uint64_t covered = 0;
        for (Worker& worker : state_.workers) {
            frame_.events += worker.setup.events;
            frame_.events += worker.events;
            covered += worker.covered;
        }
        (void)stats;
        return covered;
    }

private:
    /// Visibility everywhere, then light at what is seen, then the samples.
    void draw_tiles_in_turns() {
        EngineLight light(shading_, state_.engine, state_.batches, state_.records);
        light.reset();
        state_.tiles.resize(std::size_t(tiles_x_) * std::size_t(tiles_y_));
        each_tile([&](std::size_t tile, int x, int y, Worker&) {
            auto& buffer = state_.tiles[tile];
            if (!buffer) buffer = std::make_unique<TileBuffer>();
            raster(tile, x, y, *buffer);
            light.see(*buffer);
        });
        light.light(frame_.events);
        each_tile([&](std::size_t tile, int x, int y, Worker& worker) {
            shade(x, y, *state_.tiles[tile], worker);
        });
    }

    /// Calls draw(number, x, y, worker) for each tile that something may touch. The others have
    /// their background afterwards.
    template <class Draw>
    void each_tile(Draw&& draw) {
        parallel_for(std::size_t(tiles_x_) * std::size_t(tiles_y_), 1, frame_.plan.threads,
                     [&](std::size_t begin, std::size_t end, int w) {
                         for (std::size_t tile = begin; tile < end; ++tile)
                             if (!empty(tile))
                                 draw(tile, int(tile % std::size_t(tiles_x_)) * tile_side,
                                      int(tile / std::size_t(tiles_x_)) * tile_side,
                                      state_.workers[std::size_t(w)]);
                     });
    }

    void shade(int x, int y, const TileBuffer& tile, Worker& worker) {
        TileShader shader(shading_);
        worker.covered += shader.shade(x, y, tile);
        worker.events += shader.events;
    }

    // ---- what all kernels read
    void make_setup_view() {
        const View& view = frame_.view;
        setup_ = {};
        setup_.near = view.near, setup_.far = view.far, setup_.guard_band = guard_band;
        setup_.width = view.width, setup_.height = view.height, setup_.tiles_x = tiles_x_;
        setup_.sample_x = frame_.sample.x, setup_.sample_y = frame_.sample.y;
        setup_.orthographic = view.orthographic;
        setup_.affine = view.orthographic || frame_.plan.interpolation == Interpolation::edges;
        setup_.clip = true;
        setup_.cull_back = frame_.plan.cull == Cull::back;
        Attributes& at = setup_.attributes;
        const auto take = [&](int& offset, int planes) {
            offset = at.rows;
            at.rows += 3 * planes;
        };
        take(at.main, 3);
        if (frame_.plan.texture) take(at.texcoord, 2);
        if (frame_.plan.texture && (frame_.plan.face_light || frame_.plan.vertex_light))
            take(at.dark, 3);
        if (!position_from_depth()) take(at.position, 3);
    }

    /// A point found from depth is off by about 2^-21 of its distance, and by a share of a pixel
    /// that snapping moves corners. That does not matter to a light 128 times farther away.
    bool position_from_depth() const {
        const View& view = frame_.view;
        const double reach = view.orthographic ? 4 * (double(view.far) - double(view.near))
                                               : glm::length(view.eye) + 2;
        return state_.engine.light_distance * 128 >= reach;
    }

    void make_objects() {
        state_.materials.clear();
        for (const ObjectPlan& object : frame_.plan.objects)
            state_.materials.push_back(object.materials);
        for (std::size_t i = 0; i < frame_.scene.objects.size(); ++i) {
            const EngineObject& engine = state_.engine.objects[i];
            const ObjectView& view = frame_.object_views[i];
            SetupObject object{};
            object.mesh = engine.mesh;
            for (int c = 0; c < 3; ++c) object.normal[c] = engine.normal[c].data();
            object.index = static_cast<std::uint32_t>(i);
            object.first_triangle = frame_.plan.objects[i].first_triangle;
            for (std::size_t r = 0; r < 4; ++r)
                std::copy(view.to_clip[r].begin(), view.to_clip[r].end(), object.to_clip[r]);
            for (int r = 0; r < 3; ++r)
                std::copy(engine.to_world[r], engine.to_world[r] + 4, object.to_world[r]);
            object.mirrored = view.mirrored;
            object.shading = frame_.plan.objects[i].shading;
            object.material = state_.materials[i].data();
            objects_.push_back(object);
        }
    }

    void make_resolve_view() {
        ResolveView& resolve = shading_.resolve;
        const View& view = frame_.view;
        resolve.raster = {&state_.batches, nullptr,   frame_.sample.x, frame_.sample.y,  view.width,
                          view.height,     view.near, view.far,        view.orthographic};
        resolve.attributes = setup_.attributes;
        resolve.affine = setup_.affine;
        resolve.position_from_depth = position_from_depth();
        // Columns right, up, backward of the eye; a pixel is 1/pixels_per_unit wide at distance 1.
        const glm::dmat3 to_world = glm::transpose(view.rotation);
        const double pixel = 1 / view.pixels_per_unit;
        const double left = (frame_.sample.x / 256.0 - view.width / 2.0) * pixel;
        const double top = -(frame_.sample.y / 256.0 - view.height / 2.0) * pixel;
        const glm::dvec3 corner = to_world[0] * left + to_world[1] * top;
        const glm::dvec3 forward = -to_world[2];
        const glm::dvec3 eye = view.orthographic ? forward : view.eye;
        const glm::dvec3 ray = view.orthographic ? view.eye + corner : corner + forward;
        for (int c = 0; c < 3; ++c) {
            resolve.eye[c] = static_cast<float>(eye[c]);
            resolve.ray[c] = static_cast<float>(ray[c]);
            resolve.ray_x[c] = static_cast<float>(to_world[0][c] * pixel);
            resolve.ray_y[c] = static_cast<float>(-to_world[1][c] * pixel);
        }
        const double nearest_light = state_.engine.light_distance;
        for (LightTerm<float>& light : shading_.lighting.lit.lights)
            light.touches =
                double(light.point_scale) * nearest_light <= double(light.radius) * 1.01;
    }

    // ---- set-up
    void reset_batches() {
        const int lanes = vector_lanes();
        std::size_t most = 0;
        for (const EngineObject& object : state_.engine.objects)
            for (const Cluster& cluster : object.mesh->clusters)
                most += (cluster.triangle_count + std::uint32_t(lanes) - 1) / std::uint32_t(lanes);
        // Runs that workers leave unfinished.
        most += 16 * state_.workers.size();
        state_.batches.reset(most, setup_.attributes.rows, lanes);
    }

    /// In `edges`, faces of more than three corners are drawn whole.
    bool by_faces(std::size_t object) const {
        return frame_.plan.interpolation == Interpolation::edges &&
               frame_.scene.objects[object].mesh->has_polygons;
    }

    void add_faces(std::size_t object) {
        parallel_for(frame_.scene.objects[object].mesh->face_count(), 64, frame_.plan.threads,
                     [&](std::size_t begin, std::size_t end, int w) {
                         Worker& worker = state_.workers[std::size_t(w)];
                         RecordMaker maker(frame_, shading_.surfaces, tiles_x_, worker.records,
                                           worker.events);
                         for (std::size_t face = begin; face < end; ++face)
                             maker.add_face(object, face);
                     });
    }

    void set_up_cluster(std::size_t object, std::size_t cluster, Worker& worker) {
        setup_cluster(setup_, objects_[object], static_cast<std::uint32_t>(cluster), state_.batches,
                      worker.setup);
    }

    void make_records(Worker& worker) {
        RecordMaker maker(frame_, shading_.surfaces, tiles_x_, worker.records, worker.events);
        for (const SpecialTriangle& special : worker.setup.special)
            maker.add_triangle(special.object, special.triangle);
    }

    // ---- tiles
    bool empty(std::size_t tile) const {
        return std::all_of(state_.workers.begin(), state_.workers.end(), [&](const Worker& w) {
            return w.setup.small.empty(tile) && w.setup.medium.empty(tile) &&
                   w.records.lists.empty(tile);
        });
    }

    void write_empty(int x, int y) const {
        const PictureView& picture = shading_.picture;
        write_background(picture, x, y, tile_side, tile_side);
        if (picture.id == nullptr) return;
        for (int row = y; row < std::min(y + tile_side, picture.height); ++row) {
            const std::size_t from = std::size_t(row) * std::size_t(picture.width) + std::size_t(x);
            const int columns = std::min(tile_side, picture.width - x);
            std::fill_n(picture.depth + from, columns, 0.0f);
            std::fill_n(picture.id + from, columns, Framebuffer::no_triangle);
        }
    }

    /// Records first: what they know of whole subtiles hides others.
    void raster(std::size_t number, int x, int y, TileBuffer& tile) {
        const RasterView& view = shading_.resolve.raster;
        clear_tile(tile);
        for (std::size_t w = 0; w < state_.workers.size(); ++w)
            state_.workers[w].records.lists.each(
                number, [&](const std::uint32_t* list, std::uint32_t count) {
                    for (std::uint32_t i = 0; i < count; ++i)
                        raster_one(state_.workers[w].records, state_.first_record[w] + list[i], x,
                                   y, tile);
                });
        for (const Worker& worker : state_.workers)
            worker.setup.medium.each(number, [&](const std::uint32_t* refs, std::uint32_t count) {
                raster_medium(view, x, y, refs, count, tile);
            });
        for (const Worker& worker : state_.workers)
            worker.setup.small.each(number, [&](const std::uint32_t* refs, std::uint32_t count) {
                raster_small(view, x, y, refs, count, tile);
            });
        complete_tile(view, x, y, tile);
    }

    void raster_one(const RecordList& list, std::uint32_t record, int x, int y, TileBuffer& tile) {
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
    void cover_rows(std::span<const SnappedPoint> polygon, int x, int y,
                    std::uint64_t (&rows)[tile_side]) const {
        std::vector<SnappedPoint> moved(polygon.begin(), polygon.end());
        for (SnappedPoint& p : moved) p = {p.x - x * subpixels, p.y - y * subpixels};
        PolygonWalker walker;
        walker.walk(moved, twice_area(moved) > 0, frame_.sample,
                    std::min(tile_side, frame_.view.width - x),
                    std::min(tile_side, frame_.view.height - y), [&](int row, int begin, int end) {
                        const std::uint64_t upto_end = end == 64 ? ~0ull : (1ull << end) - 1;
                        rows[row] |= upto_end & ~((1ull << begin) - 1);
                    });
    }

    /// Depths by the scalar renderers' own function, at the covered samples.
    void scalar_depths(const Record& r, const std::uint64_t (&rows)[tile_side], int x, int y,
                       float (&depth)[tile_samples]) const {
        DrawnFace face;
        describe_drawn(frame_, r.id, face);
        std::fill(std::begin(depth), std::end(depth), 0.0f);
        for (int row = 0; row < tile_side; ++row)
            for (std::uint64_t bits = rows[row]; bits != 0; bits &= bits - 1) {
                const int column = __builtin_ctzll(bits);
                depth[tile_index(column, row)] =
                    depth_at(face, frame_, sample_point(x + column, y + row, frame_.sample));
            }
    }

    State& state_;
    Frame& frame_;
    TileShading shading_;
    const int tiles_x_, tiles_y_;
    SetupView setup_;
    std::vector<SetupObject> objects_;
};

std::uint64_t Engine::draw(Frame& frame, const PictureView& picture, FrameStats& stats) {
    Pass pass(*state_, frame, picture);
    pass.set_up();
    pass.make_records();
    pass.draw_tiles();
    pass.draw_background();
    return pass.finish(stats);
}

}  // namespace scanshade
