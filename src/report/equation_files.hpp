// What the files of the equations' part share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/equation_stability.hpp"

namespace scanshade {

/// A form in a type of number, as tables and files name it.
struct Column {
    std::string_view method;  // "printed f32"
    double no_digit;          // an error of so many ulp leaves none
    const SweepErrors* errors;
};
/// The printed form, where there is one, and ours.
std::vector<Column> columns(const SweepResult& sweep);

/// "equation-B17c-2.svg": the second sweep of B17c.
std::vector<std::string> plot_files(std::string_view kind, const std::vector<SweepResult>& sweeps);

}  // namespace scanshade
