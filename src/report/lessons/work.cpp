#include "report/lessons/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scanshade/base/error.hpp"
#include "scanshade/base/files.hpp"
#include "scanshade/image/heat.hpp"
#include "scanshade/image/metrics.hpp"
#include "scanshade/image/png.hpp"
#include "scanshade/scene/shapes.hpp"

namespace scanshade {

LessonWork::LessonWork(const LessonInfo& lesson, const std::filesystem::path& scenes,
                       const std::string& folder, Page& page)
    : lesson_(lesson),
      scene_(scenes / fmt::format("{}.toml", lesson.name)),
      folder_(folder),
      page_(page) {}

ReportInput LessonWork::input(const LessonOptions& options) const {
    ReportInput input;
    for (const auto& [name, value] : options) {
        const OptionInfo* option = find_option(name);
        SCANSHADE_CHECK(option != nullptr);
        option->apply(input.settings, value);
        input.settings.given.insert(std::string(name));
    }
    input.scene = load_scene(scene_, input.settings);
    return input;
}

std::string LessonWork::path_of(const std::string& file) const {
    return (std::filesystem::path(folder_) / file).string();
}

Figure LessonWork::picture(std::string_view file, const Image& image, std::string caption) const {
    const std::string name = fmt::format("{}-{}.png", lesson_.name, file);
    save_png(image, path_of(name));
    return {name, std::move(caption), false, image.width};
}

Figure LessonWork::picture(std::string_view file, const ReportInput& input,
                           std::string caption) const {
    return picture(file, render_image(input.scene, input.settings), std::move(caption));
}

Figure LessonWork::picture(std::string_view file, const LessonOptions& options,
                           std::string caption) const {
    return picture(file, input(options), std::move(caption));
}

Figure LessonWork::plot(std::string_view file, const std::string& svg, std::string caption) const {
    const std::string name = fmt::format("{}-{}.svg", lesson_.name, file);
    write_file(svg, path_of(name));
    return {name, std::move(caption), true, plot_width};
}

double LessonWork::measured(std::string what, double value, std::string unit) {
    facts_.push_back({lesson_.name, std::move(what), value, std::move(unit)});
    return value;
}

Framebuffer draw_planes(const ReportInput& input) {
    Framebuffer frame;
    Renderer(input.scene, input.settings).draw(frame);
    return frame;
}

Image shown(const Framebuffer& frame, const Settings& settings) {
    return encode(frame, settings.transfer, settings.exposure_ev);
}

ReportInput with_tessellation(const ReportInput& input, int tessellation) {
    ReportInput out = input;
    for (Object& object : out.scene.objects)
        if (const ShapeInfo* shape = find_shape(object.shape))
            object.mesh = make_shape_mesh(*shape, tessellation);
    return out;
}

ReportInput with_object(const ReportInput& input, std::size_t object) {
    ReportInput out = input;
    out.scene.objects = {input.scene.objects.at(object)};
    return out;
}

ReportInput with_parameter(ReportInput input, std::string name, double value) {
    input.settings.set.push_back({std::move(name), {value}, "the lesson", {}});
    return input;
}

double radiance_at(const Framebuffer& frame, int x, int y) {
    const std::size_t i = frame.index(x, y);
    return (double(frame.r[i]) + double(frame.g[i]) + double(frame.b[i])) / 3;
}

Curve row_curve(const Framebuffer& frame, int y, std::string label) {
    Curve curve{std::move(label), {}};
    for (int x = 0; x < frame.width; ++x)
        curve.points.push_back({x + 0.5, radiance_at(frame, x, y)});
    return curve;
}

double peak_radiance(const Framebuffer& frame) {
    double peak = 0;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) peak = std::max(peak, radiance_at(frame, x, y));
    return peak;
}

namespace {

Comparison compared(const Framebuffer& picture, const Framebuffer& reference,
                    const Settings& settings) {
    return {picture, reference, settings.transfer, settings.exposure_ev};
}

/// [pixel] the largest error of its channels in levels.
std::vector<float> level_errors(const Framebuffer& picture, const Framebuffer& reference,
                                const Settings& settings) {
    const Comparison pair = compared(picture, reference, settings);
    std::vector<float> error(picture.r.size());
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < error.size(); ++i)
            error[i] = std::max(error[i], 255 * std::abs(pair.picture().encoded[channel][i] -
                                                         pair.reference().encoded[channel][i]));
    return error;
}

}  // namespace

double level_rmse(const Framebuffer& picture, const Framebuffer& reference,
                  const Settings& settings) {
    const Comparison pair = compared(picture, reference, settings);
    double sum = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < picture.r.size(); ++i) {
            const auto e =
                double(pair.picture().encoded[channel][i] - pair.reference().encoded[channel][i]);
            sum += e * e;
        }
    return 255 * std::sqrt(sum / (3 * double(picture.r.size())));
}

double level_max(const Framebuffer& picture, const Framebuffer& reference,
                 const Settings& settings) {
    const std::vector<float> error = level_errors(picture, reference, settings);
    return double(*std::max_element(error.begin(), error.end()));
}

Image level_heat(const Framebuffer& picture, const Framebuffer& reference, const Settings& settings,
                 double top) {
    return heat_picture(level_errors(picture, reference, settings), picture.width, picture.height,
                        top);
}

}  // namespace scanshade
