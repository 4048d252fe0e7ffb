// Files that this program writes.
#pragma once

#include <string>
#include <string_view>

namespace scanshade {

/// Writes a file that appears under its name only when it is whole; a device is written to as it
/// is. Throws Error(file).
void write_file(std::string_view bytes, const std::string& path);

/// Makes a folder with all above it, where it is not there yet, and makes sure that files can be
/// written into it. Throws Error(file).
void make_folder(const std::string& path);

}  // namespace scanshade
