// TOML scenes.
#include <fmt/format.h>

#include <glm/glm.hpp>
#include <set>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/scene/scene.hpp"
#include "scene/scene_parts.hpp"
#include "scene/toml_keys.hpp"

namespace scanshade {
namespace {

/// Options as a scene file spells them, unless the command line has said something else.
void apply_option(const TomlReader& reader, const toml::node& node, std::string_view option,
                  const std::string& value, Settings& settings) {
    // What the command line overrides is checked all the same.
    Settings overridden;
    const bool given = settings.is_given(option);
    try {
        find_option(option)->apply(given ? overridden : settings, value);
        if (option == "set" && !given) settings.set.back().place = reader.place(node);
    } catch (const Error& e) {
        throw reader.error(node, e.what());
    }
}

/// A value of [render] as the command line would have it.
std::string option_text(const TomlReader& reader, const toml::node& node, std::string_view key) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* array = node.as_array()) {
        std::string joined;
        for (const toml::node& element : *array)
            joined += (joined.empty() ? "" : ",") + option_text(reader, element, key);
        return joined;
    }
    return fmt::format("{}",
                       reader.number(node, key, "a text, a number, true or false, or an array"));
}

void read_render(const TomlReader& reader, Settings& settings) {
    std::vector<std::string_view> names;
    for (const OptionInfo& option : shared_options()) names.push_back(option.name);
    for (const auto& [key, node] : reader.table()) {
        const OptionInfo* option = find_option(key.str());
        if (option == nullptr)
            throw reader.error(node, fmt::format("[render] has no key '{}'{}", key.str(),
                                                 suggestion(key.str(), names)));
        if (option->command_line_only)
            throw reader.error(node, fmt::format("{} is no choice of a scene's; give --{} on the "
                                                 "command line",
                                                 option->name, option->name));
        const toml::array* list = node.as_array();
        const bool texts = list != nullptr && list->is_homogeneous(toml::node_type::string);
        if (!option->repeatable || !texts) {
            apply_option(reader, node, option->name, option_text(reader, node, key.str()),
                         settings);
            continue;
        }
        for (const toml::node& element : *list)
            apply_option(reader, element, option->name, option_text(reader, element, key.str()),
                         settings);
    }
}

void read_image(const TomlReader& reader, Settings& settings) {
    reader.allow_only({"size", "background", "samples"});
    const std::pair<std::string_view, std::string_view> rows[] = {
        {"size", "resolution"}, {"background", "background"}, {"samples", "samples"}};
    for (const auto& [key, option] : rows)
        if (const toml::node* node = reader.node(key))
            apply_option(reader, *node, option, option_text(reader, *node, key), settings);
}

/// The table of that name, or nullptr.
const toml::table* sub_table(const TomlReader& root, std::string_view key) {
    const toml::node* node = root.node(key);
    if (node == nullptr) return nullptr;
    if (!node->is_table())
        throw root.error(*node, fmt::format("write {} as a table: [{}]", key, key));
    return node->as_table();
}

/// Calls read(reader) for each [[key]], of which there may be `most`.
template <class Read>
void each_table(const TomlReader& root, std::string_view key, std::size_t most, Read&& read) {
    const toml::node* node = root.node(key);
    if (node == nullptr) return;
    const auto misspelt = [&](const toml::node& at) {
        return root.error(at, fmt::format("write {} as an array of tables: [[{}]]", key, key));
    };
    if (!node->is_array()) throw misspelt(*node);
    const toml::array& tables = *node->as_array();
    if (tables.size() > most)
        throw root.error(tables[most], fmt::format("this is [[{}]] number {}; a scene has at most "
                                                   "{}",
                                                   key, most + 1, most));
    for (const toml::node& element : tables) {
        if (!element.is_table()) throw misspelt(element);
        read(TomlReader(*element.as_table(), root.file(), fmt::format("[[{}]]", key)));
    }
}

toml::table parse_toml(std::string_view text, const std::string& file) {
    if (const std::size_t line = line_of_long_key(text, max_key_parts))
        throw Error(Errc::format, fmt::format("a key has more than {} parts", max_key_parts))
            .at(file, static_cast<long>(line));
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& e) {
        throw Error(Errc::format, fmt::format("this is no TOML: {}", e.description()))
            .at(file, static_cast<long>(e.source().begin.line));
    } catch (Error& e) {
        throw e.at(file);
    }
}

}  // namespace

Scene parse_scene(std::string_view text, const std::filesystem::path& file, Settings& settings) {
    const toml::table table = parse_toml(text, file.string());
    const TomlReader root(table, file.string(), "the scene");
    root.allow_only({"ambient", "image", "camera", "light", "material", "object", "render"});
    Scene scene;
    if (const toml::table* render = sub_table(root, "render"))
        read_render(TomlReader(*render, root.file(), "[render]"), settings);
    if (const toml::table* image = sub_table(root, "image"))
        read_image(TomlReader(*image, root.file(), "[image]"), settings);
    scene.ambient = root.radiance("ambient").value_or(glm::dvec3(0));
    each_table(root, "light", max_lights,
               [&](const TomlReader& reader) { scene.lights.push_back(read_light(reader)); });
    SceneFiles files(file.parent_path(), settings.allow_outside);
    std::set<std::string> names;
    each_table(root, "material", max_materials, [&](const TomlReader& reader) {
        Material material = read_material(reader, file.parent_path(), files);
        if (!names.insert(material.name).second)
            throw reader.error(*reader.node("name"),
                               fmt::format("a [[material]] of the name '{}' is there already; "
                                           "give each its own",
                                           material.name));
        scene.materials.push_back(std::move(material));
    });
    ObjectReader objects(file.parent_path(), files, settings, scene);
    each_table(root, "object", max_objects,
               [&](const TomlReader& reader) { objects.read(reader); });
    if (const toml::table* camera = sub_table(root, "camera")) {
        const double aspect = double(settings.width) / double(settings.height);
        scene.camera = read_camera(TomlReader(*camera, root.file(), "[camera]"),
                                   framed_camera(scene.bounds(), aspect));
    }
    return scene;
}

}  // namespace scanshade
