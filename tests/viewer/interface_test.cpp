// The viewer's interface, by real events on a display of its own: what the panel, the mouse and the
// keys change is what `scanshade render` draws from the scene that is saved.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "cli/process.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/debug_view.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/scene/scene.hpp"
#include "support/catch.hpp"
#include "viewer/session.hpp"

using namespace scanshade;

namespace {

constexpr const char* torus = "[[light]]\ntype = \"directional\"\n[[object]]\nshape = \"torus\"\n";

/// The same with another shape: a file that is read again keeps the camera.
std::string with_shape(const std::string& shape) {
    std::string text = lit_ball;
    return text.replace(text.find("sphere"), 6, shape);
}
constexpr int panel = 350;  // columns

/// Part of a picture; nothing where the picture has no such part.
Image cut(const Image& from, int x, int y, int width, int height) {
    if (x + width > from.width || y + height > from.height) return {};
    Image out(width, height);
    for (int row = 0; row < height; ++row)
        std::copy_n(from.pixel(x, y + row), 3 * std::size_t(width), out.pixel(0, row));
    return out;
}

/// The middle of a slider's grab whose column is nearest to `column`, top down from `from`.
struct Place {
    int x, y;
};
std::optional<Place> find_grab(const Image& window, int column, int from) {
    const auto is_grab = [&](int x, int y) {
        const std::uint8_t* p = window.pixel(x, y);
        return p[2] > 200 && p[1] > 100 && p[1] < 160 && p[0] < 90;
    };
    for (int y = from; y + 8 < window.height; ++y)
        for (int x = std::max(column - 6, 0); x <= column + 6; ++x)
            if (is_grab(x, y) && is_grab(x, y + 8)) return Place{x, y + 4};
    return std::nullopt;
}

/// The scene that Ctrl+S saves shows what the window shows, panel aside.
void check_saved(Session& session, int number, int left) {
    session.xdotool("key ctrl+s");
    const auto saved = session.folder() / fmt::format("ball_{}.toml", number);
    REQUIRE(eventually([&] { return std::filesystem::exists(saved); }));
    REQUIRE(eventually([&] { return !read_file(saved).empty(); }));
    const Image expected = rendered(saved, {});
    CHECK(eventually([&] {
        const Image now = session.picture();
        return now.width == expected.width + left &&
               cut(now, left, 0, expected.width, expected.height).rgb == expected.rgb;
    }));
}

}  // namespace

