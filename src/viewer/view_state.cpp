#include "viewer/view_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scanshade/image/image.hpp"
#include "viewer/camera_control.hpp"
#include "viewer/light_control.hpp"

namespace scanshade::viewer {
namespace {

/// "" (each material's own), every model, "unlit".
std::vector<std::string_view> brdf_choices() {
    std::vector<std::string_view> names{""};
    for (const BrdfInfo* brdf : all_brdfs()) names.push_back(brdf->name);
    names.push_back("unlit");
    return names;
}

/// The model that all materials name, or "" where they differ.
std::string_view common_brdf(const std::vector<Material>& materials) {
    const auto other = [&](const Material& m) { return m.brdf != materials.front().brdf; };
    if (materials.empty() || std::any_of(materials.begin(), materials.end(), other)) return {};
    return materials.front().brdf;
}

}  // namespace

ViewState::ViewState(Scene scene, Settings settings)
    : scene_(std::move(scene)), own_shading_(!settings.is_given("shading")) {
    sides_[0].settings = settings;
    sides_[1].settings = std::move(settings);
    take_scene();
    // What the scene's camera was turned into by options is where reset returns to.
    home_ = scene_.camera;
}

void ViewState::take_scene() {
    bounds_ = scene_.bounds();
    objects_choose_ = own_shading_ &&
                      std::any_of(scene_.objects.begin(), scene_.objects.end(),
                                  [](const Object& object) { return object.shading.has_value(); });
    light_ = std::min(light_, scene_.lights.empty() ? 0 : scene_.lights.size() - 1);
    changed_ = true;
}

Settings ViewState::settings_while_moving(std::size_t side) const {
    Settings settings = sides_[side].settings;
    settings.samples = 1;
    return settings;
}

std::size_t ViewState::side_at(double x) const {
    if (!split_) return active_;
    return x < divider_ * settings().width ? 0 : 1;
}

std::optional<std::size_t> ViewState::selected_light() const {
    return scene_.lights.empty() ? std::nullopt : std::optional(light_);
}

Camera ViewState::camera() const {
    const double aspect = double(settings().width) / settings().height;
    return scene_.camera ? *scene_.camera : framed_camera(bounds_, aspect);
}

void ViewState::resize(int width, int height) {
    width = std::clamp(width, 1, max_image_side);
    height = std::clamp(height, 1, max_image_side);
    if (width == settings().width && height == settings().height) return;
    for (Side& side : sides_) side.settings.width = width, side.settings.height = height;
    changed_ = true;
}

bool ViewState::apply(const Request& request) {
    if (!apply_gesture(request) && !apply_view(request.action) && !apply_choice(request))
        return false;
    changed_ = true;
    return true;
}

bool ViewState::apply_gesture(const Request& r) {
    const int height = settings().height;
    switch (r.action) {
        case Action::orbit:
            scene_.camera = orbited(camera(), r.x, r.y, height);
            return true;
        case Action::pan:
            scene_.camera = panned(camera(), r.x, r.y, height);
            return true;
        case Action::zoom:
            scene_.camera = zoomed(camera(), r.y, bounds_.radius, r.at_x - settings().width / 2.0,
                                   r.at_y - height / 2.0, height);
            return true;
        case Action::move_light:
            move_light(r);
            return true;
        default:
            return false;
    }
}

void ViewState::move_light(const Request& r) {
    if (scene_.lights.empty()) return;
    Light& light = scene_.lights[light_];
    light = turned(light, camera(), bounds_.centre, r.x, r.y, settings().height);
}

bool ViewState::apply_view(Action action) {
    switch (action) {
        case Action::reset_camera:
            scene_.camera = home_;
            return true;
        case Action::view_front:
            scene_.camera = seen_from(camera(), {0, 0, 1});
            return true;
        case Action::view_right:
            scene_.camera = seen_from(camera(), {1, 0, 0});
            return true;
        case Action::view_top:
            scene_.camera = seen_from(camera(), {0, 1, 0});
            return true;
        case Action::view_opposite:
            scene_.camera = opposite(camera());
            return true;
        case Action::toggle_projection:
            scene_.camera = camera();
            scene_.camera->projection = scene_.camera->projection == Projection::perspective
                                            ? Projection::orthographic
                                            : Projection::perspective;
            return true;
        default:
            return false;
    }
}

bool ViewState::apply_choice(const Request& r) {
    Side& side = sides_[active_];
    switch (r.action) {
        case Action::next_shading:
            next_shading();
            return true;
        case Action::next_brdf:
            next_brdf();
            return true;
        case Action::next_interpolation:
            side.settings.interpolation = static_cast<Interpolation>(
                (static_cast<std::size_t>(side.settings.interpolation) + 1) %
                interpolation_names().size());
            return true;
        case Action::next_light:
            if (!scene_.lights.empty()) light_ = (light_ + 1) % scene_.lights.size();
            return true;
        case Action::toggle_wireframe:
            side.wireframe = !side.wireframe;
            return true;
        case Action::toggle_split:
            split_ = !split_;
            return true;
        case Action::other_side:
            active_ = 1 - active_;
            return true;
        case Action::debug_view:
            // The same key again shows the picture.
            side.view = side.view == DebugView(r.number) ? DebugView::none : DebugView(r.number);
            return true;
        default:
            return false;
    }
}

/// The place in the cycle of shadings; behind them is each object's own, where objects have one.
std::size_t ViewState::shading_choice(const Settings& settings) const {
    const bool own = objects_choose_ && !settings.is_given("shading");
    return own ? shading_names().size() : static_cast<std::size_t>(settings.shading);
}

void ViewState::next_shading() {
    Settings& settings = sides_[active_].settings;
    const std::size_t kinds = shading_names().size();
    const std::size_t next = (shading_choice(settings) + 1) % (kinds + (objects_choose_ ? 1 : 0));
    // An object's own shading gives way to one that was given as an option.
    if (next == kinds) {
        settings.given.erase("shading");
        return;
    }
    settings.shading = static_cast<Shading>(next);
    settings.given.insert("shading");
}

void ViewState::next_brdf() {
    std::string& brdf = sides_[active_].settings.brdf;
    const std::vector<std::string_view> names = brdf_choices();
    auto now = std::find(names.begin(), names.end(), brdf);
    if (now != names.end()) ++now;
    brdf = now == names.end() ? names.front() : *now;
}

bool ViewState::take_change() { return std::exchange(changed_, false); }

std::string ViewState::shading_name(const Settings& settings) const {
    const std::size_t choice = shading_choice(settings);
    if (choice == shading_names().size()) return "each object's own";
    return std::string(shading_names()[choice]);
}

std::string ViewState::brdf_name(const Settings& settings) const {
    if (!settings.brdf.empty()) return settings.brdf;
    const std::string_view common = common_brdf(scene_.materials);
    return common.empty() ? "each material's own" : fmt::format("{} (material's)", common);
}

std::string ViewState::title() const {
    return fmt::format("{} | shading {} | brdf {} | interpolation {}", scene_.name,
                       shading_name(settings()), brdf_name(settings()),
                       interpolation_names()[static_cast<std::size_t>(settings().interpolation)]);
}

std::string ViewState::method(std::size_t number) const {
    const Side& side = sides_[number];
    std::string text =
        fmt::format("{} · {} · {}", shading_name(side.settings), brdf_name(side.settings),
                    interpolation_names()[static_cast<std::size_t>(side.settings.interpolation)]);
    if (side.settings.renderer != RendererKind::simd)
        text += fmt::format(" · {}",
                            renderer_names()[static_cast<std::size_t>(side.settings.renderer)]);
    if (side.view != DebugView::none)
        text += fmt::format(" · {}", all_debug_views()[std::size_t(side.view)].name);
    return text;
}

std::string ViewState::current(Action action, int number) const {
    const auto on_off = [](bool on) { return std::string(on ? "on" : "off"); };
    switch (action) {
        case Action::next_shading:
            return shading_name(settings());
        case Action::next_brdf:
            return brdf_name(settings());
        case Action::next_interpolation:
            return std::string(
                interpolation_names()[static_cast<std::size_t>(settings().interpolation)]);
        case Action::next_light:
            return scene_.lights.empty()
                       ? std::string("no light")
                       : fmt::format("{} of {}", light_ + 1, scene_.lights.size());
        case Action::toggle_wireframe:
            return on_off(active().wireframe);
        case Action::toggle_split:
            return on_off(split_);
        case Action::other_side:
            return active_ == 0 ? "A" : "B";
        case Action::debug_view:
            return active().view == DebugView(number) ? "on" : "";
        case Action::toggle_projection:
            return camera().projection == Projection::perspective ? "perspective" : "orthographic";
        default:
            return {};
    }
}

}  // namespace scanshade::viewer
