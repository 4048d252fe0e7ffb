// The table of hard cases.
#pragma once

#include <span>
#include <string_view>

#include "scanshade/report/picture_stability.hpp"

namespace scanshade {

struct HardCase {
    std::string_view name;        // also of files: small letters, digits, '-'
    std::string_view difficulty;  // what is hard about it, in a sentence
    ReportInput (*make)(double parameter);
    double parameter;
    PictureBounds bounds = {};
    Shading shading = Shading::phong;
    Interpolation interpolation = Interpolation::perspective;

    ReportInput input() const;
};

std::span<const HardCase> hard_cases();

}  // namespace scanshade
