// Draws a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "scanshade/base/events.hpp"
#include "scanshade/image/framebuffer.hpp"
#include "scanshade/image/mask.hpp"
#include "scanshade/render/plan.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

struct StageStats {
    std::string_view name;
    bool ran = false;
    double ms = 0;               // all samples together
    std::uint64_t items = 0;     // what the stage worked on
    std::string_view item_name;  // "triangles", "samples", ...
};

struct FrameStats {
    double frame_ms = 0;
    std::vector<StageStats> stages;  // in the order in which they run
    EventCounts events;              // of this frame
    std::uint64_t covered_samples = 0;
    std::uint64_t tolerated_lights = 0;  // left out of tiles under --tolerance
    PlanSavings saved;                   // what each row of the plan did without
};

/// Draws one scene, with its camera and one set of settings, any number of times. Holds copies of
/// what it needs; a renderer is used by one thread at a time, several renderers by several.
class Renderer {
public:
    /// Normalises the scene and makes the plan. Throws Error for what cannot be drawn. Where the
    /// settings name an instruction set, all kernels of this process use it from now on.
    Renderer(const Scene& scene, const Settings& settings);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const RenderPlan& plan() const;

    /// Draws a frame from the scene's arrays into `frame`, which gets the plan's size. With
    /// several samples a pixel, colour is their mean, depth and id are those of the first sample.
    FrameStats draw(Framebuffer& frame);

    /// Draws these pixels alone, to the same bits; the others show the background. Only for the
    /// scalar renderers, for which shading is dear.
    FrameStats draw(Framebuffer& frame, const Mask& only);

    /// Draws a frame into bytes, encoded as the settings say. The simd renderer writes them at once
    /// and nothing else; they are the bytes of encode(Framebuffer).
    FrameStats draw(PixelBuffer& pixels);

private:
    FrameStats draw_planes(Framebuffer& frame, const Mask* only);

    struct State;
    std::unique_ptr<State> state_;
};

/// Draws once and encodes as the settings say.
Image render_image(const Scene& scene, const Settings& settings);

}  // namespace scanshade
