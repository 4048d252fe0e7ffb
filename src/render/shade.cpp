// Radiance at each visible sample.
#include "render/shade.hpp"

#include <algorithm>
#include <cmath>

#include "render/shade_common.hpp"
#include "render/texture_planes.hpp"

namespace scanshade {
namespace {

/// Shorter than this, an interpolated normal is noise: its direction has lost most digits.
constexpr double shortest_normal = 1e-6;

/// The face of the sample at hand and the values at its corners, kept while samples share it.
template <class T>
struct CurrentFace {
    DrawnFace drawn;
    std::uint32_t material = 0;
    Shading shading = Shading::phong;
    const Texture* texture = nullptr;
    TexturePlanes planes;  // where there is a texture
    bool patch = false;
    PictureCorner quad[4];
    std::vector<std::uint32_t> vertex;                // of the corners below
    std::vector<Vec3<T>> position, normal, texcoord;  // [corner]
    std::vector<Rgb<T>> radiance, unreflecting;       // [corner], Gouraud; [0], flat
    Vec3<T> face_normal;
};

template <class T>
class SampleShader {
public:
    explicit SampleShader(Frame& frame)
        : frame_(frame), lighting_(lighting_of<T>(frame)), batches_(frame.plan.materials.size()) {
        for (const Object& object : frame.scene.objects) surfaces_.emplace_back(object);
        for (std::size_t m = 0; m < batches_.size(); ++m)
            batches_[m].textured = frame.scene.materials[m].map_kd != nullptr;
    }

    void shade_row(int y) {
        const std::size_t row = frame_.target.index(0, y);
        for (int x = 0; x < frame_.view.width; ++x) {
            const std::size_t at = row + static_cast<std::size_t>(x);
            if (frame_.id[at] == Framebuffer::no_triangle) continue;
            if (frame_.id[at] != id_) begin_face(frame_.id[at]);
            shade_sample(sample_point(x, y, frame_.sample), at);
            ++frame_.items;
        }
        for (std::size_t m = 0; m < batches_.size(); ++m) finish_batch(m);
    }

private:
    void begin_face(std::uint32_t id) {
        id_ = id;
        describe_drawn(frame_, id, face_.drawn);
        const std::size_t object = face_.drawn.object;
        face_.material = material_of(frame_, object, face_.drawn.face);
        face_.shading = frame_.plan.objects[object].shading;
        face_.texture = frame_.scene.materials[face_.material].map_kd.get();
        if (face_.texture != nullptr)
            face_.planes =
                TexturePlanes(frame_, object, id - frame_.plan.objects[object].first_triangle);
        std::uint32_t quad[4];
        face_.patch = patch_corners(frame_, face_.drawn, quad, face_.quad);
        face_.vertex.assign(face_.drawn.vertex.begin(), face_.drawn.vertex.end());
        // A patch can fall back to its triangle at a sample, so both sets of corners are there.
        if (face_.patch) face_.vertex.insert(face_.vertex.end(), quad, quad + 4);
        load_corners(object);
    }

    void load_corners(std::size_t object) {
        const ObjectSurface& surface = surfaces_[object];
        const Mesh& mesh = *frame_.scene.objects[object].mesh;
        const double side = face_.drawn.back ? -1 : 1;
        face_.position.clear(), face_.normal.clear(), face_.texcoord.clear();
        face_.radiance.clear(), face_.unreflecting.clear();
        if (face_.shading == Shading::flat) load_lit(object, face_.drawn.face);
        for (const std::uint32_t v : face_.vertex) {
            if (face_.shading == Shading::gouraud) load_lit(object, v);
            face_.texcoord.push_back({T(mesh.u[v]), T(mesh.v[v]), T(0)});
            if (face_.shading != Shading::phong) continue;
            face_.position.push_back(to_vec3<T>(surface.vertex_position(v)));
            face_.normal.push_back(to_vec3<T>(surface.vertex_normal(v) * side));
        }
        face_.face_normal = to_vec3<T>(surface.face_normal(face_.drawn.face) * side);
    }

