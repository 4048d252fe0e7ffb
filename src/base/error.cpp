#include "scanshade/base/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace scanshade {

Error::Error(Errc code, std::string sentence)
    : std::runtime_error(sentence), code_(code), text_(std::move(sentence)) {}

Error& Error::at(std::string_view file, long line) {
    if (placed_) return *this;
    placed_ = true;
    text_ =
        line > 0 ? fmt::format("{}:{}: {}", file, line, text_) : fmt::format("{}: {}", file, text_);
    return *this;
}

void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "scanshade: internal error: %s does not hold at %s:%d; please report it\n",
                 condition, file, line);
    std::abort();
}

}  // namespace scanshade
