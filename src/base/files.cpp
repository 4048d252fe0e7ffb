#include "scanshade/base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <random>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace fs = std::filesystem;
namespace {

/// An open file; closes with its object.
class Descriptor {
public:
    Descriptor(const char* path, int flags) : number_(::open(path, flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    /// 0, or the number of the error: some file systems say only here that a disk is full.
    int close() {
        const int reason = number_ >= 0 && ::close(number_) != 0 ? errno : 0;
        number_ = -1;
        return reason;
    }

private:
    int number_;
};

/// The name of the one file that is being written, where a handler of signals finds it. It is a
/// plain array as a handler may neither allocate nor wait; an empty name is none.
char unfinished[PATH_MAX];
std::mutex one_at_a_time;

/// Takes a name that nothing has, in the folder of the file that is to be. Short, as the file's own
/// name may be as long as names can be; random, as containers that share a folder number their
/// processes alike.
std::string begin_unfinished(const fs::path& target) {
    const fs::path name =
        target.parent_path() / fmt::format(".scanshade-{:08x}.part", std::random_device{}());
    std::snprintf(unfinished, sizeof unfinished, "%s", name.c_str());
    return name;
}

/// 0, or the number of the error.
int write_whole(std::string_view bytes, const fs::path& target) {
    const std::lock_guard lock(one_at_a_time);
    const std::string name = begin_unfinished(target);
    Descriptor file(name.c_str(), O_WRONLY | O_CREAT | O_EXCL);
    int reason = file.number() < 0 ? errno : write_all(file.number(), bytes);
    if (const int closed = file.close(); !reason) reason = closed;
    if (!reason && ::rename(name.c_str(), target.c_str()) != 0) reason = errno;
    if (reason) remove_unfinished_file();
    unfinished[0] = '\0';
    return reason;
}

int write_device(std::string_view bytes, const fs::path& path) {
    Descriptor file(path.c_str(), O_WRONLY);
    if (file.number() < 0) return errno;
    const int reason = write_all(file.number(), bytes);
    const int closed = file.close();
    return reason ? reason : closed;
}

/// Reads until the buffer is full or the file ends. Returns how many bytes there were, or -1.
ssize_t read_all(int descriptor, char* into, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n = ::read(descriptor, into + done, size - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return -1;
        if (n == 0) break;
        done += std::size_t(n);
    }
    return ssize_t(done);
}

Error unreadable(const fs::path& path, std::string_view reason) {
    Error error(Errc::file, fmt::format("the file cannot be read ({})", reason));
    return error.at(path.string());
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t max_bytes) {
    // Without waiting: nobody may ever write into a pipe of that name.
    const Descriptor file(path.c_str(), O_RDONLY | O_NONBLOCK);
    struct stat status = {};
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
        throw unreadable(path, std::strerror(errno));
    if (S_ISDIR(status.st_mode)) throw unreadable(path, "it is a folder");
    if (!S_ISREG(status.st_mode)) throw unreadable(path, "it is no regular file");
    const auto size = std::size_t(status.st_size);
    if (size > max_bytes) {
        Error error(Errc::format,
                    fmt::format("the file has {} bytes; at most {} are read", size, max_bytes));
        throw error.at(path.string());
    }
    std::string bytes(size + 1, '\0');  // one more, to see whether it has grown
    const ssize_t read = read_all(file.number(), bytes.data(), bytes.size());
    if (read < 0) throw unreadable(path, std::strerror(errno));
    if (std::size_t(read) != size) throw unreadable(path, "it changes; try again");
    bytes.resize(size);
    return bytes;
}

int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(std::size_t(n));
    }
    return 0;
}

void write_file(std::string_view bytes, const fs::path& path) {
    std::error_code absent;
    const fs::path real = fs::canonical(path, absent);  // not a link to it
    const bool device = !absent && !fs::is_regular_file(real, absent);
    const int reason =
        device ? write_device(bytes, real) : write_whole(bytes, absent ? path : real);
    if (reason)
        throw Error(Errc::file,
                    fmt::format("{} could not be written ({}); it needs a folder that exists, with "
                                "space and permission to write",
                                path.string(), std::strerror(reason)));
}

void remove_unfinished_file() noexcept {
    if (unfinished[0] != '\0') ::unlink(unfinished);
}

void make_folder(const std::string& path) {
    std::error_code reason;
    fs::create_directories(path, reason);
    if (fs::is_directory(path)) {
        if (::access(path.c_str(), W_OK | X_OK) == 0) return;
        reason = {errno, std::generic_category()};
    } else if (!reason) {
        reason = std::make_error_code(std::errc::not_a_directory);
    }
    throw Error(Errc::file, fmt::format("folder '{}' cannot be made or written into ({}); give one "
                                        "that can",
                                        path, reason.message()));
}

}  // namespace scanshade
