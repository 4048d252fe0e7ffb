#include "cli/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace scanshade {
namespace {

int open_for_child(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0) throw std::runtime_error("cannot open " + path);
    return descriptor;
}

struct Limit {
    int resource;
    rlimit value;
    std::string folder;  // of the run's own
};

/// Starts the program with these descriptors; the caller keeps its own copies.
pid_t start(const std::string& program, const std::vector<std::string>& args, int out, int err,
            const Limit* limit = nullptr) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& arg : args) argv.push_back(const_cast<char*>(arg.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child > 0) return child;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        ::signal(signal, SIG_DFL);  // as from a terminal
    if (limit) ::setrlimit(__rlimit_resource_t(limit->resource), &limit->value);
    // The counts of coverage that all runs add to must not be cut by a limit on files, and that
    // they are is not the program's to say.
    if (limit && limit->resource == RLIMIT_FSIZE) {
        ::setenv("GCOV_PREFIX", limit->folder.c_str(), 1);
        ::setenv("GCOV_ERROR_FILE", "/dev/null", 1);
    }
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
}

int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Finished run_scanshade(const std::vector<std::string>& args, const std::string& stdout_to,
                       const std::string& program) {
    const TempFolder folder;
    const std::string out_path = stdout_to.empty() ? (folder.path / "out").string() : stdout_to;
    const std::string err_path = folder.path / "err";
    const int out = open_for_child(out_path), err = open_for_child(err_path);
    Finished finished;
    finished.status = wait_for(start(program, args, out, err));
    ::close(out);
    ::close(err);
    if (stdout_to.empty()) finished.out = read_file(out_path);
    finished.err = read_file(err_path);
    return finished;
}

Finished run_scanshade_on_terminal(const std::vector<std::string>& args, const std::string& until) {
    const TempFolder folder;
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0)
        throw std::runtime_error("cannot open a terminal");
    const int err = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const int out = open_for_child(folder.path / "out");
    const pid_t child = start(SCANSHADE_BINARY, args, out, err);
    ::close(out);
    ::close(err);
    Finished finished;
    bool interrupted = false;
    char buffer[4096];
    // Reading fails once the child, the last to hold the other end, is gone.
    for (ssize_t n; (n = ::read(terminal, buffer, sizeof buffer)) > 0;) {
        finished.err.append(buffer, std::size_t(n));
        if (interrupted || finished.err.find(until) == std::string::npos) continue;
        ::kill(child, SIGINT);
        interrupted = true;
    }
    finished.status = wait_for(child);
    ::close(terminal);
    return finished;
}

Finished run_scanshade_unread(const std::vector<std::string>& args) {
    const TempFolder folder;
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
    ::close(ends[0]);
    const int err = open_for_child(folder.path / "err");
    Finished finished;
    finished.status = wait_for(start(SCANSHADE_BINARY, args, ends[1], err));
    ::close(ends[1]);
    ::close(err);
    finished.err = read_file(folder.path / "err");
    return finished;
}

Finished run_scanshade_interrupted(const std::vector<std::string>& args, const std::string& file,
                                   std::chrono::milliseconds after, int signal) {
    const TempFolder folder;
    const int out = open_for_child(folder.path / "out"), err = open_for_child(folder.path / "err");
    const pid_t child = start(SCANSHADE_BINARY, args, out, err);
    ::close(out);
    ::close(err);
    constexpr std::chrono::milliseconds step{10};
    for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i)
        std::this_thread::sleep_for(step);
    std::this_thread::sleep_for(after);
    ::kill(child, signal);
    Finished finished;
    finished.status = wait_for(child);
    finished.out = read_file(folder.path / "out");
    finished.err = read_file(folder.path / "err");
    return finished;
}

Finished run_scanshade_limited(const std::vector<std::string>& args, int resource,
                               std::uint64_t bytes) {
    const TempFolder folder;
    const int out = open_for_child(folder.path / "out"), err = open_for_child(folder.path / "err");
    const Limit limit{resource, {rlim_t(bytes), rlim_t(bytes)}, folder.path};
    Finished finished;
    finished.status = wait_for(start(SCANSHADE_BINARY, args, out, err, &limit));
    ::close(out);
    ::close(err);
    finished.out = read_file(folder.path / "out");
    finished.err = read_file(folder.path / "err");
    return finished;
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string write_triangle(const TempFolder& folder) {
    return folder.write("triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n").string();
}

}  // namespace scanshade
