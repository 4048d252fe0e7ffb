// The vector renderer on random scenes: what its plan leaves out changes no bit, and it shows what
// its scalar twin shows. `make soak` draws many more, on every instruction set.
#include <cstdlib>

#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/level_check.hpp"
#include "support/plan_check.hpp"
#include "support/random_scene.hpp"

using namespace scanshade;

namespace {

struct Totals {
    PlanSavings saved{};
    LevelCounts levels;
};

/// All checks of one scene; what is wrong, or "".
std::string check_scene(const RandomScene& random, Totals& totals) {
    const std::string plan = plan_difference(random.scene, random.settings, totals.saved);
    if (!plan.empty()) return plan;
    Drawn drawn;
    const std::string twin = scalar_difference(random.scene, random.settings,
                                               RendererKind::scalar_f32, drawn, totals.levels);
    if (!twin.empty()) return twin;
    PixelBuffer bytes;
    Renderer(random.scene, random.settings).draw(bytes);
    const Settings& s = random.settings;
    if (to_image(bytes).rgb != encode(drawn.frame, s.transfer, s.exposure_ev).rgb)
        return "bytes that are written at once differ from those of the float picture";
    return "";
}

/// Draws scenes [first, first + count) on one instruction set.
Totals check_scenes(std::uint64_t first, std::uint64_t count, const std::string& isa) {
    Totals totals;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        RandomScene random = make_random_scene(seed);
        random.settings.isa = isa;
        const std::string wrong = check_scene(random, totals);
        if (wrong.empty()) continue;
        CAPTURE(seed, isa, describe(random));
        CHECK(wrong == "");
    }
    use_instruction_set("");
    return totals;
}

std::string from_environment(const char* name, const char* otherwise) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : otherwise;
}

}  // namespace

TEST_CASE("random scenes: the plan changes no bit, and the scalar twin shows the same",
          "[engine][plan][random]") {
    const Totals totals = check_scenes(1, 1000, instruction_sets().front());
    CHECK(totals.levels.exempt <= totals.levels.pixels / 2000);
    for (const PlanRowInfo& info : all_plan_rows()) {
        CAPTURE(info.name);
        CHECK(totals.saved[info.row].saved > 0);
    }
}

TEST_CASE("random scenes without end", "[.soak]") {
    const std::string only = from_environment("SCANSHADE_SOAK_ISA", "");
    const std::uint64_t count = std::stoull(from_environment("SCANSHADE_SOAK", "1000"));
    const std::uint64_t first = std::stoull(from_environment("SCANSHADE_SOAK_FIRST", "1"));
    for (const std::string& isa : instruction_sets()) {
        if (!only.empty() && isa != only) continue;
        const Totals totals = check_scenes(first, count, isa);
        WARN(isa << ": " << count << " scenes from seed " << first << ", " << totals.levels.pixels
                 << " pixels, " << totals.levels.exempt << " at a threshold");
    }
}
