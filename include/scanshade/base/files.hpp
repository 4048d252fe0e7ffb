// Files: read whole or refused, written whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace scanshade {

/// All bytes of a regular file. Throws Error: file (cannot be read, is no regular file, or changes
/// meanwhile), format (has more than `max_bytes`: nothing is read).
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Writes a file that appears under its name only when it is whole; what was there before stays
/// until then. Through a link its target is written; a device is written to as it is. Throws
/// Error(file).
void write_file(std::string_view bytes, const std::filesystem::path& path);

/// Writes to an open descriptor. 0, or the number of the error.
int write_all(int descriptor, std::string_view bytes);

/// Removes what write_file has not finished. For handlers of signals that end the program.
void remove_unfinished_file() noexcept;

/// Makes a folder with all above it, where it is not there yet, and makes sure that files can be
/// written into it. Throws Error(file).
void make_folder(const std::string& path);

}  // namespace scanshade
