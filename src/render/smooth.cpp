#include "scanshade/render/smooth.hpp"

#include <algorithm>

#include "render/pixel_ray.hpp"
#include "render/shade_common.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/image/texture.hpp"

namespace scanshade {
namespace {

/// What all rows of the picture share.
struct SmoothScene {
    SmoothScene(const Scene& normalised_scene, const RenderPlan& render_plan)
        : scene(normalised_scene),
          plan(render_plan),
          view(make_view(plan.camera, plan.depth, plan.width, plan.height)),
          lighting{make_lighting(scene, view), make_unlit_lighting(view)},
          surfaces(scene.objects.begin(), scene.objects.end()) {}

    const Scene& scene;
    const RenderPlan& plan;
    View view;
    LightingPair<double> lighting;
    std::vector<ObjectSurface> surfaces;
};

/// A triangle of the mesh, and what stands in its stead.
class SeenTriangle {
public:
    SeenTriangle(const SmoothScene& in, std::uint32_t id)
        : object_(object_of(in.plan, id)),
          mesh_(*in.scene.objects[object_].mesh),
          surface_(in.surfaces[object_]),
          to_world_(in.scene.objects[object_].to_world) {
        const std::uint32_t triangle = id - in.plan.objects[object_].first_triangle;
        vertex_ = mesh_.triangle[triangle];
        face_ = mesh_.triangle_face[triangle];
        for (std::size_t i = 0; i < 3; ++i) corner_[i] = surface_.vertex_position(vertex_[i]);
        material = in.plan.objects[object_].materials[mesh_.face_material[face_]];
    }

    std::uint32_t material;

    /// Nothing where the ray runs along the triangle.
    std::optional<SurfaceHit> hit(const PixelRay& ray, SmoothCounts& counts) const {
        std::optional<SurfaceHit> on_mesh = mesh_hit(ray);
        if (!on_mesh) return std::nullopt;
        if (mesh_.shape == nullptr) return ++counts.meshes, on_mesh;
        if (mesh_.shape->smooth == nullptr) return ++counts.exact, on_mesh;
        const std::size_t patch = face_ / (mesh_.face_count() / std::size_t(mesh_.shape->patches));
        const auto exact =
            PlacedPatch(*mesh_.shape, int(patch), to_world_).meet(ray, on_mesh->texcoord);
        if (!exact || !stays(ray, *on_mesh, *exact)) return ++counts.unrefined, on_mesh;
        return ++counts.exact, exact;
    }

    /// Seen from behind, by the face's own normal.
    bool back(const PixelRay& ray) const {
        return glm::dot(surface_.face_normal(face_), ray.towards_eye(corner_[0])) < 0;
    }

private:
    std::optional<SurfaceHit> mesh_hit(const PixelRay& ray) const {
        glm::dmat2 inverse;
        const auto at =
            ray.meet_plane(corner_[0], corner_[1] - corner_[0], corner_[2] - corner_[0], inverse);
        if (!at) return std::nullopt;
        const double weight[3] = {1 - at->x - at->y, at->x, at->y};
        SurfaceHit hit{glm::dvec3(0), glm::dvec3(0), {}, {}};
        glm::dvec2 uv[3];
        for (std::size_t i = 0; i < 3; ++i) {
            uv[i] = {double(mesh_.u[vertex_[i]]), double(mesh_.v[vertex_[i]])};
            hit.position += corner_[i] * weight[i];
            hit.normal += surface_.vertex_normal(vertex_[i]) * weight[i];
            hit.texcoord += uv[i] * weight[i];
        }
        const double length = glm::length(hit.normal);
        hit.normal = length > 1e-6 ? hit.normal / length : surface_.face_normal(face_);
        for (int k = 0; k < 2; ++k)
            hit.texcoord_per_pixel[k] =
                (uv[1] - uv[0]) * inverse[k].x + (uv[2] - uv[0]) * inverse[k].y;
        return hit;
    }

