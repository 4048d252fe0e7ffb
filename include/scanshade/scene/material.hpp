// Materials: a reflection model by name, with what a file says of its parameters.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scanshade {

struct Texture;

/// A parameter as an input gives it: by the model's name for it ("kd", "shininess", "ka", ...).
/// One number means the same for each channel; a choice is a word.
struct ParamSetting {
    std::string name;
    std::vector<double> values;  // one or three; none where the value is a word
    std::string place;           // where it was given, for messages: "scene.toml:12" or "--set kd"
    std::string word{};
};

/// A material is resolved against the registry of reflection models when a scene is prepared, so
/// that `--brdf` and `--set` can still change it.
struct Material {
    std::string name = "default";
    std::string brdf = "blinn-phong";       // or "unlit"
    std::vector<ParamSetting> parameters;   // what is not set has the model's default
    std::shared_ptr<const Texture> map_kd;  // multiplies the diffuse parameter and ka; may be null
    std::filesystem::path map_file;         // where map_kd was read
    std::string place;                      // where it was defined, for messages

    const ParamSetting* find(std::string_view parameter) const {
        for (const ParamSetting& p : parameters)
            if (p.name == parameter) return &p;
        return nullptr;
    }
    /// Sets a parameter, replacing an earlier value.
    void set(std::string_view parameter, std::vector<double> values, std::string from = {});
    void set_word(std::string_view parameter, std::string word, std::string from = {});
};

}  // namespace scanshade
