// A viewer at work, as its user meets it.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/process.hpp"
#include "scanshade/image/png.hpp"
#include "support/catch.hpp"
#include "viewer/display.hpp"

namespace scanshade {

inline const std::string viewer_program =
    std::filesystem::path(SCANSHADE_BINARY).parent_path() / "scanshade-view";

// Quads seen from nearby, so that every choice of shading and interpolation shows.
inline constexpr const char* lit_ball = R"(
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
    Session(const std::string& scene, const std::vector<std::string>& options, bool panel = false)
        : input_(folder_.write("ball.toml", scene)),
          panel_(panel),
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
    /// Its exit status; a check that fails shows what it said.
    int wait() {
        const int status = viewer_.wait();
        UNSCOPED_INFO(messages());
        return status;
    }
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
        if (!panel_) all.emplace_back("--no-panel");
        return all;
    }

    TempFolder folder_;
    std::string input_;
    bool panel_;
    Display display_;
    Child viewer_;
    std::string window_;
};

/// What `scanshade render` draws.
inline Image rendered(const std::string& input, std::vector<std::string> options) {
    const TempFolder folder;
    const std::string out = folder.path / "out.png";
    options.insert(options.begin(), {"render", input, "-o", out});
    const Finished run = run_scanshade(options);
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    return load_image(out);
}

/// Whether what the tests of the window need is there; says so where not.
inline bool can_open_windows() {
    for (const char* program : {"Xvfb", "xdotool"})
        if (!is_installed(program)) {
            WARN("not tested: " << program << " is not installed");
            return false;
        }
    return true;
}

}  // namespace scanshade