    /// Newton's method may find another place that the ray meets: the one meant is near the
    /// triangle and seen from the same side.
    bool stays(const PixelRay& ray, const SurfaceHit& from, const SurfaceHit& to) const {
        const double size =
            std::max(glm::distance(corner_[0], corner_[1]), glm::distance(corner_[0], corner_[2]));
        const bool to_back = glm::dot(to.normal, ray.towards_eye(to.position)) < 0;
        return glm::distance(from.position, to.position) < 2 * size && to_back == back(ray);
    }

    std::size_t object_, face_ = 0;
    const Mesh& mesh_;
    const ObjectSurface& surface_;
    const glm::dmat4& to_world_;
    std::array<std::uint32_t, 3> vertex_{};
    glm::dvec3 corner_[3];
};

std::array<float, 3> albedo_at(const Texture& texture, const SurfaceHit& hit) {
    const auto f = [](double x) { return static_cast<float>(x); };
    const glm::dvec2 &x = hit.texcoord_per_pixel[0], &y = hit.texcoord_per_pixel[1];
    return texture.sample(f(hit.texcoord.x), f(hit.texcoord.y), {f(x.x), f(x.y), f(y.x), f(y.y)});
}

/// Shades rows; of one thread.
class SmoothRows {
public:
    SmoothRows(const SmoothScene& in, Framebuffer& into)
        : in_(in), into_(into), batches_(in.plan.materials.size()) {
        for (std::size_t m = 0; m < batches_.size(); ++m)
            batches_[m].textured = in.scene.materials[m].map_kd != nullptr;
    }

    void shade(int y) {
        for (int x = 0; x < in_.plan.width; ++x)
            if (into_.id[into_.index(x, y)] != Framebuffer::no_triangle) push(x, y);
        for (std::size_t m = 0; m < batches_.size(); ++m) finish(m);
    }

    SmoothCounts counts;

private:
    void push(int x, int y) {
        const std::size_t at = into_.index(x, y);
        const SeenTriangle triangle(in_, into_.id[at]);
        const PixelRay ray(in_.view, x + 0.5, y + 0.5);
        const auto hit = triangle.hit(ray, counts);
        if (!hit) return;  // keeps what the renderer has drawn there
        const double side = triangle.back(ray) ? -1 : 1;
        Batch<double>& batch = batches_[triangle.material];
        batch.push(to_vec3<double>(hit->position), to_vec3<double>(hit->normal * side), at);
        if (batch.textured)
            batch.push_albedo(albedo_at(*in_.scene.materials[triangle.material].map_kd, *hit));
    }

    void finish(std::size_t m) {
        Batch<double>& batch = batches_[m];
        const ResolvedMaterial& material = in_.plan.materials[m];
        batch.illuminate(material, in_.lighting.of(material), ignored_);
        std::vector<float>* const planes[] = {&into_.r, &into_.g, &into_.b};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < batch.size(); ++i)
                (*planes[c])[batch.target[i]] = static_cast<float>(batch.radiance[c][i]);
        batch.clear();
    }

    const SmoothScene& in_;
    Framebuffer& into_;
    std::vector<Batch<double>> batches_;  // [material]
    EventCounts ignored_;                 // those of the renderer are counted when it draws
};

}  // namespace

SmoothCounts draw_smooth(const Scene& scene, const Settings& settings, Framebuffer& into) {
    Settings plain = settings;
    plain.renderer = RendererKind::simd;
    plain.shading = Shading::phong;
    plain.given.insert("shading");
    plain.interpolation = Interpolation::perspective;
    plain.samples = 1;
    Renderer renderer(scene, plain);
    renderer.draw(into);
    const Scene normal = normalised(scene);
    const SmoothScene in(normal, renderer.plan());
    const int threads = settings.threads == 0 ? available_threads() : settings.threads;
    std::vector<SmoothRows> rows(std::size_t(threads), SmoothRows(in, into));
    parallel_for(std::size_t(settings.height), 4, threads,
                 [&](std::size_t begin, std::size_t end, int worker) {
                     for (std::size_t y = begin; y < end; ++y)
                         rows[std::size_t(worker)].shade(int(y));
                 });
    SmoothCounts counts;
    for (const SmoothRows& each : rows) {
        counts.exact += each.counts.exact;
        counts.meshes += each.counts.meshes;
        counts.unrefined += each.counts.unrefined;
    }
    return counts;
}

}  // namespace scanshade
