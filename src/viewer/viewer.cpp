#include "viewer/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/timer.hpp"
#include "scanshade/report/timing.hpp"

namespace scanshade::viewer {
namespace {

using namespace std::chrono_literals;

constexpr auto rest = 120ms;           // without a change until a picture is refined
constexpr auto look_interval = 500ms;  // between two looks at files
constexpr int settling_frames = 2;     // of the interface after an event
constexpr double divider_reach = 5;    // points around it where it can be taken

WindowSize window_size(const Settings& settings, const ViewerOptions& options) {
    return {settings.width + (options.no_panel ? 0 : panel_width), settings.height,
            !settings.is_given("resolution")};
}

bool is_button(const SDL_Event& event) {
    return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP;
}

}  // namespace

Viewer::Viewer(std::filesystem::path input, Scene scene, Settings settings, Settings command_line,
               const ViewerOptions& options)
    : window_(window_size(settings, options)),
      gui_(window_.window(), window_.renderer()),
      command_line_(std::move(command_line)),
      input_file_(std::move(input)),
      state_(std::move(scene), std::move(settings)) {
    ui_.panel = !options.no_panel;
    ui_.lesson = lesson_of(input_file_);
    if (!options.record.empty()) recorder_.emplace(options.record);
    if (!options.play.empty()) player_.emplace(options.play);
    watch_.watch(input_file_, state_.scene());
    fit_picture();
    state_.take_change();
    picture_.draw(state_, false);
    say(fmt::format("{:.1f} ms", picture_.report(0).stats.frame_ms));
    show();
}

void Viewer::run() {
    while (running_) {
        if (player_ && !player_->done())
            player_->play_frame([&] { handle_pending(); });
        else
            wait_for_events();
        if (running_) update();
    }
}

void Viewer::wait_for_events() {
    const auto patience = frames_to_show_ > 0 ? std::chrono::milliseconds::zero()
                          : !picture_.final() ? rest
                                              : look_interval;
    SDL_Event event;
    if (SDL_WaitEventTimeout(&event, static_cast<int>(patience.count())) != 0) {
        handle(event);
        handle_pending();
    }
    if (Clock::now() - last_look_ < look_interval) return;
    last_look_ = Clock::now();
    if (watch_.changed()) open(input_file_, true);
}

void Viewer::handle_pending() {
    SDL_Event event;
    while (running_ && SDL_PollEvent(&event) != 0) handle(event);
}

Placement Viewer::placement() const { return {left(), 0, window_.pixels_per_point()}; }

bool Viewer::is_for_interface(const SDL_Event& event) const {
    switch (event.type) {
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
        case SDL_MOUSEMOTION:
        case SDL_MOUSEWHEEL:
            return gui_.wants_mouse();
        case SDL_KEYDOWN:
            return gui_.wants_keyboard();
        default:
            return false;
    }
}

void Viewer::handle(const SDL_Event& event) {
    if (recorder_) recorder_->write(event);
    // A button goes to what the mouse is over now, not where it was when the interface was last
    // described.
    if ((is_button(event) || event.type == SDL_MOUSEWHEEL) && interface_is_old_) describe();
    const bool for_interface = is_for_interface(event);
    gui_.process(event);
    interface_is_old_ = true;
    frames_to_show_ = settling_frames;
    if (is_button(event)) describe();

    if (event.type == SDL_WINDOWEVENT) handle_window(event.window);
    if (event.type == SDL_DROPFILE) {
        open(event.drop.file, false);
        SDL_free(event.drop.file);
    }
    if (for_interface || handle_divider(event)) return;
    if (const auto request = input_.translate(event, placement())) perform(*request);
}

void Viewer::handle_window(const SDL_WindowEvent& event) {
    if (event.event == SDL_WINDOWEVENT_SIZE_CHANGED) fit_picture();
}

/// The line between the sides of a split screen can be dragged.
bool Viewer::handle_divider(const SDL_Event& event) {
    if (!state_.split()) return divider_held_ = false;
    const Placement at = placement();
    const double width = state_.settings().width / at.pixels_per_point;
    if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT)
        divider_held_ =
            std::abs(event.button.x - at.left - state_.divider() * width) <= divider_reach;
    else if (event.type == SDL_MOUSEMOTION && divider_held_)
        state_.set_divider((event.motion.x - at.left) / width);
    else if (event.type == SDL_MOUSEBUTTONUP && divider_held_)
        return std::exchange(divider_held_, false);
    return divider_held_;
}

