// The table of options that every rendering command, scene files and the viewer share.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/scene/settings.hpp"
#include "scene/limits.hpp"

namespace scanshade {
namespace {

constexpr std::string_view shadings[] = {"flat", "gouraud", "phong"};
constexpr std::string_view interpolations[] = {"perspective", "edges", "patch"};
constexpr std::string_view renderers[] = {"simd", "scalar-f32", "scalar-f64"};
constexpr std::string_view isas[] = {"auto", "avx3", "avx2", "sse4", "ssse3", "scalar"};
constexpr std::string_view powers[] = {"squaring", "exp-log"};
constexpr std::string_view transfers[] = {"srgb", "linear"};
constexpr std::string_view projections[] = {"perspective", "orthographic"};
constexpr std::string_view normal_sources[] = {"file", "average", "area", "angle"};
constexpr std::string_view culls[] = {"none", "back"};
constexpr std::string_view up_axes[] = {"y", "z"};

/// The value of an enum whose names stand in a table in its order.
template <class Enum>
Enum choice(std::string_view option, std::span<const std::string_view> names,
            std::string_view value) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == value) return static_cast<Enum>(i);
    throw Error(Errc::usage,
                fmt::format("--{} knows no '{}'{}", option, value, suggestion(value, names)));
}

[[noreturn]] void fail(std::string_view option, std::string_view takes, std::string_view value) {
    throw Error(Errc::usage, fmt::format("--{} takes {}, not '{}'", option, takes, value));
}

double real_between(std::string_view option, double low, double high, std::string_view takes,
                    std::string_view value) {
    const auto number = parse_real(value);
    if (!number || !(*number >= low && *number <= high)) fail(option, takes, value);
    return *number;
}

glm::dvec3 three(std::string_view option, std::string_view takes, std::string_view value) {
    const auto parts = split(value, ',');
    if (parts.size() != 3) fail(option, takes, value);
    glm::dvec3 v(0);
    for (int i = 0; i < 3; ++i) {
        const auto number = parse_real(parts[static_cast<std::size_t>(i)]);
        if (!number) fail(option, takes, value);
        v[i] = *number;
    }
    return v;
}

glm::dvec3 point(std::string_view option, std::string_view value) {
    constexpr std::string_view takes = "three numbers x,y,z, each from -1e100 to 1e100";
    const glm::dvec3 v = three(option, takes, value);
    if (max_abs(v) > max_coordinate) fail(option, takes, value);
    return v;
}

void set_resolution(Settings& s, std::string_view value) {
    constexpr std::string_view takes = "width,height in pixels, each 1 to 16384, such as 1280,720";
    const auto parts = split(value, ',');
    if (parts.size() != 2) fail("resolution", takes, value);
    int size[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const auto n = parse_integer(parts[i]);
        if (!n || *n < 1 || *n > max_image_side) fail("resolution", takes, value);
        size[i] = static_cast<int>(*n);
    }
    s.width = size[0];
    s.height = size[1];
}

void set_samples(Settings& s, std::string_view value) {
    const auto n = parse_integer(value);
    const int side = n && *n >= 1 && *n <= 1024
                         ? static_cast<int>(std::lround(std::sqrt(static_cast<double>(*n))))
                         : 0;
    if (side == 0 || side * side != *n)
        fail("samples", "a square number from 1 to 1024, such as 4 or 16", value);
    s.samples = side * side;
}

