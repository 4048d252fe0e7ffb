// Instruction sets: which this machine has, and which one kernels use.
#pragma once

#include <string>
#include <vector>

namespace scanshade {

/// Names of the instruction sets that are compiled in and run on this machine, best first.
std::vector<std::string> instruction_sets();

/// Makes kernels use that one; "" the best. Not while kernels run on other threads.
void use_instruction_set(const std::string& name);

}  // namespace scanshade
