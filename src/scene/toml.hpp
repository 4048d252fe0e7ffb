// The TOML library, whose own checks end in an error: a file can break some of them ("[[["), and an
// assertion would end the program. To be included instead of the library's header.
#pragma once

#include "scanshade/base/error.hpp"

namespace scanshade {

[[noreturn]] inline void toml_check_failed() {
    throw Error(Errc::format, "this is no TOML: its brackets, keys or values make no sense");
}

}  // namespace scanshade

#define TOML_ASSERT(condition) ((condition) ? void(0) : ::scanshade::toml_check_failed())
#include <toml++/toml.h>
