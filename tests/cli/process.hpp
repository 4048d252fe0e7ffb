// Runs the program that was built beside the tests.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <string>
#include <vector>

#include "support/temp_folder.hpp"

namespace scanshade {

/// How a process ended and what it said.
struct Finished {
    int status = -1;  // exit status; 128 + signal where it was killed
    std::string out, err;
};

/// `scanshade ARGS...`, with standard output and standard error each in a file of its own.
/// `stdout_to` is a file to write standard output to instead, `program` a copy to run.
Finished run_scanshade(const std::vector<std::string>& args, const std::string& stdout_to = {},
                       const std::string& program = SCANSHADE_BINARY);

/// The same with standard error on a terminal, sent SIGINT once `until` is on it; `out` is empty.
Finished run_scanshade_on_terminal(const std::vector<std::string>& args, const std::string& until);

/// The same with nobody left to read standard output; `out` is empty.
Finished run_scanshade_unread(const std::vector<std::string>& args);

/// The same, sent a signal some time after `file` has appeared.
Finished run_scanshade_interrupted(const std::vector<std::string>& args, const std::string& file,
                                   std::chrono::milliseconds after = std::chrono::milliseconds(500),
                                   int signal = SIGINT);

/// The same with a limit of the system's on the process: RLIMIT_AS, RLIMIT_FSIZE, ... in bytes.
Finished run_scanshade_limited(const std::vector<std::string>& args, int resource,
                               std::uint64_t bytes);

/// The whole file, as it is.
std::string read_file(const std::string& path);

/// A file with one triangle that fills much of the default view.
std::string write_triangle(const TempFolder& folder);

}  // namespace scanshade
