// What the tests know of each equation, apart from its text: plain data.
#pragma once

#include <string_view>

namespace scanshade {

inline constexpr int max_equation_inputs = 14, max_equation_outputs = 4;

struct InputRange {
    double low, high;
};

/// One function of eq/ as numbers in, numbers out.
struct EquationInfo {
    std::string_view name;
    int inputs, outputs;
    double error_u;  // |error| ≤ error_u · u · (|result| + scale)
    double scale;    // 0: the bound is relative
    InputRange range[max_equation_inputs];
};

}  // namespace scanshade
