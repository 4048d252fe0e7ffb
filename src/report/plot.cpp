#include "scanshade/report/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/report/document.hpp"

extern char** environ;

namespace scanshade {
namespace fs = std::filesystem;
namespace {

/// A folder inside the report's, for gnuplot to work in; goes away with its object.
struct Workshop {
    fs::path path;

    explicit Workshop(const std::string& folder) {
        std::string name = (fs::path(folder) / ".plot-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw Error(Errc::file, fmt::format("folder '{}' cannot be written into ({})", folder,
                                                std::strerror(errno)));
        path = name;
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
};

constexpr const char* style = R"(
set encoding utf8
set datafile separator "\t"
set output 'picture.svg'
set border 3 lc rgb '#8a8f98'
set tics nomirror textcolor rgb '#30343b'
set grid lc rgb '#e3e5e8' lt 1
set key textcolor rgb '#30343b'
)";

std::string script_of(const Plot& plot) {
    // noenhanced: '_' and '^' in names are letters.
    std::string script = fmt::format(
        "set terminal svg noenhanced size {},{} font 'sans-serif,13' "
        "background '#ffffff'\n",
        plot.width, plot.height);
    for (const auto& [name, value] : plot.numbers) script += fmt::format("{} = {}\n", name, value);
    script += style;
    for (const char* part : plot.script) script += part;
    return script;
}

/// Starts gnuplot in the folder, on 'script', with nothing to read and its words in 'words'. No
/// shell has a part in it. Returns 0, or why it could not be started.
int start_gnuplot(const fs::path& folder, pid_t& child) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "words", O_WRONLY | O_CREAT, 0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    // A group of its own: Ctrl-C is for the measurement, whose plots are then still drawn.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    char name[] = "gnuplot", defaults[] = "-d", script[] = "script";
    char* arguments[] = {name, defaults, script, nullptr};
    const int reason = ::posix_spawnp(&child, name, &actions, &attributes, arguments, environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return reason;
}

/// An empty string, or why there is no picture.
std::string draw(const Plot& plot, const std::string& folder) {
    const Workshop workshop(folder);
    write_file(script_of(plot), workshop.path / "script");
    write_file(plot.data.bytes(), workshop.path / "data");
    pid_t child = 0;
    if (const int reason = start_gnuplot(workshop.path, child); reason != 0)
        return fmt::format("gnuplot could not be started ({})", std::strerror(reason));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    std::error_code missing;
    if (status == 0)
        fs::rename(workshop.path / "picture.svg", fs::path(folder) / plot.file, missing);
    if (status == 0 && !missing) return {};
    return fmt::format("gnuplot failed on {} (status {})", plot.file, status);
}

}  // namespace

PlotData& PlotData::field(std::string_view bytes) {
    if (line_begun_) bytes_ += '\t';
    bytes_ += bytes;
    line_begun_ = true;
    return *this;
}

PlotData& PlotData::number(double value) { return field(fmt::format("{}", value)); }

PlotData& PlotData::text(std::string_view name) {
    std::string letters = clean_text(name);
    for (char& c : letters)
        if (c == '"' || c == '\\' || c == '`') c = '\'';
    // A field of blanks would be no field: a space that is none to gnuplot.
    if (letters.find_first_not_of(' ') == std::string::npos) letters = "\u00a0";
    return field(fmt::format("\"{}\"", letters));
}

void PlotData::end_line() {
    bytes_ += '\n';
    line_begun_ = false;
}

void PlotData::end_block() { bytes_ += "\n\n"; }

std::string draw_plots(std::span<const Plot> plots, const std::string& folder) {
    std::error_code ignored;  // pictures of an earlier report would be taken for this one's
    for (const Plot& plot : plots) fs::remove(fs::path(folder) / plot.file, ignored);
    for (const Plot& plot : plots)
        if (const std::string reason = draw(plot, folder); !reason.empty())
            return fmt::format("{}, so the report has no plots; Debian's package is gnuplot-nox",
                               reason);
    return {};
}

}  // namespace scanshade
