// The state of one picture on its way through the stages.
#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "kernels/engine_data.hpp"
#include "render/transform.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/kernels/span.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {

/// Light at the corners (Gouraud) or in the middle (flat) of visible faces, one object's. A key is
/// made of the material, the side and the number of the vertex or face.
template <class T>
struct LitPoints {
    std::vector<std::uint64_t> key;  // ascending
    std::vector<T> radiance[3];      // [key]
    std::vector<T> unreflecting[3];  // [key] with albedo 0; empty where nothing is textured
};

/// Seen faces of a frame that `edges` or `patch` could not carry as it would, by their first triangle
/// in the scene: tiles, threads and sample positions see the same ones, and each counts once.
using Fallbacks = std::unordered_set<std::uint32_t>;

class Engine;

/// What a stage reads and writes.
struct Frame {
    Frame(const Scene& normalised_scene, const RenderPlan& render_plan, Framebuffer& into);

    const Scene& scene;  // normalised
    const RenderPlan& plan;
    View view;
    Lighting<double> lighting, unlit;  // the second: what an unlit material sees

    std::vector<ObjectView> object_views;            // [object]
    std::vector<std::vector<VertexState>> vertices;  // [object][vertex]; empty: made when asked

    // one sample a pixel, for the sample of this pass
    SampleOffset sample;
    bool first_sample = true;
    std::vector<float> depth;       // 0: nothing there
    std::vector<std::uint32_t> id;  // Framebuffer::no_triangle: none
    const Mask* only = nullptr;     // scalar: nothing is visible elsewhere

    std::vector<LitPoints<float>> lit_f32;  // [object]
    std::vector<LitPoints<double>> lit_f64;

    VertexState vertex(std::size_t object, std::uint32_t v) const {
        if (vertices.empty())
            return transform_vertex(*scene.objects[object].mesh, v, object_views[object], view);
        return vertices[object][v];
    }

    // the vector renderer's
    Engine* engine = nullptr;
    PictureView picture{};
    PlanSavings saved;
    std::uint64_t tolerated_lights = 0;

    Framebuffer& target;
    EventCounts events;
    std::uint64_t items = 0;  // what the running stage worked on

    void count(const Fallbacks& seen) {
        const bool edges = plan.interpolation == Interpolation::edges;
        for (const std::uint32_t face : seen)
            if (fallbacks.insert(face).second)
                events.add(edges ? Event::edges_fallback : Event::patch_fallback);
    }
    Fallbacks fallbacks;
};

/// Fills frame.vertices.
void transform_vertices(Frame& frame);

/// The object that a triangle of the whole scene belongs to. O(log objects).
std::size_t object_of(const RenderPlan& plan, std::uint32_t triangle);

}  // namespace scanshade
