// Visits what is seen at each pixel, for pictures of how it came about.
#pragma once

#include <vector>

#include "render/face_values.hpp"
#include "scanshade/render/debug_view.hpp"

namespace scanshade {

/// As pictures keep it.
inline std::uint32_t opaque(const Rgb8& c) {
    return 0xff000000u | std::uint32_t(c[2]) << 16 | std::uint32_t(c[1]) << 8 | c[0];
}

class DebugPass {
public:
    /// `carry_normals`: corners have normals whatever the shading.
    DebugPass(const Scene& scene, const Settings& settings, bool carry_normals);

    int width() const { return plan_.width; }
    int height() const { return plan_.height; }

    /// Faces that cover each pixel.
    std::vector<double> coverage();

    /// normals, barycentrics, triangles or plan.
    DebugPicture draw(DebugView view);

private:
    Rgb8 colour(DebugView view, FaceValues<float>& face, int x, int y) const;
    Rgb8 normal_colour(FaceValues<float>& face, const Place<float>& at) const;
    DebugPicture draw_plan();

    Scene scene_;  // normalised
    RenderPlan plan_;
    std::vector<Shading> shading_;  // [object] as the settings have it
    Framebuffer target_;
    Frame frame_;
    std::vector<ObjectSurface> surfaces_;
};

}  // namespace scanshade
