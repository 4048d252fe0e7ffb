#include "render/engine_light.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "render/records.hpp"
#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

/// Several threads may note the same; nobody reads before all are done.
void note(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

PlacedMesh placed(const EngineObject& object) {
    PlacedMesh out{};
    for (int c = 0; c < 3; ++c) {
        std::copy_n(object.to_world[c], 4, out.to_world[c]);
        out.normal[c] = object.normal[c].data();
    }
    return out;
}

void resize(std::vector<float> (&channels)[3], std::size_t count) {
    for (auto& channel : channels) channel.resize(count);
}

}  // namespace

namespace {

/// Fragments of textured faces there are none.
constexpr Attributes fragment_attributes = {1, fragment_rows, fragment_values};

}  // namespace

/// Points of one material on their way through its kernel: those of a cluster or of a batch.
class EngineLight::Points {
public:
    static constexpr std::size_t capacity = max_cluster_vertices;

    /// Room for a vector of points from `first` on.
    PointArrays at(std::size_t first) {
        PointArrays out{};
        for (int c = 0; c < 3; ++c) {
            out.position[c] = position_[c] + first;
            out.normal[c] = normal_[c] + first;
        }
        return out;
    }

    /// The first `count` of them, each with that albedo in every channel.
    void light(const TileShading& shading, std::uint32_t number, std::size_t count, float albedo,
               float* const (&radiance)[3], EventCounts& events) {
        const ResolvedMaterial& material = shading.frame.plan.materials[number];
        std::fill(std::begin(albedo_), std::end(albedo_), albedo);
        SurfaceSpan<float> span{};
        for (int c = 0; c < 3; ++c) {
            span.position[c] = position_[c];
            span.normal[c] = normal_[c];
            span.albedo[c] = albedo_;
            span.radiance[c] = radiance[c];
        }
        span.count = count;
        const SpanEvents seen = material.brdf->illuminate_simd(span, shading.lighting.of(material),
                                                               shading.params[number]);
        if (seen.light_at_surface > 0) events.add(Event::light_at_surface, seen.light_at_surface);
    }

private:
    alignas(64) float position_[3][capacity] = {}, normal_[3][capacity] = {}, albedo_[capacity];
};

EngineLight::EngineLight(const TileShading& shading, const EngineScene& scene, const Stores& stores,
                         std::vector<Record>& records, EngineLightMemory& memory)
    : shading_(shading),
      scene_(scene),
      records_(records),
      memory_(memory),
      kinds_{{Kind::triangles, *stores.batches, shading.resolve.attributes, memory.seen_triangle},
             {Kind::fragments, *stores.fragments, fragment_attributes, memory.seen_fragment},
             {Kind::quads, *stores.quads, shading.resolve.quad_attributes, memory.seen_quad}} {}

void EngineLight::reset() {
    memory_.objects.resize(scene_.objects.size());
    for (std::size_t i = 0; i < scene_.objects.size(); ++i)
        if (concerns(static_cast<std::uint32_t>(i))) reset_object(i);
    for (const Lit& lit : kinds_) lit.seen.assign(lit.store.used() * lit.store.lanes(), 0);
    memory_.seen_record.assign(records_.size(), 0);
    sees_all_ = false;
}

void EngineLight::reset_object(std::size_t object) {
    EngineLitObject& lit = memory_.objects[object];
    if (shading_.objects[object].shading == Shading::gouraud) {
        const std::size_t count = 2 * scene_.objects[object].mesh->x.size();
        lit.needed.assign(count, 0);
        resize(lit.radiance, count);
        if (shading_.frame.plan.texture) resize(lit.dark, count);
        return;
    }
    const LargeVector<std::uint32_t>& triangle = scene_.objects[object].mesh->triangle;
    // Unused lanes name any number that a cluster can have.
    const std::size_t slots = triangle.size() + face_numbers;
    if (lit.centre[0].size() == slots) return;
    resize(lit.centre, slots);
    resize(lit.normal, slots);
    const Mesh& mesh = *shading_.frame.scene.objects[object].mesh;
    for (std::size_t slot = 0; slot < triangle.size(); ++slot) {
        if (triangle[slot] == no_index) continue;
        const std::uint32_t face = mesh.triangle_face[triangle[slot]];
        const glm::dvec3 p = shading_.surfaces[object].face_centre(face);
        const glm::dvec3 n = shading_.surfaces[object].face_normal(face);
        for (int c = 0; c < 3; ++c) {
            lit.centre[c][slot] = static_cast<float>(p[c]);
            lit.normal[c][slot] = static_cast<float>(n[c]);
        }
    }
}

