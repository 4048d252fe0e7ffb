#include "scanshade/kernels/isa.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/targets.h>

#include <cctype>

#include "scanshade/base/error.hpp"

namespace scanshade {

namespace {

/// Highway's name in the spelling of --isa.
std::string name_of(std::int64_t target) {
    std::string name = hwy::TargetName(target);
    if (name == "EMU128") return "scalar";
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

/// Asked once: when one has been chosen, Highway knows of no other.
const std::vector<std::int64_t>& all_targets() {
    static const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    return targets;
}

}  // namespace

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const std::int64_t target : all_targets()) names.push_back(name_of(target));
    return names;
}

void use_instruction_set(const std::string& name) {
    const std::vector<std::int64_t>& targets = all_targets();
    if (name.empty()) return hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : targets)
        if (name == name_of(target)) return hwy::SetSupportedTargetsForTest(target);
    throw Error(Errc::usage,
                fmt::format("this machine does not run the instruction set '{}'; it runs {}", name,
                            fmt::join(instruction_sets(), ", ")));
}

}  // namespace scanshade
