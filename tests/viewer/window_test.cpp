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
#include "viewer/display.hpp"

using namespace scanshade;

namespace {

const std::string viewer_program =
    std::filesystem::path(SCANSHADE_BINARY).parent_path() / "scanshade-view";

// Quads seen from nearby, so that every choice of shading and interpolation shows.
constexpr const char* ball = R"(
[camera]
position = [0.7, 0.9, 2.6]
focal_point = [0, 0, 0]
view_angle = 45
[[light]]
type = "point"
position = [1.5, 2, 2]
[[object]]
shape = "sphere"
tessellation = 3
)";

template <class Condition>
bool eventually(Condition condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(15);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// The viewer on a display of its own, started in a folder of its own through `scanshade view`.
class Session {
public:
    Session(const std::string& scene, const std::vector<std::string>& options)
        : input_(folder_.write("ball.toml", scene)),
          viewer_(command(options), display_.environment(),
                  {"", folder_.path / "err", folder_.path}) {
        REQUIRE(eventually([&] {
            window_ = display_.xdotool("search --onlyvisible --class scanshade-view");
            return !window_.empty();
        }));
        window_.erase(window_.find('\n'));
        // Nobody manages windows here, so nobody else gives the focus.
        xdotool("windowfocus --sync " + window_);
    }

    const std::filesystem::path& folder() const { return folder_.path; }
    const std::string& window() const { return window_; }
    const std::string& input() const { return input_; }
    pid_t id() const { return viewer_.id(); }
    int wait() { return viewer_.wait(); }
    std::string messages() const { return read_file(folder_.path / "err"); }
    std::string xdotool(const std::string& words) const { return display_.xdotool(words); }
    std::string title() const { return xdotool("getwindowname " + window_); }

    /// What the window shows; nothing where a busy machine did not answer in time.
    Image picture() const {
        const std::string geometry = xdotool("getwindowgeometry --shell " + window_);
        if (geometry.find("\nHEIGHT=") == std::string::npos) return {};
        const auto value = [&](const std::string& name) {
            return std::stoi(geometry.substr(geometry.find("\n" + name + "=") + name.size() + 2));
        };
        return display_.screen(value("X"), value("Y"), value("WIDTH"), value("HEIGHT"));
    }

    bool shows(const Image& expected) const {
        return eventually([&] {
            const Image now = picture();
            return now.width == expected.width && now.rgb == expected.rgb;
        });
    }

private:
    std::vector<std::string> command(const std::vector<std::string>& options) const {
        std::vector<std::string> all{SCANSHADE_BINARY, "view", input_};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }

    TempFolder folder_;
    std::string input_;
    Display display_;
    Child viewer_;
    std::string window_;
};

/// What `scanshade render` draws.
Image rendered(const std::string& input, std::vector<std::string> options) {
    const TempFolder folder;
    const std::string out = folder.path / "out.png";
    options.insert(options.begin(), {"render", input, "-o", out});
    const Finished run = run_scanshade(options);
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    return load_image(out);
}

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

/// Whether what the tests of the window need is there; says so where not.
bool can_open_windows() {
    for (const char* program : {"Xvfb", "xdotool"})
        if (!is_installed(program)) {
            WARN("not tested: " << program << " is not installed");
            return false;
        }
    return true;
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
    Session session(ball, {"--resolution", "200,150"});
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
    Session session(ball, {"--resolution", "200,150"});
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
    session.xdotool("click 4");
    check_and_reset(viewer::zoomed(home, 1, scene.bounds().radius));
    session.xdotool("click --repeat 2 5");
    check_and_reset(viewer::zoomed(home, -2, scene.bounds().radius));

    session.xdotool("key Escape");
    CHECK(session.wait() == 0);
}

TEST_CASE("the picture follows the window, and F12 saves it", "[viewer]") {
    if (!can_open_windows()) return;
    Session session(ball, {"--resolution", "200,150"});
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
    Session session(ball, {"--resolution", "200,150"});
    REQUIRE(session.shows(rendered(session.input(), {"--resolution", "200,150"})));
    const long before = ticks(session.id());
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    CHECK(ticks(session.id()) - before <= ::sysconf(_SC_CLK_TCK) / 50);
}

TEST_CASE("without a display the viewer says so and names the way out", "[viewer]") {
    const TempFolder folder;
    const std::string scene = folder.write("ball.toml", ball);
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
