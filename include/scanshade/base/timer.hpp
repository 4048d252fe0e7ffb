// Wall-clock time.
#pragma once

#include <chrono>

namespace scanshade {

/// Measures from its construction (or the last restart) in milliseconds of a steady clock.
class Timer {
public:
    void restart() { start_ = Clock::now(); }
    double ms() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace scanshade
