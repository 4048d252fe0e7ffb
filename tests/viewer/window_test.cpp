// scanshade-view as a user meets it: real events on a display of its own, and what is on the
// screen compared with what `scanshade render` draws.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <sstream>
#include <thread>

#include "cli/process.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/scene/scene.hpp"
#include "support/catch.hpp"
#include "viewer/camera_control.hpp"
#include "viewer/session.hpp"

using namespace scanshade;

namespace {

std::vector<std::string> camera_options(const Camera& camera) {
    const auto words = [](const glm::dvec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    return {"--camera-position", words(camera.position), "--camera-focal-point",
            words(camera.focal_point)};
}

/// Processor time of a process so far, in clock ticks.
long ticks(pid_t id) {
    std::string stat = read_file(fmt::format("/proc/{}/stat", id));
    std::istringstream fields(stat.substr(stat.rfind(')') + 2));
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    long user = 0, system = 0;
    fields >> user >> system;
    return user + system;
}

std::string started_without_display(const std::vector<std::string>& args, int expected_status) {
    const TempFolder folder;
    const std::string err = folder.path / "err";
    std::vector<std::string> command{viewer_program};
    command.insert(command.end(), args.begin(), args.end());
    Child viewer(command, {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"},
                 {"", err, ""});
    CHECK(viewer.wait() == expected_status);
    return read_file(err);
}

}  // namespace

TEST_CASE("keys choose what is drawn, and the window shows what render draws", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    std::vector<std::string> options{"--resolution", "200,150"};
    const auto render_with = [&](const std::string& name, std::string_view value) {
        std::vector<std::string> all = options;
        all.insert(all.end(), {"--" + name, std::string(value)});
        return rendered(session.input(), all);
    };
    Image before = rendered(session.input(), options);
    CHECK(session.shows(before));

    const auto press_through = [&](const std::string& key, const std::string& option,
                                   const std::vector<std::string>& values) {
        for (const std::string& value : values) {
            CAPTURE(option, value);
            session.xdotool("key " + key);
            const Image expected = render_with(option, value);
            CHECK(session.shows(expected));
            CHECK(session.title().find(value) != std::string::npos);
        }
    };
    press_through("s", "shading", {"flat", "gouraud", "phong"});
    CHECK(render_with("shading", "flat").rgb != render_with("shading", "gouraud").rgb);
    CHECK(render_with("shading", "flat").rgb != before.rgb);

    press_through("i", "interpolation", {"edges", "patch", "perspective"});
    CHECK(render_with("interpolation", "edges").rgb != before.rgb);

    std::vector<std::string> brdfs;
    for (const BrdfInfo* brdf : all_brdfs()) brdfs.emplace_back(brdf->name);
    brdfs.emplace_back("unlit");
    press_through("b", "brdf", brdfs);
    CHECK(render_with("brdf", "unlit").rgb != render_with("brdf", "lambert").rgb);

    session.xdotool("key q");
    CHECK(session.wait() == 0);
    CHECK(session.messages().empty());
}

TEST_CASE("the mouse moves the camera, Enter brings it back", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    Settings settings;
    const Scene scene = load_scene(session.input(), settings);
    const Camera home = *scene.camera;
    const auto render_from = [&](const Camera& camera) {
        std::vector<std::string> options = camera_options(camera);
        options.insert(options.end(), {"--resolution", "200,150"});
        return rendered(session.input(), options);
    };
    const Image at_home = render_from(home);
    REQUIRE(session.shows(at_home));

    const auto drag = [&](const std::string& button, const std::string& modifier) {
        const std::string at = "mousemove --sync --window " + session.window();
        session.xdotool(at + " 90 70");
        if (!modifier.empty()) session.xdotool("keydown " + modifier);
        session.xdotool("mousedown " + button + " " + at + " 120 62 mouseup " + button);
        if (!modifier.empty()) session.xdotool("keyup " + modifier);
    };
    const auto check_and_reset = [&](const Camera& expected) {
        const Image picture = render_from(expected);
        CHECK(picture.rgb != at_home.rgb);
        CHECK(session.shows(picture));
        session.xdotool("key Return");
        CHECK(session.shows(at_home));
    };
    drag("1", "");
    check_and_reset(viewer::orbited(home, 30, -8, 150));
    for (const char* button : {"2", "3"}) {
        CAPTURE(button);
        drag(button, "");
        check_and_reset(viewer::panned(home, 30, -8, 150));
    }
    drag("1", "shift");
    check_and_reset(viewer::panned(home, 30, -8, 150));
    // The mouse is at (120, 62), 20 to the right of the middle and 13 above it.
    const auto zoomed = [&](const Camera& camera, double steps) {
        return viewer::zoomed(camera, steps, scene.bounds().radius, 20, -13, 150);
    };
    session.xdotool("click 4");
    check_and_reset(zoomed(home, 1));
    session.xdotool("click --repeat 2 5");
    check_and_reset(zoomed(zoomed(home, -1), -1));

    session.xdotool("key Escape");
    CHECK(session.wait() == 0);
}

TEST_CASE("the picture follows the window, and F12 saves it", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    for (const auto& [width, height] : {std::pair{311, 187}, {90, 240}}) {
        session.xdotool(fmt::format("windowsize {} {} {}", session.window(), width, height));
        const Image expected =
            rendered(session.input(), {"--resolution", fmt::format("{},{}", width, height)});
        CHECK(session.shows(expected));

        const int number = width == 311 ? 1 : 2;
        const auto saved = session.folder() / fmt::format("ball_{}.png", number);
        // Help is over the picture, not in it.
        session.xdotool("key h");
        CHECK(eventually([&] { return session.picture().rgb != expected.rgb; }));
        session.xdotool("key F12");
        REQUIRE(eventually([&] { return std::filesystem::exists(saved); }));
        CHECK(load_image(saved).rgb == expected.rgb);
        CHECK(session.title().find(saved.filename().string()) != std::string::npos);
        session.xdotool("key h");
        CHECK(session.shows(expected));
    }
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("a viewer left alone costs no processor time", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    REQUIRE(session.shows(rendered(session.input(), {"--resolution", "200,150"})));
    const long before = ticks(session.id());
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    CHECK(ticks(session.id()) - before <= ::sysconf(_SC_CLK_TCK) / 50);
}

TEST_CASE("without a display the viewer says so and names the way out", "[viewer]") {
    const TempFolder folder;
    const std::string scene = folder.write("ball.toml", lit_ball);
    const std::string said = started_without_display({scene}, 3);
    CAPTURE(said);
    CHECK(said.starts_with("scanshade-view: cannot open a window (no display"));
    CHECK(said.find("`scanshade render`") != std::string::npos);
    CHECK(std::count(said.begin(), said.end(), '\n') == 1);
}

TEST_CASE("the viewer refuses bad input as scanshade does", "[viewer]") {
    const TempFolder folder;
    const std::string bad_scene = folder.write("bad.toml", "[camera]\nview_angel = 3\n");
    struct Row {
        std::vector<std::string> args;
        int status;
    };
    for (const Row& row : {Row{{}, 2}, Row{{"a.obj", "--shadng", "flat"}, 2},
                           Row{{folder.path / "none.obj"}, 3}, Row{{bad_scene}, 5}}) {
        const std::string said = started_without_display(row.args, row.status);
        CAPTURE(said);
        CHECK(said.starts_with("scanshade-view: "));
        CHECK(std::count(said.begin(), said.end(), '\n') == 1);
    }
}
