// What goes wrong, and what is said of it.
#pragma once

#include <functional>
#include <string>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"

namespace scanshade {

/// The call throws an Error of that kind whose sentence has `part` in it.
inline void check_error(Errc code, const std::string& part, const std::function<void()>& call) {
    try {
        call();
        FAIL("no error, expected: " << part);
    } catch (const Error& error) {
        CAPTURE(error.what());
        CHECK(error.code() == code);
        CHECK(std::string(error.what()).find(part) != std::string::npos);
    }
}

}  // namespace scanshade
