#include "report/calibration.hpp"

#include <algorithm>
#include <functional>

#include "scanshade/report/subject.hpp"

namespace scanshade {
namespace {

constexpr int shrink = 4;  // of each side

bool grows_with_pixels(const StageStats& stage) {
    return stage.item_name == "samples" || stage.item_name == "pixels" ||
           stage.item_name == "tiles";
}

/// `ratio` is how many pixels the real frame has for one of this.
double predicted(const FrameStats& frame, double ratio) {
    double fixed = 0;
    for (const StageStats& stage : frame.stages)
        if (!grows_with_pixels(stage)) fixed += stage.ms;
    return fixed + ratio * std::max(frame.frame_ms - fixed, 0.0);
}

}  // namespace

std::vector<double> predict_ms(const Scene& scene, const Settings& settings,
                               std::span<const Method* const> methods) {
    Settings small = settings;
    small.width = (settings.width + shrink - 1) / shrink;
    small.height = (settings.height + shrink - 1) / shrink;
    const double ratio = double(settings.width) * settings.height / small.width / small.height;

    std::vector<PixelBuffer> pixels(methods.size());
    std::vector<std::function<FrameStats()>> subjects;
    for (std::size_t m = 0; m < methods.size(); ++m)
        subjects.push_back([drawing = make_drawing(scene, settings_of(*methods[m], small)),
                            &buffer = pixels[m]] { return drawing.pixels(buffer); });
    const Rounds rounds{1, 5, 1};
    std::vector<double> result;
    for (const auto& frames : time_interleaved(subjects, rounds, [] { return false; })) {
        const auto ms =
            of_frames(frames, [ratio](const FrameStats& frame) { return predicted(frame, ratio); });
        // What else runs on the machine only makes frames slower.
        result.push_back(*std::min_element(ms.begin(), ms.end()));
    }
    return result;
}

}  // namespace scanshade
