// A line that says what is going on, for work that takes longer than a second.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "scanshade/base/timer.hpp"

namespace scanshade {

/// Shows its text and the seconds on standard error from the first second on, and takes the line
/// away at the end. Silent where standard error is no terminal.
class Progress {
public:
    explicit Progress(std::string text);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void text(std::string now);

    /// Takes the line away, so that something else can be written; nothing is shown afterwards.
    void finish();

private:
    void show_until_stopped(const std::stop_token& stop);

    Timer timer_;
    std::mutex mutex_;  // guards text_
    std::condition_variable_any stopped_;
    std::string text_;
    std::jthread thread_;  // last: it uses the others
};

}  // namespace scanshade
