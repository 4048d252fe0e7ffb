#include "scanshade/report/choose.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/calibration.hpp"
#include "report/reference_check.hpp"
#include "scanshade/base/timer.hpp"
#include "scanshade/report/subject.hpp"

namespace scanshade {
namespace {

constexpr Method methods[] = {
    {"phong shading by scalar-f64", Shading::phong, RendererKind::scalar_f64},
    {"phong shading by simd", Shading::phong, RendererKind::simd},
    {"gouraud shading by simd", Shading::gouraud, RendererKind::simd},
    {"flat shading by simd", Shading::flat, RendererKind::simd},
};
constexpr const Method& reference = methods[0];

/// The approximations, each with its predicted time.
std::vector<Candidate> measured_approximations(const Scene& scene, const Settings& settings,
                                               Choice& choice, const Tell& tell) {
    tell("measuring methods");
    const Timer timer;
    std::vector<const Method*> all;
    for (const Method& method : methods)
        if (&method != &reference) all.push_back(&method);
    const std::vector<double> ms = predict_ms(scene, settings, all);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < all.size(); ++i) candidates.push_back({all[i], ms[i]});
    choice.calibration_ms = timer.ms();
    return candidates;
}

bool is_cheaper(const Candidate& a, const Candidate& b) { return a.predicted_ms < b.predicted_ms; }

std::string error_sentence(const Candidate& candidate, const Choice& choice) {
    return fmt::format(
        "{} {} (predicted {:.2f} ms a frame): {} of {} checked pixels are off by more, "
        "{} may be",
        choice.method == candidate.method ? "chose" : "rejected", candidate.method->name,
        candidate.predicted_ms, *candidate.off, choice.checked, choice.allowed);
}

std::string cost_sentence(const Choice& choice) {
    return fmt::format(
        "measuring took {:.1f} ms; drawing and checking {} of {} covered pixels, "
        "{:.1f} ms",
        choice.calibration_ms, choice.checked, choice.covered, choice.trial_ms);
}

}  // namespace

std::span<const Method> all_methods() { return methods; }

Settings settings_of(const Method& method, Settings settings) {
    settings.shading = method.shading;
    settings.given.insert("shading");  // stronger than what objects say
    settings.renderer = method.renderer;
    settings.interpolation = Interpolation::perspective;
    return settings;
}

Choice choose_by_error(const Scene& scene, const Settings& settings, double levels,
                       const Tell& tell) {
    Choice choice{"max-error", levels, &reference};
    std::vector<Candidate> candidates = measured_approximations(scene, settings, choice, tell);
    std::sort(candidates.begin(), candidates.end(), is_cheaper);

    const Timer timer;
    std::optional<ReferenceCheck> check;  // visibility is the same for all: one is enough
    for (Candidate& candidate : candidates) {
        tell(fmt::format("checking {}", candidate.method->name));
        Framebuffer frame;
        Renderer(scene, settings_of(*candidate.method, settings)).draw(frame);
        if (!check) check.emplace(scene, settings_of(reference, settings), frame);
        choice.covered = check->covered(), choice.checked = check->checked();
        choice.allowed = check->allowed();
        candidate.off = check->off(frame, levels);
        if (*candidate.off <= choice.allowed) choice.method = candidate.method;
        choice.sentences.push_back(error_sentence(candidate, choice));
        choice.candidates.push_back(candidate);
        if (choice.method == candidate.method) break;
    }
    choice.trial_ms = timer.ms();
    if (choice.method == &reference)
        choice.sentences.push_back(fmt::format("chose the reference, {}", reference.name));
    choice.sentences.push_back(cost_sentence(choice));
    return choice;
}

namespace {

/// The longest of some frames, after one that warms up: enough to see one in twenty that is late,
/// but not more than a second of them, nor any after one that is.
double slowest_frame(const Scene& scene, const Settings& settings, double budget_ms) {
    constexpr int most_frames = 20;
    constexpr double enough_ms = 1000;
    const Drawing drawing = make_drawing(scene, settings);
    PixelBuffer pixels;
    drawing.pixels(pixels);
    double slowest = 0;
    const Timer timer;
    for (int i = 0; i < most_frames && slowest <= budget_ms; ++i) {
        slowest = std::max(slowest, drawing.pixels(pixels).frame_ms);
        if (timer.ms() > enough_ms) break;
    }
    return slowest;
}

std::string time_sentence(const Candidate& candidate, bool chosen) {
    return fmt::format("{} {}: predicted {:.2f} ms a frame{}", chosen ? "chose" : "rejected",
                       candidate.method->name, candidate.predicted_ms,
                       candidate.slowest_ms
                           ? fmt::format(", slowest trial frame {:.2f} ms", *candidate.slowest_ms)
                           : "");
}

/// Draws trial frames where the prediction allows it.
bool keeps_budget(const Scene& scene, const Settings& settings, double budget_ms,
                  Candidate& candidate) {
    if (candidate.predicted_ms > budget_ms) return false;
    candidate.slowest_ms =
        slowest_frame(scene, settings_of(*candidate.method, settings), budget_ms);
    return *candidate.slowest_ms <= budget_ms;
}

}  // namespace

Choice choose_by_time(const Scene& scene, const Settings& settings, double budget_ms,
                      const Tell& tell) {
    Choice choice{"budget-ms", budget_ms, nullptr};
    std::vector<Candidate> candidates = measured_approximations(scene, settings, choice, tell);
    // The reference does no less work than Phong shading by vectors: often there is no need to try.
    if (candidates.front().predicted_ms <= budget_ms) {
        const Timer timer;
        const Method* const only[] = {&reference};
        candidates.insert(candidates.begin(), {&reference, predict_ms(scene, settings, only)[0]});
        choice.calibration_ms += timer.ms();
    }
    const Timer timer;
    for (Candidate& candidate : candidates) {
        tell(fmt::format("trying {}", candidate.method->name));
        const bool keeps = keeps_budget(scene, settings, budget_ms, candidate);
        choice.candidates.push_back(candidate);
        choice.sentences.push_back(time_sentence(candidate, keeps));
        if (!keeps) continue;
        choice.method = candidate.method;
        break;
    }
    choice.trial_ms = timer.ms();
    if (!choice.method) {
        choice.fits = false;
        choice.method = std::min_element(candidates.begin(), candidates.end(), is_cheaper)->method;
        choice.sentences.push_back(
            fmt::format("no method takes {:g} ms or less; chose {}, the "
                        "cheapest; fewer pixels or samples would be faster",
                        budget_ms, choice.method->name));
    }
    choice.sentences.push_back(fmt::format("measuring took {:.1f} ms, trial frames {:.1f} ms",
                                           choice.calibration_ms, choice.trial_ms));
    return choice;
}

}  // namespace scanshade
