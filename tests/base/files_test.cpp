// Files: read whole or refused, written whole or not at all.
#include "scanshade/base/files.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "scanshade/base/error.hpp"
#include "support/check_error.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

std::size_t file_count(const TempFolder& folder) {
    return std::size_t(
        std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}

/// The exit status of a process that may write files of at most `bytes`, and gets SIGXFSZ in the
/// middle of a longer one.
int status_in_child(rlim_t bytes, void (*handler)(int), const std::function<int()>& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, handler);
        ::_exit(body());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a file comes back as it was written", "[files]") {
    const TempFolder folder;
    const fs::path file = folder.path / std::string(250, 'n');  // as long as names nearly can be
    for (const std::string& bytes : {std::string(), std::string("a\0\xff\n", 4)}) {
        write_file(bytes, file);
        CHECK(read_file(file, 4) == bytes);
    }
    CHECK(file_count(folder) == 1);
}

TEST_CASE("what is no regular file, or too large, is refused before it is read", "[files]") {
    const TempFolder folder;
    const auto read = [](const fs::path& path) { return [=] { read_file(path, 100); }; };
    check_error(Errc::file, "No such file", read(folder.path / "none"));
    check_error(Errc::file, "it is a folder", read(folder.path));
    check_error(Errc::file, "no regular file", read("/dev/zero"));
    REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
    check_error(Errc::file, "no regular file", read(folder.path / "pipe"));
    check_error(Errc::file, "it changes", read("/proc/self/status"));  // longer than it says
    const fs::path large = folder.write("large", "");
    fs::resize_file(large, 101);
    check_error(Errc::format, "has 101 bytes; at most 100", read(large));
    fs::resize_file(large, 100);
    CHECK(read_file(large, 100).size() == 100);
}

TEST_CASE("a file that cannot be written whole leaves what was there, and nothing else",
          "[files]") {
    const TempFolder folder;
    const fs::path file = folder.write("a", "before");
    const std::string bytes(100'000, 'x');
    CHECK(status_in_child(5000, SIG_IGN, [&] {
              try {
                  write_file(bytes, file);
              } catch (const Error& error) {
                  return int(error.code());
              }
              return 0;
          }) == int(Errc::file));
    CHECK(read_file(file, 100) == "before");
    CHECK(file_count(folder) == 1);
    write_file(bytes, file);
    CHECK(fs::file_size(file) == bytes.size());
}

TEST_CASE("a signal in the middle of a file leaves nothing of it", "[files]") {
    const TempFolder folder;
    const auto handler = [](int) {
        remove_unfinished_file();
        ::_exit(42);
    };
    const std::string bytes(100'000, 'x');
    CHECK(status_in_child(5000, handler, [&] {
              write_file(bytes, folder.path / "a");
              return 0;
          }) == 42);
    CHECK(file_count(folder) == 0);
}
