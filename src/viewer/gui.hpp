// Dear ImGui in an SDL window: events in, its draw lists out.
#pragma once

#include <SDL.h>

#include <array>
#include <memory>

namespace scanshade::viewer {

/// One at a time: Dear ImGui has one context.
class Gui {
public:
    Gui(SDL_Window* window, SDL_Renderer* renderer);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    void process(const SDL_Event& event);

    /// Between the two the windows are described anew.
    void begin();
    void end();
    /// What was described last, over what the renderer has drawn.
    void draw();

    /// Whether the mouse is over a window of the interface, or holds something there.
    bool wants_mouse() const;
    bool wants_keyboard() const;  // text is being typed

private:
    struct Destroy {
        void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
    };
    void load_font();
    void take_mouse();

    SDL_Renderer* renderer_;
    std::unique_ptr<SDL_Texture, Destroy> font_;
    // The mouse as events have it, also played ones; the backend would ask the desktop.
    float mouse_x_ = -1, mouse_y_ = -1;
    std::array<bool, 3> held_{}, pressed_{};  // left, right, middle
};

}  // namespace scanshade::viewer
