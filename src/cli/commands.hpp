// The commands: one file for each, one row for each in main.cpp.
#pragma once

#include <string_view>

#include "cli/options.hpp"

namespace scanshade {

struct Command {
    std::string_view name;
    std::string_view usage;    // what follows the name
    std::string_view summary;  // one line
    /// Declares its options, parses `args` (what follows the name, null-terminated) and works.
    /// Returns the exit status. Throws Error.
    int (*run)(OptionParser& options, char** args);
};

int run_render(OptionParser& options, char** args);
int run_view(OptionParser& options, char** args);
int run_explain(OptionParser& options, char** args);
int run_compare(OptionParser& options, char** args);
int run_sheet(OptionParser& options, char** args);
int run_brdf(OptionParser& options, char** args);
int run_inspect(OptionParser& options, char** args);
int run_info(OptionParser& options, char** args);
int run_lesson(OptionParser& options, char** args);
int run_report(OptionParser& options, char** args);

}  // namespace scanshade
