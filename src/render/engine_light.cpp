#include "render/engine_light.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "scanshade/base/parallel.hpp"

namespace scanshade {
namespace {

/// Several threads may note the same; nobody reads before all are done.
void note(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

}  // namespace

EngineLight::EngineLight(const TileShading& shading, const EngineScene& scene, BatchStore& batches,
                         std::vector<Record>& records)
    : shading_(shading), scene_(scene), batches_(batches), records_(records) {}

void EngineLight::reset() {
    points_.resize(scene_.objects.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!concerns(static_cast<std::uint32_t>(i))) continue;
        const Mesh& mesh = *shading_.frame.scene.objects[i].mesh;
        const std::size_t count =
            2 * (shading_.objects[i].shading == Shading::flat ? mesh.face_count()
                                                              : scene_.objects[i].mesh->x.size());
        points_[i].needed.assign(count, 0);
        for (int c = 0; c < 3; ++c) {
            points_[i].radiance[c].resize(count);
            points_[i].dark[c].resize(shading_.frame.plan.texture ? count : 0);
        }
    }
    seen_triangle_.assign(batches_.used() * batches_.lanes(), 0);
    seen_record_.assign(records_.size(), 0);
}

void EngineLight::see(const TileBuffer& tile) {
    for (int s = 0; s < TileBuffer::subtiles; ++s) {
        if (!tile.written[s]) continue;
        std::uint32_t last = no_ref;
        for (int i = 0; i < subtile_samples; ++i) {
            const int row = (s / 4) * 4 + i / 64, column = (s % 4) * 4 + i % 64 / block_samples;
            const std::uint32_t ref =
                tile.ref[(row * (tile_side / block_side) + column) * block_samples +
                         i % block_samples];
            if (ref == last || ref == no_ref) continue;
            last = ref;
            note((ref & record_bit) != 0 ? seen_record_[ref & ~record_bit] : seen_triangle_[ref]);
        }
    }
}

void EngineLight::see_all() {
    std::fill(seen_triangle_.begin(), seen_triangle_.end(), std::uint8_t{1});
    std::fill(seen_record_.begin(), seen_record_.end(), std::uint8_t{1});
}

void EngineLight::mark(std::uint32_t object, std::size_t point) {
    note(points_[object].needed[point]);
}

void EngineLight::mark_batch(std::uint32_t number) {
    const BatchInfo& info = batches_.info(number);
    if (info.count == 0 || !concerns(info.object)) return;
    const std::uint32_t lanes = batches_.lanes();
    const auto* rows = reinterpret_cast<const std::uint32_t*>(batches_.batch(number));
    const Mesh& mesh = *shading_.frame.scene.objects[info.object].mesh;
    const std::uint32_t first_triangle = shading_.frame.plan.objects[info.object].first_triangle;
    const std::uint32_t first_slot =
        scene_.objects[info.object].mesh->clusters[info.cluster].first_vertex;
    for (std::uint32_t lane = 0; lane < info.count; ++lane) {
        if (seen_triangle_[number * lanes + lane] == 0) continue;
        const std::uint32_t packed = rows[row_corners * lanes + lane];
        const std::size_t back = (packed & back_bit) != 0 ? 1 : 0;
        if (shading_.objects[info.object].shading == Shading::flat) {
            const std::uint32_t id = rows[row_id * lanes + lane];
            mark(info.object, 2 * std::size_t(mesh.triangle_face[id - first_triangle]) + back);
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t local = packed >> (k * corner_bits) & (max_cluster_vertices - 1);
            mark(info.object, 2 * std::size_t(first_slot + local) + back);
        }
    }
}

// ---- light

void EngineLight::finish(std::size_t object, std::uint32_t number, Batch<float>& points,
                         EventCounts& events) {
    if (points.size() == 0) return;
    EngineLitPoints& lit = points_[object];
    const ResolvedMaterial& material = shading_.frame.plan.materials[number];
    const auto run = [&](std::vector<float>(&to)[3], float albedo) {
        points.textured = true;
        for (auto& channel : points.albedo) channel.assign(points.size(), albedo);
        points.illuminate(material, shading_.lighting.of(material), events);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int c = 0; c < 3; ++c) to[c][points.target[i]] = points.radiance[c][i];
    };
    run(lit.radiance, 1);
    if (shading_.frame.plan.texture) {
        points.unpad();
        run(lit.dark, 0);
    }
    points.clear();
}

void EngineLight::light_cluster(std::size_t object, std::size_t number, Batch<float>& points,
                                EventCounts& events) {
    const EngineObject& engine = scene_.objects[object];
    const ClusteredMesh& mesh = *engine.mesh;
    const Cluster& cluster = mesh.clusters[number];
    for (std::uint32_t i = 0; i < 2 * cluster.vertex_count; ++i) {
        const std::uint32_t slot = cluster.first_vertex + i / 2;
        const std::size_t point = 2 * std::size_t(cluster.first_vertex) + i;
        if (points_[object].needed[point] == 0) continue;
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const auto world = [&](int r) {
            const float* m = engine.to_world[r];
            return m[0] * mesh.x[slot] + m[1] * mesh.y[slot] + m[2] * mesh.z[slot] + m[3];
        };
        points.push(
            {world(0), world(1), world(2)},
            Vec3<float>{engine.normal[0][slot], engine.normal[1][slot], engine.normal[2][slot]} *
                side,
            point);
    }
    finish(object, shading_.frame.plan.objects[object].materials[cluster.material], points, events);
}

