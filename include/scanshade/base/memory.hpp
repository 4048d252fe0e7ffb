// The memory of this process.
#pragma once

#include <cstdint>

namespace scanshade {

/// The most that was ever resident, in bytes; 0 where the system does not say.
std::uint64_t peak_memory_bytes();

/// From now on this process gets no more than what is available now. What asks for more gets
/// std::bad_alloc, which is an error in a sentence, before the machine swaps or the system ends
/// whichever process it likes.
void limit_memory();

}  // namespace scanshade
