#include "scanshade/base/parallel.hpp"

#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("parallel_for visits each index once, in pieces of the grain at most", "[threads]") {
    for (const int threads : {0, 1, 2, 3, 7, 20})
        for (const std::size_t count : {0u, 1u, 2u, 16u, 17u, 1000u})
            for (const std::size_t grain : {1u, 3u, 16u, 5000u}) {
                std::vector<int> visits(count);
                std::mutex mutex;
                bool sizes = true;
                parallel_for(count, grain, threads, [&](std::size_t begin, std::size_t end, int) {
                    const std::lock_guard lock(mutex);
                    sizes = sizes && begin < end && end - begin <= grain && end <= count;
                    for (std::size_t i = begin; i < end; ++i) ++visits[i];
                });
                CAPTURE(threads, count, grain);
                CHECK(sizes);
                CHECK(visits == std::vector<int>(count, 1));
            }
}

TEST_CASE("no two calls of parallel_for with one worker overlap", "[threads]") {
    for (const int threads : {0, 1, 2, 3, 7}) {
        const int workers = threads == 0 ? available_threads() : threads;
        // One more than there are: what a worker that does not exist would use.
        std::vector<std::atomic<int>> inside(std::size_t(workers) + 1);
        std::atomic<int> overlaps{0}, strangers{0};
        // Not atomic: the thread sanitizer sees every overlap, too.
        std::vector<std::unique_ptr<int>> scratch;
        for (int w = 0; w < workers; ++w) scratch.push_back(std::make_unique<int>(0));
        parallel_for(2000, 1, threads, [&](std::size_t, std::size_t, int worker) {
            if (worker < 0 || worker >= workers) {
                ++strangers;
                return;
            }
            if (inside[std::size_t(worker)].fetch_add(1) != 0) ++overlaps;
            ++*scratch[std::size_t(worker)];
            std::this_thread::yield();
            inside[std::size_t(worker)].fetch_sub(1);
        });
        int calls = 0;
        for (const auto& own : scratch) calls += *own;
        CAPTURE(threads);
        CHECK(strangers == 0);
        CHECK(overlaps == 0);
        CHECK(calls == 2000);
    }
}

TEST_CASE("parallel_for takes as many threads as it is told, beyond those of the machine too",
          "[threads]") {
    for (const int threads : {2, 5, 9}) {
        // Each piece waits until all threads have one, so fewer threads would not end; a limit of
        // time turns that into a failure.
        std::atomic<int> waiting{0};
        std::atomic<bool> all{false};
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        parallel_for(std::size_t(threads), 1, threads, [&](std::size_t, std::size_t, int) {
            if (++waiting == threads) all = true;
            while (!all && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        });
        CAPTURE(threads);
        CHECK(all);
    }
}

TEST_CASE("parallel_for throws what a body throws", "[threads]") {
    for (const int threads : {1, 2, 7}) {
        CAPTURE(threads);
        CHECK_THROWS_WITH(parallel_for(100, 1, threads,
                                       [](std::size_t begin, std::size_t, int) {
                                           if (begin == 40) throw std::runtime_error("piece 40");
                                       }),
                          "piece 40");
        // And is fit for use afterwards.
        std::atomic<int> calls{0};
        parallel_for(100, 1, threads, [&](std::size_t, std::size_t, int) { ++calls; });
        CHECK(calls == 100);
    }
}

TEST_CASE("callers on several threads do not share their workers' numbers", "[threads]") {
    std::atomic<int> overlaps{0}, calls{0};
    const auto call = [&] {
        for (int k = 0; k < 50; ++k) {
            std::vector<std::atomic<int>> inside(3);
            parallel_for(40, 1, 3, [&](std::size_t, std::size_t, int worker) {
                if (inside[std::size_t(worker)].fetch_add(1) != 0) ++overlaps;
                std::this_thread::yield();
                inside[std::size_t(worker)].fetch_sub(1);
                ++calls;
            });
        }
    };
    std::vector<std::thread> callers;
    for (int i = 0; i < 4; ++i) callers.emplace_back(call);
    for (std::thread& caller : callers) caller.join();
    CHECK(overlaps == 0);
    CHECK(calls == 4 * 50 * 40);
}

TEST_CASE("thousands of loops take no more memory than a few", "[threads]") {
    const auto resident_pages = [] {
        long size = 0, resident = 0;
        std::ifstream("/proc/self/statm") >> size >> resident;
        return resident;
    };
    const auto loop = [](int times) {
        for (int k = 0; k < times; ++k) parallel_for(8, 1, 3, [](std::size_t, std::size_t, int) {});
    };
    loop(100);
    const long before = resident_pages();
    loop(3000);
    CHECK(resident_pages() - before < 1000);  // 4 MB
}
