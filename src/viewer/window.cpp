#include "viewer/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "scanshade/base/error.hpp"

namespace scanshade::viewer {
namespace {

constexpr double share_of_screen = 0.9;  // leaves room for the title bar

[[noreturn]] void fail(std::string_view what) {
    throw Error(Errc::file, fmt::format("cannot {} ({}); `scanshade render` needs no window", what,
                                        SDL_GetError()));
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

void start_video() {
#ifdef __linux__
    // Left alone, SDL takes a driver that shows nothing where no display answers.
    const bool wayland = is_set("WAYLAND_DISPLAY");
    if (!is_set("SDL_VIDEODRIVER") && !is_set("DISPLAY") && !wayland)
        throw Error(Errc::file,
                    "cannot open a window (no display: neither DISPLAY nor WAYLAND_DISPLAY is "
                    "set); `scanshade render` needs none");
    SDL_SetHint(SDL_HINT_VIDEODRIVER, wayland ? "x11,wayland" : "x11");
#endif
    // What is made on the CPU and shown as it is gains nothing from a graphics driver, which may be a
    // slow one in software.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    // A viewer that shows a still picture must not keep the screen awake.
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("open a window");
}

/// The size in points, shrunk to what the desktop leaves free where it is to fit.
SDL_Point initial_size(const WindowSize& size) {
    SDL_Rect free;
    if (!size.fit_to_screen || SDL_GetDisplayUsableBounds(0, &free) != 0)
        return {size.width, size.height};
    const double shrink = std::min(
        {1.0, share_of_screen * free.w / size.width, share_of_screen * free.h / size.height});
    const auto shrunk = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(side * shrink)));
    };
    return {shrunk(size.width), shrunk(size.height)};
}

}  // namespace

Window::Window(const WindowSize& size) {
    start_video();
    const SDL_Point points = initial_size(size);
    window_ = SDL_CreateWindow("scanshade", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                               points.x, points.y, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!window_) fail("open a window");
    renderer_.reset(SDL_CreateRenderer(window_, -1, SDL_RENDERER_SOFTWARE));
    if (!renderer_) fail("draw into a window");
    update_size();
}

double Window::pixels_per_point() const {
    int points = 0;
    SDL_GetWindowSize(window_, &points, nullptr);
    return points > 0 ? double(width_) / points : 1;
}

void Window::update_size() {
    if (SDL_GetRendererOutputSize(renderer_.get(), &width_, &height_) != 0)
        fail("ask for the window's size");
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }

void Window::put(const PixelBuffer& picture, int left) {
    upload(picture);
    // Pixel for pixel: while the window is between two sizes the picture is not stretched.
    const SDL_Rect whole{left, 0, picture.width, picture.height};
    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    SDL_RenderClear(renderer_.get());
    SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &whole);
}

void Window::present() { SDL_RenderPresent(renderer_.get()); }

void Window::resize(int width, int height) { SDL_SetWindowSize(window_, width, height); }

// In the order of bytes that windows have, so that nobody converts it again on the way there.
void Window::upload(const PixelBuffer& picture) {
    int width = 0;
    int height = 0;
    if (texture_) SDL_QueryTexture(texture_.get(), nullptr, nullptr, &width, &height);
    if (width != picture.width || height != picture.height)
        texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888,
                                         SDL_TEXTUREACCESS_STREAMING, picture.width,
                                         picture.height));
    void* pixels = nullptr;
    int pitch = 0;
    if (!texture_ || SDL_LockTexture(texture_.get(), nullptr, &pixels, &pitch) != 0)
        fail("show the picture");
    for (int y = 0; y < picture.height; ++y) {
        const std::uint32_t* from = &picture.rgba()[std::size_t(y) * std::size_t(picture.width)];
        auto* to = reinterpret_cast<std::uint32_t*>(static_cast<std::uint8_t*>(pixels) + y * pitch);
        for (int x = 0; x < picture.width; ++x)
            to[x] = (from[x] & 0xff00ff00u) | (from[x] & 0xffu) << 16 | (from[x] >> 16 & 0xffu);
    }
    SDL_UnlockTexture(texture_.get());
    SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE);
}

}  // namespace scanshade::viewer
