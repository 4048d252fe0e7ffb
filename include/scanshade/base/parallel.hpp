// Loops over independent parts, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace scanshade {

/// Threads that this machine runs at once, at least 1.
int available_threads();

/// Calls body(begin, end, worker) until [0, count) is done, in pieces of at most `grain`, on up to
/// `threads` threads (0: all that the machine runs). worker is below max(threads, 1) and no two
/// calls with one worker overlap, so it can index scratch memory. Which worker gets which piece is
/// left to chance: results must not depend on it. The first exception of a body is thrown here.
void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t begin, std::size_t end, int worker)>& body);

}  // namespace scanshade
