// What reports measure: scenes, and something that draws them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scanshade/render/renderer.hpp"
#include "scanshade/report/provenance.hpp"
#include "scanshade/report/timing.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// A scene and how it is drawn; the settings are those that load_scene() left.
struct ReportInput {
    Scene scene;
    Settings settings;
};

/// Draws frames of one scene.
struct Drawing {
    std::function<FrameStats(PixelBuffer&)> pixels;  // what is timed: all a picture needs
    std::function<FrameStats(Framebuffer&)> planes;  // the same picture before encoding
};

/// Prepares a drawing; everything but frames happens here.
using MakeDrawing = std::function<Drawing(const Scene&, const Settings&)>;

/// By a Renderer.
Drawing make_drawing(const Scene& scene, const Settings& settings);

}  // namespace scanshade
