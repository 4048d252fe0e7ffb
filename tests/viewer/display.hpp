// A display without a screen, a program on it, and real events from xdotool.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "scanshade/image/image.hpp"
#include "support/temp_folder.hpp"

namespace scanshade {

/// Whether a program of that name is on the PATH.
bool is_installed(const std::string& program);

/// A child process; killed with its object where it is still running.
class Child {
public:
    struct Redirected {
        std::string out, err;  // files; empty: as the parent's
        std::string folder;    // to start in; empty: the parent's
    };

    /// `environment` has "NAME=value" to set and "NAME" to take away.
    Child(const std::vector<std::string>& command, const std::vector<std::string>& environment,
          const Redirected& redirected);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    pid_t id() const { return id_; }
    /// Exit status; 128 + signal where it was killed; -1 where it still runs after so many seconds.
    int wait(int seconds = 10);

private:
    pid_t id_ = -1;
    int status_ = -1;
    bool ended_ = false;
};

/// An X server of its own with no window manager. Throws std::runtime_error where it does not
/// start.
class Display {
public:
    explicit Display(const std::string& size = "800x600x24");

    /// "DISPLAY=:N", with what else a program needs to use this display and no other.
    std::vector<std::string> environment() const;

    /// Runs xdotool with the words of `command`; what it printed.
    std::string xdotool(const std::string& command) const;

    /// The part of the screen from (x, y), read from the server's own memory.
    Image screen(int x, int y, int width, int height) const;

private:
    TempFolder folder_;
    Child server_;
    std::string name_;
};

}  // namespace scanshade
