#include "scanshade/report/provenance.hpp"

#include <ctime>
#include <fstream>

#include "build_facts.inc"  // BUILD_COMMIT, BUILD_FLAGS: written by the Makefile
#include "scanshade/base/parallel.hpp"
#include "scanshade/kernels/isa.hpp"

namespace scanshade {
namespace {

std::string compiler() {
#ifdef __clang__
    return __VERSION__;  // names itself
#else
    return std::string("GCC ") + __VERSION__;
#endif
}

std::string cpu() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            if (const std::size_t colon = line.find(": "); colon != std::string::npos)
                return line.substr(colon + 2);
    return "unknown";
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text, length};
}

}  // namespace

Provenance provenance(const Settings& settings, std::uint64_t seed) {
    return {BUILD_COMMIT,
            compiler(),
            BUILD_FLAGS,
            cpu(),
            settings.isa.empty() ? instruction_sets().front() : settings.isa,
            settings.threads == 0 ? available_threads() : settings.threads,
            seed,
            utc_now()};
}

}  // namespace scanshade
