#include "viewer/view_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scanshade/base/error.hpp"
#include "scanshade/brdf/brdf.hpp"
#include "scanshade/image/image.hpp"
#include "viewer/camera_control.hpp"

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
    : scene_(std::move(scene)),
      settings_(std::move(settings)),
      home_(scene_.camera),
      radius_(scene_.bounds().radius),
      brdfs_(brdf_choices()) {
    for (std::size_t i = 0; i < shading_names().size(); ++i)
        shadings_.push_back({static_cast<Shading>(i), true});
    shading_ = static_cast<std::size_t>(settings_.shading);

    const bool objects_choose =
        std::any_of(scene_.objects.begin(), scene_.objects.end(),
                    [](const Object& object) { return object.shading.has_value(); });
    if (objects_choose && !settings_.is_given("shading")) {
        shading_ = shadings_.size();
        shadings_.push_back({settings_.shading, false});
    }
}

void ViewState::resize(int width, int height) {
    width = std::clamp(width, 1, max_image_side);
    height = std::clamp(height, 1, max_image_side);
    if (width == settings_.width && height == settings_.height) return;
    settings_.width = width;
    settings_.height = height;
    changed_ = true;
}

bool ViewState::apply(const Request& request) {
    switch (request.action) {
        case Action::orbit:
        case Action::pan:
        case Action::zoom:
            move_camera(request);
            break;
        case Action::next_shading:
            next_shading();
            break;
        case Action::next_brdf:
            next_brdf();
            break;
        case Action::next_interpolation:
            settings_.interpolation =
                static_cast<Interpolation>((static_cast<std::size_t>(settings_.interpolation) + 1) %
                                           interpolation_names().size());
            break;
        case Action::reset_camera:
            scene_.camera = home_;
            break;
        case Action::save_picture:
        case Action::toggle_help:
        case Action::quit:
            return false;
    }
    changed_ = true;
    return true;
}

void ViewState::move_camera(const Request& request) {
    const double aspect = double(settings_.width) / settings_.height;
    const Camera camera = scene_.camera ? *scene_.camera : framed_camera(scene_.bounds(), aspect);
    switch (request.action) {
        case Action::orbit:
            scene_.camera = orbited(camera, request.x, request.y, settings_.height);
            break;
        case Action::pan:
            scene_.camera = panned(camera, request.x, request.y, settings_.height);
            break;
        default:
            scene_.camera = zoomed(camera, request.y, radius_);
    }
}

void ViewState::next_shading() {
    shading_ = (shading_ + 1) % shadings_.size();
    settings_.shading = shadings_[shading_].shading;
    // An object's own shading gives way to one that was given as an option.
    if (shadings_[shading_].for_all)
        settings_.given.insert("shading");
    else
        settings_.given.erase("shading");
}

void ViewState::next_brdf() {
    auto now = std::find(brdfs_.begin(), brdfs_.end(), settings_.brdf);
    if (now != brdfs_.end()) ++now;
    settings_.brdf = now == brdfs_.end() ? brdfs_.front() : *now;
}

bool ViewState::take_change() { return std::exchange(changed_, false); }

std::string ViewState::title() const {
    const std::string_view shading =
        shadings_[shading_].for_all ? shading_names()[static_cast<std::size_t>(settings_.shading)]
                                    : "each object's own";
    std::string brdf = settings_.brdf;
    if (brdf.empty()) {
        const std::string_view common = common_brdf(scene_.materials);
        brdf = common.empty() ? "each material's own" : fmt::format("{} (material's)", common);
    }
    return fmt::format("{} | shading {} | brdf {} | interpolation {}", scene_.name, shading, brdf,
                       interpolation_names()[static_cast<std::size_t>(settings_.interpolation)]);
}

std::filesystem::path next_picture_path(const std::filesystem::path& folder,
                                        std::string_view model) {
    constexpr int max_number = 1'000'000;
    for (int n = 1; n <= max_number; ++n) {
        const std::filesystem::path path = folder / fmt::format("{}_{}.png", model, n);
        std::error_code unreadable;  // saving there will say what is wrong
        if (!std::filesystem::exists(path, unreadable)) return path;
    }
    throw Error(Errc::file, fmt::format("the names {0}_1.png to {0}_{1}.png are all taken; move "
                                        "some pictures elsewhere",
                                        model, max_number));
}

}  // namespace scanshade::viewer