// ---- what is seen

void EngineLight::see(const TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (!tile.written[s]) continue;
        for (int i = 0; i < subtile_samples; ++i) {
            const int row = (s / 4) * 4 + i / 64, column = (s % 4) * 4 + i % 64 / block_samples;
            const std::uint32_t ref =
                tile.ref[(row * (tile_side / block_side) + column) * block_samples +
                         i % block_samples];
            if (ref == no_ref) continue;
            if ((ref & record_bit) != 0)
                note(memory_.seen_record[ref & ~record_bit]);
            else if ((ref & fragment_bit) != 0)
                note(memory_.seen_fragment[ref & ~fragment_bit]);
            else if ((ref & quad_bit) != 0)
                note(memory_.seen_quad[ref & ~quad_bit]);
            else
                note(memory_.seen_triangle[ref]);
        }
    }
}

void EngineLight::see_all() {
    for (const Lit& lit : kinds_) std::fill(lit.seen.begin(), lit.seen.end(), std::uint8_t{1});
    std::fill(memory_.seen_record.begin(), memory_.seen_record.end(), std::uint8_t{1});
    sees_all_ = true;
}

void EngineLight::mark_vertices(const Lit& lit, std::uint32_t number) {
    const BatchInfo& info = lit.store.info(number);
    const std::uint32_t lanes = lit.store.lanes();
    const auto* packed = reinterpret_cast<const std::uint32_t*>(lit.store.batch(number)) +
                         std::size_t(row_corners) * lanes;
    const ClusteredMesh& mesh = *scene_.objects[info.object].mesh;
    const Cluster& cluster = mesh.clusters[info.cluster];
    std::uint8_t* needed = memory_.objects[info.object].needed.data() + cluster.first_vertex;
    if (sees_all_) {
        // Nearly all of the cluster's are needed, from the sides that it shows.
        std::uint32_t any = 0, all = ~0u;
        for (std::uint32_t lane = 0; lane < info.count; ++lane)
            any |= packed[lane], all &= packed[lane];
        for (std::uint32_t i = 0; i < cluster.vertex_count; ++i) {
            if ((all & back_bit) == 0) note(needed[i]);
            if ((any & back_bit) != 0) note(needed[mesh.x.size() + i]);
        }
        return;
    }
    for (std::uint32_t lane = 0; lane < info.count; ++lane) {
        if (lit.seen_in(number)[lane] == 0) continue;
        std::uint8_t* side = needed + ((packed[lane] & back_bit) != 0 ? mesh.x.size() : 0);
        for (int k = 0; k < (lit.kind == Kind::quads ? 4 : 3); ++k)
            note(side[packed[lane] >> (k * corner_bits) & (max_cluster_vertices - 1)]);
    }
}

// ---- light

/// Whole vectors from the first vertex that somebody needs to the last.
EngineLight::Counts EngineLight::light_cluster(std::size_t object, std::size_t number,
                                               Points& points, EventCounts& events) {
    const EngineObject& engine = scene_.objects[object];
    const Cluster& cluster = engine.mesh->clusters[number];
    EngineLitObject& lit = memory_.objects[object];
    Counts counts;
    for (const bool back : {false, true}) {
        const std::size_t side = back ? engine.mesh->x.size() : 0;
        const auto begin = lit.needed.begin() + std::ptrdiff_t(side + cluster.first_vertex);
        const auto end = begin + std::ptrdiff_t(cluster.vertex_count);
        const auto first = std::find(begin, end, 1);
        if (first == end) continue;
        counts.lit += std::uint64_t(std::count(first, end, 1));
        const auto from = std::size_t(first - begin) / cluster_padding * cluster_padding;
        std::size_t to = cluster.vertex_count;
        while (to > from + cluster_padding && begin[std::ptrdiff_t(to) - 1] == 0) --to;
        for (std::size_t i = from; i < to; i += cluster_padding)
            place_vertices(*engine.mesh, placed(engine),
                           cluster.first_vertex + static_cast<std::uint32_t>(i), back,
                           points.at(i - from));
        const std::size_t at = side + cluster.first_vertex + from;
        const auto light = [&](std::vector<float>(&radiance)[3], float albedo) {
            points.light(
                shading_, shading_.frame.plan.objects[object].materials[cluster.material],
                to - from, albedo,
                {radiance[0].data() + at, radiance[1].data() + at, radiance[2].data() + at},
                events);
        };
        light(lit.radiance, 1);
        if (shading_.frame.plan.texture) light(lit.dark, 0);
    }
    return counts;
}