void Viewer::fit_picture() {
    window_.update_size();
    const int panel = static_cast<int>(std::lround(left() * window_.pixels_per_point()));
    state_.resize(window_.width() - panel, window_.height());
}

void Viewer::perform(const Request& request) {
    if (state_.apply(request)) return;
    switch (request.action) {
        case Action::click:
            inspect(request.at_x, request.at_y);
            break;
        case Action::previous_file:
        case Action::next_file:
            open(neighbour(input_file_, request.action == Action::next_file ? 1 : -1),
                 request.keep_camera);
            break;
        case Action::reload:
            open(input_file_, true);
            break;
        case Action::open_lesson:
            open_lesson(static_cast<std::size_t>(request.number));
            break;
        case Action::save_picture:
            save_picture();
            break;
        case Action::save_scene:
            save_scene();
            break;
        case Action::toggle_help:
            ui_.help = !ui_.help;
            break;
        case Action::toggle_panel:
            ui_.panel = !ui_.panel;
            fit_picture();
            break;
        default:
            running_ = false;
    }
}

void Viewer::perform_requests() {
    for (const Request& request : std::exchange(ui_.requests, {})) perform(request);
}

void Viewer::update() {
    perform_requests();
    if (state_.take_change()) {
        last_change_ = Clock::now();
        draw(true);
    } else if (!picture_.final() && Clock::now() - last_change_ >= rest) {
        draw(false);
    }
    if (frames_to_show_ > 0) show();
}

void Viewer::draw(bool moving) {
    frames_to_show_ = std::max(frames_to_show_, 1);
    ui_.moving = moving;
    ui_.light_is_moving = input_.dragging() == Action::move_light;
    try {
        picture_.draw(state_, moving);
        say(fmt::format("{:.1f} ms", picture_.report(state_.active_number()).stats.frame_ms));
        ui_.notice.clear();
    } catch (const Error& error) {
        say("not drawn");
        report(error.what());
    }
    if (ui_.inspection && picture_.final()) {
        ui_.moving = false;
        inspect(ui_.inspection->x, ui_.inspection->y);
    }
}

void Viewer::inspect(double x, double y) {
    const Settings& settings = state_.side(state_.side_at(x)).settings;
    if (!(x >= 0 && y >= 0 && x < settings.width && y < settings.height)) return;
    frames_to_show_ = settling_frames;
    ui_.moving = false;
    attempt(ui_, [&] {
        ui_.inspection =
            inspect_pixel(state_.scene(), settings, static_cast<int>(x), static_cast<int>(y));
    });
}

void Viewer::describe() {
    gui_.begin();
    build_overlays(state_, picture_, ui_, left());
    if (ui_.panel) build_panel(state_, picture_, ui_);
    if (ui_.panel) build_lesson(ui_);
    build_help(state_, ui_);
    build_inspector(ui_, left());
    build_notice(ui_, left());
    gui_.end();
    interface_is_old_ = false;
}

void Viewer::show() {
    describe();
    window_.put(picture_.pixels(),
                static_cast<int>(std::lround(left() * window_.pixels_per_point())));
    gui_.draw();
    window_.present();
    --frames_to_show_;
    if (recorder_) recorder_->frame();
}

void Viewer::say(const std::string& what) {
    ui_.status = what;
    window_.set_title(fmt::format("{} | {}", state_.title(), what));
}

void Viewer::report(const std::string& sentence) {
    note("scanshade-view: " + sentence);
    ui_.notice = sentence;
    frames_to_show_ = settling_frames;
}

std::string Viewer::turn(long long frames) {
    std::vector<double> total, drawing;
    for (long long i = 0; i < frames; ++i) {
        const Timer timer;
        handle_pending();
        perform({Action::orbit, 3});
        update();
        total.push_back(timer.ms());
        drawing.push_back(picture_.report(state_.active_number()).stats.frame_ms);
    }
    const double ms = median(total);
    return fmt::format(
        "{} frames of {} × {}: {:.1f} frames a second, {:.2f} ms a frame (median), {:.2f} ms of it "
        "drawing",
        frames, state_.settings().width, state_.settings().height, 1000 / ms, ms, median(drawing));
}

}  // namespace scanshade::viewer
