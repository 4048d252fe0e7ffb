// What a person sees on the terminal, and the exit status that a script sees.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scanshade {

inline constexpr std::string_view program_version = "0.1.0";

/// Besides these, the values of Errc.
enum ExitStatus : int {
    exit_done = 0,
    exit_different = 1,      // pictures differ, a check failed
    exit_out_of_memory = 5,  // the same as Errc::scene: too large for this machine
};

/// Runs a program's body. What it throws becomes one sentence on standard error, after the
/// program's name, and the exit status. A reader of our output that goes away early is an error.
int run_program(std::string_view program, const std::function<int()>& body);

/// To standard output; print_finished() says whether all of it arrived. Throws Error(file).
void print(std::string_view text);
void print_finished();

/// One line on standard error. Control characters, which file names and materials may hold, are
/// replaced: they would steer the terminal.
void note(std::string_view text);

/// "warning: ..." for each, and how many more there are after the tenth.
void warn(const std::vector<std::string>& sentences);

/// Rows as aligned columns, two spaces between them; a row may end early.
std::string table(const std::vector<std::vector<std::string>>& rows);

/// Standard output for "-".
void write_text(std::string_view text, const std::string& path);

/// Refuses a file that cannot be written before the work is done whose result it would hold.
/// Throws Error: usage (no name, or the same file as `input`), file.
void check_output(const std::string& path, const std::string& input);

/// The same for a picture: also refuses the name of a format that is not PNG.
void check_picture_output(const std::string& path, const std::string& input);

}  // namespace scanshade
