// Where numbers come from: what somebody needs who wants the same ones again.
#pragma once

#include <cstdint>
#include <string>

#include "scanshade/scene/settings.hpp"

namespace scanshade {

struct Provenance {
    std::string commit;           // "unknown" where this was not built in a checkout
    std::string compiler, flags;  // of this library
    std::string cpu;              // "unknown" where the system does not say
    std::string isa;              // instruction set that the kernels use
    int threads;
    std::uint64_t seed;  // of whatever is left to chance
    std::string date;    // now, in UTC: 2026-01-31T12:00:00Z
};

Provenance provenance(const Settings& settings, std::uint64_t seed);

}  // namespace scanshade
