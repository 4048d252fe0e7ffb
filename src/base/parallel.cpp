#include "scanshade/base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace scanshade {

int available_threads() { return std::max(tbb::info::default_concurrency(), 1); }

namespace {

/// oneTBB starts no more threads than the machine runs at once, and complains; who asks for more
/// gets them.
void allow(int threads) {
    static std::mutex mutex;
    static int most = available_threads();
    static std::unique_ptr<tbb::global_control> allowed;
    const std::lock_guard lock(mutex);
    if (threads <= most) return;
    most = threads;
    allowed.reset();  // of several the smallest counts
    allowed = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    std::size_t(most));
}

}  // namespace

void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t, std::size_t, int)>& body) {
    if (threads == 0) threads = available_threads();
    if (threads == 1 || count <= grain) {
        for (std::size_t begin = 0; begin < count; begin += grain)
            body(begin, std::min(begin + grain, count), 0);
        return;
    }
    allow(threads);
    tbb::task_arena arena(threads);
    arena.execute([&] {
        const std::size_t pieces = (count + grain - 1) / grain;
        tbb::parallel_for(
            std::size_t{0}, pieces,
            [&](std::size_t piece) {
                const std::size_t begin = piece * grain;
                body(begin, std::min(begin + grain, count),
                     tbb::this_task_arena::current_thread_index());
            },
            tbb::simple_partitioner());
    });
}

}  // namespace scanshade
