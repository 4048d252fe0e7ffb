// Names of the files that the pictures' part of the stability report puts beside the page.
#pragma once

#include <string>

#include "scanshade/report/picture_stability.hpp"

namespace scanshade {

inline constexpr const char* levels_plot = "pictures-levels.svg";
inline constexpr const char* geometry_plot = "pictures-geometry.svg";

/// Names of users' scenes may hold anything, and two may have the same: they have numbers.
std::string picture_file(const PictureStability& pictures, const PictureCaseResult& result);

}  // namespace scanshade
