#include "scanshade/render/inspect.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "render/lit_values.hpp"
#include "render/stages.hpp"
#include "scanshade/base/error.hpp"

namespace scanshade {
namespace {

template <class T>
std::array<T, 3> plain(const Vec3<T>& v) {
    return {v.x, v.y, v.z};
}
template <class T>
std::array<T, 3> plain(const Rgb<T>& v) {
    return {v.r, v.g, v.b};
}
template <class T>
Vec3<T> as_vec3(const Rgb<T>& v) {
    return {v.r, v.g, v.b};
}

/// What the scalar renderer in T computes at the samples of one pixel.
template <class T>
class PixelWitness {
public:
    PixelWitness(Frame& frame, Inspection& into)
        : frame_(frame),
          into_(into),
          surfaces_(frame.scene.objects.begin(), frame.scene.objects.end()),
          lighting_(lighting_of<T>(frame)),
          face_(frame, surfaces_, ignored_) {}

    /// After the stages of a sample have run.
    void take_sample(std::size_t number) {
        if (number == into_.samples.size()) into_.samples.push_back(describe());
        InspectedSample& sample = into_.samples[number];
        if (!sample.covered) return;
        face_.begin(sample.triangle);
        if constexpr (std::is_same_v<T, float>)
            sample.f32 = numbers(sample);
        else
            sample.f64 = numbers(sample);
    }

private:
    SnappedPoint point() const { return sample_point(into_.x, into_.y, frame_.sample); }

    InspectedSample describe() {
        InspectedSample out{};
        const SnappedPoint p = point();
        const std::size_t at = frame_.target.index(into_.x, into_.y);
        out.x = double(p.x) / subpixels, out.y = double(p.y) / subpixels;
        out.triangle = frame_.id[at];
        out.depth = frame_.depth[at];
        out.covered = out.triangle != Framebuffer::no_triangle;
        if (!out.covered) return out;
        face_.begin(out.triangle);
        const DrawnFace& drawn = face_.drawn;
        out.object = drawn.object, out.face = drawn.face;
        out.object_name = frame_.scene.objects[drawn.object].mesh->name;
        out.material_name = frame_.scene.materials[face_.material].name;
        const ResolvedMaterial& material = frame_.plan.materials[face_.material];
        out.brdf = material.unlit ? "unlit" : material.brdf->name;
        out.shading = face_.shading;
        out.back = drawn.back;
        out.textured = face_.texture != nullptr;
        out.clipped = drawn.carrier == Carrier::clipped;
        const std::size_t first = first_corner(face_.place(p));
        for (std::size_t i = first; i < first + corner_count(first); ++i)
            out.corners.push_back(corner(face_.vertex[i]));
        return out;
    }

    // The corners of a patch stand behind those of the triangle that it can fall back to.
    std::size_t first_corner(const Place<T>& at) const {
        return at.kind == Place<T>::Kind::patch ? face_.drawn.vertex.size() : 0;
    }
    std::size_t corner_count(std::size_t first) const {
        return first > 0 ? 4 : face_.drawn.vertex.size();
    }

    InspectedCorner corner(std::uint32_t vertex) const {
        const VertexState state = frame_.vertex(face_.drawn.object, vertex);
        const bool between = (state.outcode & out_depth) == 0;
        const PictureCorner c = between ? picture_corner(frame_.view, state) : PictureCorner{0, 0};
        return {vertex, c.x / subpixels, c.y / subpixels, between};
    }

    SampleNumbers<T> numbers(const InspectedSample& sample) {
        SampleNumbers<T> out{};
        const SnappedPoint p = point();
        const Place<T> at = face_.place(p);
        out.travel = static_cast<Travel>(at.kind);
        if (out.travel == Travel::weights) out.weight.assign(at.weight, at.weight + 3);
        out.u = at.u, out.v = at.v;
        const std::array<float, 3> albedo = face_.albedo(at, p);
        if (face_.shading == Shading::phong) {
            fill_phong(at, albedo, out);
            return out;
        }
        if (face_.radiance.empty()) load_lit(frame_, face_);
        out.radiance = plain(face_.lit(at, albedo));
        const std::size_t first = first_corner(at);
        if (face_.shading == Shading::flat) {
            out.lit.push_back(lit_report(face_.drawn.face));
            out.carried = plain(face_.lit(at));
            return out;
        }
        std::vector<Vec3<T>> light;
        for (const Rgb<T>& L : face_.radiance) light.push_back(as_vec3(L));
        for (std::size_t i = first; i < first + sample.corners.size(); ++i)
            out.lit.push_back(lit_report(face_.vertex[i]));
        fill_corners(at, light, out);
        out.carried = plain(face_.lit(at));
        return out;
    }

    void fill_phong(const Place<T>& at, const std::array<float, 3>& albedo, SampleNumbers<T>& out) {
        fill_corners(at, face_.corner_normals(), out);
        const Vec3<T> n = face_.normal(at);
        out.carried = plain(n);
        Batch<T> batch;
        batch.push(face_.position(at), n, 0);
        batch.textured = face_.texture != nullptr;
        if (batch.textured) batch.push_albedo(albedo);
        out.lit.push_back(report(batch));
        const T(&L)[3] = out.lit[0].radiance;
        out.radiance = {L[0], L[1], L[2]};
    }

