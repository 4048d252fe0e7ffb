// Chooses how a picture is drawn: by the error that is allowed, or by the time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// A way to draw a picture, always with interpolation in perspective and the samples that the
/// settings ask for.
struct Method {
    std::string_view name;  // for people and for JSON
    Shading shading;
    RendererKind renderer;
};

/// In the order of quality, the best first: that is the reference, scalar-f64 with Phong shading.
std::span<const Method> all_methods();

/// The settings with the method's choices, also for objects that have a shading of their own.
Settings settings_of(const Method& method, Settings settings);

/// What was found out about a method, as far as it was needed.
struct Candidate {
    const Method* method;
    double predicted_ms;                    // a frame, from a calibration
    std::optional<std::size_t> off = {};    // checked pixels off by more than the limit
    std::optional<double> slowest_ms = {};  // of trial frames
};

struct Choice {
    std::string_view option;  // "max-error" or "budget-ms"
    double limit;             // its value
    const Method* method;
    bool fits = true;  // else it is the cheapest there is, and slower than the budget
    std::vector<std::string> sentences = {};  // what was chosen, and why nothing better or cheaper
    std::vector<Candidate> candidates = {};   // in the order in which they were considered
    double calibration_ms = 0;                // spent on choosing: on measuring the methods,
    double trial_ms = 0;                      // and on drawing with them and checking
    std::size_t covered = 0, checked = 0, allowed = 0;  // pixels, where errors were checked
};

/// Told what is done now.
using Tell = std::function<void(const std::string&)>;

/// The cheapest method that shows at most 0.1 % of the covered pixels (those with an id) off by more
/// than `levels` of 255 in any channel, against the reference: bytes against bytes. Candidates are
/// drawn in the order of their predicted times, and 8192 random covered pixels are compared with the
/// reference; none of them may be off, which proves the promise with 99.9 % confidence. Where no
/// method is left it is the reference itself. A picture with no more covered pixels than that is
/// checked whole.
Choice choose_by_error(const Scene& scene, const Settings& settings, double levels,
                       const Tell& tell);

/// The best method whose frames are predicted to take at most `budget_ms`, from a calibration at a
/// sixteenth of the pixels, and whose trial frames do. Where there is none it is the cheapest.
Choice choose_by_time(const Scene& scene, const Settings& settings, double budget_ms,
                      const Tell& tell);

}  // namespace scanshade
