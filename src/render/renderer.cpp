#include "scanshade/render/renderer.hpp"

#include <algorithm>

#include "render/lighting.hpp"
#include "render/stages.hpp"
#include "scanshade/base/timer.hpp"

namespace scanshade {

struct Renderer::State {
    Scene scene;  // normalised
    RenderPlan plan;
};

Renderer::Renderer(const Scene& scene, const Settings& settings)
    : state_(std::make_unique<State>()) {
    state_->scene = normalised(scene);
    state_->plan = make_plan(state_->scene, settings);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const RenderPlan& Renderer::plan() const { return state_->plan; }

namespace {

/// Sample (i, j) of a regular grid of side × side in a pixel, to the nearest 1/256.
SampleOffset grid_sample(int i, int j, int side) {
    const auto at = [side](int k) { return (2 * k + 1) * subpixels / (2 * side); };
    return {at(i), at(j)};
}

void run_stage(std::size_t number, Frame& frame, FrameStats& stats) {
    const Stage& stage = all_stages()[number];
    if (!stage.needed(frame.plan)) return;
    StageStats& row = stats.stages[number];
    frame.items = 0;
    const Timer timer;
    stage.run(frame);
    row.ms += timer.ms();
    row.ran = true;
    row.items += frame.items;
}

/// The stages between `transform` and `average` once for every sample, in rows of samples.
void run_stages(Frame& frame, FrameStats& stats) {
    const auto stages = all_stages();
    const auto is_each = [](const Stage& stage) { return stage.each_sample; };
    const auto first = std::find_if(stages.begin(), stages.end(), is_each);
    const auto last = std::find_if_not(first, stages.end(), is_each);
    const auto run = [&](auto from, auto to) {
        for (auto stage = from; stage != to; ++stage)
            run_stage(static_cast<std::size_t>(stage - stages.begin()), frame, stats);
    };
    run(stages.begin(), first);
    const int side = frame.plan.samples_side;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            frame.sample = grid_sample(i, j, side);
            run(first, last);
            stats.covered_samples += static_cast<std::uint64_t>(
                std::count_if(frame.id.begin(), frame.id.end(),
                              [](std::uint32_t id) { return id != Framebuffer::no_triangle; }));
            if (i > 0 || j > 0) continue;
            frame.target.depth = frame.depth;
            frame.target.id = frame.id;
        }
    run(last, stages.end());
}

}  // namespace

FrameStats Renderer::draw(Framebuffer& target) {
    const RenderPlan& plan = state_->plan;
    if (target.width != plan.width || target.height != plan.height)
        target = Framebuffer(plan.width, plan.height);
    for (std::vector<float>* channel : {&target.r, &target.g, &target.b})
        std::fill(channel->begin(), channel->end(), 0.0f);

    FrameStats stats;
    for (const Stage& stage : all_stages())
        stats.stages.push_back({stage.name, false, 0, 0, stage.item_name});
    const Timer timer;
    Frame frame(state_->scene, plan, target);
    run_stages(frame, stats);
    stats.frame_ms = timer.ms();
    stats.events = frame.events;
    return stats;
}

Image render_image(const Scene& scene, const Settings& settings) {
    Framebuffer frame;
    Renderer(scene, settings).draw(frame);
    return encode(frame, settings.transfer, settings.exposure_ev);
}

}  // namespace scanshade
