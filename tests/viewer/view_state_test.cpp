// What the viewer's actions change.
#include "viewer/view_state.hpp"

#include <algorithm>
#include <fstream>
#include <glm/glm.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/image.hpp"
#include "support/catch.hpp"
#include "viewer/picture.hpp"

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
    for (const Action action : {Action::click, Action::next_file, Action::previous_file,
                                Action::reload, Action::save_picture, Action::save_scene,
                                Action::toggle_help, Action::toggle_panel, Action::quit}) {
        CHECK_FALSE(state.apply({action}));
        CHECK_FALSE(state.take_change());
    }
    for (const Action action :
         {Action::orbit, Action::pan, Action::zoom, Action::next_shading, Action::next_brdf,
          Action::next_interpolation, Action::next_light, Action::move_light,
          Action::toggle_wireframe, Action::toggle_split, Action::other_side, Action::view_front,
          Action::view_right, Action::view_top, Action::view_opposite, Action::toggle_projection,
          Action::reset_camera}) {
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

TEST_CASE("a split screen draws each side by its own method", "[viewer]") {
    ViewState state = state_of(std::string(ball) + "[[light]]\ntype = \"directional\"\n");
    CHECK(state.side_at(0) == 0);
    state.apply({Action::toggle_split});
    state.apply({Action::other_side});
    state.apply({Action::next_shading});
    state.set_option(*find_option("exposure"), "1");
    state.set_option(*find_option("interpolation"), "edges");
    CHECK(state.side(0).settings.shading == Shading::phong);
    CHECK(state.side(1).settings.shading == Shading::flat);
    CHECK(state.side(0).settings.interpolation == Interpolation::perspective);
    CHECK(state.side(1).settings.interpolation == Interpolation::edges);
    // What is no method is both sides'.
    CHECK(state.side(0).settings.exposure_ev == 1);
    CHECK(state.side(1).settings.exposure_ev == 1);
    state.set_divider(0.25);
    CHECK(state.side_at(0.2 * state.settings().width) == 0);
    CHECK(state.side_at(0.3 * state.settings().width) == 1);

    state.resize(80, 60);
    Picture picture;
    picture.draw(state, false);
    const Image shown = to_image(picture.pixels());
    const Image a = render_image(state.scene(), state.side(0).settings);
    const Image b = render_image(state.scene(), state.side(1).settings);
    CHECK(a.rgb != b.rgb);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const std::uint8_t* expected = x < 20 ? a.pixel(x, y) : b.pixel(x, y);
            CHECK(std::equal(expected, expected + 3, shown.pixel(x, y)));
        }
}

TEST_CASE("one sample a pixel while something moves", "[viewer]") {
    Settings settings;
    settings.samples = 4;
    settings.width = 60, settings.height = 40;
    ViewState state = state_of(std::string(ball) + "[[light]]\ntype = \"directional\"\n", settings);
    Picture picture;
    picture.draw(state, true);
    CHECK_FALSE(picture.final());
    Settings one = settings;
    one.samples = 1;
    CHECK(to_image(picture.pixels()).rgb == render_image(state.scene(), one).rgb);
    picture.draw(state, false);
    CHECK(picture.final());
    CHECK(to_image(picture.pixels()).rgb == render_image(state.scene(), settings).rgb);
}

TEST_CASE("a debug view's key shows it, and the picture again", "[viewer]") {
    ViewState state = state_of(ball);
    Request depth{Action::debug_view};
    depth.number = int(DebugView::depth);
    CHECK(state.apply(depth));
    CHECK(state.active().view == DebugView::depth);
    CHECK(state.current(Action::debug_view, depth.number) == "on");
    state.apply(depth);
    CHECK(state.active().view == DebugView::none);
}

TEST_CASE("an option that is refused changes nothing", "[viewer]") {
    ViewState state = state_of(ball);
    state.take_change();
    CHECK_THROWS_AS(state.set_option(*find_option("exposure"), "101"), Error);
    CHECK_THROWS_AS(state.set_parameter(0, "kd", {2}), Error);
    CHECK_THROWS_AS(state.set_parameter(0, "unknown", {1}), Error);
    CHECK_THROWS_AS(state.set_model(0, "unknown"), Error);
    CHECK(state.settings().exposure_ev == 0);
    CHECK(state.scene().materials[0].parameters.empty());
    CHECK_FALSE(state.take_change());
}

