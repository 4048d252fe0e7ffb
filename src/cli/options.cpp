#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "cli/console.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade {
namespace {

constexpr std::size_t help_column = 34;  // where meanings begin
constexpr std::size_t help_width = 100;

/// CLI11 keeps line breaks of a description and indents what follows.
std::string wrapped(std::string_view text) {
    std::string out;
    std::size_t column = help_column;
    for (const std::string_view word : split(text, ' ')) {
        const std::size_t width = word.size() + (out.empty() ? 0 : 1);
        const bool breaks = column + width > help_width;
        if (!out.empty()) out += breaks ? '\n' : ' ';
        out += word;
        column = breaks ? help_column + word.size() : column + width;
    }
    return out;
}

/// Help with the command's own usage line.
class HelpFormatter : public CLI::Formatter {
public:
    explicit HelpFormatter(std::string usage) : usage_(std::move(usage)) {
        column_width(help_column);
        label("Positionals", "Arguments");
    }
    std::string make_description(const CLI::App* app) const override {
        return app->get_name() + ": " + app->get_description() + "\n\n";
    }
    std::string make_usage(const CLI::App*, std::string) const override {
        return "Usage: " + usage_ + "\n";
    }

private:
    std::string usage_;
};

}  // namespace

struct OptionParser::State {
    struct Required {
        CLI::Option* option;
        std::string name;
    };

    CLI::App app;
    std::string program;
    std::vector<Required> required;  // checked here: CLI11 would name them before a misspelt option
    bool unknown_allowed = false;

    State(std::string_view name, std::string_view usage, std::string_view summary)
        : app(std::string(summary), std::string(name)), program(name) {
        app.formatter(std::make_shared<HelpFormatter>(fmt::format("{} {}", name, usage)));
        app.set_help_flag("-h,--help", "show this help");
        app.allow_extras();
    }

    std::string help() const {
        // CLI11 parts groups by two empty lines and ends with more.
        std::string text = CLI::detail::find_and_replace(app.help(), "\n\n\n", "\n\n");
        text.erase(text.find_last_not_of('\n') + 1);
        return text + "\n";
    }

    /// Every option is a list of texts for CLI11, each of one argument.
    template <class Take>
    CLI::Option* add(std::string_view names, std::string_view form, std::string_view meaning,
                     Take take) {
        const auto callback = [take](const CLI::results_t& values) {
            take(values);
            return true;
        };
        return app.add_option(std::string(names), callback, wrapped(meaning))
            ->option_text(std::string(form))
            ->type_size(1)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }

    CLI::Option* add_text(std::string_view names, std::string_view form, std::string& value,
                          std::string_view meaning) {
        return add(names, form, meaning,
                   [&value](const CLI::results_t& given) { value = given.back(); });
    }