    /// Values at the corners, and where the sample's row crosses the edges.
    void fill_corners(const Place<T>& at, const std::vector<Vec3<T>>& value,
                      SampleNumbers<T>& out) const {
        const std::size_t first = first_corner(at), count = corner_count(first);
        for (std::size_t i = first; i < first + count; ++i) out.corner.push_back(plain(value[i]));
        const SnappedPoint p = point();
        if (out.travel == Travel::scanline) out.scanline = crossings(at, p, value.data());
        if (out.travel == Travel::weights && face_.drawn.carrier == Carrier::triangle)
            out.scanline = triangle_crossings(p, value.data());
    }

    /// (C3), (C5) along the two edges.
    Scanline<T> crossings(const Place<T>& at, SnappedPoint p, const Vec3<T>* value) const {
        const auto pixel = [&](T from_sample) { return (T(p.x) + from_sample) / T(subpixels); };
        return {at.a,
                at.b,
                at.c,
                at.d,
                pixel(at.ab_x),
                pixel(at.cd_x),
                plain(along_edge(value[at.a], value[at.b], at.a_y, at.b_y, at.y)),
                plain(along_edge(value[at.c], value[at.d], at.c_y, at.d_y, at.y))};
    }

    /// The same on a triangle, whose values travel by weights: what they are where the row crosses the
    /// edges. In perspective that is (C3) of value/w over (C3) of 1/w, and depth is near/w.
    Scanline<T> triangle_crossings(SnappedPoint p, const Vec3<T>* value) const {
        PictureCorner corner[3];
        Vec3<T> scaled[3];
        T scale[3];
        const bool affine =
            frame_.view.orthographic || frame_.plan.interpolation == Interpolation::edges;
        for (int i = 0; i < 3; ++i) {
            corner[i] = picture_corner(frame_.view, face_.drawn.state[std::size_t(i)]);
            scale[i] = affine ? T(1) : T(face_.drawn.state[std::size_t(i)].depth);
            scaled[i] = value[i] * scale[i];
        }
        const Place<T> at = polygon_place<T>(corner, p);
        Scanline<T> out = crossings(at, p, scaled);
        if (affine) return out;
        const T ab = along_edge(scale[at.a], scale[at.b], at.a_y, at.b_y, at.y);
        const T cd = along_edge(scale[at.c], scale[at.d], at.c_y, at.d_y, at.y);
        for (std::size_t i = 0; i < 3; ++i) out.ab[i] /= ab, out.cd[i] /= cd;
        return out;
    }

    PointReport<T> lit_report(std::uint64_t number) {
        const ObjectSurface& surface = surfaces_[face_.drawn.object];
        Batch<T> batch;
        push_lit_point(batch, surface, face_.shading,
                       lit_key(face_.material, face_.drawn.back, number), 0);
        return report(batch);
    }

    PointReport<T> report(Batch<T>& batch) {
        const ResolvedMaterial& material = frame_.plan.materials[face_.material];
        return batch.report(material, lighting_.of(material));
    }

    Frame& frame_;
    Inspection& into_;
    std::vector<ObjectSurface> surfaces_;
    LightingPair<T> lighting_;
    EventCounts ignored_;  // the stages count them
    FaceValues<T> face_;
};

template <class T>
void inspect_in(const Scene& normalised_scene, const Settings& settings, Inspection& into,
                std::array<float, 3>& radiance, std::array<std::uint8_t, 3>& bytes) {
    Settings scalar = settings;
    scalar.renderer =
        std::is_same_v<T, float> ? RendererKind::scalar_f32 : RendererKind::scalar_f64;
    const RenderPlan plan = make_plan(normalised_scene, scalar);
    Framebuffer target(plan.width, plan.height);
    Frame frame(normalised_scene, plan, target);
    Mask only(plan.width, plan.height);
    only.inside[target.index(into.x, into.y)] = 1;
    frame.only = &only;
    PixelWitness<T> witness(frame, into);
    FrameStats stats;
    std::size_t sample = 0;
    run_stages(frame, stats, [&] { witness.take_sample(sample++); });

    const std::size_t at = target.index(into.x, into.y);
    radiance = {target.r[at], target.g[at], target.b[at]};
    Framebuffer pixel(1, 1);
    pixel.r[0] = radiance[0], pixel.g[0] = radiance[1], pixel.b[0] = radiance[2];
    const Image encoded = encode(pixel, plan.transfer, plan.exposure_ev);
    std::copy(encoded.rgb.begin(), encoded.rgb.end(), bytes.begin());
}

}  // namespace

Inspection inspect_pixel(const Scene& scene, const Settings& settings, int x, int y) {
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height)
        throw Error(Errc::usage,
                    fmt::format("pixel {},{} is outside the picture; x goes from 0 to {}, y from 0 "
                                "to {}",
                                x, y, settings.width - 1, settings.height - 1));
    Inspection out{};
    out.x = x, out.y = y, out.width = settings.width, out.height = settings.height;
    out.interpolation = settings.interpolation;
    out.lights = scene.lights;
    const Normalisation to = normalisation(scene);
    out.origin = to.origin, out.unit = to.unit;
    const Scene normal = normalised(scene);
    inspect_in<float>(normal, settings, out, out.radiance32, out.byte32);
    inspect_in<double>(normal, settings, out, out.radiance64, out.byte64);
    return out;
}

}  // namespace scanshade
