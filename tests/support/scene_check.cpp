#include "support/scene_check.hpp"

#include <cmath>

#include "support/plan_check.hpp"

namespace scanshade {
namespace {

bool all_finite(const Framebuffer& frame) {
    for (const auto plane :
         {&Framebuffer::r, &Framebuffer::g, &Framebuffer::b, &Framebuffer::depth})
        for (const float value : frame.*plane)
            if (!std::isfinite(value)) return false;
    return true;
}

}  // namespace

std::string scene_fault(const RandomScene& random, SceneTotals& totals) {
    const std::string plan = plan_difference(random.scene, random.settings, totals.saved);
    if (!plan.empty()) return plan;
    Drawn drawn;
    for (const RendererKind twin : {RendererKind::scalar_f32, RendererKind::scalar_f64}) {
        const std::string found =
            scalar_difference(random.scene, random.settings, twin, drawn, totals.levels);
        if (!found.empty()) return found;
    }
    if (!all_finite(drawn.frame)) return "a value is not finite";
    PixelBuffer bytes;
    Renderer(random.scene, random.settings).draw(bytes);
    const Settings& s = random.settings;
    if (to_image(bytes).rgb != encode(drawn.frame, s.transfer, s.exposure_ev).rgb)
        return "bytes that are written at once differ from those of the float picture";
    return "";
}

}  // namespace scanshade