void EngineLight::light_faces(std::size_t object, std::size_t begin, std::size_t end,
                              Batch<float>& points, EventCounts& events) {
    const ObjectSurface& surface = shading_.surfaces[object];
    std::uint32_t material = 0;
    for (std::size_t i = 2 * begin; i < 2 * end; ++i) {
        if (points_[object].needed[i] == 0) continue;
        const std::uint32_t own = material_of(shading_.frame, object, i / 2);
        if (own != material) finish(object, material, points, events);
        material = own;
        points.push(to_vec3<float>(surface.face_centre(i / 2)),
                    to_vec3<float>(surface.face_normal(i / 2)) * (i % 2 == 0 ? 1.0f : -1.0f), i);
    }
    finish(object, material, points, events);
}

void EngineLight::light_record(Record& r, EventCounts& events) const {
    const ObjectSurface& surface = shading_.surfaces[r.object];
    const Mesh& mesh = *shading_.frame.scene.objects[r.object].mesh;
    const ResolvedMaterial& material = shading_.frame.plan.materials[r.material];
    const float side = r.back ? -1.0f : 1.0f;
    Batch<float> points;
    points.vectors = true;
    if (shading_.objects[r.object].shading == Shading::flat) {
        const std::uint32_t face = mesh.triangle_face[r.triangle];
        points.push(to_vec3<float>(surface.face_centre(face)),
                    to_vec3<float>(surface.face_normal(face)) * side, 0);
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.triangle[r.triangle][k];
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
}

void EngineLight::fill(std::uint32_t number) {
    const BatchInfo& info = batches_.info(number);
    if (info.count == 0 || !concerns(info.object)) return;
    const std::uint32_t lanes = batches_.lanes();
    const auto seen = seen_triangle_.begin() + std::ptrdiff_t(number * lanes);
    if (std::find(seen, seen + std::ptrdiff_t(lanes), 1) == seen + std::ptrdiff_t(lanes)) return;
    const EngineLitPoints& lit = points_[info.object];
    const Mesh& mesh = *shading_.frame.scene.objects[info.object].mesh;
    LitFill fill{};
    fill.shading = shading_.objects[info.object].shading;
    for (int c = 0; c < 3; ++c) {
        fill.radiance[c] = lit.radiance[c].data();
        fill.dark[c] = lit.dark[c].empty() ? nullptr : lit.dark[c].data();
    }
    fill.first_point =
        std::int32_t(2 * scene_.objects[info.object].mesh->clusters[info.cluster].first_vertex);
    fill.faces = {mesh.triangle_face.data(),
                  shading_.frame.plan.objects[info.object].first_triangle,
                  std::uint32_t(mesh.triangle_count())};
    fill_lit(batches_.batch(number), shading_.resolve.attributes, fill);
}

EngineLight::Counts EngineLight::light(EventCounts& events) {
    const int threads = shading_.frame.plan.threads;
    parallel_for(batches_.used(), 256, threads, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t b = begin; b < end; ++b) mark_batch(std::uint32_t(b));
    });
    std::mutex events_mutex;
    Counts count;
    for (std::size_t object = 0; object < points_.size(); ++object) {
        if (!concerns(std::uint32_t(object))) continue;
        const bool flat = shading_.objects[object].shading == Shading::flat;
        const std::size_t parts =
            flat ? points_[object].needed.size() / 2 : scene_.objects[object].mesh->clusters.size();
        parallel_for(parts, flat ? 512 : 16, threads, [&](std::size_t begin, std::size_t end, int) {
            EventCounts own;
            Batch<float> points;
            points.vectors = true;
            if (flat) light_faces(object, begin, end, points, own);
            for (std::size_t c = begin; c < end && !flat; ++c)
                light_cluster(object, c, points, own);
            const std::lock_guard lock(events_mutex);
            events += own;
        });
        const std::vector<std::uint8_t>& needed = points_[object].needed;
        count.lit += std::uint64_t(std::count(needed.begin(), needed.end(), 1));
        count.all += needed.size();
    }
    parallel_for(batches_.used(), 256, threads, [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t b = begin; b < end; ++b) fill(std::uint32_t(b));
    });
    for (std::size_t r = 0; r < records_.size(); ++r)
        if (seen_record_[r] != 0 && concerns(records_[r].object) &&
            records_[r].depth != Record::Depth::scalar)
            light_record(records_[r], events);
    return count;
}

}  // namespace scanshade
