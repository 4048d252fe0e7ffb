#include "scanshade/base/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace fs = std::filesystem;

void write_file(std::string_view bytes, const std::string& path) {
    std::error_code ignored;
    const bool device = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
    const std::string name = device ? path : fmt::format("{}.{}.part", path, ::getpid());
    errno = 0;
    std::ofstream file(name, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    file.close();
    if (file && (device || std::rename(name.c_str(), path.c_str()) == 0)) return;
    const int reason = errno ? errno : EIO;
    if (!device) std::remove(name.c_str());
    throw Error(Errc::file,
                fmt::format("{} could not be written ({})", path, std::strerror(reason)));
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
