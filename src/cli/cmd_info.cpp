// scanshade info: what is in an input, as it was understood.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/events.hpp"
#include "cli/progress.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/texture.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string text(const glm::dvec3& v) { return fmt::format("{:g}, {:g}, {:g}", v.x, v.y, v.z); }

Rows count_rows(const Scene& scene, const EventTotals& totals) {
    std::uint64_t by_corners[3] = {};  // triangles, quadrilaterals, more
    for (const Object& object : scene.objects)
        for (std::size_t f = 0; f < object.mesh->face_count(); ++f)
            ++by_corners[std::clamp<std::size_t>(object.mesh->corner_count(f), 3, 5) - 3];
    const std::uint64_t drawable = by_corners[0] + by_corners[1] + by_corners[2];
    return {{"objects", fmt::format("{}", scene.objects.size())},
            {"faces", fmt::format("{}: {} triangles, {} quadrilaterals, {} of more corners",
                                  drawable, by_corners[0], by_corners[1], by_corners[2])},
            {"triangles", fmt::format("{} as drawn", totals.triangles)},
            {"vertices", fmt::format("{} of distinct position, normal and texture coordinate",
                                     totals.vertices)}};
}

Rows place_rows(const Scene& scene, const Settings& settings) {
    const Bounds bounds = scene.bounds();
    const Camera camera = scene.camera.value_or(
        framed_camera(bounds, double(settings.width) / double(settings.height)));
    return {
        {"bounds", fmt::format("centre {}, radius {:g}", text(bounds.centre), bounds.radius)},
        {"camera",
         fmt::format("{}, position {}, focal point {}, view up {}, view angle {:g}°{}",
                     camera.projection == Projection::perspective ? "perspective" : "orthographic",
                     text(camera.position), text(camera.focal_point), text(camera.view_up),
                     camera.view_angle_deg, scene.camera ? "" : " (framed on the bounds)")},
        {"ambient", text(scene.ambient)}};
}

std::string light_text(const Light& light) {
    std::string out;
    if (light.kind != LightKind::directional)
        out += fmt::format("position {}, attenuation {}, ", text(light.position),
                           text(light.attenuation));
    if (light.kind != LightKind::point) out += fmt::format("direction {}, ", text(light.direction));
    if (light.kind == LightKind::spot)
        out += fmt::format("cutoff {:g}°, penumbra {:g}°, ", light.cutoff_deg, light.penumbra_deg);
    return out + fmt::format("intensity {}", text(light.intensity));
}

Rows light_rows(const Scene& scene) {
    Rows rows;
    for (const Light& light : scene.lights)
        rows.push_back(
            {fmt::format("  {}", light_kind_names()[std::size_t(light.kind)]), light_text(light)});
    return rows;
}

/// One number where all channels agree.
std::string channels(const double (&value)[3]) {
    if (value[0] == value[1] && value[1] == value[2]) return fmt::format("{:g}", value[0]);
    return fmt::format("{:g},{:g},{:g}", value[0], value[1], value[2]);
}

/// The parameters that are used, whether they were given or are defaults.
std::string parameter_text(const ResolvedMaterial& resolved) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < resolved.brdf->params.size(); ++i)
        parts.push_back(
            fmt::format("{} {}", resolved.brdf->params[i].name,
                        resolved.brdf->params[i].kind == ParamKind::choice
                            ? value_text(resolved.brdf->params[i], resolved.params.value[i][0])
                            : channels(resolved.params.value[i])));
    parts.push_back(fmt::format("ka {}", channels(resolved.params.ka)));
    parts.push_back(fmt::format("emission {}", channels(resolved.params.emission)));
    return fmt::format("{}", fmt::join(parts, ", "));
}

Rows material_rows(const Scene& scene, const Settings& settings) {
    Rows rows;
    for (const Material& material : scene.materials) {
        const ResolvedMaterial resolved = resolve_material(material, settings.brdf, settings.set);
        rows.push_back({fmt::format("  {}", material.name),
                        std::string(resolved.unlit ? "unlit" : resolved.brdf->name),
                        parameter_text(resolved)});
        if (const Texture* map = material.map_kd.get())
            rows.push_back(
                {"", "",
                 fmt::format("map_kd {}, {} × {}", map->name, map->width(), map->height())});
        for (const std::string& what : resolved.mapped) rows.push_back({"", "", what});
    }
    return rows;
}

Rows event_table(const std::vector<EventRow>& events) {
    Rows rows;
    for (const EventRow& row : events)
        rows.push_back({fmt::format("  {}", row.info->name),
                        fmt::format("{} of {}", row.count, row.info->among),
                        fmt::format("{:.3g} %", 100 * row.rate), std::string(row.info->meaning)});
    return rows;
}

void print_section(std::string_view title, const Rows& rows) {
    print(fmt::format("\n{}\n{}", title, rows.empty() ? "  none\n" : table(rows)));
}

}  // namespace

int run_info(OptionParser& options, char** args) {
    std::string input;
    Settings settings;
    options.positional("INPUT", input, "an .obj file or a .toml scene");
    options.shared(settings);
    if (!options.parse(args)) return exit_done;

    Progress progress("loading " + input);
    const Scene scene = load_scene(input, settings);
    progress.finish();
    const EventTotals totals = event_totals(scene);
    Rows warnings;
    for (const std::string& sentence : scene.warnings) warnings.push_back({"  " + sentence});

    Rows overview = count_rows(scene, totals);
    for (auto& row : place_rows(scene, settings)) overview.push_back(std::move(row));
    print(table(overview));
    print_section("lights", light_rows(scene));
    print_section("materials, as they are drawn", material_rows(scene, settings));
    print_section("events while loading", event_table(event_rows(scene.events, totals)));
    print_section("warnings", warnings);
    return exit_done;
}

}  // namespace scanshade