    std::vector<std::string_view> option_names() {
        std::vector<std::string_view> names;
        for (const CLI::Option* option : app.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back(name);
        return names;
    }

    /// The sentence for the first argument that nobody declared.
    void check_unknown() {
        if (unknown_allowed) return;
        for (const std::string& argument : app.remaining()) {
            if (argument == "--") continue;
            if (argument.size() < 2 || argument[0] != '-')
                throw Error(
                    Errc::usage,
                    fmt::format("argument '{}' is one too many; '{} --help' shows the usage",
                                argument, program));
            const std::string_view word = std::string_view(argument).substr(
                argument.find_first_not_of('-') == std::string::npos
                    ? 0
                    : argument.find_first_not_of('-'));
            const std::string_view near =
                nearest_name(word.substr(0, word.find('=')), option_names());
            throw Error(
                Errc::usage,
                fmt::format("option '{}' is unknown{}", argument,
                            near.empty() ? fmt::format("; '{} --help' lists the options", program)
                                         : fmt::format(", did you mean '--{}'?", near)));
        }
    }

    void check_required() const {
        for (const Required& need : required)
            if (need.option->count() == 0 || need.option->results().back().empty())
                throw Error(Errc::usage,
                            fmt::format("{} is {}; '{} --help' shows the usage", need.name,
                                        need.option->count() ? "empty" : "missing", program));
    }

    /// CLI11 knows two: "NAME: 1 required TYPE missing", and "NAME was given a disallowed flag
    /// override" for a flag. The sentence is made anew from the name.
    Error mismatch_error(const CLI::ArgumentMismatch& mismatch) {
        const std::string what = mismatch.what();
        const bool is_flag = what.find(" flag override") != std::string::npos;
        const std::string name = what.substr(0, what.find(is_flag ? ' ' : ':'));
        if (is_flag) return Error(Errc::usage, fmt::format("option '--{}' takes no value", name));
        const CLI::Option* option = app.get_option_no_throw(name);
        return Error(Errc::usage, fmt::format("option '{}' needs a value{}", name,
                                              option ? ": " + option->get_option_text() : ""));
    }
};

OptionParser::OptionParser(std::string_view program, std::string_view usage,
                           std::string_view summary)
    : state_(std::make_unique<State>(program, usage, summary)) {}

OptionParser::~OptionParser() = default;

void OptionParser::positional(std::string_view name, std::string& value, std::string_view meaning) {
    CLI::Option* option = state_->add_text(name, "", value, meaning);
    state_->required.push_back({option, std::string(name)});
}

void OptionParser::optional_positional(std::string_view name, std::string& value,
                                       std::string_view meaning) {
    state_->add_text(name, "", value, meaning);
}

void OptionParser::optional_positionals(std::string_view name, std::vector<std::string>& values,
                                        std::string_view meaning) {
    state_->add(name, "", meaning, [&values](const CLI::results_t& given) { values = given; })
        ->expected(0, CLI::detail::expected_max_vector_size)
        ->allow_extra_args();
}

void OptionParser::text(std::string_view names, std::string_view form, std::string& value,
                        std::string_view meaning) {
    state_->add_text(names, form, value, meaning);
}

void OptionParser::required_text(std::string_view names, std::string_view form, std::string& value,
                                 std::string_view meaning) {
    CLI::Option* option = state_->add_text(names, form, value, meaning);
    state_->required.push_back({option, fmt::format("{} {}", names, form)});
}

void OptionParser::texts(std::string_view names, std::string_view form,
                         std::vector<std::string>& values, std::string_view meaning) {
    state_->add(names, form, meaning, [&values](const CLI::results_t& given) { values = given; });
}

void OptionParser::integer(std::string_view names, long long min, long long max, long long& value,
                           std::string_view meaning) {
    state_->add(names, "N", meaning, [=, &value](const CLI::results_t& given) {
        const std::optional<long long> number = parse_integer(given.back());
        if (!number || *number < min || *number > max)
            throw Error(Errc::usage, fmt::format("{} is a whole number from {} to {}, not '{}'",
                                                 names, min, max, given.back()));
        value = *number;
    });
}

void OptionParser::real(std::string_view names, std::string_view form, double min, double max,
                        std::optional<double>& value, std::string_view meaning) {
    state_->add(names, form, meaning, [=, &value](const CLI::results_t& given) {
        value = parse_real(given.back());
        if (!value || !(*value >= min && *value <= max))
            throw Error(Errc::usage, fmt::format("{} is a number from {:g} to {:g}, not '{}'",
                                                 names, min, max, given.back()));
    });
}

void OptionParser::flag(std::string_view names, bool& value, std::string_view meaning) {
    state_->app.add_flag(std::string(names), value, wrapped(meaning))->disable_flag_override();
}

void OptionParser::shared(Settings& settings, std::span<const std::string_view> only) {
    for (const OptionInfo& info : shared_options()) {
        if (!only.empty() && std::find(only.begin(), only.end(), info.name) == only.end()) continue;
        const auto take = [&settings, &info](std::string_view value) {
            info.apply(settings, value);
            settings.given.emplace(info.name);
        };
        const std::string name = fmt::format("--{}", info.name);
        CLI::Option* option =
            info.is_flag
                ? state_->app
                      .add_flag_callback(
                          name, [take] { take("true"); }, wrapped(info.meaning))
                      ->disable_flag_override()
                : state_->add(name, info.values, info.meaning,
                              [take, repeatable = info.repeatable](const CLI::results_t& given) {
                                  if (!repeatable) return take(given.back());
                                  for (const std::string& value : given) take(value);
                              });
        option->group("Options shared by all commands that draw");
    }
}

void OptionParser::allow_unknown() { state_->unknown_allowed = true; }

bool OptionParser::parse(const char* const* args) {
    std::vector<std::string> reversed;  // as CLI11 wants them
    for (; *args; ++args) reversed.emplace_back(*args);
    std::reverse(reversed.begin(), reversed.end());
    try {
        state_->app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        print(state_->help());
        return false;
    } catch (const CLI::ArgumentMismatch& mismatch) {
        state_->check_unknown();
        throw state_->mismatch_error(mismatch);
    } catch (const CLI::ParseError& error) {
        state_->check_unknown();
        throw Error(Errc::usage, error.what());
    }
    state_->check_unknown();
    state_->check_required();
    return true;
}

}  // namespace scanshade
