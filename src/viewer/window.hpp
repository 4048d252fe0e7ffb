// The window: pixels on the screen.
#pragma once

#include <SDL.h>

#include <memory>
#include <string>

#include "scanshade/image/framebuffer.hpp"

namespace scanshade::viewer {

struct WindowSize {
    int width, height;   // points, as the desktop counts
    bool fit_to_screen;  // shrunk, its proportions kept, where the screen is smaller
};

/// Owns SDL's video for as long as it lives; one at a time.
class Window {
public:
    /// Opens a resizable window. Throws Error(file) where that cannot be done.
    explicit Window(const WindowSize& size);

    /// Size of the picture that fills the window, in pixels.
    int width() const { return width_; }
    int height() const { return height_; }
    double pixels_per_point() const;

    /// Asks the desktop for the size again, after an event that may have changed it.
    void update_size();

    void set_title(const std::string& title);

    /// Clears the window and puts a picture on it, pixel by pixel, from column `left` on.
    void put(const PixelBuffer& picture, int left);
    /// Shows what was put and drawn.
    void present();

    void resize(int width, int height);  // points

    SDL_Window* window() { return window_; }
    SDL_Renderer* renderer() { return renderer_.get(); }

private:
    struct Destroy {
        void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
        void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
    };

    void upload(const PixelBuffer& picture);

    // Goes away with the program. SDL wakes a waiting program by a message to its window on a
    // connection of its own; one that still travels when the window is destroyed is an error that X
    // ends the program for.
    SDL_Window* window_;
    std::unique_ptr<SDL_Renderer, Destroy> renderer_;
    std::unique_ptr<SDL_Texture, Destroy> texture_;
    int width_ = 0, height_ = 0;
};

}  // namespace scanshade::viewer
