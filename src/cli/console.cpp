#include "cli/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <typeinfo>

#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/base/memory.hpp"
#include "scanshade/base/text.hpp"

namespace scanshade {
namespace fs = std::filesystem;
namespace {

Error cannot_write(std::string_view what, int reason) {
    return Error(Errc::file,
                 fmt::format("{} could not be written ({})", what, std::strerror(reason)));
}

std::string printable(std::string_view text) {
    std::string out(text);
    std::replace_if(
        out.begin(), out.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return out;
}

/// Columns that a UTF-8 text takes: every byte but those that continue a character.
std::size_t columns(std::string_view text) {
    return std::size_t(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

constexpr std::string_view out_of_memory =
    "there is not enough memory for this scene and picture; a smaller --resolution or a smaller "
    "file needs less";

/// Memory, or threads, which need memory.
bool is_out_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error)) return true;
    if (dynamic_cast<const std::length_error*>(&error)) return true;
    if (const auto* failed = dynamic_cast<const std::system_error*>(&error))
        return failed->code() == std::errc::resource_unavailable_try_again;
    return typeid(error) == typeid(std::runtime_error);  // oneTBB's, for a thread
}

/// Threads may run out of memory at the same time. The first one says so and ends the program; another
/// gives it a second to do that.
void speak_alone() {
    static std::atomic_flag spoken;
    if (!spoken.test_and_set()) return;
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ::_exit(exit_out_of_memory);
}

std::terminate_handler standard_terminate = nullptr;

/// Where no one can catch, as in a thread that oneTBB starts another one from.
void end_out_of_memory() {
    try {
        if (std::current_exception()) std::rethrow_exception(std::current_exception());
    } catch (const std::exception& error) {
        if (is_out_of_memory(error)) {
            speak_alone();
            remove_unfinished_file();
            fmt::print(stderr, "scanshade: {}\n", out_of_memory);
            ::_exit(exit_out_of_memory);
        }
    } catch (...) {
    }
    standard_terminate();
}

}  // namespace

int run_program(std::string_view program, const std::function<int()>& body) {
    for (const int writing_fails : {SIGPIPE, SIGXFSZ}) std::signal(writing_fails, SIG_IGN);
    standard_terminate = std::set_terminate(end_out_of_memory);
    limit_memory();
    const auto failed = [&](std::string_view sentence, int status) {
        note(fmt::format("{}: {}", program, sentence));
        return status;
    };
    try {
        const int status = body();
        print_finished();
        return status;
    } catch (const Error& error) {
        return failed(error.what(), int(error.code()));
    } catch (const fs::filesystem_error& error) {
        return failed(error.what(), int(Errc::file));
    } catch (const std::exception& error) {
        if (!is_out_of_memory(error)) throw;
        speak_alone();
        return failed(out_of_memory, exit_out_of_memory);
    }
}

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw cannot_write("standard output", errno);
}

void print_finished() {
    if (std::fflush(stdout) != 0) throw cannot_write("standard output", errno);
}

void note(std::string_view text) { fmt::print(stderr, "{}\n", printable(text)); }

void warn(const std::vector<std::string>& sentences) {
    constexpr std::size_t shown = 10;
    for (std::size_t i = 0; i < std::min(shown, sentences.size()); ++i)
        note(fmt::format("warning: {}", shortened(sentences[i])));
    if (sentences.size() > shown)
        note(fmt::format("warning: and {} more; 'scanshade info' lists them all",
                         sentences.size() - shown));
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c)
            widths[c] = std::max(widths[c], columns(row[c]));
    }
    std::string out;
    for (const auto& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            out += printable(row[c]);
            if (c + 1 < row.size()) out.append(widths[c] - columns(row[c]) + 2, ' ');
        }
        out += '\n';
    }
    return out;
}

void write_text(std::string_view text, const std::string& path) {
    if (path == "-") return print(text);
    write_file(text, path);
}

void check_output(const std::string& path, const std::string& input) {
    if (path == "-") return;
    if (path.empty()) throw Error(Errc::usage, "the name of the file to write is empty");
    std::error_code ignored;
    if (fs::equivalent(path, input, ignored))
        throw Error(
            Errc::usage,
            fmt::format("'{}' is both input and output; give the output a name of its own", path));
    if (fs::is_directory(path, ignored))
        throw Error(Errc::file, "this is a folder; give the name of a file to write").at(path);
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return;
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, ignored))
        throw Error(Errc::file, fmt::format("folder '{}' does not exist, so nothing can be written "
                                            "into it",
                                            folder.string()))
            .at(path);
    if (::access(folder.c_str(), W_OK) != 0) throw cannot_write(path, errno);
}

void check_picture_output(const std::string& path, const std::string& input) {
    check_output(path, input);
    const std::string extension = fs::path(path).extension().string();
    for (const std::string_view other : {".jpg", ".jpeg", ".bmp", ".tga", ".gif", ".ppm", ".exr"})
        if (extension == other)
            throw Error(Errc::usage, fmt::format("pictures are written as PNG, so '{}' should end "
                                                 "in .png",
                                                 path));
}

}  // namespace scanshade
