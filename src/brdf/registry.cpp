// The list of reflection models: one line for each file that defines one, made by the Makefile.
#include <algorithm>
#include <array>

#include "scanshade/brdf/brdf.hpp"

namespace scanshade {

#define MODEL(name) extern const BrdfInfo brdf_##name;
#include "brdf_models.inc"
#undef MODEL

std::span<const BrdfInfo* const> all_brdfs() {
#define MODEL(name) &brdf_##name,
    static constexpr const BrdfInfo* models[] = {
#include "brdf_models.inc"
    };
#undef MODEL
    return models;
}

const BrdfInfo* find_brdf(std::string_view name) {
    for (const BrdfInfo* brdf : all_brdfs())
        if (brdf->name == name) return brdf;
    return nullptr;
}

}  // namespace scanshade
