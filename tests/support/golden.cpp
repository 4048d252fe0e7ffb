#include "support/golden.hpp"

#include <filesystem>
#include "scene/toml.hpp"

#include "support/catch.hpp"

namespace scanshade {
namespace {

GoldenPicture load_picture(const toml::table& manifest, const toml::table& row) {
    GoldenPicture picture;
    picture.name = row["name"].value<std::string>().value();
    const std::string scene = row["scene"].value<std::string>().value();
    find_option("resolution")->apply(picture.settings, "240,180");
    for (const auto& [key, value] : *row["options"].as_table()) {
        const OptionInfo* option = find_option(key.str());
        REQUIRE(option != nullptr);
        const auto text = value.value<std::string>();
        option->apply(picture.settings,
                      text ? *text : std::to_string(value.value<std::int64_t>().value()));
        picture.settings.given.insert(std::string(key.str()));
    }
    picture.scene_file = scene;
    const Settings options = picture.settings;
    if (const auto text = manifest["scenes"][scene].value<std::string>())
        picture.scene = parse_scene(*text, "golden/manifest.toml", picture.settings);
    else
        picture.scene =
            load_scene(std::filesystem::path("models/scenes") / scene, picture.settings);
    picture.settings.width = options.width;
    picture.settings.height = options.height;
    if (options.projection) picture.scene.camera->projection = *options.projection;
    return picture;
}

}  // namespace

GoldenList load_golden_list() {
    const toml::table manifest = toml::parse_file("golden/manifest.toml");
    GoldenList list;
    list.max_delta = manifest["max_delta"].value<int>().value();
    list.max_count = manifest["max_count"].value<std::uint64_t>().value();
    for (const toml::node& row : *manifest["picture"].as_array())
        list.pictures.push_back(load_picture(manifest, *row.as_table()));
    return list;
}

}  // namespace scanshade
