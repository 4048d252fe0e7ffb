// The vector renderer: draws tile by tile with the kernels of src/kernels.
#pragma once

#include <memory>

#include "kernels/engine_data.hpp"
#include "render/frame.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {

class Engine {
public:
    /// Keeps clusters and normals; the scene and the plan stay where they are.
    Engine(const Scene& normalised_scene, const RenderPlan& plan);
    ~Engine();

    /// Draws frame.sample of every pixel into the picture: radiance is added, bytes and ids are
    /// written. Counts into the frame's events and `stats`, whose stages are those of
    /// engine_stage_names, and returns how many samples show a surface.
    std::uint64_t draw(Frame& frame, const PictureView& picture, FrameStats& stats);

private:
    class Pass;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace scanshade
