#include "scanshade/scene/material.hpp"

#include <utility>

namespace scanshade {

void Material::set(std::string_view parameter, std::vector<double> values, std::string from) {
    for (ParamSetting& p : parameters) {
        if (p.name != parameter) continue;
        p.values = std::move(values);
        p.place = std::move(from);
        return;
    }
    parameters.push_back({std::string(parameter), std::move(values), std::move(from)});
}

}  // namespace scanshade