void EngineLight::fill(const Lit& lit, std::uint32_t number) {
    const BatchInfo& info = lit.store.info(number);
    const ClusteredMesh& mesh = *scene_.objects[info.object].mesh;
    const EngineLitObject& object = memory_.objects[info.object];
    const auto fill = [&](const std::vector<float>(&radiance)[3], int to) {
        const VertexLight light = {{radiance[0].data(), radiance[1].data(), radiance[2].data()},
                                   mesh.clusters[info.cluster].first_vertex,
                                   static_cast<std::uint32_t>(mesh.x.size())};
        float* batch = lit.store.batch(number);
        switch (lit.kind) {
            case Kind::triangles:
                return fill_lit(batch, lit.at.main, to, light);
            case Kind::fragments:
                return fill_fragments_lit(batch, light);
            case Kind::quads:
                return fill_quads_lit(batch, to, light);
        }
    };
    // The radiance takes the place of the weights.
    if (lit.at.dark >= 0) fill(object.dark, lit.at.dark);
    fill(object.radiance, lit.at.main);
}

/// The faces that a batch shows, straight into its rows.
void EngineLight::light_faces(const Lit& lit, std::uint32_t number, Points& points,
                              EventCounts& events) {
    const BatchInfo& info = lit.store.info(number);
    const EngineLitObject& object = memory_.objects[info.object];
    const std::uint32_t first = scene_.objects[info.object].mesh->clusters[info.cluster].first_face;
    FaceArrays faces{};
    for (int c = 0; c < 3; ++c) {
        faces.centre[c] = object.centre[c].data() + first;
        faces.normal[c] = object.normal[c].data() + first;
    }
    place_faces(lit.store.batch(number), faces, points.at(0));
    const auto light = [&](int row, float albedo) {
        const auto to = [&](int c) {
            return lit.store.batch(number) +
                   std::size_t(row + lit.at.stride * c) * lit.store.lanes();
        };
        points.light(shading_, info.material, info.count, albedo, {to(0), to(1), to(2)}, events);
    };
    light(lit.at.main, 1);
    if (lit.at.dark >= 0) light(lit.at.dark, 0);
}

void EngineLight::light_record(Record& r, EventCounts& events) const {
    const ObjectSurface& surface = shading_.surfaces[r.object];
    const Mesh& mesh = *shading_.frame.scene.objects[r.object].mesh;
    const ResolvedMaterial& material = shading_.frame.plan.materials[r.material];
    const float side = r.back ? -1.0f : 1.0f;
    const std::uint32_t face = mesh.triangle_face[r.triangle];
    std::span<const std::uint32_t> corners = mesh.triangle[r.triangle];
    if (r.depth == Record::Depth::spans)
        corners = std::span(mesh.corner).subspan(mesh.face_begin[face], 4);
    Batch<float> points;
    points.vectors = true;
    if (shading_.objects[r.object].shading == Shading::flat) {
        points.push(to_vec3<float>(surface.face_centre(face)),
                    to_vec3<float>(surface.face_normal(face)) * side, 0);
    } else {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::uint32_t v = corners[k];
            points.push(to_vec3<float>(surface.vertex_position(v)),
                        to_vec3<float>(surface.vertex_normal(v)) * side, k);
        }
    }
    points.textured = true;
    for (const float albedo : {1.0f, 0.0f}) {
        points.unpad();
        for (auto& channel : points.albedo) channel.assign(points.size(), albedo);
        points.illuminate(material, shading_.lighting.of(material), events);
        for (std::size_t k = 0; k < points.size(); ++k)
            for (int c = 0; c < 3; ++c)
                (albedo > 0 ? r.main : r.dark)[k][c] = points.radiance[c][k];
    }
    if (r.depth == Record::Depth::plane || r.depth == Record::Depth::spans) fill_rows(r);
}

