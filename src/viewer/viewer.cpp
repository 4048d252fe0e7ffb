#include "viewer/viewer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/renderer.hpp"
#include "viewer/overlay.hpp"

namespace scanshade::viewer {

Viewer::Viewer(Scene scene, Settings settings)
    : window_({settings.width, settings.height, !settings.is_given("resolution")}),
      state_(std::move(scene), std::move(settings)) {
    state_.resize(window_.width(), window_.height());
    state_.take_change();
    draw();
    show();
}

void Viewer::run() {
    while (running_) {
        SDL_Event event;
        if (SDL_WaitEvent(&event) == 0)
            throw Error(Errc::file, fmt::format("cannot wait for events ({})", SDL_GetError()));
        do handle(event);
        while (running_ && SDL_PollEvent(&event) != 0);

        if (!running_) return;
        if (state_.take_change()) try_draw();
        if (outdated_) show();
    }
}

void Viewer::handle(const SDL_Event& event) {
    if (event.type == SDL_WINDOWEVENT) {
        if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
            window_.update_size();
            state_.resize(window_.width(), window_.height());
        }
        outdated_ |= event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED ||
                     event.window.event == SDL_WINDOWEVENT_EXPOSED;
    }
    if (const auto request = input_.translate(event, window_.pixels_per_point())) perform(*request);
}

void Viewer::perform(const Request& request) {
    if (state_.apply(request)) return;
    switch (request.action) {
        case Action::save_picture:
            save_picture();
            break;
        case Action::toggle_help:
            help_ = !help_;
            outdated_ = true;
            break;
        default:
            running_ = false;
    }
}

void Viewer::draw() {
    Renderer renderer(state_.scene(), state_.settings());
    const FrameStats stats = renderer.draw(frame_);
    picture_ = encode(frame_, state_.settings().transfer, state_.settings().exposure_ev);
    status_ = fmt::format("{:.1f} ms", stats.frame_ms);
    notice_.clear();
    outdated_ = true;
}

void Viewer::try_draw() {
    try {
        draw();
    } catch (const Error& error) {
        status_ = "not drawn";
        report(error.what());
    }
}

void Viewer::save_picture() {
    // What is asked for before it in the same batch of events belongs into the picture.
    if (state_.take_change()) try_draw();
    try {
        const auto path = next_picture_path(".", state_.scene().name);
        save_png(picture_, path);
        status_ = fmt::format("saved {}", path.filename().string());
        outdated_ = true;
        note("scanshade-view: " + status_);
    } catch (const Error& error) {
        report(error.what());
    }
}

void Viewer::report(const std::string& sentence) {
    note("scanshade-view: " + sentence);
    notice_ = sentence;
    outdated_ = true;
}

void Viewer::show() {
    window_.set_title(fmt::format("{} | {}", state_.title(), status_));
    const std::string text = (help_ ? help_text() : "") + notice_;
    if (text.empty()) {
        window_.show(picture_);
    } else {
        Image lettered = picture_;
        draw_overlay(lettered, text);
        window_.show(lettered);
    }
    outdated_ = false;
}

}  // namespace scanshade::viewer