TEST_CASE("a slider of the panel changes the picture; the saved scene is that picture",
          "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,500"}, true);
    const Image before = rendered(session.input(), {"--resolution", "200,500"});
    REQUIRE(eventually([&] {
        const Image now = session.picture();
        return now.width == 200 + panel && cut(now, panel, 0, 200, 500).rgb == before.rgb;
    }));
    // Of all sliders that begin in their middle, exposure is the first.
    const auto grab = find_grab(session.picture(), 107, 100);
    REQUIRE(grab.has_value());
    const std::string at = "mousemove --sync --window " + session.window();
    session.xdotool(fmt::format("{0} {1} {2} mousedown 1 {0} {3} {2} mouseup 1", at, grab->x,
                                grab->y, grab->x + 20));
    CHECK(eventually([&] { return cut(session.picture(), panel, 0, 200, 500).rgb != before.rgb; }));
    session.xdotool(at + " 450 480");  // hints hang at the mouse
    check_saved(session, 1, panel);
    CHECK(read_file(session.folder() / "ball_1.toml").find("exposure") != std::string::npos);

    // Ctrl + click: the default again.
    session.xdotool(fmt::format("{} {} {}", at, grab->x + 20, grab->y));
    session.xdotool("keydown ctrl click 1 keyup ctrl");
    session.xdotool(at + " 450 480");
    CHECK(eventually([&] { return cut(session.picture(), panel, 0, 200, 500).rgb == before.rgb; }));
    session.xdotool("key p");
    CHECK(eventually([&] {
        return session.picture().rgb == rendered(session.input(), {"--resolution", "550,500"}).rgb;
    }));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("Ctrl + Shift + drag moves the light", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    const Image before = rendered(session.input(), {"--resolution", "200,150"});
    REQUIRE(session.shows(before));
    const std::string at = "mousemove --sync --window " + session.window();
    session.xdotool("keydown ctrl keydown shift");
    session.xdotool(at + " 90 70 mousedown 1 " + at + " 50 70");
    CHECK(eventually([&] { return session.picture().rgb != before.rgb; }));
    session.xdotool("mouseup 1 keyup shift keyup ctrl");
    // Another event, so that the line to the light is gone.
    session.xdotool("key 5 key 5");
    check_saved(session, 1, 0);
    Settings settings;
    const Scene moved = load_scene(session.folder() / "ball_1.toml", settings);
    CHECK(moved.lights.at(0).position.x < 1);
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("a split screen shows both methods, its divider is dragged", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    const Image phong = rendered(session.input(), {"--resolution", "200,150"});
    const Image flat = rendered(session.input(), {"--resolution", "200,150", "--shading", "flat"});
    REQUIRE(session.shows(phong));
    session.xdotool("key v key x key s");
    const auto parted_at = [&](int x) {
        return eventually([&] {
            // Below the names, beside the line.
            const Image now = session.picture();
            return cut(now, 0, 40, x - 4, 110).rgb == cut(phong, 0, 40, x - 4, 110).rgb &&
                   cut(now, x + 4, 40, 196 - x, 110).rgb == cut(flat, x + 4, 40, 196 - x, 110).rgb;
        });
    };
    CHECK(parted_at(100));
    const std::string at = "mousemove --sync --window " + session.window();
    session.xdotool(at + " 100 70 mousedown 1 " + at + " 60 70 mouseup 1");
    CHECK(parted_at(60));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("debug views by their keys, a pixel's equation by a click", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "780,400"});
    Settings settings;
    const Scene scene = load_scene(session.input(), settings);
    settings.width = 780, settings.height = 400;
    const Image before = render_image(scene, settings);
    REQUIRE(session.shows(before));
    for (const auto& [key, view] :
         {std::pair{"F2", DebugView::normals}, {"F4", DebugView::triangles}}) {
        CAPTURE(key);
        session.xdotool(fmt::format("key {}", key));
        CHECK(session.shows(to_image(draw_debug_view(scene, settings, view).pixels)));
        session.xdotool(fmt::format("key {}", key));
        CHECK(session.shows(before));
    }
    session.xdotool("mousemove --sync --window " + session.window() + " 260 190 click 1");
    // The polygon's edges are drawn on the picture, beside the window with the numbers.
    CHECK(eventually([&] {
        const Image now = session.picture();
        int yellow = 0;
        for (int y = 0; y < now.height; ++y)
            for (int x = 0; x < now.width; ++x) {
                const std::uint8_t* p = now.pixel(x, y);
                yellow += p[0] == 255 && p[1] == 220 && p[2] == 90;
            }
        return yellow > 10;
    }));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("the menu of lessons opens a lesson's scene, with a window about it",
          "[viewer][lesson]") {
    if (!can_open_windows()) return;
    constexpr int width = 450, height = 420, row = 97;  // row: of the menu's entry
    const std::vector<std::string> size{"--resolution", fmt::format("{},{}", width, height)};
    Session session(lit_ball, size, true);
    const Image ball = rendered(session.input(), size);
    REQUIRE(eventually([&] {
        const Image now = session.picture();
        return now.width == width + panel && cut(now, panel, 0, width, height).rgb == ball.rgb;
    }));
    const auto move = [&](int x, int y) {
        session.xdotool(fmt::format("mousemove --sync --window {} {} {}", session.window(), x, y));
        std::this_thread::sleep_for(std::chrono::milliseconds(200));  // menus open while one waits
    };
    CHECK(eventually([&] {
        move(25, 12);
        session.xdotool("click 1");
        for (const int x : {40, 120, 255}) move(x, row);  // File, Lessons, and over to the first
        session.xdotool("click 1");
        move(panel + 20, height - 20);
        return session.title().starts_with("shading |");
    }));
    const Image lesson = rendered("models/lessons/shading.toml", size);
    const auto shows_lesson = [&](int from) {
        return eventually([&] {
            return cut(session.picture(), panel, from, width, height - from).rgb ==
                   cut(lesson, 0, from, width, height - from).rgb;
        });
    };
    CHECK(shows_lesson(height - 60));
    // The window about it is over the rest, until it is closed.
    const auto hidden = [&] {
        const Image now = session.picture();
        return now.width == width + panel && cut(now, panel + width - 300, 60, 250, 100).rgb !=
                                                 cut(lesson, width - 300, 60, 250, 100).rgb;
    };
    CHECK(eventually(hidden));
    move(panel + width - 24, 20);
    session.xdotool("click 1");
    move(panel + 20, height - 20);
    CHECK(shows_lesson(0));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("files are watched, errors shown without losing the scene, neighbours a key away",
          "[viewer]") {
    if (!can_open_windows()) return;
    Session session(lit_ball, {"--resolution", "200,150"});
    const std::vector<std::string> size{"--resolution", "200,150"};
    const Image before = rendered(session.input(), size);
    REQUIRE(session.shows(before));

    std::ofstream(session.input()) << with_shape("torus");
    const Image changed = rendered(session.input(), size);
    CHECK(session.shows(changed));

    std::ofstream(session.input()) << with_shape("tours");
    CHECK(eventually([&] { return session.messages().find("'tours'") != std::string::npos; }));
    // The sentence is over the lower part; the upper one still shows the scene.
    CHECK(cut(session.picture(), 0, 0, 200, 40).rgb == cut(changed, 0, 0, 200, 40).rgb);

    std::ofstream(session.folder() / "other.toml") << lit_ball;
    session.xdotool("key Right");
    CHECK(session.shows(before));
    CHECK(session.title().starts_with("other |"));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("a recorded interaction can be played again; a file can be dropped", "[viewer]") {
    if (!can_open_windows()) return;
    const TempFolder shared;
    const std::string recording = shared.path / "recording";
    Image recorded;
    {
        Session session(lit_ball, {"--resolution", "200,150", "--record", recording});
        REQUIRE(session.shows(rendered(session.input(), {"--resolution", "200,150"})));
        const std::string at = "mousemove --sync --window " + session.window();
        session.xdotool(at + " 90 70 mousedown 1 " + at + " 120 62 " + at + " 131 40 mouseup 1");
        session.xdotool("key s key i click 4 key F12");
        const auto saved = session.folder() / "ball_1.png";
        REQUIRE(eventually([&] { return std::filesystem::exists(saved); }));
        recorded = load_image(saved);
        session.xdotool("key q");
        REQUIRE(session.wait() == 0);
    }
    CHECK(read_file(recording).find("motion 120 62 30 -8\n") != std::string::npos);
    {
        const TempFolder folder;
        const std::string scene = folder.write("ball.toml", lit_ball);
        const Display display;
        Child viewer(
            {viewer_program, scene, "--resolution", "200,150", "--no-panel", "--play", recording},
            display.environment(), {"", folder.path / "err", folder.path});
        CHECK(viewer.wait() == 0);  // Q is part of it
        CHECK(load_image(folder.path / "ball_1.png").rgb == recorded.rgb);
    }
    const auto dropped = shared.write("dropped.toml", torus);
    const auto play = shared.write("drop", "0 drop " + dropped.string() + "\nframe\n");
    Session session(lit_ball, {"--resolution", "200,150", "--play", play});
    CHECK(session.shows(rendered(dropped, {"--resolution", "200,150"})));
    session.xdotool("key q");
    CHECK(session.wait() == 0);
}

TEST_CASE("a recording that is none is refused with its line", "[viewer]") {
    if (!can_open_windows()) return;
    const TempFolder folder;
    const std::string scene = folder.write("ball.toml", lit_ball);
    for (const char* line : {"hello", "0 key 0 NoSuchKey", "0 down 9 1 1", "0 motion 1 2 3", "0"}) {
        const std::string play = folder.write("play", fmt::format("0 wheel 1\n{}\n", line));
        const Display display;
        Child viewer({viewer_program, scene, "--play", play}, display.environment(),
                     {"", folder.path / "err", ""});
        CHECK(viewer.wait() == 4);
        const std::string said = read_file(folder.path / "err");
        CAPTURE(line, said);
        CHECK(said.find("play:2:") != std::string::npos);
    }
}

TEST_CASE("how many frames a second the viewer turns the teapot by", "[.view-speed]") {
    const TempFolder folder;
    const Display display("1700x800x24");
    for (const char* more : {"--no-panel", "--samples=1"}) {
        Child viewer({viewer_program, "models/scenes/teapot.toml", "--resolution", "1280,720",
                      "--turn", "240", more},
                     display.environment(), {folder.path / "out", folder.path / "err", ""});
        CHECK(viewer.wait(120) == 0);
        WARN((more == std::string("--no-panel") ? "picture alone: " : "with the panel: ")
             << read_file(folder.path / "out"));
    }
}
