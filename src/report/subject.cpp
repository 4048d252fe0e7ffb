#include "scanshade/report/subject.hpp"

#include <memory>

namespace scanshade {

Drawing make_drawing(const Scene& scene, const Settings& settings) {
    const auto renderer = std::make_shared<Renderer>(scene, settings);
    return {[renderer](PixelBuffer& pixels) { return renderer->draw(pixels); },
            [renderer](Framebuffer& frame) { return renderer->draw(frame); }};
}

}  // namespace scanshade
