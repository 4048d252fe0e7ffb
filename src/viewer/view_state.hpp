// What the viewer shows: the scene, its settings and the camera, and how actions change them.
// Knows nothing of windows or events.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanshade/scene/scene.hpp"

namespace scanshade::viewer {

/// Everything that a person can ask of the viewer.
enum class Action {
    orbit,  // the first three are gestures with an amount
    pan,
    zoom,
    next_shading,
    next_brdf,
    next_interpolation,
    reset_camera,
    save_picture,
    toggle_help,
    quit,
};

/// An action with its amount: pixels of the picture, y down (orbit, pan), or wheel steps in y.
struct Request {
    Action action;
    double x = 0, y = 0;
};

class ViewState {
public:
    /// Shows `scene` (as load_scene returns it) just as `scanshade render` does.
    ViewState(Scene scene, Settings settings);

    const Scene& scene() const { return scene_; }
    const Settings& settings() const { return settings_; }

    /// The picture's size follows the window's; a camera that was framed on the bounds and not
    /// moved since is framed again.
    void resize(int width, int height);

    /// Does what the request asks of the state; false where it asks for something else (saving,
    /// help, quit).
    bool apply(const Request& request);

    /// Whether the picture must be drawn again; asking clears the answer.
    bool take_change();

    /// "teapot | shading flat | brdf phong | interpolation edges", or whose own choice each is.
    std::string title() const;

private:
    struct ShadingChoice {
        Shading shading;
        bool for_all;  // also for objects that choose their own
    };

    void move_camera(const Request& request);
    void next_shading();
    void next_brdf();

    Scene scene_;
    Settings settings_;
    std::optional<Camera> home_;  // the camera to which reset returns; none: framed on the bounds
    double radius_;               // of the scene's bounds
    std::vector<ShadingChoice> shadings_;
    std::size_t shading_ = 0;              // index of the choice
    std::vector<std::string_view> brdfs_;  // "": each material's own
    bool changed_ = true;
};

/// `folder`/`model`_N.png with the first number from 1 on that no file has.
/// Throws Error(file) where the first million are taken.
std::filesystem::path next_picture_path(const std::filesystem::path& folder,
                                        std::string_view model);

}  // namespace scanshade::viewer
