#include "scanshade/base/parallel.hpp"

#ifdef SCANSHADE_STD_THREADS
#include <atomic>
#include <exception>
#include <thread>
#else
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace scanshade {
namespace {

#ifdef SCANSHADE_STD_THREADS

int machine_threads() { return int(std::thread::hardware_concurrency()); }

/// For the thread sanitizer, which cannot see how oneTBB's threads wait for each other. Calls
/// run(piece, worker) for each piece.
template <class Run>
void run_pieces(std::size_t pieces, int threads, const Run& run) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr first;
    const auto work = [&](int worker) {
        try {
            for (std::size_t piece; (piece = next.fetch_add(1)) < pieces;) run(piece, worker);
        } catch (...) {
            next.store(pieces);
            const std::lock_guard lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (int worker = 1; worker < threads; ++worker) others.emplace_back(work, worker);
    work(0);
    for (std::thread& thread : others) thread.join();
    if (first) std::rethrow_exception(first);
}

#else

int machine_threads() { return tbb::info::default_concurrency(); }

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

/// One for each number of threads, kept: oneTBB does not give back all that an arena has taken, and
/// a loop gets slower with each arena that there was.
tbb::task_arena& arena_of(int threads) {
    static std::mutex mutex;
    static std::map<int, tbb::task_arena> arenas;
    const std::lock_guard lock(mutex);
    return arenas.try_emplace(threads, threads).first->second;
}

template <class Run>
void run_pieces(std::size_t pieces, int threads, const Run& run) {
    allow(threads);
    arena_of(threads).execute([&] {
        tbb::parallel_for(
            std::size_t{0}, pieces,
            [&](std::size_t piece) { run(piece, tbb::this_task_arena::current_thread_index()); },
            tbb::simple_partitioner());
    });
}

#endif

}  // namespace

int available_threads() { return std::max(machine_threads(), 1); }

void parallel_for(std::size_t count, std::size_t grain, int threads,
                  const std::function<void(std::size_t, std::size_t, int)>& body) {
    if (threads == 0) threads = available_threads();
    const auto run = [&](std::size_t piece, int worker) {
        body(piece * grain, std::min((piece + 1) * grain, count), worker);
    };
    const std::size_t pieces = (count + grain - 1) / grain;
    if (threads > 1 && pieces > 1) return run_pieces(pieces, threads, run);
    for (std::size_t piece = 0; piece < pieces; ++piece) run(piece, 0);
}

}  // namespace scanshade
