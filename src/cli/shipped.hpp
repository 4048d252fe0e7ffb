// Files that come with the programs.
#pragma once

#include <filesystem>
#include <string_view>

namespace scanshade {

/// models/<name> with scenes in it: the first below the working directory, or below a folder that
/// this program lies in. Throws Error(file) where there is none; `remedy` ends its sentence.
std::filesystem::path shipped_folder(std::string_view name, std::string_view remedy);

}  // namespace scanshade
