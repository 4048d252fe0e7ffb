#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace scanshade {
namespace {

constexpr std::chrono::milliseconds first_shown{1000}, interval{200};
constexpr const char* clear_line = "\r\033[K";

}  // namespace

Progress::Progress(std::string text) : text_(std::move(text)) {
    if (::isatty(STDERR_FILENO))
        thread_ = std::jthread([this](const std::stop_token& stop) { show_until_stopped(stop); });
}

Progress::~Progress() { finish(); }

void Progress::text(std::string now) {
    const std::lock_guard lock(mutex_);
    text_ = std::move(now);
}

void Progress::finish() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void Progress::show_until_stopped(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    auto wait = first_shown;
    bool shown = false;
    // Nobody notifies: the stop token alone ends the waiting early.
    while (!stopped_.wait_for(lock, stop, wait, [&] { return stop.stop_requested(); })) {
        fmt::print(stderr, "{}{} ({:.0f} s)", clear_line, text_, timer_.ms() / 1000);
        std::fflush(stderr);
        shown = true;
        wait = interval;
    }
    if (shown) fmt::print(stderr, "{}", clear_line);
}

}  // namespace scanshade
