// The pictures' part of the stability report as files: rows, plots, pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/picture_files.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/image/texture.hpp"

namespace scanshade {

std::string picture_file(const PictureStability& pictures, const PictureCaseResult& result) {
    if (result.generated) return fmt::format("case-{}.png", result.name);
    return fmt::format("scene-{}.png", &result - pictures.cases.data() + 1);
}

namespace {

// ---- for programs

Json events_json(const EventCounts& events) {
    Json json = Json::object();
    for (const EventInfo& info : all_events())
        if (events[info.event] > 0) json[std::string(info.name)] = events[info.event];
    return json;
}

Json row_json(const PictureCaseResult& result, std::string_view method, Json error) {
    return {{"axis", "pictures"},
            {"method", method},
            {"parameters",
             {{"width", result.width}, {"height", result.height}, {"triangles", result.triangles}}},
            {"error", std::move(error)}};
}

Json renderer_json(const PictureCaseResult& result, const RendererResult& r) {
    Json row = row_json(result, r.renderer,
                        {{"not_finite", r.not_finite},
                         {"other_id", r.other_id},
                         {"levels", r.levels},
                         {"levels_bound", result.bounds.levels},
                         {"differing_pixels", r.differing},
                         {"beyond_a_level", r.beyond},
                         {"beyond_a_level_bound", result.bounds.beyond}});
    row["events"] = events_json(r.events);
    return row;
}

Json geometry_json(const PictureCaseResult& result) {
    const GeometryResult& g = result.geometry;
    Json error = {{"vertices", g.vertices},
                  {"displacement_256th", g.displacement},
                  {"covered_samples", g.samples},
                  {"moved_samples", g.moved},
                  {"opened_samples", g.opened},
                  {"edge_distance_256th", g.edge_distance},
                  {"rounding_bound_share", g.bound_share},
                  {"mistaken_samples", g.mistaken}};
    if (result.generated) {
        error["displacement_bound"] = result.bounds.displacement;
        error["mistaken_bound"] = result.bounds.mistaken;
    }
    return row_json(result, "geometry", std::move(error));
}

}  // namespace

Json picture_scenes_json(const PictureStability& pictures) {
    Json scenes = Json::array();
    for (const PictureCaseResult& result : pictures.cases) {
        Json rows = Json::array();
        for (const RendererResult& r : result.renderers) rows.push_back(renderer_json(result, r));
        rows.push_back(geometry_json(result));
        for (Json& row : rows) row["image"] = picture_file(pictures, result);
        scenes.push_back({{"name", result.name},
                          {"generated", result.generated},
                          {"difficulty", result.difficulty},
                          {"reason", result.bounds.reason},
                          {"loading_events", events_json(result.loading)},
                          {"rows", rows}});
    }
    return scenes;
}

// ---- plots

namespace {

/// A line of the data is a case: its place from the top, its name, and three values.
constexpr const char* cases_script = R"(
set border 1
set lmargin 30
set yrange [cases - 0.5:-0.5]
set key outside top center horizontal samplen 1
set ytics scale 0
set linetype 1 linecolor rgb '#0072b2' pointtype 7 pointsize 0.6
set linetype 2 linecolor rgb '#d55e00' pointtype 6 pointsize 0.9
set linetype 3 linecolor rgb '#a32012' pointtype 8 pointsize 0.7
)";

constexpr const char* levels_script = R"(
set logscale x 2
set xrange [0.4:300]
set xtics ('0' 0.5, '1' 1, '2' 2, '4' 4, '8' 8, '16' 16, '32' 32, '64' 64, '128' 128, '255' 255)
set xlabel 'largest difference from scalar-f64, levels of 255'
plot 'data' using 3:1:ytic(2) with points linetype 1 title 'vector renderer', \
     'data' using 4:1 with points linetype 2 title 'scalar-f32', \
     'data' using 5:1 with points linetype 3 title 'bound'
)";

constexpr const char* geometry_script = R"(
set logscale x
set xrange [0.001:*]
set format x '%g'
set xlabel '1/256 pixel'
plot 'data' using 3:1:ytic(2) with points linetype 1 title 'displacement of a vertex', \
     'data' using 4:1 with points linetype 2 title 'distance of a moved sample from its edge', \
     'data' using 5:1 with points linetype 3 title 'bound'
)";

/// A long name would take the plot's room.
std::string short_name(const std::string& name) {
    constexpr std::size_t most = 28;
    return name.size() <= most ? name : clean_text(name.substr(0, most - 1)) + "…";
}

int largest_levels(const PictureCaseResult& result, bool simd) {
    int most = 0;
    for (const RendererResult& r : result.renderers)
        if ((r.renderer.rfind("simd", 0) == 0) == simd) most = std::max(most, r.levels);
    return most;
}

Plot cases_plot(const PictureStability& pictures, const char* file, const char* script) {
    const std::size_t cases = pictures.cases.size();
    Plot plot{file, 760, int(110 + 17 * cases), {{"cases", double(cases)}}, {}, {}};
    plot.script = {cases_script, script};
    return plot;
}

}  // namespace

std::vector<Plot> picture_plots(const PictureStability& pictures) {
    if (pictures.cases.empty()) return {};
    Plot levels = cases_plot(pictures, levels_plot, levels_script);
    Plot moved = cases_plot(pictures, geometry_plot, geometry_script);
    // Logarithmic axes have no 0; what is not a number gets no point.
    constexpr double no_point = std::numeric_limits<double>::quiet_NaN();
    const auto level = [](int n) { return std::max(double(n), 0.5); };
    const auto distance = [](double d) { return std::isfinite(d) ? std::max(d, 0.001) : no_point; };
    double y = 0;
    for (const PictureCaseResult& result : pictures.cases) {
        const GeometryResult& g = result.geometry;
        levels.data.number(y).text(short_name(result.name));
        levels.data.number(level(largest_levels(result, true)))
            .number(level(largest_levels(result, false)))
            .number(level(result.bounds.levels))
            .end_line();
        moved.data.number(y).text(short_name(result.name));
        moved.data.number(distance(g.displacement))
            .number(distance(g.edge_distance))
            .number(distance(result.bounds.displacement))
            .end_line();
        ++y;
    }
    return {levels, moved};
}

// ---- files

namespace {

constexpr int thumbnail_width = 320;

/// A level of the picture's mip chain: it is averaged as light, not as bytes.
Image thumbnail(const Image& image) {
    if (image.width <= thumbnail_width) return image;
    const Texture texture = make_texture(image, "");
    const auto small =
        std::find_if(texture.levels.begin(), texture.levels.end(),
                     [](const MipLevel& level) { return level.width <= thumbnail_width; });
    Framebuffer frame(small->width, small->height);
    for (std::size_t i = 0; i < frame.r.size(); ++i) {
        frame.r[i] = small->texels[3 * i];
        frame.g[i] = small->texels[3 * i + 1];
        frame.b[i] = small->texels[3 * i + 2];
    }
    return encode(frame, Transfer::srgb, 0);
}

}  // namespace

void write_pictures(const PictureStability& pictures, const std::string& folder) {
    for (const PictureCaseResult& result : pictures.cases)
        save_png(thumbnail(result.picture),
                 std::filesystem::path(folder) / picture_file(pictures, result));
}

}  // namespace scanshade
