#include "scanshade/base/memory.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <new>

#include "support/catch.hpp"

using namespace scanshade;

TEST_CASE("the peak of memory is known, and grows", "[memory]") {
    const std::uint64_t before = peak_memory_bytes();
    CHECK(before > 1'000'000);
    const std::size_t size = before + (std::size_t{1} << 24);
    const std::unique_ptr<char[]> block = std::make_unique<char[]>(size);  // zeros are written
    CHECK(peak_memory_bytes() > before);
    CHECK(block[size - 1] == 0);
}

TEST_CASE("large arrays lie on lines of the cache, and too large ones are an error", "[memory]") {
    for (const std::size_t count : {1u, 15u, 1000u, 1u << 20, 3u << 20}) {
        CAPTURE(count);
        const LargeVector<float> array(count, 1.5f);
        CHECK(reinterpret_cast<std::uintptr_t>(array.data()) % 64 == 0);
        CHECK(array.back() == 1.5f);
    }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    CHECK_THROWS_AS(allocate_large(std::size_t(1) << 60), std::bad_alloc);
#endif
    CHECK_THROWS_AS(LargeAllocator<float>().allocate(std::size_t(-1) / 2), std::bad_alloc);
}

TEST_CASE("a process that limits itself gets no more than the machine has", "[memory]") {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    WARN("skipped: sanitizers map more than any machine has");
#else
    const std::size_t block = std::size_t{1} << 28;
    const auto pages = std::size_t(::sysconf(_SC_PHYS_PAGES));
    const std::size_t all = pages * std::size_t(::sysconf(_SC_PAGESIZE)) / block + 1;
    // Nothing is written, so a process without a limit gets many times what there is.
    const pid_t child = ::fork();
    if (child == 0) {
        limit_memory();
        std::size_t got = 0;
        while (got < 4 * all && ::operator new(block, std::nothrow) != nullptr) ++got;
        ::_exit(got <= all ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(status == 0);
#endif
}