/// Radiance where resolve looks for it: planes, corners, or one value of a flat face.
void EngineLight::fill_rows(Record& r) const {
    const bool whole = r.depth == Record::Depth::spans;
    const Attributes& at = whole ? shading_.resolve.quad_attributes : shading_.resolve.attributes;
    const bool flat = shading_.objects[r.object].shading == Shading::flat;
    const auto fill = [&](int from, const float(&value)[4][3]) {
        for (int c = 0; c < 3 && from >= 0; ++c) {
            const int row = from + at.stride * c;
            if (flat)
                r.rows[row] = value[0][c];
            else if (whole)
                for (int k = 0; k < 4; ++k) r.rows[row + k] = value[r.order[k]][c];
            else
                set_plane(r, row, value[0][c], value[1][c], value[2][c]);
        }
    };
    fill(at.main, r.main);
    fill(at.dark, r.dark);
}

/// Calls work(kind, batch, points, events) for the batches of that shading that show anything.
template <class Work>
EngineLight::Counts EngineLight::each_batch(Shading shading, EventCounts& events, Work&& work) {
    std::mutex mutex;
    Counts counts;
    for (const Lit& lit : kinds_)
        parallel_for(lit.store.used(), 64, shading_.frame.plan.threads,
                     [&](std::size_t begin, std::size_t end, int) {
                         EventCounts own;
                         Counts own_counts;
                         Points points;
                         for (auto b = std::uint32_t(begin); b < end; ++b) {
                             const BatchInfo& info = lit.store.info(b);
                             if (info.count == 0 || !concerns(info.object) ||
                                 shading_.objects[info.object].shading != shading)
                                 continue;
                             const std::uint8_t* seen = lit.seen_in(b);
                             const auto shown =
                                 std::uint64_t(std::count(seen, seen + lit.store.lanes(), 1));
                             own_counts += {shown, info.count};
                             if (shown > 0) work(lit, b, points, own);
                         }
                         const std::lock_guard lock(mutex);
                         events += own;
                         counts += own_counts;
                     });
    return counts;
}

EngineLight::Counts EngineLight::light(EventCounts& events) {
    Counts counts = each_batch(Shading::flat, events,
                               [&](const Lit& lit, std::uint32_t b, Points& points,
                                   EventCounts& own) { light_faces(lit, b, points, own); });
    each_batch(
        Shading::gouraud, events,
        [&](const Lit& lit, std::uint32_t b, Points&, EventCounts&) { mark_vertices(lit, b); });
    for (std::size_t object = 0; object < scene_.objects.size(); ++object)
        if (concerns(std::uint32_t(object)) && shading_.objects[object].shading == Shading::gouraud)
            counts += light_vertices(object, events);
    each_batch(Shading::gouraud, events,
               [&](const Lit& lit, std::uint32_t b, Points&, EventCounts&) { fill(lit, b); });
    for (std::size_t r = 0; r < records_.size(); ++r)
        if (memory_.seen_record[r] != 0 && concerns(records_[r].object) && !records_[r].scalar)
            light_record(records_[r], events);
    return counts;
}

EngineLight::Counts EngineLight::light_vertices(std::size_t object, EventCounts& events) {
    std::mutex mutex;
    Counts counts;
    parallel_for(scene_.objects[object].mesh->clusters.size(), 16, shading_.frame.plan.threads,
                 [&](std::size_t begin, std::size_t end, int) {
                     EventCounts own;
                     Counts own_counts;
                     Points points;
                     for (std::size_t c = begin; c < end; ++c)
                         own_counts += light_cluster(object, c, points, own);
                     const std::lock_guard lock(mutex);
                     events += own;
                     counts += own_counts;
                 });
    counts.all = memory_.objects[object].needed.size();
    return counts;
}

}  // namespace scanshade
