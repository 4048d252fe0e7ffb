// The stages of a picture, as rows of one table.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "render/frame.hpp"

namespace scanshade {

struct Stage {
    std::string_view name;
    std::string_view item_name;  // what it works on
    bool each_sample;            // runs anew for each sample of a pixel
    bool (*needed)(const RenderPlan&);
    std::string (*reason)(const RenderPlan&);  // why it runs or not, with the counts
    void (*run)(Frame&);
};

/// Those of a renderer, in the order in which they run.
std::span<const Stage> stages_of(RendererKind renderer);

/// Runs those of the plan's renderer that are needed: those of each sample once for every sample, in
/// rows of samples; the others once, before or after. `after_sample` is called while the frame still
/// has what a sample's stages found.
void run_stages(Frame& frame, FrameStats& stats, const std::function<void()>& after_sample = {});

}  // namespace scanshade