    void load_lit(std::size_t object, std::uint64_t number) {
        const LitPoints<T>& points = lit_points<T>(frame_)[object];
        const std::uint64_t key = lit_key(face_.material, face_.drawn.back, number);
        const auto at = static_cast<std::size_t>(
            std::lower_bound(points.key.begin(), points.key.end(), key) - points.key.begin());
        const auto rgb = [at](const std::vector<T>(&from)[3]) {
            return Rgb<T>{from[0][at], from[1][at], from[2][at]};
        };
        face_.radiance.push_back(rgb(points.radiance));
        if (face_.texture != nullptr) face_.unreflecting.push_back(rgb(points.unreflecting));
    }

    Place<T> place(SnappedPoint p) {
        if (!face_.patch) return place_in<T>(face_.drawn, frame_, p, frame_.events);
        const auto uv = inverse_bilinear(face_.quad[0], face_.quad[1], face_.quad[2], face_.quad[3],
                                         {double(p.x), double(p.y)});
        if (!uv) {
            frame_.events.add(Event::patch_fallback);
            return place_in<T>(face_.drawn, frame_, p, frame_.events);
        }
        Place<T> at{};
        at.kind = Place<T>::Kind::patch;
        at.a = 3, at.b = 4, at.c = 5, at.d = 6;  // after the triangle's corners
        at.u = T(uv->u), at.v = T(uv->v);
        return at;
    }

    void shade_sample(SnappedPoint p, std::size_t to) {
        const bool flat = face_.shading == Shading::flat;
        if (flat && face_.texture == nullptr) return add(to, face_.radiance[0]);
        const Place<T> at = place(p);
        std::array<float, 3> albedo{1, 1, 1};
        if (face_.texture != nullptr) {
            const Vec3<T> uv = carry(at, face_.texcoord.data());
            albedo = face_.texture->sample(
                static_cast<float>(uv.x), static_cast<float>(uv.y),
                face_.planes.gradient(frame_.view, p, 1.0 / frame_.plan.samples_side));
        }
        if (face_.shading == Shading::phong) return push_phong(at, albedo, to);
        const Rgb<T> lit = flat ? face_.radiance[0] : carry(at, face_.radiance.data());
        if (face_.texture == nullptr) return add(to, lit);
        // Reflected light is linear in the albedo, so two lit values give it at any.
        const Rgb<T> dark = flat ? face_.unreflecting[0] : carry(at, face_.unreflecting.data());
        add(to, {dark.r + T(albedo[0]) * (lit.r - dark.r), dark.g + T(albedo[1]) * (lit.g - dark.g),
                 dark.b + T(albedo[2]) * (lit.b - dark.b)});
    }

    void push_phong(const Place<T>& at, const std::array<float, 3>& albedo, std::size_t to) {
        Vec3<T> n = carry(at, face_.normal.data());
        if (!(dot(n, n) > T(shortest_normal * shortest_normal))) {
            frame_.events.add(Event::zero_normal);
            n = face_.face_normal;
        }
        Batch<T>& batch = batches_[face_.material];
        batch.push(carry(at, face_.position.data()), n, to);
        if (batch.textured) batch.push_albedo(albedo);
    }

    void finish_batch(std::size_t m) {
        Batch<T>& batch = batches_[m];
        if (batch.size() == 0) return;
        const ResolvedMaterial& material = frame_.plan.materials[m];
        batch.illuminate(material, lighting_.of(material), frame_.events);
        for (std::size_t i = 0; i < batch.size(); ++i)
            add(batch.target[i],
                {batch.radiance[0][i], batch.radiance[1][i], batch.radiance[2][i]});
        batch.clear();
    }

    void add(std::size_t to, const Rgb<T>& L) {
        if (!(std::isfinite(L.r) && std::isfinite(L.g) && std::isfinite(L.b))) {
            frame_.events.add(Event::not_finite);
            return;
        }
        frame_.target.r[to] += static_cast<float>(L.r);
        frame_.target.g[to] += static_cast<float>(L.g);
        frame_.target.b[to] += static_cast<float>(L.b);
    }

    Frame& frame_;
    LightingPair<T> lighting_;
    std::vector<ObjectSurface> surfaces_;
    std::vector<Batch<T>> batches_;  // [material]
    std::uint32_t id_ = Framebuffer::no_triangle;
    CurrentFace<T> face_;
};

}  // namespace

template <class T>
void shade_samples(Frame& frame) {
    SampleShader<T> shader(frame);
    for (int y = 0; y < frame.view.height; ++y) shader.shade_row(y);
}

template void shade_samples<float>(Frame&);
template void shade_samples<double>(Frame&);

}  // namespace scanshade
