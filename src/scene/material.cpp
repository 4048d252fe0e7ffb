#include "scanshade/scene/material.hpp"

#include <utility>

namespace scanshade {
namespace {

void replace(std::vector<ParamSetting>& parameters, ParamSetting setting) {
    for (ParamSetting& p : parameters) {
        if (p.name != setting.name) continue;
        p = std::move(setting);
        return;
    }
    parameters.push_back(std::move(setting));
}

}  // namespace

void Material::set(std::string_view parameter, std::vector<double> values, std::string from) {
    replace(parameters, {std::string(parameter), std::move(values), std::move(from), {}});
}

void Material::set_word(std::string_view parameter, std::string word, std::string from) {
    replace(parameters, {std::string(parameter), {}, std::move(from), std::move(word)});
}

}  // namespace scanshade
