#include "scene/toml_keys.hpp"

#include <algorithm>

namespace scanshade {
namespace {

/// Where the string that begins at `at` ends, one past its last quote; the end of the text where it
/// does not.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string_view three(quote == '"' ? "\"\"\"" : "'''");
    const bool many_lines = text.substr(at, 3) == three;
    const std::string_view close = many_lines ? three : three.substr(0, 1);
    for (at += close.size(); at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"')
            ++at;
        else if (text[at] == '\n' && !many_lines)
            return at;
        else if (text.substr(at, close.size()) == close)
            return at + close.size();
    }
    return text.size();
}

bool is_in_key(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == ' ' || c == '\t';
}

}  // namespace

std::size_t line_of_long_key(std::string_view text, std::size_t most) {
    std::size_t parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = end_of_string(text, at);
            continue;
        }
        if (c == '.')
            ++parts;
        else if (!is_in_key(c))
            parts = 1;
        if (parts > most)
            return 1 +
                   std::size_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
        at = c == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
    }
    return 0;
}

}  // namespace scanshade
