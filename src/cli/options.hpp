// The options of one command: declared by the command, parsed by CLI11, and every mistake turned
// into one sentence. Both programs use it; the shared options come from their table.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/scene/settings.hpp"

namespace scanshade {

/// Texts are kept by reference until parse() has returned. Values may begin with a dash
/// ("--exposure -1"); of an option that is given twice, the last counts.
class OptionParser {
public:
    /// `program` is what the user types before the arguments, "scanshade render"; `usage` what
    /// follows, "INPUT -o OUT.png [options]".
    OptionParser(std::string_view program, std::string_view usage, std::string_view summary);
    ~OptionParser();
    OptionParser(const OptionParser&) = delete;
    OptionParser& operator=(const OptionParser&) = delete;

    /// An argument without a dash, in the order of declaration.
    void positional(std::string_view name, std::string& value, std::string_view meaning);
    void optional_positionals(std::string_view name, std::vector<std::string>& values,
                              std::string_view meaning);
    void optional_positional(std::string_view name, std::string& value, std::string_view meaning);

    /// `names` is "--diff" or "-o,--output"; `form` shows what a value looks like.
    void text(std::string_view names, std::string_view form, std::string& value,
              std::string_view meaning);
    void required_text(std::string_view names, std::string_view form, std::string& value,
                       std::string_view meaning);
    /// Given any number of times.
    void texts(std::string_view names, std::string_view form, std::vector<std::string>& values,
               std::string_view meaning);
    void integer(std::string_view names, long long min, long long max, long long& value,
                 std::string_view meaning);
    /// `form` is a letter for it.
    void real(std::string_view names, std::string_view form, double min, double max,
              std::optional<double>& value, std::string_view meaning);
    void flag(std::string_view names, bool& value, std::string_view meaning);

    /// Every row of shared_options(), or those that `only` names: its value is applied to
    /// `settings`, its name noted in settings.given.
    void shared(Settings& settings, std::span<const std::string_view> only = {});

    /// Arguments that nobody declared are no error: another program will judge them.
    void allow_unknown();

    /// Parses the arguments after the command's name (null-terminated). Returns false where help
    /// was asked for and is printed. Throws Error(usage).
    bool parse(const char* const* args);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace scanshade
