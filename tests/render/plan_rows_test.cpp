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
    const auto idle = [&](const PlanRowInfo& info) { return saved[info.row].saved == 0; };
    const auto rows = all_plan_rows();
    CHECK(std::count_if(rows.begin(), rows.end(), idle) < int(plan_row_count / 2));
}

TEST_CASE("rows count what they save only where they are left out", "[engine][plan]") {
    for (const GoldenPicture& picture : load_golden_list().pictures) {
        Settings settings = picture.settings;
        settings.no_plan = true;
        CAPTURE(picture.name);
        const PlanSavings saved = draw(picture.scene, settings).stats.saved;
        for (const PlanRowInfo& info : all_plan_rows()) CHECK(saved[info.row].saved == 0);
    }
}