TEST_CASE("a parameter of the model that is drawn makes that model the material's", "[viewer]") {
    ViewState state = state_of(ball);
    state.set_parameter(0, "kd", {0.1, 0.2, 0.3});
    CHECK(state.scene().materials[0].brdf == "blinn-phong");
    state.set_option(*find_option("brdf"), "torrance-sparrow");
    state.set_option(*find_option("set"), "m=0.9");
    const ResolvedMaterial before =
        resolve_material(state.scene().materials[0], "torrance-sparrow", {});
    state.set_parameter(0, "m", {0.5});
    const Material& material = state.scene().materials[0];
    CHECK(material.brdf == "torrance-sparrow");
    CHECK(material.find("m")->values == std::vector<double>{0.5});
    CHECK(state.settings().set.empty());
    const ResolvedMaterial after = resolve_material(material, "", {});
    for (int c = 0; c < 3; ++c) CHECK(after.params.value[0][c] == before.params.value[0][c]);
    state.set_parameter(0, "distribution", {}, "beckmann");
    CHECK(state.scene().materials[0].find("distribution")->word == "beckmann");
}

TEST_CASE("lights are selected, changed, added, moved and removed", "[viewer]") {
    ViewState state = state_of(std::string(ball) +
                               "[[light]]\ntype = \"point\"\nposition = [0, 0, 4]\n"
                               "[[light]]\ntype = \"directional\"\n");
    CHECK(state.selected_light() == 0u);
    state.apply({Action::move_light, 10, 0});
    const glm::dvec3 moved = state.scene().lights[0].position;
    CHECK(moved.x > 0);
    CHECK(glm::length(moved) == Approx(4));
    state.apply({Action::next_light});
    const glm::dvec3 down = state.scene().lights[1].direction;
    state.apply({Action::move_light, 0, 10});
    CHECK(state.scene().lights[1].direction != down);
    state.add_light();
    CHECK(state.scene().lights.size() == 3);
    CHECK(state.selected_light() == 2u);
    Light bad = state.scene().lights[2];
    bad.attenuation = glm::dvec3(0);
    CHECK_THROWS_AS(state.set_light(2, bad), Error);
    for (int i = 0; i < 3; ++i) state.remove_light(0);
    CHECK_FALSE(state.selected_light().has_value());
    CHECK(state.apply({Action::move_light, 1, 1}));
}

TEST_CASE("another file keeps what was chosen, and the camera where asked", "[viewer]") {
    ViewState state = state_of(ball);
    state.apply({Action::next_shading});
    state.apply({Action::orbit, 20, 30});
    state.set_option(*find_option("exposure"), "0.5");
    const glm::dvec3 position = state.scene().camera->position;
    for (const bool keep : {true, false}) {
        Settings settings = state.settings_for_loading({});
        Scene next = parse_scene("[[object]]\nshape = \"torus\"\n", "torus.toml", settings);
        CHECK(settings.exposure_ev == 0.5);
        state.replace(std::move(next), settings, keep);
        CHECK(state.settings().shading == Shading::flat);
        CHECK(state.scene().camera.has_value() == keep);
        if (keep) CHECK(state.scene().camera->position == position);
    }
}

TEST_CASE("every key is listed in the help and in README.md, once", "[viewer]") {
    std::ifstream file("README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    for (const HelpRow& row : help_rows()) {
        const std::string line = "| " + row.inputs + " | " + row.effect + " |\n";
        CAPTURE(line);
        CHECK(readme.find(line) != std::string::npos);
        CHECK(help_text().find(row.inputs + ": " + row.effect + "\n") != std::string::npos);
    }
    for (const Binding& b : all_bindings())
        CHECK(find_binding(b.gesture, b.code, b.modifiers) == &b);
    CHECK(find_binding(Gesture::key, "F9", no_modifier) == nullptr);
}
