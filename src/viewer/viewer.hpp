// The loop that ties state, interface and window together. Data goes one way: events change the
// state, the state is drawn, the picture is shown.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "viewer/files.hpp"
#include "viewer/gui.hpp"
#include "viewer/input.hpp"
#include "viewer/picture.hpp"
#include "viewer/record.hpp"
#include "viewer/ui.hpp"
#include "viewer/view_state.hpp"
#include "viewer/window.hpp"

namespace scanshade::viewer {

struct ViewerOptions {
    std::string record, play;  // files
    bool no_panel = false;
    long long turn = 0;  // frames to turn the scene by, to see how long they take
};

class Viewer {
public:
    /// Opens the window and draws the first picture. `command_line` has the settings before the
    /// scene was read. Throws Error where that cannot be done.
    Viewer(std::filesystem::path input, Scene scene, Settings settings, Settings command_line,
           const ViewerOptions& options);

    /// Runs until the user quits. Sleeps while nothing happens and draws once for all events that
    /// have arrived, so that a slow picture does not fall behind the mouse.
    void run();

    /// Turns the scene a little, frame by frame; what a frame took, in a sentence.
    std::string turn(long long frames);

private:
    using Clock = std::chrono::steady_clock;

    void wait_for_events();
    void handle_pending();
    void handle(const SDL_Event& event);
    void handle_window(const SDL_WindowEvent& event);
    bool handle_divider(const SDL_Event& event);
    bool is_for_interface(const SDL_Event& event) const;
    void perform(const Request& request);
    void perform_requests();
    void update();  // draws what has changed and shows it
    void draw(bool moving);
    void describe();  // the interface anew
    void show();
    void fit_picture();
    void inspect(double x, double y);
    void open(const std::filesystem::path& file, bool keep_camera);
    void open_lesson(std::size_t number);
    void save_picture();
    void save_scene();
    void say(const std::string& what);
    void report(const std::string& sentence);
    double left() const { return ui_.panel ? panel_width : 0; }
    Placement placement() const;

    Window window_;
    Gui gui_;
    Settings command_line_;
    std::filesystem::path input_file_;
    ViewState state_;
    Ui ui_;
    Input input_;
    Picture picture_;
    FileWatch watch_;
    std::optional<Recorder> recorder_;
    std::optional<Player> player_;
    Clock::time_point last_change_, last_look_;
    int frames_to_show_ = 0;  // the interface settles within a few
    bool interface_is_old_ = true;
    bool divider_held_ = false;
    bool running_ = true;
};

}  // namespace scanshade::viewer
