#include "scanshade/base/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "scanshade/base/text.hpp"

namespace scanshade {

Error::Error(Errc code, std::string_view sentence)
    : std::runtime_error(std::string(sentence)), code_(code), text_(shortened(sentence)) {}

Error& Error::at(std::string_view file, long line) {
    if (placed_) return *this;
    placed_ = true;
    const std::string place = shortened(file);
    text_ = line > 0 ? fmt::format("{}:{}: {}", place, line, text_)
                     : fmt::format("{}: {}", place, text_);
    return *this;
}

void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "scanshade: internal error: %s does not hold at %s:%d; please report it\n",
                 condition, file, line);
    std::abort();
}

}  // namespace scanshade
