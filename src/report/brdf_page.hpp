// A page about one reflection model.
#pragma once

#include <string>

#include "scanshade/brdf/brdf.hpp"

namespace scanshade {

/// The page as HTML that needs no other file: equation, parameters, promises, a polar plot for
/// several angles of the light, the albedo, and spheres across the model's main parameter. `given`
/// are parameters other than the defaults. Throws Error(usage) for one that the model lacks.
std::string brdf_page(const BrdfInfo& brdf, const std::vector<ParamSetting>& given);

/// What a promise says, in a sentence.
std::string_view reciprocity_text(const Promises& promises);
std::string_view energy_text(const Promises& promises);

/// The range of a parameter, or the names of a choice.
std::string range_text(const ParamInfo& info);
std::string_view kind_text(const ParamInfo& info);

}  // namespace scanshade
