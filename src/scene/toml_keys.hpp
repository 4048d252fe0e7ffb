// How deep the keys of a TOML text go.
#pragma once

#include <cstddef>
#include <string_view>

namespace scanshade {

/// The line, counted from 1, of the first key of more than `most` parts (a.b.c has three); 0: none.
/// Each part is a table in a table, and the library takes tables apart one inside the other, as deep
/// as its stack holds.
std::size_t line_of_long_key(std::string_view text, std::size_t most);

}  // namespace scanshade
