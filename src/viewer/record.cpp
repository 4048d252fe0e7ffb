#include "viewer/record.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade::viewer {
namespace {

constexpr std::size_t max_events = 1'000'000;

/// The words of a line after the modifiers, and how they make an event.
class Words {
public:
    explicit Words(std::string_view line) : words_(split(line, ' ')) {}

    std::string_view word(std::size_t i) const {
        if (i >= words_.size()) fail();
        return words_[i];
    }
    int integer(std::size_t i) const {
        const auto n = parse_integer(word(i));
        if (!n || *n < -1'000'000 || *n > 1'000'000) fail();
        return static_cast<int>(*n);
    }
    /// From word i to the end of the line.
    std::string rest(std::size_t i) const {
        const std::string_view first = word(i), last = words_.back();
        return {first.data(), last.data() + last.size()};
    }
    [[noreturn]] static void fail() {
        throw Error(
            Errc::format,
            "this is no recorded event; lines are \"0 motion X Y DX DY\", \"0 down BUTTON X "
            "Y\", \"0 key KEY\", \"frame\" and the like");
    }

private:
    std::vector<std::string_view> words_;
};

std::string key_line(std::string_view kind, const SDL_KeyboardEvent& key) {
    return fmt::format("{} {} {}", kind, key.repeat, SDL_GetKeyName(key.keysym.sym));
}

std::string button_line(std::string_view kind, const SDL_MouseButtonEvent& button) {
    return fmt::format("{} {} {} {}", kind, button.button, button.x, button.y);
}

SDL_Event make_key(const Words& w, Uint32 type, int modifiers) {
    SDL_Event event{};
    event.type = type;
    event.key.state = type == SDL_KEYDOWN ? SDL_PRESSED : SDL_RELEASED;
    event.key.repeat = static_cast<Uint8>(w.integer(2) != 0);
    event.key.keysym.sym = SDL_GetKeyFromName(w.rest(3).c_str());
    if (event.key.keysym.sym == SDLK_UNKNOWN) Words::fail();
    event.key.keysym.scancode = SDL_GetScancodeFromKey(event.key.keysym.sym);
    event.key.keysym.mod = static_cast<Uint16>(modifiers);
    return event;
}

SDL_Event make_button(const Words& w, Uint32 type) {
    SDL_Event event{};
    event.type = type;
    event.button.state = type == SDL_MOUSEBUTTONDOWN ? SDL_PRESSED : SDL_RELEASED;
    event.button.clicks = 1;
    const int button = w.integer(2);
    if (button < 1 || button > 5) Words::fail();
    event.button.button = static_cast<Uint8>(button);
    event.button.x = w.integer(3), event.button.y = w.integer(4);
    return event;
}

SDL_Event make_motion(const Words& w) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = w.integer(2), event.motion.y = w.integer(3);
    event.motion.xrel = w.integer(4), event.motion.yrel = w.integer(5);
    return event;
}

SDL_Event make_wheel(const Words& w) {
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = w.integer(2);
    event.wheel.preciseY = static_cast<float>(event.wheel.y);
    return event;
}

SDL_Event make_text(const Words& w) {
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    const std::string text = w.rest(2);
    if (text.size() >= sizeof(event.text.text)) Words::fail();
    std::memcpy(event.text.text, text.c_str(), text.size() + 1);
    return event;
}

}  // namespace

std::optional<std::string> event_line(const SDL_Event& event, int modifiers) {
    const auto line = [&](const std::string& text) {
        return fmt::format("{} {}", modifiers, text);
    };
    switch (event.type) {
        case SDL_MOUSEMOTION:
            return line(fmt::format("motion {} {} {} {}", event.motion.x, event.motion.y,
                                    event.motion.xrel, event.motion.yrel));
        case SDL_MOUSEBUTTONDOWN:
            return line(button_line("down", event.button));
        case SDL_MOUSEBUTTONUP:
            return line(button_line("up", event.button));
        case SDL_MOUSEWHEEL:
            return line(fmt::format("wheel {}", event.wheel.y));
        case SDL_KEYDOWN:
            return line(key_line("key", event.key));
        case SDL_KEYUP:
            return line(key_line("key-up", event.key));
        case SDL_TEXTINPUT:
            return line(fmt::format("text {}", event.text.text));
        case SDL_DROPFILE:
            return line(fmt::format("drop {}", event.drop.file));
        default:
            return std::nullopt;
    }
}

PlayedEvent parse_event(std::string_view line) {
    const Words w(line);
    PlayedEvent out{{}, w.integer(0), {}};
    const std::string_view kind = w.word(1);
    if (kind == "motion") {
        out.event = make_motion(w);
    } else if (kind == "down" || kind == "up") {
        out.event = make_button(w, kind == "down" ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP);
    } else if (kind == "wheel") {
        out.event = make_wheel(w);
    } else if (kind == "key" || kind == "key-up") {
        out.event = make_key(w, kind == "key" ? SDL_KEYDOWN : SDL_KEYUP, out.modifiers);
    } else if (kind == "text") {
        out.event = make_text(w);
    } else if (kind == "drop") {
        out.event.type = SDL_DROPFILE;
        out.file = w.rest(2);
    } else {
        Words::fail();
    }
    return out;
}

Recorder::Recorder(const std::filesystem::path& file) : out_(file) {
    if (!out_) throw Error(Errc::file, "the interaction cannot be written there").at(file.string());
}

void Recorder::write(const SDL_Event& event) {
    if (const auto line = event_line(event, SDL_GetModState())) {
        out_ << *line << '\n';
        events_since_frame_ = true;
    }
}

void Recorder::frame() {
    if (std::exchange(events_since_frame_, false)) out_ << "frame\n" << std::flush;
}

Player::Player(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw Error(Errc::file, "there is no such recording").at(file.string());
    std::string line;
    std::vector<PlayedEvent> events;
    std::size_t count = 0;
    for (long number = 1; std::getline(in, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        if (line == "frame") {
            frames_.push_back(std::exchange(events, {}));
            continue;
        }
        try {
            events.push_back(parse_event(line));
        } catch (Error& error) {
            throw error.at(file.string(), number);
        }
        if (++count > max_events)
            throw Error(Errc::format,
                        fmt::format("the recording has more than {} events", max_events))
                .at(file.string());
    }
    if (!events.empty()) frames_.push_back(std::move(events));
}

void Player::push(const PlayedEvent& played) {
    SDL_SetModState(static_cast<SDL_Keymod>(played.modifiers));
    SDL_Event event = played.event;
    if (event.type == SDL_DROPFILE) event.drop.file = SDL_strdup(played.file.c_str());
    SDL_PushEvent(&event);
}

}  // namespace scanshade::viewer
