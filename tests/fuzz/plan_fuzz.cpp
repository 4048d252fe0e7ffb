// Scenes of all kinds: the plan changes no bit, and the scalar twins show the same.
#include "fuzz/fuzz.hpp"
#include "support/scene_check.hpp"

using namespace scanshade;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    RandomScene random = make_random_scene(Rng(std::span(data, size)));
    random.settings.threads = 1;
    SceneTotals totals;
    try {
        const std::string fault = scene_fault(random, totals);
        if (!fault.empty()) broken(fault + "\n" + describe(random));
    } catch (const Error& error) {
        check_sentence(error);  // numbers can make a camera that stands where it looks
    }
    return 0;
}
