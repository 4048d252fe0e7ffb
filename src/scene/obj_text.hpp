// The text of OBJ and MTL files: whole files, statements, words.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <streambuf>
#include <string>
#include <string_view>

namespace scanshade {

/// All of a regular file of text, its byte order mark left out. Throws Error: file (cannot be
/// read), format (larger than `max_bytes`, UTF-16, or with bytes that no text has).
std::string read_text(const std::filesystem::path& path, std::size_t max_bytes);

/// Takes the first word off the front of `text`; empty at its end.
std::string_view next_word(std::string_view& text);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

struct Statement {
    std::string_view keyword, arguments;
    long line;  // where it begins; 1 is the first line
};

/// Hands a text out as a stream, one statement after the other: any line ending becomes '\n',
/// lines that end in a backslash are joined with the next one, comments are left out. Each
/// statement is shown to a visitor before a reader of the stream gets it.
class StatementStream : public std::streambuf {
public:
    using Visitor = std::function<void(const Statement&)>;

    StatementStream(std::string_view text, Visitor visitor)
        : rest_(text), visitor_(std::move(visitor)) {}

    /// Shows all statements without a reader.
    void visit_all() {
        while (underflow() != traits_type::eof()) {
        }
    }

protected:
    int_type underflow() override;

private:
    std::string_view next_line();

    std::string_view rest_;
    Visitor visitor_;
    std::string statement_;
    long line_ = 0;  // lines taken so far
};

}  // namespace scanshade
