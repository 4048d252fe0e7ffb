// Runs the tests; the last line is "N passed, N failed".
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "support/catch.hpp"

#include <cstddef>
#include <cstdio>

namespace {

std::size_t passed = 0;
std::size_t failed = 0;

/// Counts test cases as they end.
#if __has_include(<catch2/catch_all.hpp>)
struct Tally : Catch::EventListenerBase {
    using Catch::EventListenerBase::EventListenerBase;
#else
struct Tally : Catch::TestEventListenerBase {
    using Catch::TestEventListenerBase::TestEventListenerBase;
#endif
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        const bool ok = stats.totals.testCases.failed == 0;
        ++(ok ? passed : failed);
    }
};
CATCH_REGISTER_LISTENER(Tally)

}  // namespace

int main(int argc, char** argv) {
    const int status = Catch::Session().run(argc, argv);
    std::printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0 ? 1 : status;
}
