// What the plan's rows say they saved.
#include "support/catch.hpp"
#include "support/pictures.hpp"

using namespace scanshade;

TEST_CASE("what a row saves is no more than there was, and nothing where it is kept", "[plan]") {
    Scene scene = lit_sphere();
    scene.lights.front().intensity = glm::dvec3(0);
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Settings settings = small_picture();
        settings.shading = shading;
        const FrameStats stats = draw(scene, settings).stats;
        for (const PlanRowInfo& info : all_plan_rows()) {
            CAPTURE(info.name, shading);
            CHECK(stats.saved[info.row].saved <= stats.saved[info.row].of);
            settings.kept_rows = {std::string(info.name)};
            CHECK(draw(scene, settings).stats.saved[info.row] == PlanSaving{});
        }
    }
}

TEST_CASE("what a row saves does not depend on the threads", "[plan]") {
    Scene scene = lit_sphere();
    scene.materials.front().brdf = "phong";
    Settings settings = small_picture();
    settings.set = {{"ks", {0}, "ks"}};
    settings.width = 640, settings.height = 480;
    settings.threads = 1;
    const FrameStats one = draw(scene, settings).stats;
    settings.threads = 4;
    const FrameStats four = draw(scene, settings).stats;
    CHECK(one.saved[PlanRow::specular] == PlanSaving{1, 1});
    for (const PlanRowInfo& info : all_plan_rows()) {
        CAPTURE(info.name);
        CHECK(one.saved[info.row] == four.saved[info.row]);
    }
}
