#include "scanshade/base/memory.hpp"

#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <new>
#include <optional>
#include <string>

namespace scanshade {
namespace {

/// The number in KiB that stands behind a key in one of the system's files, in bytes.
std::optional<std::uint64_t> bytes_in(const char* file, const std::string& key) {
    std::ifstream lines(file);
    for (std::string word; lines >> word; lines.ignore(4096, '\n')) {
        std::uint64_t kib = 0;
        if (word == key && lines >> kib) return 1024 * kib;
    }
    return std::nullopt;
}

/// What a container may have; more than any machine where there is none.
std::uint64_t container_bytes() {
    std::ifstream file("/sys/fs/cgroup/memory.max");
    std::uint64_t bytes = 0;
    return file >> bytes ? bytes : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

std::uint64_t peak_memory_bytes() {
    // getrusage would count what the parent had resident before it started this program.
    return bytes_in("/proc/self/status", "VmHWM:").value_or(0);
}

void limit_memory() {
    const auto available = bytes_in("/proc/meminfo", "MemAvailable:");
    const auto taken = bytes_in("/proc/self/status", "VmData:");
    rlimit limit = {};
    if (!available || !taken || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    // A sanitizer maps more than any machine has, and does with it as it likes.
    if (*taken > *available) return;
    limit.rlim_cur =
        std::min({rlim_t(*taken + *available), rlim_t(container_bytes()), limit.rlim_cur});
    ::setrlimit(RLIMIT_DATA, &limit);
}

void* allocate_large(std::size_t bytes) {
    constexpr std::size_t line = 64, huge_page = std::size_t{2} << 20;
    const bool large = bytes >= 2 * huge_page;
    const std::size_t boundary = large ? huge_page : line;
    void* const memory = std::aligned_alloc(boundary, (bytes + boundary - 1) / boundary * boundary);
    if (memory == nullptr) throw std::bad_alloc();
    // A wish: where it is not granted, only time differs.
    if (large) ::madvise(memory, bytes, MADV_HUGEPAGE);
    return memory;
}

}  // namespace scanshade
