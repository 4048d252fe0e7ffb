// What can be chosen for a picture, apart from what is in it: one struct and one table of options
// that the command line, scene files, the viewer and the docs read.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/scene/camera.hpp"
#include "scanshade/scene/light.hpp"
#include "scanshade/scene/material.hpp"
#include "scanshade/scene/mesh.hpp"

namespace scanshade {

enum class Shading { flat, gouraud, phong };             // where reflection is evaluated
enum class Interpolation { perspective, edges, patch };  // how values travel inside a polygon
/// Whether faces of more than three corners are drawn whole, not cut into triangles.
constexpr bool draws_whole(Interpolation i) { return i == Interpolation::edges; }
enum class RendererKind {
    simd,
    scalar_f32,
    scalar_f64
};                                           // vectors of floats; or their plain twins
enum class PowerForm { squaring, exp_log };  // how a whole exponent is raised
enum class Transfer { srgb, linear };        // from radiance to bytes
enum class Cull { none, back };
enum class UpAxis { y, z };

/// Names as options and files spell them, in the order of the enums.
std::span<const std::string_view> shading_names();
std::span<const std::string_view> interpolation_names();
std::span<const std::string_view> renderer_names();
std::span<const std::string_view> power_form_names();

struct Settings {
    int width = 960, height = 720;  // pixels, 1 to 16384
    Shading shading = Shading::phong;
    std::string brdf;               // every material gets this model; empty: its own
    std::vector<ParamSetting> set;  // every material gets these parameters
    Interpolation interpolation = Interpolation::perspective;
    RendererKind renderer = RendererKind::simd;
    std::string isa;  // instruction set of the kernels; empty: the best of this machine
    int tile = 64;    // side of the simd renderer's tiles in samples: 16, 32 or 64
    int threads = 0;  // of the simd renderer, 1 to 1024; 0: all that the machine runs
    int samples = 1;  // a square number, 1 to 1024
    PowerForm power = PowerForm::squaring;
    Transfer transfer = Transfer::srgb;
    double exposure_ev = 0;                   // radiance is multiplied by 2^EV
    glm::dvec3 background{0.05, 0.06, 0.08};  // linear radiance
    std::optional<glm::dvec3> camera_position, camera_focal_point, camera_view_up;
    std::optional<double> camera_view_angle_deg;
    std::optional<Projection> projection;
    std::vector<Light> lights;  // not empty: instead of the scene's
    NormalOptions normals;
    bool mtl_ambient = false;  // k_a from the MTL file instead of from Kd
    UpAxis up = UpAxis::y;     // of OBJ files
    Cull cull = Cull::none;
    double tolerance = 0;        // levels of 255 that lights left out of a tile may add together
    bool allow_outside = false;  // files that a scene names may be outside its folder
    bool no_plan = false;        // leave nothing out that the picture does not need
    std::set<std::string, std::less<>> kept_rows;  // rows of the plan that are not left out

    std::set<std::string, std::less<>> given;  // names of options given on the command line
    bool is_given(std::string_view name) const { return given.find(name) != given.end(); }
};

/// How an option is set by hand in a window.
struct OptionControl {
    enum Kind { none, choice, number, whole, colour, flag } kind = none;
    double low = 0, high = 0;  // of a slider; files and the command line may go further
    std::string_view unit{};
    std::string_view choices{};  // "a|b|c"
    bool while_loading = false;  // acts on meshes as they are read
};

/// One shared option.
struct OptionInfo {
    std::string_view name;     // without the dashes
    std::string_view values;   // "W,H", "flat|gouraud|phong", ...
    std::string_view meaning;  // one line
    bool repeatable = false;
    bool is_flag = false;  // takes no value; in a scene file: true
    /// Parses and stores a value; throws Error(usage) that says what would be right.
    void (*apply)(Settings& settings, std::string_view value);
    /// What apply would take for the value that is there; null for what has no single one.
    std::string (*show)(const Settings& settings) = nullptr;
    OptionControl control{};
    bool command_line_only = false;  // not for a scene to say
};

/// Every option that all rendering commands share. A scene file's [render] table knows the same
/// names (arrays are joined by commas).
std::span<const OptionInfo> shared_options();

/// The option of that name, or nullptr.
const OptionInfo* find_option(std::string_view name);

/// One light as `--light` spells it; throws Error(usage) that shows the right form.
Light parse_light(std::string_view text);

}  // namespace scanshade
