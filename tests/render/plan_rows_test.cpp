// Each row of the plan leaves out what the picture does not need: not a bit of it changes.
#include <algorithm>

#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/plan_check.hpp"

using namespace scanshade;

TEST_CASE("the plan and each of its rows alone change no bit of a golden scene", "[engine][plan]") {
    PlanSavings saved{};
    for (const GoldenPicture& picture : load_golden_list().pictures)
        for (const Cull cull : {Cull::none, Cull::back}) {
            Settings settings = picture.settings;
            settings.cull = cull;
            CAPTURE(picture.name, int(cull));
            CHECK(plan_difference(picture.scene, settings, saved) == "");
        }
    // Which rows fire is asked of the random scenes; here more than half do.
    CHECK(std::count(saved.begin(), saved.end(), 0u) < int(plan_row_count / 2));
}

TEST_CASE("rows count what they save only where they are left out", "[engine][plan]") {
    for (const GoldenPicture& picture : load_golden_list().pictures) {
        Settings settings = picture.settings;
        settings.no_plan = true;
        CAPTURE(picture.name);
        CHECK(draw(picture.scene, settings).stats.saved == PlanSavings{});
    }
}
