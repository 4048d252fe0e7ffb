#include "viewer/display.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "cli/process.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade {
namespace {

constexpr std::chrono::seconds patience{10};

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

void redirect(const std::string& path, int descriptor) {
    if (path.empty()) return;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

void change_environment(const std::vector<std::string>& environment) {
    for (const std::string& entry : environment) {
        const std::size_t equals = entry.find('=');
        if (equals == std::string::npos)
            ::unsetenv(entry.c_str());
        else
            ::setenv(entry.substr(0, equals).c_str(), entry.c_str() + equals + 1, 1);
    }
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

bool is_installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    for (const std::string_view folder : split(path ? path : "", ':'))
        if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

Child::Child(const std::vector<std::string>& command, const std::vector<std::string>& environment,
             const Redirected& redirected) {
    std::vector<char*> argv;
    for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    id_ = ::fork();
    if (id_ < 0) throw std::runtime_error("cannot fork");
    if (id_ > 0) return;
    change_environment(environment);
    redirect(redirected.out, STDOUT_FILENO);
    redirect(redirected.err, STDERR_FILENO);
    if (!redirected.folder.empty() && ::chdir(redirected.folder.c_str()) != 0) ::_exit(126);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
}

Child::~Child() {
    if (ended_) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
}

int Child::wait(int seconds) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    for (int status = 0; !ended_ && std::chrono::steady_clock::now() < deadline; pause()) {
        if (::waitpid(id_, &status, WNOHANG) != id_) continue;
        ended_ = true;
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    return status_;
}

// The server chooses a free number itself and prints it (on standard output) once it is ready;
// with -fbdir its memory is a file. Without -noreset it would start afresh whenever xdotool, its
// only client so far, leaves, and take down a viewer that is just connecting.
Display::Display(const std::string& size)
    : server_({"Xvfb", "-displayfd", "1", "-screen", "0", size, "-fbdir", folder_.path, "-nolisten",
               "tcp", "-nocursor", "-noreset"},
              {}, {folder_.path / "number", folder_.path / "err", ""}) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (name_.find('\n') == std::string::npos) {
        if (std::chrono::steady_clock::now() > deadline)
            throw std::runtime_error("Xvfb does not start: " + read_file(folder_.path / "err"));
        pause();
        name_ = read_file(folder_.path / "number");
    }
    name_ = ":" + name_.substr(0, name_.find('\n'));
}

std::vector<std::string> Display::environment() const {
    // D-Bus and what SDL loads at run time keep memory to the end; a sanitizer would call it a leak
    // of the viewer. Leaks of our own code are found where the tests link it.
    return {"DISPLAY=" + name_, "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XAUTHORITY",
            "ASAN_OPTIONS=detect_leaks=0"};
}

std::string Display::xdotool(const std::string& command) const {
    std::vector<std::string> all = words("xdotool " + command);
    const std::string out = folder_.path / "xdotool";
    Child child(all, environment(), {out, folder_.path / "err", ""});
    child.wait();
    return read_file(out);
}

Image Display::screen(int x, int y, int width, int height) const {
    // A dump as xwd writes it: a header of big-endian words, colours of 12 bytes, then rows of
    // pixels, here of four bytes: blue, green, red and one that is not used.
    enum { header_size = 0, screen_width = 4, screen_height, byte_order = 7, pixel_bits = 11 };
    enum { row_bytes = 12, colour_count = 19 };
    const std::string dump = read_file(folder_.path / "Xvfb_screen0");
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(dump.at(at)); };
    const auto word = [&](std::size_t n) {
        return std::size_t{byte(4 * n)} << 24 | std::size_t{byte(4 * n + 1)} << 16 |
               std::size_t{byte(4 * n + 2)} << 8 | std::size_t{byte(4 * n + 3)};
    };
    if (word(pixel_bits) != 32 || word(byte_order) != 0)
        throw std::runtime_error("the screen's pixels are not stored as expected");
    if (x < 0 || y < 0 || std::size_t(x + width) > word(screen_width) ||
        std::size_t(y + height) > word(screen_height))
        throw std::runtime_error("the window is not wholly on the screen");
    const std::size_t pixels = word(header_size) + 12 * word(colour_count);

    Image image(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (std::size_t channel = 0; channel < 3; ++channel)
                image.pixel(column, row)[channel] =
                    byte(pixels + std::size_t(y + row) * word(row_bytes) +
                         4 * std::size_t(x + column) + 2 - channel);
    return image;
}

}  // namespace scanshade
