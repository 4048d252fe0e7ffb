// Files of pictures: what the decoder does not look at.
#pragma once

#include <string_view>

namespace scanshade {

/// Throws Error(format) for a file that stb would take although it is damaged or cut off, so that it
/// would be another picture and nobody the wiser; or that would harm stb: data without end, a table
/// larger than its place. Of files that are no pictures it says nothing.
void check_picture_file(std::string_view bytes);

}  // namespace scanshade
