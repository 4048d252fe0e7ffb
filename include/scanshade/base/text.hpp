// Words and numbers that people type.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scanshade {

/// The candidate with the smallest edit distance to `word`, or "" where none is near enough to be
/// a likely slip of the hand (more than a third of the word's letters, at least 2, differ).
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// ", did you mean 'x'?" with the nearest name, or the whole list where none is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

/// A finite real number that fills the whole text (no sign but '-' or '+', no trailing letters,
/// independent of the locale); nothing otherwise.
std::optional<double> parse_real(std::string_view text);

/// An integer that fills the whole text and fits; nothing otherwise.
std::optional<long long> parse_integer(std::string_view text);

/// The text, or of a longer one than `most` bytes its beginning and end, cut between characters of
/// UTF-8: a name in a sentence may be a file's megabyte.
std::string shortened(std::string_view text, std::size_t most = 1000);

/// The parts of `text` between `separator`; "a,,b" has three parts and "" has one.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace scanshade
