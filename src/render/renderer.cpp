#include "scanshade/render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/engine.hpp"
#include "render/lighting.hpp"
#include "render/stages.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/timer.hpp"
#include "scanshade/kernels/isa.hpp"

namespace scanshade {

struct Renderer::State {
    Scene scene;  // normalised
    RenderPlan plan;
    std::unique_ptr<Engine> engine;  // simd
    Framebuffer planes;              // of draw(PixelBuffer&), where bytes are not written at once
};

Renderer::Renderer(const Scene& scene, const Settings& settings)
    : state_(std::make_unique<State>()) {
    state_->scene = normalised(scene);
    state_->plan = make_plan(state_->scene, settings);
    if (!settings.isa.empty()) use_instruction_set(settings.isa);
    if (state_->plan.renderer == RendererKind::simd)
        state_->engine = std::make_unique<Engine>(state_->scene, state_->plan);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const RenderPlan& Renderer::plan() const { return state_->plan; }

namespace {

std::uint32_t background_bytes(const RenderPlan& plan) {
    Framebuffer pixel(1, 1);
    pixel.r[0] = plan.background[0], pixel.g[0] = plan.background[1],
    pixel.b[0] = plan.background[2];
    const Image image = encode(pixel, plan.transfer, plan.exposure_ev);
    std::uint32_t rgba = 0xff000000u;
    std::memcpy(&rgba, image.rgb.data(), 3);
    return rgba;
}

PictureView picture_view(const RenderPlan& plan) {
    PictureView view{};
    view.width = plan.width, view.height = plan.height;
    view.scale = static_cast<float>(std::exp2(plan.exposure_ev));
    view.srgb = plan.transfer == Transfer::srgb;
    view.srgb_start = srgb_byte_starts().data();
    std::copy(plan.background.begin(), plan.background.end(), view.background);
    view.background_rgba = background_bytes(plan);
    return view;
}

}  // namespace

FrameStats Renderer::draw(Framebuffer& frame) { return draw_planes(frame, nullptr); }

FrameStats Renderer::draw(Framebuffer& frame, const Mask& only) {
    SCANSHADE_CHECK(state_->plan.renderer != RendererKind::simd);
    SCANSHADE_CHECK(only.width == state_->plan.width && only.height == state_->plan.height);
    return draw_planes(frame, &only);
}

FrameStats Renderer::draw_planes(Framebuffer& target, const Mask* only) {
    const RenderPlan& plan = state_->plan;
    if (target.width != plan.width || target.height != plan.height)
        target = Framebuffer(plan.width, plan.height);
    for (std::vector<float>* channel : {&target.r, &target.g, &target.b})
        std::fill(channel->begin(), channel->end(), 0.0f);

    FrameStats stats;
    const Timer timer;
    Frame frame(state_->scene, plan, target);
    frame.only = only;
    frame.engine = state_->engine.get();
    frame.picture = picture_view(plan);
    frame.picture.r = target.r.data();
    frame.picture.g = target.g.data();
    frame.picture.b = target.b.data();
    frame.picture.depth = target.depth.data();
    frame.picture.id = target.id.data();
    run_stages(frame, stats);
    stats.frame_ms = timer.ms();
    return stats;
}

FrameStats Renderer::draw(PixelBuffer& pixels) {
    const RenderPlan& plan = state_->plan;
    if (pixels.width != plan.width || pixels.height != plan.height)
        pixels = PixelBuffer(plan.width, plan.height);
    FrameStats stats;
    const Timer timer;
    if (state_->engine && plan.samples_side == 1) {
        Framebuffer none;
        Frame frame(state_->scene, plan, none);
        frame.engine = state_->engine.get();
        frame.picture = picture_view(plan);
        const PixelBuffer::Blanks over = pixels.draw_over(frame.picture.background_rgba);
        frame.picture.rgba = over.rgba;
        if (plan.leaves_out(PlanRow::unchanged_background))
            frame.picture.blank = over.blank;
        else
            pixels.edit();
        run_stages(frame, stats);
    } else {
        stats = draw(state_->planes);
        encode(state_->planes, plan.transfer, plan.exposure_ev, pixels);
    }
    stats.frame_ms = timer.ms();
    return stats;
}

Image render_image(const Scene& scene, const Settings& settings) {
    PixelBuffer pixels;
    Renderer(scene, settings).draw(pixels);
    return to_image(pixels);
}

}  // namespace scanshade
