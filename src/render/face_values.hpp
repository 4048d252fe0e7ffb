// The values of one drawn face at its samples: what shading interpolates.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/shade_common.hpp"
#include "render/texture_planes.hpp"

namespace scanshade {

/// Shorter than this, an interpolated normal is noise: its direction has lost most digits.
inline constexpr double shortest_normal = 1e-6;

/// Describes a face by its id and keeps the values at its corners while samples share it.
template <class T>
class FaceValues {
public:
    FaceValues(const Frame& frame, const std::vector<ObjectSurface>& surfaces, EventCounts& events)
        : frame_(frame), surfaces_(surfaces), events_(events) {}

    /// True where the face is another than before: radiance at its corners must be set again.
    bool begin(std::uint32_t id) {
        if (id == id_) return false;
        id_ = id;
        describe_drawn(frame_, id, drawn);
        const std::size_t object = drawn.object;
        material = material_of(frame_, object, drawn.face);
        shading = frame_.plan.objects[object].shading;
        texture = frame_.scene.materials[material].map_kd.get();
        if (texture != nullptr)
            planes_ =
                TexturePlanes(frame_, object, id - frame_.plan.objects[object].first_triangle);
        std::uint32_t quad[4];
        patch_ = patch_corners(frame_, drawn, quad, quad_);
        if (falls_back(frame_, drawn, patch_)) fall_back();
        vertex.assign(drawn.vertex.begin(), drawn.vertex.end());
        // A patch can fall back to its triangle at a sample, so both sets of corners are there.
        if (patch_) vertex.insert(vertex.end(), quad, quad + 4);
        load_corners(object);
        return true;
    }

    Place<T> place(SnappedPoint p) {
        if (!patch_) return place_in<T>(drawn, frame_, p, events_);
        const auto uv =
            inverse_bilinear(quad_[0], quad_[1], quad_[2], quad_[3], {double(p.x), double(p.y)});
        if (!uv) {
            fall_back();
            return place_in<T>(drawn, frame_, p, events_);
        }
        Place<T> at{};
        at.kind = Place<T>::Kind::patch;
        at.a = 3, at.b = 4, at.c = 5, at.d = 6;  // after the triangle's corners
        at.u = T(uv->u), at.v = T(uv->v);
        return at;
    }

    /// Not normalised; the face's normal, counted, where the interpolated one has no length.
    Vec3<T> normal(const Place<T>& at) {
        const Vec3<T> n = carry(at, normal_.data());
        if (dot(n, n) > T(shortest_normal * shortest_normal)) return n;
        events_.add(Event::zero_normal);
        return face_normal_;
    }
    Vec3<T> position(const Place<T>& at) const { return carry(at, position_.data()); }
    Vec3<T> texcoord(const Place<T>& at) const { return carry(at, texcoord_.data()); }
    /// How fast the texture coordinates move from the sample at p to the next.
    TextureGradient gradient(SnappedPoint p) const {
        return planes_.gradient(frame_.view, p, 1.0 / frame_.plan.samples_side);
    }
    /// The texture's colour at a sample; 1 where there is none.
    std::array<float, 3> albedo(const Place<T>& at, SnappedPoint p) const {
        if (texture == nullptr) return {1, 1, 1};
        const Vec3<T> uv = texcoord(at);
        return texture->sample(static_cast<float>(uv.x), static_cast<float>(uv.y), gradient(p));
    }
    /// Light that was evaluated at lit points, at a sample. Reflected light is linear in the albedo,
    /// so two lit values give it at any.
    Rgb<T> lit(const Place<T>& at, const std::array<float, 3>& albedo) const {
        const Rgb<T> white = lit(at);
        if (texture == nullptr) return white;
        const Rgb<T> black = dark(at);
        return {black.r + T(albedo[0]) * (white.r - black.r),
                black.g + T(albedo[1]) * (white.g - black.g),
                black.b + T(albedo[2]) * (white.b - black.b)};
    }
    Rgb<T> lit(const Place<T>& at) const { return value(at, radiance); }
    Rgb<T> dark(const Place<T>& at) const { return value(at, unreflecting); }
    const std::vector<Vec3<T>>& corner_normals() const { return normal_; }

    DrawnFace drawn;
    std::uint32_t material = 0;
    Shading shading = Shading::phong;
    const Texture* texture = nullptr;
    std::vector<std::uint32_t> vertex;  // of the corners
    // Set by whoever lights points: at each corner (Gouraud), or one value (flat).
    std::vector<Rgb<T>> radiance, unreflecting;
    Fallbacks fallbacks;

private:
    void fall_back() {
        const Mesh& mesh = *frame_.scene.objects[drawn.object].mesh;
        fallbacks.insert(frame_.plan.objects[drawn.object].first_triangle +
                         mesh.face_first_triangle[drawn.face]);
    }

    Rgb<T> value(const Place<T>& at, const std::vector<Rgb<T>>& corners) const {
        return shading == Shading::flat ? corners[0] : carry(at, corners.data());
    }

    void load_corners(std::size_t object) {
        const ObjectSurface& surface = surfaces_[object];
        const Mesh& mesh = *frame_.scene.objects[object].mesh;
        const double side = drawn.back ? -1 : 1;
        position_.clear(), normal_.clear(), texcoord_.clear();
        radiance.clear(), unreflecting.clear();
        for (const std::uint32_t v : vertex) {
            texcoord_.push_back({T(mesh.u[v]), T(mesh.v[v]), T(0)});
            if (shading != Shading::phong) continue;
            position_.push_back(to_vec3<T>(surface.vertex_position(v)));
            normal_.push_back(to_vec3<T>(surface.vertex_normal(v) * side));
        }
        face_normal_ = to_vec3<T>(surface.face_normal(drawn.face) * side);
    }

    const Frame& frame_;
    const std::vector<ObjectSurface>& surfaces_;
    EventCounts& events_;
    std::uint32_t id_ = Framebuffer::no_triangle;
    bool patch_ = false;
    PictureCorner quad_[4];
    TexturePlanes planes_;                               // where there is a texture
    std::vector<Vec3<T>> position_, normal_, texcoord_;  // [corner]
    Vec3<T> face_normal_;
};

}  // namespace scanshade
