// Scenes as TOML text: what parse_scene reads.
#include <fmt/format.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <set>

#include "scanshade/base/error.hpp"
#include "scanshade/scene/scene.hpp"
#include "scene/up_axis.hpp"

namespace scanshade {
namespace {

/// Bytes from `at` on that are one character in UTF-8; 0: none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xc0) != 0x80) return 0;
    return length;
}

/// A text in quotes. What is no UTF-8, which names in OBJ files may be, becomes '?'.
std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        const char c = text[at];
        if (length == 0)
            out += '?';
        else if (c == '"' || c == '\\')
            out += fmt::format("\\{}", c);
        else if (length == 1 && (static_cast<unsigned char>(c) < ' ' || c == 0x7f))
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        else
            out += text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out + '"';
}

std::string three(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string path_text(const std::filesystem::path& path, const std::filesystem::path& folder) {
    std::error_code failed;
    const std::filesystem::path relative = std::filesystem::proximate(path, folder, failed);
    return in_quotes((failed ? std::filesystem::absolute(path) : relative).generic_string());
}

std::string camera_text(const Camera& c) {
    constexpr std::string_view projections[] = {"perspective", "orthographic"};
    std::string out = fmt::format(
        "\n[camera]\nposition = {}\nfocal_point = {}\nview_up = {}\nview_angle = {}\n"
        "projection = \"{}\"\n",
        three(c.position), three(c.focal_point), three(c.view_up), c.view_angle_deg,
        projections[static_cast<std::size_t>(c.projection)]);
    if (c.near) out += fmt::format("near = {}\n", *c.near);
    if (c.far) out += fmt::format("far = {}\n", *c.far);
    return out;
}

std::string light_text(const Light& light) {
    std::string out = fmt::format("\n[[light]]\ntype = \"{}\"\n",
                                  light_kind_names()[static_cast<std::size_t>(light.kind)]);
    if (light.kind != LightKind::directional)
        out += fmt::format("position = {}\n", three(light.position));
    if (light.kind != LightKind::point)
        out += fmt::format("direction = {}\n", three(light.direction));
    out += fmt::format("intensity = {}\n", three(light.intensity));
    if (light.kind != LightKind::directional)
        out += fmt::format("attenuation = {}\n", three(light.attenuation));
    if (light.kind == LightKind::spot)
        out += fmt::format("cutoff = {}\npenumbra = {}\n", light.cutoff_deg, light.penumbra_deg);
    if (light.radius) out += fmt::format("radius = {}\n", *light.radius);
    return out;
}

std::string param_text(const ParamSetting& p) {
    if (p.values.empty()) return in_quotes(p.word);
    if (p.values.size() == 1) return fmt::format("{}", p.values[0]);
    return three({p.values[0], p.values[1], p.values[2]});
}

std::string material_text(const Material& material, const std::string& name,
                          const std::filesystem::path& folder) {
    std::string out =
        fmt::format("\n[[material]]\nname = {}\nbrdf = \"{}\"\n", in_quotes(name), material.brdf);
    std::vector<ParamSetting> parameters = material.parameters;  // by name, as tables are read
    std::sort(parameters.begin(), parameters.end(),
              [](const ParamSetting& a, const ParamSetting& b) { return a.name < b.name; });
    for (const ParamSetting& p : parameters) out += fmt::format("{} = {}\n", p.name, param_text(p));
    if (material.map_kd) out += fmt::format("map_kd = {}\n", path_text(material.map_file, folder));
    return out;
}

/// A name for each material that an object has, no two the same; "" for the others.
std::vector<std::string> material_names(const Scene& scene) {
    std::vector<std::string> names(scene.materials.size());
    std::set<std::string> taken;
    for (const Object& object : scene.objects)
        for (const std::uint32_t m : object.materials) {
            if (!names[m].empty()) continue;
            const std::string given =
                scene.materials[m].name.empty() ? "material" : scene.materials[m].name;
            std::string name = given;
            // Compared as they are written: two names may differ in what is no UTF-8 alone.
            for (int n = 2; !taken.insert(in_quotes(name)).second; ++n)
                name = fmt::format("{} {}", given, n);
            names[m] = name;
        }
    return names;
}

std::string placement_text(const glm::dmat4& m) {
    if (m == glm::dmat4(1)) return {};
    std::string out = "matrix = [";
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            out += fmt::format("{}{}", row + column > 0 ? ", " : "", m[column][row]);
    return out + "]\n";
}

std::string object_text(const Object& object, const std::vector<std::string>& names,
                        const Settings& settings, const std::filesystem::path& folder) {
    std::string out = "\n[[object]]\n";
    glm::dmat4 placement = object.to_world;
    if (!object.mesh_file.empty()) {
        out += fmt::format("mesh = {}\n", path_text(object.mesh_file, folder));
        placement *= glm::transpose(up_rotation(settings.up));  // put there again by the reader
    } else if (!object.shape.empty()) {
        out +=
            fmt::format("shape = \"{}\"\ntessellation = {}\n", object.shape, object.tessellation);
    } else {
        throw Error(Errc::scene, fmt::format("the mesh '{}' is neither from a file nor a shape, "
                                             "so no scene file can name it",
                                             object.mesh->name));
    }
    out += placement_text(placement);
    out += "materials = [";
    for (std::size_t i = 0; i < object.materials.size(); ++i)
        out += fmt::format("{}{}", i > 0 ? ", " : "", in_quotes(names[object.materials[i]]));
    out += "]\n";
    if (object.shading && !settings.is_given("shading"))
        out += fmt::format("shading = \"{}\"\n",
                           shading_names()[static_cast<std::size_t>(*object.shading)]);
    return out;
}

/// Of all that is not as it would be anyway. The scene has camera and lights itself; what suits a
/// machine is no part of a scene.
std::string render_text(const Settings& settings) {
    std::string out;
    const Settings standard;
    for (const OptionInfo& option : shared_options()) {
        if (option.show == nullptr || option.name == "isa" || option.name == "threads") continue;
        const std::string value = option.show(settings);
        if (value == option.show(standard)) continue;
        out += fmt::format("{} = {}\n", option.name, in_quotes(value));
    }
    if (settings.set.empty()) return out;
    out += "set = [";
    for (std::size_t i = 0; i < settings.set.size(); ++i) {
        const ParamSetting& p = settings.set[i];
        std::string value = p.word;
        for (const double v : p.values) value += fmt::format("{}{}", value.empty() ? "" : ",", v);
        out += fmt::format("{}{}", i > 0 ? ", " : "", in_quotes(p.name + "=" + value));
    }
    return out + "]\n";
}

}  // namespace

std::string scene_text(const Scene& scene, const Settings& settings,
                       const std::filesystem::path& folder) {
    std::string out = fmt::format("ambient = {}\n", three(scene.ambient));
    if (const std::string render = render_text(settings); !render.empty())
        out += "\n[render]\n" + render;
    if (scene.camera) out += camera_text(*scene.camera);
    for (const Light& light : scene.lights) out += light_text(light);
    const std::vector<std::string> names = material_names(scene);
    for (std::size_t m = 0; m < names.size(); ++m)
        if (!names[m].empty()) out += material_text(scene.materials[m], names[m], folder);
    for (const Object& object : scene.objects) out += object_text(object, names, settings, folder);
    return out;
}

}  // namespace scanshade
