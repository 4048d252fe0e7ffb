// Pictures that are compared with each other.
#pragma once

#include <fmt/format.h>

#include "scanshade/base/error.hpp"

namespace scanshade {

/// Throws Error(format) where the sizes differ.
template <class Picture>
void check_same_size(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(Errc::format, fmt::format("pictures of {} × {} and {} × {} pixels cannot be "
                                              "compared; they must have the same size",
                                              a.width, a.height, b.width, b.height));
}

}  // namespace scanshade
