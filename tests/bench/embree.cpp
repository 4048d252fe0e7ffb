// Embree: primary rays in coherent packets; the tree is built before anything is timed.
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/peer_scene.hpp"
#include "bench/point_arrays.hpp"
#include "bench/rival.hpp"
#include "bench/scenes.hpp"
#include "scanshade/base/error.hpp"

namespace scanshade::bench {
namespace {

/// A packet of rays: a block of pixels.
struct Packet16 {
    using Rays = RTCRayHit16;
    static constexpr int width = 4, height = 4;
    static constexpr RTCDeviceProperty native = RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED;
    static constexpr auto intersect = rtcIntersect16;
};
struct Packet8 {
    using Rays = RTCRayHit8;
    static constexpr int width = 4, height = 2;
    static constexpr RTCDeviceProperty native = RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED;
    static constexpr auto intersect = rtcIntersect8;
};
struct Packet4 {
    using Rays = RTCRayHit4;
    static constexpr int width = 2, height = 2;
    static constexpr RTCDeviceProperty native = RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED;
    static constexpr auto intersect = rtcIntersect4;
};

constexpr int tile_side = 32;  // pixels
constexpr std::size_t tile_pixels = std::size_t(tile_side) * tile_side;

/// What one thread works in: the hits of its tile, close together, and their surface points.
struct Tile {
    std::size_t hits = 0;
    std::uint32_t pixel[tile_pixels], triangle[tile_pixels];
    float u[tile_pixels], v[tile_pixels];  // weights of the second and third corner
    bool back[tile_pixels];
    PointArrays points;
    std::uint32_t rgba[tile_pixels];

    Tile() { points.resize(tile_pixels); }
};

/// a·x + b·y + c·z
Float3 weighted(const Float3& x, float a, const Float3& y, float b, const Float3& z, float c) {
    return {a * x[0] + b * y[0] + c * z[0], a * x[1] + b * y[1] + c * z[1],
            a * x[2] + b * y[2] + c * z[2]};
}

class Embree final : public Rival {
public:
    explicit Embree(const Ground& ground)
        : ground_(ground),
          mesh_(*ground.scene.objects[0].mesh),
          arena_(ground.threads),
          device_(rtcNewDevice(fmt::format("threads={}", ground.threads).c_str())) {
        if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
        arena_.execute([this] { build_tree(); });
        choose_packet<Packet4>();
        choose_packet<Packet8>();
        choose_packet<Packet16>();
    }

    std::string about() const override {
        const auto version = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_VERSION);
        return fmt::format("Embree {}.{}.{}, packets of {}", version / 10000, version / 100 % 100,
                           version % 100, packet_size_);
    }

    std::vector<std::string> prepare(const Cell& cell) override {
        if (cell.interpolation != Interpolation::perspective) return {};
        SCANSHADE_CHECK(cell.width % 4 == 0 && cell.height % 4 == 0);
        cell_ = cell;
        peer_ = make_peer_scene(lit_scene(ground_.scene, cell), settings_of(cell, ground_.cull));
        lighting_ = {peer_.lights.data(), peer_.lights.size(), {}, {}, cell.brdf == "blinn-phong"};
        std::copy(peer_.eye.begin(), peer_.eye.end(), lighting_.eye);
        std::copy(peer_.base.begin(), peer_.base.end(), lighting_.base);
        place_lit_points();
        picture_.rgba.resize(std::size_t(cell.width) * std::size_t(cell.height));
        return {"packets"};
    }

    void draw(std::size_t) override {
        arena_.execute([this] { draw_frame(false); });
    }

    Picture picture(std::size_t) override {
        picture_.id.assign(picture_.rgba.size(), Picture::no_triangle);
        arena_.execute([this] { draw_frame(true); });
        return picture_;
    }

private:
    Float3 position(std::size_t v) const {
        return peer_.placed({mesh_.x[v], mesh_.y[v], mesh_.z[v]});
    }

