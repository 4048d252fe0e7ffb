#include "scanshade/kernels/isa.hpp"

#include <hwy/targets.h>

#include "scanshade/base/error.hpp"

namespace scanshade {

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.emplace_back(hwy::TargetName(target));
    return names;
}

void use_instruction_set(const std::string& name) {
    if (name.empty()) return hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (name == hwy::TargetName(target)) return hwy::SetSupportedTargetsForTest(target);
    throw Error(Errc::usage, "this machine does not run the instruction set '" + name + "'");
}

}  // namespace scanshade
