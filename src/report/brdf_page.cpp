#include "report/brdf_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "report/brdf_values.hpp"
#include "report/svg_plot.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/render/renderer.hpp"
#include "scanshade/report/page.hpp"
#include "scanshade/scene/scene.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr int sphere_pixels = 150, sphere_count = 6, sphere_tessellation = 48;

/// π f_r cosθ_i cosθ_o over the plane of incidence: the intensity that a spot of the surface shows,
/// 1 for a white Lambertian one that faces light and viewer. A curve is scaled to its own largest
/// value, which stands in its label: lobes of grazing light are many times longer than others.
std::string lobes(const BrdfInfo& brdf, const MaterialParams<double>& params) {
    std::vector<Curve> curves;
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        Curve curve;
        double largest = 1e-12;
        // The light is on the left, so the mirror direction is on the right.
        for (int quarter = -359; quarter <= 359; ++quarter) {
            const double to = 0.25 * quarter;
            const ViewedFrom at{degrees * degree, std::abs(to) * degree, to > 0 ? 180 * degree : 0};
            const double shown = 180 * degree * f_cos_at(brdf, params, at) * std::cos(at.theta_o);
            curve.points.push_back({to * degree, shown});
            largest = std::max(largest, shown);
        }
        for (PlotPoint& p : curve.points) p.y /= largest;
        curve.label = fmt::format("light at {:g}°: {:.2g}", degrees, largest);
        curves.push_back(std::move(curve));
    }
    return polar_plot(curves);
}

std::string albedo_plot(const BrdfInfo& brdf, const MaterialParams<double>& params) {
    Curve curve{"albedo", {}};
    for (int degrees = 0; degrees <= 89; ++degrees)
        curve.points.push_back({double(degrees), albedo(brdf, params, degrees * degree)});
    return line_plot({"θ_o in degrees", "ρ(ω_o)", 0, 90},
                     {std::move(curve), Curve{"all of it", {{0, 1}, {90, 1}}}});
}

/// The parameter that changes a model's look most: its highlight's width, else its first number,
/// else its first colour.
const ParamInfo& main_parameter(const BrdfInfo& brdf) {
    for (const ParamInfo& p : brdf.params)
        if (p.role == ParamRole::exponent || p.role == ParamRole::roughness) return p;
    for (const ParamInfo& p : brdf.params)
        if (p.kind == ParamKind::number) return p;
    return brdf.params.front();
}

/// From a fifth of the default upwards, in equal ratios.
std::vector<double> strip_values(const ParamInfo& info) {
    const double low = std::max(info.min, info.standard / 5);
    const double high = std::min(info.max, info.standard * 25);
    std::vector<double> values;
    for (int i = 0; i < sphere_count; ++i) {
        const double value = low * std::pow(high / low, double(i) / (sphere_count - 1));
        values.push_back(std::clamp(value, low, high));
    }
    return values;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string sphere_strip(const BrdfInfo& brdf, const std::vector<ParamSetting>& given) {
    const ParamInfo& main = main_parameter(brdf);
    const auto mesh = std::make_shared<const Mesh>(
        build_mesh(find_shape("sphere")->make(sphere_tessellation), {}));
    Settings settings;
    settings.width = settings.height = sphere_pixels;
    settings.samples = 4;
    settings.brdf = brdf.name;
    std::string out;
    for (const double value : strip_values(main)) {
        settings.set = given;
        settings.set.push_back({std::string(main.name), {value}, {}, {}});
        const Image picture = render_image(single_object_scene(mesh, {}), settings);
        out += fmt::format(
            "<figure><img width=\"{0}\" height=\"{0}\" alt=\"sphere\" "
            "src=\"data:image/png;base64,{1}\"><figcaption>{2} = {3:.3g}</figcaption></figure>\n",
            sphere_pixels, base64(encode_png(picture)), escaped(main.symbol), value);
    }
    return out;
}

std::string parameter_rows(const BrdfInfo& brdf, const MaterialParams<double>& params) {
    std::string out;
    for (std::size_t i = 0; i < brdf.params.size(); ++i) {
        const ParamInfo& p = brdf.params[i];
        out += fmt::format(
            "<tr><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "</tr>\n",
            escaped(p.name), escaped(p.symbol), escaped(range_text(p)),
            value_text(p, params.value[i][0]), p.unit.empty() ? "1" : p.unit, escaped(p.meaning));
    }
    return out;
}

constexpr std::string_view style =
    "body{max-width:62rem;margin:2rem auto;padding:0 1rem;font-family:sans-serif;color:#222;"
    "background:#fff}pre{background:#f3f4f6;padding:.8rem;overflow:auto}table{border-collapse:"
    "collapse}td,th{padding:.25rem .7rem;border-bottom:1px solid #ddd;text-align:left}figure{"
    "display:inline-block;margin:.2rem;text-align:center}h2{margin-top:2rem}";

}  // namespace

std::string_view reciprocity_text(const Promises& promises) {
    return promises.reciprocal ? "reciprocal: f_r(ω_i, ω_o) = f_r(ω_o, ω_i)"
                               : "not reciprocal: f_r(ω_i, ω_o) and f_r(ω_o, ω_i) may differ";
}

std::string_view energy_text(const Promises& promises) {
    constexpr std::string_view texts[] = {
        "conserves energy: reflects at most what arrives",
        "conserves energy where the diffuse and the specular parameter sum to at most 1",
        "may reflect more energy than arrives, for some parameters in range",
    };  // in the enum's order
    return texts[std::size_t(promises.energy)];
}

std::string range_text(const ParamInfo& info) {
    if (info.kind == ParamKind::choice) return fmt::format("{}", fmt::join(info.names, " "));
    return fmt::format("{:g} to {:g}", info.min, info.max);
}

std::string_view kind_text(const ParamInfo& info) {
    constexpr std::string_view names[] = {"R,G,B", "number", "exponent", "choice"};
    return names[std::size_t(info.kind)];  // in the enum's order
}

std::string brdf_page(const BrdfInfo& brdf, const std::vector<ParamSetting>& given) {
    const MaterialParams<double> params = resolve_material({}, brdf.name, given).params;
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>"
        "<style>{1}</style></head><body>\n<h1>{0}</h1>\n<p>{2}</p>\n<pre>{3}</pre>\n"
        "<p>Source: {4}</p>\n<ul><li>{5}</li><li>{6}</li></ul>\n"
        "<h2>Parameters of this page</h2>\n<table><tr><th>name</th><th>symbol</th><th>range</th>"
        "<th>here</th><th>unit</th><th>meaning</th></tr>\n{7}</table>\n"
        "<h2>Across the main parameter</h2>\n{8}"
        "<h2>Where the light goes</h2>\n<p>π f_r cosθ_i cosθ_o in the plane of incidence, over the "
        "direction of the viewer: the intensity that a spot of the surface shows. The light is on "
        "the left. Each curve is scaled to 1; its label has the largest value, where a white "
        "Lambertian surface that faces light and viewer has 1.</p>\n{9}"
        "<h2>How much of it</h2>\n<p>Albedo ρ(ω_o): the part of uniform light from everywhere that "
        "a viewer at θ_o sees again.</p>\n{10}</body></html>\n",
        escaped(brdf.name), style, escaped(brdf.title), escaped(brdf.equation),
        escaped(brdf.source), escaped(reciprocity_text(brdf.promises)),
        escaped(energy_text(brdf.promises)), parameter_rows(brdf, params),
        sphere_strip(brdf, given), lobes(brdf, params), albedo_plot(brdf, params));
}

}  // namespace scanshade
