// The loop that ties state, input and window together.
#pragma once

#include <string>

#include "scanshade/image/framebuffer.hpp"
#include "viewer/input.hpp"
#include "viewer/view_state.hpp"
#include "viewer/window.hpp"

namespace scanshade::viewer {

class Viewer {
public:
    /// Opens the window and draws the first picture. Throws Error where either cannot be done.
    Viewer(Scene scene, Settings settings);

    /// Runs until the user quits. Sleeps while nothing happens and draws once for all events that
    /// have arrived, so that a slow picture does not fall behind the mouse.
    void run();

private:
    void handle(const SDL_Event& event);
    void perform(const Request& request);
    void draw();      // throws Error
    void try_draw();  // an error is shown, and the last picture stays
    void save_picture();
    void report(const std::string& sentence);
    void show();

    Window window_;
    ViewState state_;
    Input input_;
    Framebuffer frame_;
    Image picture_;       // the last one that was drawn without an error
    std::string status_;  // end of the title: frame time, ...
    std::string notice_;  // over the picture until the next change
    bool help_ = false;
    bool outdated_ = false;  // the window shows something old
    bool running_ = true;
};

}  // namespace scanshade::viewer
