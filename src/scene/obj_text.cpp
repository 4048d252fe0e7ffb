#include "scene/obj_text.hpp"

#include <algorithm>

#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"

namespace scanshade {
namespace {

constexpr auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
constexpr auto ends_line = [](char c) { return c == '\n' || c == '\r'; };

/// The text from its first character on that `ends`: find_first_of would ask the library anew for each
/// character, which takes longer than all that is done with a line.
template <class Ends>
std::string_view from_first(std::string_view text, Ends&& ends) {
    const auto first = std::find_if(text.begin(), text.end(), ends);
    return text.substr(std::size_t(first - text.begin()));
}
std::string_view without_leading_blanks(std::string_view text) {
    return from_first(text, [](char c) { return !is_blank(c); });
}

}  // namespace

std::string read_text(const std::filesystem::path& path, std::size_t max_bytes) {
    std::string text = read_file(path, max_bytes);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw Error(Errc::format, "the file is UTF-16 text; it must be saved as UTF-8")
            .at(path.string());
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (const auto zero = std::find(text.begin(), text.end(), '\0'); zero != text.end())
        throw Error(Errc::format, "the line has a byte of value 0, so the file is no text")
            .at(path.string(), 1 + std::count(text.begin(), zero, '\n'));
    return text;
}

std::string_view next_word(std::string_view& text) {
    text = without_leading_blanks(text);
    const std::string_view rest = from_first(text, is_blank);
    const std::string_view word = text.substr(0, text.size() - rest.size());
    text = rest;
    return word;
}

std::string_view trimmed(std::string_view text) {
    text = without_leading_blanks(text);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view StatementStream::next_line() {
    const std::string_view after = from_first(rest_, ends_line);
    const std::string_view line = rest_.substr(0, rest_.size() - after.size());
    rest_ = after;
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
    ++line_;
    return line;
}

StatementStream::int_type StatementStream::underflow() {
    if (rest_.empty()) return traits_type::eof();
    statement_ = next_line();
    const long line = line_;
    while (statement_.ends_with('\\')) {
        statement_.back() = ' ';
        if (!rest_.empty()) statement_ += next_line();
    }
    // Only numbers are followed by comments: names may have a '#' in them.
    std::string_view arguments = statement_;
    std::string_view keyword = next_word(arguments);
    const bool numbers = keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f";
    if (numbers || keyword.starts_with('#')) {
        statement_.resize(std::min(statement_.find('#'), statement_.size()));
        arguments = statement_;
        keyword = next_word(arguments);
    }
    if (!keyword.empty()) visitor_({keyword, arguments, line});
    statement_ += '\n';
    setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
    return traits_type::to_int_type(statement_.front());
}

}  // namespace scanshade
