// scanshade view: hands over to scanshade-view, so that this program needs no window system.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade {
namespace fs = std::filesystem;
namespace {

constexpr const char* viewer_name = "scanshade-view";

bool is_program(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

/// Beside this program, else on the PATH; empty where it is nowhere.
fs::path find_viewer() {
    std::error_code ignored;
    const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / viewer_name;
    if (is_program(beside)) return beside;
    const char* path = std::getenv("PATH");
    for (const std::string_view folder : split(path ? path : "", ':'))
        if (!folder.empty() && is_program(fs::path(folder) / viewer_name))
            return fs::path(folder) / viewer_name;
    return {};
}

}  // namespace

int run_view(OptionParser& options, char** args) {
    // The shared options are checked here already; what the viewer has besides is its own matter.
    std::string input;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.shared(settings);
    options.allow_unknown();
    if (!options.parse(args)) return exit_done;

    const fs::path viewer = find_viewer();
    if (viewer.empty())
        throw Error(Errc::file,
                    "the viewer 'scanshade-view' is neither beside this program nor on the PATH; "
                    "'make' builds it where libsdl2-dev is installed");
    std::vector<char*> viewer_args{const_cast<char*>(viewer_name)};
    while (*args) viewer_args.push_back(*args++);
    viewer_args.push_back(nullptr);
    std::signal(SIGPIPE, SIG_DFL);  // the viewer decides for itself
    ::execv(viewer.c_str(), viewer_args.data());
    throw Error(Errc::file, "this program could not be started").at(viewer.string());
}

}  // namespace scanshade