/// Letters, digits and dashes, and no number: the name of a choice.
bool is_word(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !text.empty() && is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(),
                       [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-'; });
}

void set_isa(Settings& s, std::string_view value) {
    enum class Isa {};
    const auto number = static_cast<std::size_t>(choice<Isa>("isa", isas, value));
    s.isa = number == 0 ? "" : isas[number];
}

void set_threads(Settings& s, std::string_view value) {
    const auto n = parse_integer(value);
    if (!n || *n < 0 || *n > 1024)
        fail("threads", "a number from 1 to 1024, or 0 for all that the machine runs", value);
    s.threads = static_cast<int>(*n);
}

void set_parameter(Settings& s, std::string_view value) {
    constexpr std::string_view takes =
        "NAME=V, NAME=R,G,B or NAME=WORD, such as shininess=80 or distribution=ggx";
    const std::size_t equals = value.find('=');
    if (equals == std::string_view::npos || equals == 0) fail("set", takes, value);
    if (s.set.size() == max_parameters)
        throw Error(Errc::usage, fmt::format("--set is given more than {} times", max_parameters));
    ParamSetting setting{std::string(value.substr(0, equals)), {}, {}, {}};
    setting.place = "--set " + setting.name;
    const std::string_view given = value.substr(equals + 1);
    if (is_word(given)) {
        setting.word = given;
    } else {
        for (const std::string_view part : split(given, ',')) {
            const auto number = parse_real(part);
            if (!number) fail("set", takes, value);
            setting.values.push_back(*number);
        }
        if (setting.values.size() != 1 && setting.values.size() != 3) fail("set", takes, value);
    }
    s.set.push_back(std::move(setting));
}

void set_background(Settings& s, std::string_view value) {
    constexpr std::string_view takes =
        "three numbers r,g,b of linear radiance, each from 0 to 1e30";
    const glm::dvec3 v = three("background", takes, value);
    if (v.x < 0 || v.y < 0 || v.z < 0 || max_abs(v) > max_radiance)
        fail("background", takes, value);
    s.background = v;
}

void add_light(Settings& s, std::string_view value) {
    if (s.lights.size() == max_lights)
        throw Error(Errc::usage, fmt::format("--light is given more than {} times", max_lights));
    s.lights.push_back(parse_light(value));
}

bool flag(std::string_view option, std::string_view value) {
    if (value.empty() || value == "true") return true;
    if (value == "false") return false;
    fail(option, "true or false", value);
}

template <class Enum>
std::string name_of(std::span<const std::string_view> names, Enum value) {
    return std::string(names[static_cast<std::size_t>(value)]);
}
std::string three_text(const glm::dvec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

constexpr OptionControl pick(std::string_view choices, bool while_loading = false) {
    return {OptionControl::choice, 0, 0, {}, choices, while_loading};
}
constexpr OptionControl slide(double low, double high, std::string_view unit,
                              bool while_loading = false) {
    return {OptionControl::number, low, high, unit, {}, while_loading};
}
constexpr OptionControl tick(bool while_loading) {
    return {OptionControl::flag, 0, 0, {}, {}, while_loading};
}

// A light given anew replaces the scene's, one given again is added to it.
constexpr OptionInfo options[] = {
    {"resolution", "W,H", "size of the picture in pixels, 1 to 16384 each", false, false,
     set_resolution, [](const Settings& s) { return fmt::format("{},{}", s.width, s.height); }},
    {"shading", "flat|gouraud|phong",
     "where reflection is evaluated: at faces, at vertices, at pixels", false, false,
     [](Settings& s, std::string_view v) { s.shading = choice<Shading>("shading", shadings, v); },
     [](const Settings& s) { return name_of(shadings, s.shading); }, pick("flat|gouraud|phong")},
    {"brdf", "NAME|unlit", "reflection model of every material; see `scanshade brdf list`", false,
     false, [](Settings& s, std::string_view v) { s.brdf = v; },
     [](const Settings& s) { return s.brdf; }},
    {"set", "NAME=V[,V,V]|NAME=WORD",
     "a parameter of every material, such as shininess=80 or distribution=ggx", true, false,
     set_parameter},
    {"interpolation", "perspective|edges|patch", "how values travel inside a polygon", false, false,
     [](Settings& s, std::string_view v) {
         s.interpolation = choice<Interpolation>("interpolation", interpolations, v);
     },
     [](const Settings& s) { return name_of(interpolations, s.interpolation); },
     pick("perspective|edges|patch")},
    {"renderer", "simd|scalar-f32|scalar-f64",
     "the fast one; or sample by sample in float or double", false, false,
     [](Settings& s, std::string_view v) {
         s.renderer = choice<RendererKind>("renderer", renderers, v);
     },
     [](const Settings& s) { return name_of(renderers, s.renderer); },
     pick("simd|scalar-f32|scalar-f64")},
    {"isa", "auto|avx3|avx2|sse4|ssse3|scalar", "instruction set of the simd renderer", false,
     false, set_isa, [](const Settings& s) { return s.isa.empty() ? std::string("auto") : s.isa; }},
    {"threads", "N", "threads of the simd renderer; 0: all that the machine runs", false, false,
     set_threads, [](const Settings& s) { return fmt::format("{}", s.threads); },
     OptionControl{OptionControl::whole, 0, 16, {}, {}, false}},
    {"samples", "N", "samples a pixel, a square number from 1 to 1024", false, false, set_samples,
     [](const Settings& s) { return fmt::format("{}", s.samples); },
     pick("1|4|9|16|25|64|256|1024")},
    {"power", "squaring|exp-log", "how a whole exponent is raised: by squaring, or as e^(s log x)",
     false, false,
     [](Settings& s, std::string_view v) { s.power = choice<PowerForm>("power", powers, v); },
     [](const Settings& s) { return name_of(powers, s.power); }, pick("squaring|exp-log")},
    {"transfer", "srgb|linear", "curve from radiance to bytes", false, false,
     [](Settings& s, std::string_view v) {
         s.transfer = choice<Transfer>("transfer", transfers, v);
     },
     [](const Settings& s) { return name_of(transfers, s.transfer); }, pick("srgb|linear")},
    {"exposure", "EV", "radiance is multiplied by 2^EV, -100 to 100", false, false,
     [](Settings& s, std::string_view v) {
         s.exposure_ev = real_between("exposure", -100, 100, "a number from -100 to 100", v);
     },
     [](const Settings& s) { return fmt::format("{}", s.exposure_ev); }, slide(-8, 8, "EV")},
    {"background", "R,G,B", "linear radiance where nothing is drawn", false, false, set_background,
     [](const Settings& s) { return three_text(s.background); },
     OptionControl{OptionControl::colour, 0, 1, {}, {}, false}},
    {"camera-position", "X,Y,Z", "where the camera stands", false, false,
     [](Settings& s, std::string_view v) { s.camera_position = point("camera-position", v); }},
    {"camera-focal-point", "X,Y,Z", "what the camera looks at", false, false,
     [](Settings& s, std::string_view v) {
         s.camera_focal_point = point("camera-focal-point", v);
     }},
    {"camera-view-up", "X,Y,Z", "direction that points up in the picture", false, false,
     [](Settings& s, std::string_view v) { s.camera_view_up = point("camera-view-up", v); }},
    {"camera-view-angle", "DEG", "vertical angle of view, above 0 and below 180", false, false,
     [](Settings& s, std::string_view v) {
         s.camera_view_angle_deg =
             real_between("camera-view-angle", min_view_angle_deg, max_view_angle_deg,
                          "degrees from 0.001 to 179.9", v);
     }},
    {"projection", "perspective|orthographic", "kind of camera", false, false,
     [](Settings& s, std::string_view v) {
         s.projection = choice<Projection>("projection", projections, v);
     }},
    {"light", "TYPE:...",
     "a light instead of the scene's: point:x,y,z[:r,g,b[:c,l,q]] directional:dx,dy,dz[:r,g,b] "
     "spot:x,y,z:dx,dy,dz:deg[:r,g,b[:c,l,q]] cosine:x,y,z:dx,dy,dz[:r,g,b[:c,l,q]]",
     true, false, add_light},
    {"normals", "file|average|area|angle",
     "where vertex normals come from: the file or shape itself, or its faces", false, false,
     [](Settings& s, std::string_view v) {
         s.normals.source = choice<NormalSource>("normals", normal_sources, v);
     },
     [](const Settings& s) { return name_of(normal_sources, s.normals.source); },
     pick("file|average|area|angle", true)},
    {"crease", "DEG", "faces at a larger angle share no normal, 0 to 180 (never split)", false,
     false,
     [](Settings& s, std::string_view v) {
         s.normals.crease_deg = real_between("crease", 0, 180, "degrees from 0 to 180", v);
     },
     [](const Settings& s) { return fmt::format("{}", s.normals.crease_deg); },
     slide(0, 180, "°", true)},
    {"cull", "none|back", "leave out faces seen from behind", false, false,
     [](Settings& s, std::string_view v) { s.cull = choice<Cull>("cull", culls, v); },
     [](const Settings& s) { return name_of(culls, s.cull); }, pick("none|back")},
    {"tolerance", "LEVELS",
     "leave out of a tile lights that add less than that many of 255 levels together, 0 to 255",
     false, false,
     [](Settings& s, std::string_view v) {
         s.tolerance = real_between("tolerance", 0, 255, "a number of levels from 0 to 255", v);
     },
     [](const Settings& s) { return fmt::format("{}", s.tolerance); }, slide(0, 8, "levels")},
    {"no-plan", "", "leave nothing out that the picture does not need", false, true,
     [](Settings& s, std::string_view v) { s.no_plan = flag("no-plan", v); },
     [](const Settings& s) { return std::string(s.no_plan ? "true" : "false"); }, tick(false)},
    {"mtl-ambient", "", "take k_a from the MTL file instead of from Kd", false, true,
     [](Settings& s, std::string_view v) { s.mtl_ambient = flag("mtl-ambient", v); },
     [](const Settings& s) { return std::string(s.mtl_ambient ? "true" : "false"); }, tick(true)},
    {"allow-outside", "", "read what a scene names outside its own folder, too", false, true,
     [](Settings& s, std::string_view v) { s.allow_outside = flag("allow-outside", v); }, nullptr,
     OptionControl{}, true},
    {"up", "y|z", "axis that points up in an OBJ file", false, false,
     [](Settings& s, std::string_view v) { s.up = choice<UpAxis>("up", up_axes, v); },
     [](const Settings& s) { return name_of(up_axes, s.up); }, pick("y|z", true)},
};

}  // namespace

std::span<const std::string_view> shading_names() { return shadings; }
std::span<const std::string_view> interpolation_names() { return interpolations; }
std::span<const std::string_view> renderer_names() { return renderers; }
std::span<const std::string_view> power_form_names() { return powers; }

std::span<const OptionInfo> shared_options() { return options; }

const OptionInfo* find_option(std::string_view name) {
    for (const OptionInfo& option : options)
        if (option.name == name) return &option;
    return nullptr;
}

}  // namespace scanshade
