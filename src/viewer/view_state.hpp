// What the viewer shows: the scene, its settings on both sides of a split screen, the camera, and how
// requests change them. Knows nothing of windows or events.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/brdf/brdf.hpp"
#include "scanshade/render/debug_view.hpp"
#include "scanshade/scene/scene.hpp"
#include "viewer/actions.hpp"

namespace scanshade::viewer {

/// How a scene is drawn on one side.
struct Side {
    Settings settings;
    DebugView view = DebugView::none;
    bool wireframe = false;
};

class ViewState {
public:
    /// Shows `scene` (as load_scene returns it) just as `scanshade render` does.
    ViewState(Scene scene, Settings settings);

    const Scene& scene() const { return scene_; }
    const Side& side(std::size_t number) const { return sides_[number]; }
    const Side& active() const { return sides_[active_]; }
    const Settings& settings() const { return active().settings; }
    /// With which it is drawn while something moves: one sample a pixel.
    Settings settings_while_moving(std::size_t side) const;

    std::size_t active_number() const { return active_; }
    bool split() const { return split_; }
    double divider() const { return divider_; }  // share of the width that is side 0
    /// The side that is seen at column x.
    std::size_t side_at(double x) const;
    std::optional<std::size_t> selected_light() const;
    /// The camera that draws, framed where the scene has none.
    Camera camera() const;
    const Bounds& bounds() const { return bounds_; }

    /// The picture's size follows the window's; a camera that was framed on the bounds and not
    /// moved since is framed again.
    void resize(int width, int height);

    /// Does what the request asks of the state; false where it asks for something else.
    bool apply(const Request& request);

    /// With which another file is read: what the command line said, and what was chosen since.
    Settings settings_for_loading(const Settings& command_line) const;
    /// Another file, or the same one read again, with the settings that reading has filled in. What
    /// was chosen for a side stays. The camera may stay, too.
    void replace(Scene scene, const Settings& loaded, bool keep_camera);

    // What the panel does. Values are checked: these throw Error and leave everything as it was.
    void set_option(const OptionInfo& option, std::string_view text);
    void set_model(std::size_t material, std::string_view brdf);
    /// A material takes the model that it is drawn with for its own.
    void set_parameter(std::size_t material, std::string_view name, std::vector<double> values,
                       std::string word = {});
    void set_ambient(const glm::dvec3& ambient);
    void set_light(std::size_t number, const Light& light);
    void add_light();
    void remove_light(std::size_t number);
    void select_light(std::size_t number);
    void set_debug_view(DebugView view);
    void set_divider(double share);
    void set_active(std::size_t side);

    /// Whether the picture must be drawn again; asking clears the answer.
    bool take_change();

    /// "teapot | shading flat | brdf phong | interpolation edges", or whose own choice each is.
    std::string title() const;
    /// "flat · phong · edges", for a side.
    std::string method(std::size_t side) const;
    /// What an action's key stands at now: "phong", "on", ...; empty: nothing.
    std::string current(Action action, int number) const;

private:
    struct ShadingChoice {
        Shading shading;
        bool for_all;  // also for objects that choose their own
    };

    bool apply_gesture(const Request& request);
    bool apply_view(Action action);
    bool apply_choice(const Request& request);
    void move_light(const Request& request);
    void next_shading();
    void next_brdf();
    std::size_t shading_choice(const Settings& settings) const;
    std::string shading_name(const Settings& settings) const;
    std::string brdf_name(const Settings& settings) const;
    void take_scene();

    Scene scene_;
    std::array<Side, 2> sides_;
    std::size_t active_ = 0;
    bool split_ = false;
    double divider_ = 0.5;
    std::size_t light_ = 0;       // selected
    std::optional<Camera> home_;  // the camera to which reset returns; none: framed on the bounds
    Bounds bounds_;
    bool own_shading_;             // objects may choose: the command line has not
    bool objects_choose_ = false;  // some object has a shading of its own, and may
    bool changed_ = true;
};

}  // namespace scanshade::viewer
