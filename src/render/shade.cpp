// Radiance at each visible sample.
#include "render/shade.hpp"

#include <algorithm>
#include <cmath>

#include "render/lit_values.hpp"

namespace scanshade {
namespace {

template <class T>
class SampleShader {
public:
    explicit SampleShader(Frame& frame)
        : frame_(frame),
          lighting_(lighting_of<T>(frame)),
          surfaces_(frame.scene.objects.begin(), frame.scene.objects.end()),
          batches_(frame.plan.materials.size()),
          face_(frame, surfaces_, frame.events) {
        for (std::size_t m = 0; m < batches_.size(); ++m)
            batches_[m].textured = frame.scene.materials[m].map_kd != nullptr;
    }

    void shade_row(int y) {
        const std::size_t row = frame_.target.index(0, y);
        for (int x = 0; x < frame_.view.width; ++x) {
            const std::size_t at = row + static_cast<std::size_t>(x);
            if (frame_.id[at] == Framebuffer::no_triangle) continue;
            if (face_.begin(frame_.id[at])) load_lit(frame_, face_);
            shade_sample(sample_point(x, y, frame_.sample), at);
            ++frame_.items;
        }
        for (std::size_t m = 0; m < batches_.size(); ++m) finish_batch(m);
    }

    const Fallbacks& fallbacks() const { return face_.fallbacks; }

private:
    void shade_sample(SnappedPoint p, std::size_t to) {
        const bool flat = face_.shading == Shading::flat;
        if (flat && face_.texture == nullptr) return add(to, face_.radiance[0]);
        const Place<T> at = face_.place(p);
        const std::array<float, 3> albedo = face_.albedo(at, p);
        if (face_.shading == Shading::phong) return push_phong(at, albedo, to);
        add(to, face_.lit(at, albedo));
    }

    void push_phong(const Place<T>& at, const std::array<float, 3>& albedo, std::size_t to) {
        Batch<T>& batch = batches_[face_.material];
        batch.push(face_.position(at), face_.normal(at), to);
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
    FaceValues<T> face_;
};

}  // namespace

template <class T>
void shade_samples(Frame& frame) {
    SampleShader<T> shader(frame);
    for (int y = 0; y < frame.view.height; ++y) shader.shade_row(y);
    frame.count(shader.fallbacks());
}

template void shade_samples<float>(Frame&);
template void shade_samples<double>(Frame&);

}  // namespace scanshade
