// Reflection models as the formula sheet prints their equations, times cosθ_i.
#pragma once

#include <string_view>

#include "scanshade/brdf/brdf.hpp"

namespace scanshade {

struct PrintedModel {
    std::string_view name;    // of the registry
    bool misprint;            // the printed form is wrong, whatever the arithmetic
    std::string_view choice;  // what the model computes instead, and why
    float (*f32)(const Cosines<float>&, const BrdfInfo&, const MaterialParams<double>&);
    double (*f64)(const Cosines<double>&, const BrdfInfo&, const MaterialParams<double>&);
};

/// nullptr for a model that the sheet does not have.
const PrintedModel* find_printed_model(std::string_view name);

}  // namespace scanshade