    void build_tree() {
        peer_ = make_peer_scene(ground_.scene, Settings{});
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
            return rtcSetNewGeometryBuffer(geometry, type, 0, format, 12, count);
        };
        auto* vertices = static_cast<Float3*>(
            buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh_.vertex_count()));
        for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
            vertices[v] = position(v);
            normals_.push_back({mesh_.nx[v], mesh_.ny[v], mesh_.nz[v]});
        }
        std::copy(mesh_.triangle.begin(), mesh_.triangle.end(),
                  static_cast<std::array<std::uint32_t, 3>*>(
                      buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh_.triangle_count())));
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        tree_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(tree_, RTC_BUILD_QUALITY_HIGH);
        rtcAttachGeometry(tree_, geometry);
        rtcReleaseGeometry(geometry);
        rtcJoinCommitScene(tree_);
    }

    /// Called from the narrowest to the widest: the last that this machine has stays.
    template <class Packet>
    void choose_packet() {
        if (rtcGetDeviceProperty(device_, Packet::native) == 0) return;
        packet_size_ = Packet::width * Packet::height;
        trace_ = &Embree::trace<Packet>;
    }

    /// Where Gouraud and flat light is evaluated: vertices or faces, those of the back behind
    /// those of the front.
    void place_lit_points() {
        const bool faces = cell_.shading == Shading::flat;
        lit_count_ = faces ? mesh_.face_count() : mesh_.vertex_count();
        const bool at_pixels = cell_.shading == Shading::phong || cell_.lights == 0;
        const std::size_t sides = ground_.cull == Cull::none ? 2 : 1;
        const std::size_t count = at_pixels ? 0 : sides * lit_count_;
        lit_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = i % lit_count_;
            Float3 n = faces ? mesh_.face_normal[k] : normals_[k];
            if (i >= lit_count_)
                for (float& x : n) x = -x;
            lit_.set_normal(i, n);
            lit_.set_position(i, faces ? peer_.placed(mesh_.face_centre[k]) : position(k));
        }
    }

    void draw_frame(bool with_ids) {
        constexpr std::size_t grain = 1024;  // a multiple of packet_block
        tbb::parallel_for(std::size_t(0), lit_.size(), grain, [&](std::size_t first) {
            shade_points(lit_.span(first, std::min(grain, lit_.size() - first)), lighting_);
        });
        const int columns = (cell_.width + tile_side - 1) / tile_side;
        const int rows = (cell_.height + tile_side - 1) / tile_side;
        tbb::parallel_for(0, columns * rows, [&](int i) {
            draw_tile(i % columns * tile_side, i / columns * tile_side, tiles_.local(), with_ids);
        });
    }

    void draw_tile(int left, int top, Tile& tile, bool with_ids) {
        clear(left, top, tile);
        tile.hits = 0;
        (this->*trace_)(left, top, tile);
        if (tile.hits == 0) return;
        if (cell_.lights == 0) {
            for (std::size_t i = 0; i < tile.hits; ++i) tile.points.set_radiance(i, peer_.base);
        } else if (cell_.shading == Shading::phong) {
            set_normals(tile);
            shade_points(tile.points.span(0, tile.hits), lighting_);
        } else {
            set_radiance(tile);
        }
        encode_points(tile.points.span(0, tile.hits), tile.rgba);
        for (std::size_t i = 0; i < tile.hits; ++i) picture_.rgba[tile.pixel[i]] = tile.rgba[i];
        for (std::size_t i = 0; with_ids && i < tile.hits; ++i)
            picture_.id[tile.pixel[i]] = tile.triangle[i];
    }

    void clear(int left, int top, Tile& tile) {
        tile.points.set_radiance(0, peer_.background);
        encode_points(tile.points.span(0, 1), tile.rgba);
        const int width = std::min(tile_side, cell_.width - left);
        for (int y = top; y < std::min(top + tile_side, cell_.height); ++y)
            std::fill_n(picture_.rgba.begin() + std::ptrdiff_t(y) * cell_.width + left, width,
                        tile.rgba[0]);
    }

    template <class Packet>
    void trace(int left, int top, Tile& tile) {
        for (int y = top; y < std::min(top + tile_side, cell_.height); y += Packet::height)
            for (int x = left; x < std::min(left + tile_side, cell_.width); x += Packet::width)
                trace_packet<Packet>(x, y, tile);
    }

    template <class Packet>
    void trace_packet(int left, int top, Tile& tile) {
        constexpr int count = Packet::width * Packet::height;
        alignas(64) int valid[count];
        typename Packet::Rays rays;
        for (int i = 0; i < count; ++i) {
            const int column = left + i % Packet::width, row = top + i / Packet::width;
            const float x = float(column) + 0.5f, y = float(row) + 0.5f;
            const Float3 d = weighted(peer_.ray_corner, 1, peer_.ray_x, x, peer_.ray_y, y);
            valid[i] = -1;
            rays.ray.org_x[i] = peer_.eye[0], rays.ray.dir_x[i] = d[0];
            rays.ray.org_y[i] = peer_.eye[1], rays.ray.dir_y[i] = d[1];
            rays.ray.org_z[i] = peer_.eye[2], rays.ray.dir_z[i] = d[2];
            rays.ray.tnear[i] = 0, rays.ray.tfar[i] = INFINITY, rays.ray.time[i] = 0;
            rays.ray.mask[i] = ~0u, rays.ray.flags[i] = 0;
            rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        Packet::intersect(valid, tree_, &context, &rays);
        for (int i = 0; i < count; ++i) {
            if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
            const std::size_t at = tile.hits++;
            const Float3 d = {rays.ray.dir_x[i], rays.ray.dir_y[i], rays.ray.dir_z[i]};
            tile.points.set_position(at, weighted(peer_.eye, 1, d, rays.ray.tfar[i], d, 0));
            tile.pixel[at] =
                std::uint32_t((top + i / Packet::width) * cell_.width + left + i % Packet::width);
            tile.triangle[at] = rays.hit.primID[i];
            tile.u[at] = rays.hit.u[i], tile.v[at] = rays.hit.v[i];
            tile.back[at] =
                rays.hit.Ng_x[i] * d[0] + rays.hit.Ng_y[i] * d[1] + rays.hit.Ng_z[i] * d[2] > 0;
        }
    }

    void set_normals(Tile& tile) {
        for (std::size_t i = 0; i < tile.hits; ++i) {
            const auto& corner = mesh_.triangle[tile.triangle[i]];
            const float side = tile.back[i] ? -1.0f : 1.0f;
            const float u = side * tile.u[i], v = side * tile.v[i];
            tile.points.set_normal(i, weighted(normals_[corner[0]], side - u - v,
                                               normals_[corner[1]], u, normals_[corner[2]], v));
        }
    }

    /// From the light at the corners or of the face.
    void set_radiance(Tile& tile) {
        const std::size_t behind = ground_.cull == Cull::none ? lit_count_ : 0;
        for (std::size_t i = 0; i < tile.hits; ++i) {
            const std::size_t side = tile.back[i] ? behind : 0, t = tile.triangle[i];
            if (cell_.shading == Shading::flat) {
                tile.points.set_radiance(i, lit_.radiance(side + mesh_.triangle_face[t]));
                continue;
            }
            const auto lit = [&](std::size_t corner) {
                return lit_.radiance(side + mesh_.triangle[t][corner]);
            };
            const float u = tile.u[i], v = tile.v[i];
            tile.points.set_radiance(i, weighted(lit(0), 1 - u - v, lit(1), u, lit(2), v));
        }
    }

    Ground ground_;
    const Mesh& mesh_;
    tbb::task_arena arena_;
    RTCDevice device_;
    RTCScene tree_ = nullptr;
    std::vector<Float3> normals_;  // [vertex]
    int packet_size_ = 0;
    void (Embree::*trace_)(int, int, Tile&) = nullptr;
    Cell cell_{};
    PeerScene peer_{};
    PacketLighting lighting_{};
    PointArrays lit_;  // Gouraud: vertices, flat: faces
    std::size_t lit_count_ = 0;
    tbb::enumerable_thread_specific<Tile> tiles_;
    Picture picture_;
};

}  // namespace

std::unique_ptr<Rival> make_embree(const Ground& ground) {
    return std::make_unique<Embree>(ground);
}

}  // namespace scanshade::bench
