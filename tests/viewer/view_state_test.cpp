// What the viewer's actions change.
#include "viewer/view_state.hpp"

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/image.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
using namespace scanshade::viewer;

namespace {

constexpr const char* ball = "[[object]]\nshape = \"sphere\"\n";

ViewState state_of(const std::string& toml, Settings settings = {}) {
    Scene scene = parse_scene(toml, "ball.toml", settings);
    scene.name = "ball";
    return ViewState(std::move(scene), std::move(settings));
}

/// The values that `value` takes while `action` is asked for until the first one comes back, or
/// a hundred times.
template <class Value>
auto cycle(ViewState& state, Action action, Value value) {
    std::vector values{value(state)};
    for (int i = 0; i < 100; ++i) {
        CHECK(state.apply({action}));
        if (value(state) == values.front()) break;
        values.push_back(value(state));
    }
    return values;
}

}  // namespace

TEST_CASE("shading cycles through all kinds", "[viewer]") {
    ViewState state = state_of(ball);
    const auto seen =
        cycle(state, Action::next_shading, [](ViewState& s) { return s.settings().shading; });
    CHECK(seen == std::vector{Shading::phong, Shading::flat, Shading::gouraud});
    CHECK(state.settings().is_given("shading"));
}

TEST_CASE("shading cycles also through what objects choose for themselves", "[viewer]") {
    ViewState state = state_of(std::string(ball) + "shading = \"flat\"\n");
    const auto own = [](ViewState& s) { return !s.settings().is_given("shading"); };
    CHECK(own(state));
    const auto seen = cycle(state, Action::next_shading, [&](ViewState& s) {
        return own(s) ? "own" : std::string(shading_names()[std::size_t(s.settings().shading)]);
    });
    CHECK(seen == std::vector<std::string>{"own", "flat", "gouraud", "phong"});
    CHECK(state.title().find("each object's own") != std::string::npos);
}

TEST_CASE("a shading that was given as an option leaves objects no choice", "[viewer]") {
    Settings settings;
    settings.given.insert("shading");
    ViewState state = state_of(std::string(ball) + "shading = \"flat\"\n", settings);
    const auto seen =
        cycle(state, Action::next_shading, [](ViewState& s) { return s.settings().shading; });
    CHECK(seen.size() == shading_names().size());
}

TEST_CASE("brdf cycles through the materials' own, every model and unlit", "[viewer]") {
    ViewState state = state_of(ball);
    const auto seen =
        cycle(state, Action::next_brdf, [](ViewState& s) { return s.settings().brdf; });
    std::vector<std::string> expected{""};
    for (const BrdfInfo* brdf : all_brdfs()) expected.emplace_back(brdf->name);
    expected.emplace_back("unlit");
    CHECK(seen == expected);
}

TEST_CASE("interpolation cycles through all kinds", "[viewer]") {
    ViewState state = state_of(ball);
    const auto seen = cycle(state, Action::next_interpolation,
                            [](ViewState& s) { return s.settings().interpolation; });
    CHECK(seen ==
          std::vector{Interpolation::perspective, Interpolation::edges, Interpolation::patch});
}

TEST_CASE("the title names the model and what was chosen", "[viewer]") {
    ViewState state = state_of(ball);
    CHECK(state.title() ==
          "ball | shading phong | brdf blinn-phong (material's) | interpolation perspective");
    state.apply({Action::next_shading});
    state.apply({Action::next_brdf});
    state.apply({Action::next_interpolation});
    CHECK(state.title() == "ball | shading flat | brdf blinn-phong | interpolation edges");
}

TEST_CASE("the title says where materials differ in their brdf", "[viewer]") {
    const ViewState state = state_of(
        "[[material]]\nname = \"a\"\nbrdf = \"lambert\"\n"
        "[[object]]\nshape = \"sphere\"\nmaterial = \"a\"\n"
        "[[object]]\nshape = \"sphere\"\n");
    CHECK(state.title().find("brdf each material's own") != std::string::npos);
}

TEST_CASE("reset returns to the scene's camera", "[viewer]") {
    ViewState state = state_of(std::string(ball) + "[camera]\nposition = [1, 2, 6]\n");
    state.apply({Action::orbit, 30, 40});
    state.apply({Action::pan, 5, 6});
    state.apply({Action::zoom, 0, 2});
    CHECK(state.scene().camera->position != glm::dvec3(1, 2, 6));
    CHECK(state.scene().camera->focal_point != glm::dvec3(0));
    state.apply({Action::reset_camera});
    CHECK(state.scene().camera->position == glm::dvec3(1, 2, 6));
    CHECK(state.scene().camera->focal_point == glm::dvec3(0));
}

TEST_CASE("without a camera in the scene gestures start from the framed one", "[viewer]") {
    ViewState state = state_of(ball);
    state.resize(300, 500);
    state.apply({Action::orbit, 0, 0});
    const Camera framed = framed_camera(state.scene().bounds(), 300.0 / 500);
    CHECK(glm::length(state.scene().camera->position - framed.position) < 1e-9);
    state.apply({Action::reset_camera});
    CHECK_FALSE(state.scene().camera.has_value());
}

TEST_CASE("only what changes the picture asks for a new one", "[viewer]") {
    ViewState state = state_of(ball);
    CHECK(state.take_change());
    CHECK_FALSE(state.take_change());
    for (const Action action : {Action::save_picture, Action::toggle_help, Action::quit}) {
        CHECK_FALSE(state.apply({action}));
        CHECK_FALSE(state.take_change());
    }
    for (const Action action :
         {Action::orbit, Action::pan, Action::zoom, Action::next_shading, Action::next_brdf,
          Action::next_interpolation, Action::reset_camera}) {
        CHECK(state.apply({action, 1, 1}));
        CHECK(state.take_change());
    }
    state.resize(state.settings().width, state.settings().height);
    CHECK_FALSE(state.take_change());
    state.resize(123, 45);
    CHECK(state.take_change());
}

TEST_CASE("the picture's size stays within what a picture may have", "[viewer]") {
    ViewState state = state_of(ball);
    state.resize(0, 1'000'000);
    CHECK(state.settings().width == 1);
    CHECK(state.settings().height == max_image_side);
}

TEST_CASE("saved pictures take the first free number", "[viewer]") {
    const TempFolder folder;
    CHECK(next_picture_path(folder.path, "ball") == folder.path / "ball_1.png");
    folder.write("ball_1.png", "");
    folder.write("ball_3.png", "");
    CHECK(next_picture_path(folder.path, "ball") == folder.path / "ball_2.png");
    folder.write("ball_2.png", "");
    CHECK(next_picture_path(folder.path, "ball") == folder.path / "ball_4.png");
    CHECK(next_picture_path(folder.path, "cube") == folder.path / "cube_1.png");
}
