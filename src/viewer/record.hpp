// Interactions as text, to be played again: a line for each event, "frame" where a picture was shown.
#pragma once

#include <SDL.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanshade::viewer {

/// An event with the modifiers that were held: "0 motion 120 62 30 -8", "64 down 1 120 62 1".
/// Nothing for events that play no part.
std::optional<std::string> event_line(const SDL_Event& event, int modifiers);

struct PlayedEvent {
    SDL_Event event;
    int modifiers;
    std::string file;  // of a dropped one: SDL frees the event's own text
};

/// Throws Error(format) for a line that is none.
PlayedEvent parse_event(std::string_view line);

class Recorder {
public:
    /// Throws Error(file) where it cannot be written.
    explicit Recorder(const std::filesystem::path& file);
    void write(const SDL_Event& event);
    void frame();

private:
    std::ofstream out_;
    bool events_since_frame_ = false;
};

class Player {
public:
    /// Throws Error: file, format (with the line).
    explicit Player(const std::filesystem::path& file);

    bool done() const { return next_ == frames_.size(); }
    /// Puts the events up to the next picture into SDL's queue, one by one; `handle` empties it.
    template <class Handle>
    void play_frame(Handle handle) {
        for (const PlayedEvent& played : frames_[next_]) {
            push(played);
            handle();
        }
        ++next_;
    }

private:
    static void push(const PlayedEvent& played);

    std::vector<std::vector<PlayedEvent>> frames_;
    std::size_t next_ = 0;
};

}  // namespace scanshade::viewer
