// The vector renderer: draws tile by tile with the kernels of src/kernels.
#pragma once

#include <memory>

#include "render/frame.hpp"

namespace scanshade {

/// Keeps clusters, normals and memory from frame to frame. Its stages run in the order of the table,
/// once for each sample of the pixels; frame.picture says what is written.
class Engine {
public:
    /// The scene and the plan stay where they are.
    Engine(const Scene& normalised_scene, const RenderPlan& plan);
    ~Engine();

    /// Clusters to batches of triangles and lists a tile.
    void set_up(Frame& frame);
    /// What set-up left over to records.
    void make_records(Frame& frame);
    /// Visibility of all tiles at once.
    void raster(Frame& frame);
    /// Light at the vertices and faces that raster has shown.
    void light_points(Frame& frame);
    /// Radiance of every sample; each tile's visibility first, where raster did not run.
    void shade(Frame& frame);
    /// Background in tiles that nothing touches.
    void draw_background(Frame& frame);

private:
    class Pass;
    struct State;
    std::unique_ptr<State> state_;
    std::unique_ptr<Pass> pass_;  // the sample at hand
};

}  // namespace scanshade
