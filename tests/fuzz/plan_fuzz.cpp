// Scenes of all kinds: the plan changes no bit, and the scalar twins show the same.
#include "fuzz/fuzz.hpp"
#include "support/scene_check.hpp"

using namespace scanshade;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    RandomScene random = make_random_scene(Rng(std::span(data, size)));
    random.settings.threads = 1;
    SceneTotals totals;
    const std::string fault = scene_fault(random, totals);
    if (!fault.empty()) broken(fault + "\n" + describe(random));
    return 0;
}
