// The vector renderer on random scenes: what its plan leaves out changes no bit, and it shows what
// its scalar twins show, in float and in double. `make soak` draws many more, on every instruction set.
#include <cstdlib>

#include "scanshade/base/memory.hpp"
#include "scanshade/kernels/isa.hpp"
#include "support/catch.hpp"
#include "support/scene_check.hpp"

using namespace scanshade;

namespace {

/// Draws scenes [first, first + count) on one instruction set.
SceneTotals check_scenes(std::uint64_t first, std::uint64_t count, const std::string& isa) {
    SceneTotals totals;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        RandomScene random = make_random_scene(seed);
        random.settings.isa = isa;
        const std::string wrong = scene_fault(random, totals);
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

TEST_CASE("random scenes: the plan changes no bit, and the scalar twins show the same",
          "[engine][plan][random]") {
    const SceneTotals totals = check_scenes(1, 1000, instruction_sets().front());
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
        const std::uint64_t tenth = count / 10;
        check_scenes(first, tenth, isa);
        const std::uint64_t early = peak_memory_bytes();
        const SceneTotals totals = check_scenes(first + tenth, count - tenth, isa);
        const std::uint64_t late = peak_memory_bytes();
        WARN(isa << ": " << count << " scenes from seed " << first << ", " << totals.levels.pixels
                 << " pixels, " << totals.levels.exempt << " at a threshold; peak memory "
                 << (early >> 20) << " MiB after a tenth, " << (late >> 20) << " at the end");
        // What nine times as many scenes add is a larger scene, never a leak.
        if (tenth > 100) CHECK(double(late) < 1.25 * double(early));
    }
}
