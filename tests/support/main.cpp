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
    Catch::Session session;
    if (const int status = session.applyCommandLine(argc, argv); status != 0) return status;
    const auto& options = session.configData();
    const bool runs = !options.showHelp && !options.listTests && !options.listTags;
    const int status = session.run();
    std::printf("%zu passed, %zu failed\n", passed, failed);
    if (failed > 0) return 1;
    return runs && passed == 0 ? 2 : status;  // a misspelt tag must not look like success
}
