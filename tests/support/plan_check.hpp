// What the plan leaves out, whole and row by row, against a picture with nothing left out.
#pragma once

#include <string>

#include "support/pictures.hpp"
#include "support/same_picture.hpp"

namespace scanshade {

/// The settings with one row of the plan asked for, or all but that one.
inline Settings keeping(const Settings& settings, PlanRow row, bool all_others) {
    Settings out = settings;
    out.kept_rows.clear();
    for (const PlanRowInfo& info : all_plan_rows())
        if ((info.row == row) != all_others) out.kept_rows.insert(std::string(info.name));
    return out;
}

/// The first difference in bits between a picture without a plan and those with it: whole, without
/// one row, with one row alone; and as bytes, in its second frame. "" if there is none. Adds to `saved` what the rows saved.
inline std::string plan_difference(const Scene& scene, const Settings& settings,
                                   PlanSavings& saved) {
    Settings without = settings;
    without.no_plan = true;
    const Framebuffer all = draw(scene, without).frame;
    const auto compare = [&](const Drawn& drawn, const std::string& what) {
        const std::string found = difference(drawn.frame, all);
        return found.empty() ? found : what + ": " + found;
    };
    const Drawn planned = draw(scene, settings);
    saved += planned.stats.saved;
    std::string found = compare(planned, "the plan");
    const RenderPlan plan = Renderer(scene, settings).plan();
    for (const PlanRowInfo& info : all_plan_rows()) {
        if (!plan.leaves_out(info.row)) continue;  // asking for it changes no plan
        const std::string name(info.name);
        if (found.empty())
            found = compare(draw(scene, keeping(settings, info.row, false)), "all but " + name);
        if (found.empty())
            found = compare(draw(scene, keeping(settings, info.row, true)), name + " alone");
    }
    // Bytes, over those of the frame before.
    Renderer renderer(scene, settings);
    PixelBuffer bytes, expected(settings.width, settings.height);
    renderer.draw(bytes);
    saved += renderer.draw(bytes).saved;
    encode(all, settings.transfer, settings.exposure_ev, expected);
    if (found.empty() && bytes.rgba() != expected.rgba()) found = "the plan: the bytes differ";
    return found;
}

}  // namespace scanshade
