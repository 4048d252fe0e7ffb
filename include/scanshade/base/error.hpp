// Errors that a user can act on, and checks of our own work.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace scanshade {

/// What kind of input was wrong; the value is the exit status of the process.
enum class Errc { usage = 2, file = 3, format = 4, scene = 5 };

/// The only exception that this library throws. what() is one sentence: the place, what is wrong
/// and what would be right. It is thrown at the edges (files, options) and caught in main.
class Error : public std::runtime_error {
public:
    Error(Errc code, std::string_view sentence);

    /// Adds the place as "file:line: " while the exception travels up. The first place given
    /// stays: an outer caller that adds a place of its own changes nothing.
    Error& at(std::string_view file, long line = 0);

    Errc code() const noexcept { return code_; }
    const char* what() const noexcept override { return text_.c_str(); }

private:
    Errc code_;
    bool placed_ = false;
    std::string text_;
};

/// Reports a broken promise of our own code and ends the program.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace scanshade

/// Our own faults: never for input.
#define SCANSHADE_CHECK(condition) \
    ((condition) ? void(0) : ::scanshade::check_failed(#condition, __FILE__, __LINE__))
