#include "scanshade/render/debug_view.hpp"

#include <algorithm>
#include <cmath>

#include "render/debug_pass.hpp"
#include "scanshade/render/renderer.hpp"

namespace scanshade {
namespace {

constexpr DebugViewInfo views[] = {
    {"picture", "what is drawn"},
    {"depth", "distance from the eye along the view direction"},
    {"normals", "normals as they are interpolated, (x, y, z) as red, green, blue"},
    {"barycentrics", "weights of the corners; on polygons and patches the place inside"},
    {"triangles", "each triangle in a colour of its own"},
    {"overdraw", "how many faces cover a pixel"},
    {"plan", "which work each pixel took"},
    {"error to double", "difference from scalar-f64"},
    {"error to phong", "difference from phong shading"},
};

Rgb8 mix(const Rgb8& a, const Rgb8& b, double t) {
    Rgb8 out{};
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = static_cast<std::uint8_t>(std::lround(a[c] + t * (double(b[c]) - double(a[c]))));
    return out;
}

}  // namespace

std::span<const DebugViewInfo> all_debug_views() { return views; }

Rgb8 false_colour(double t) {
    constexpr Rgb8 ramp[] = {
        {12, 14, 46}, {38, 76, 190}, {36, 170, 140}, {236, 206, 66}, {250, 60, 44}};
    constexpr int last = 4;
    const double at = (t > 0 ? std::min(t, 1.0) : 0) * last;  // NaN is not > 0
    const int i = std::min(static_cast<int>(at), last - 1);
    return mix(ramp[i], ramp[i + 1], at - i);
}

namespace {

/// Values as false colours; what is negative stays black.
DebugPicture in_false_colours(const std::vector<double>& values, const DebugScale& scale, int width,
                              int height) {
    DebugPicture out{PixelBuffer(width, height), scale, {}};
    const auto place = [&](double v) {
        if (!scale.logarithmic) return (v - scale.low) / (scale.high - scale.low);
        return std::log(v / scale.low) / std::log(scale.high / scale.low);
    };
    LargeVector<std::uint32_t>& rgba = out.pixels.edit();
    for (std::size_t i = 0; i < values.size(); ++i)
        rgba[i] = opaque(values[i] < 0 ? Rgb8{0, 0, 0} : false_colour(place(values[i])));
    return out;
}

/// Of values that are there; the two are never the same.
DebugScale scale_of(const std::vector<double>& values, double at_least, std::string unit) {
    double low = double(INFINITY), high = -low;
    for (const double v : values)
        if (v >= 0) low = std::min(low, v), high = std::max(high, v);
    if (!(high >= low)) low = 0, high = at_least;
    return {low, std::max(high, low + at_least), false, std::move(unit)};
}

DebugPicture depth_view(const Scene& scene, const Settings& settings) {
    Framebuffer frame;
    Renderer renderer(scene, settings);
    renderer.draw(frame);
    const auto [near, far] = renderer.plan().depth;
    const bool orthographic = renderer.plan().camera.projection == Projection::orthographic;
    const double unit = normalisation(scene).unit;
    std::vector<double> distance(frame.depth.size(), -1.0);
    for (std::size_t i = 0; i < distance.size(); ++i) {
        const double z = double(frame.depth[i]);
        if (frame.id[i] == Framebuffer::no_triangle) continue;
        distance[i] = unit * (orthographic ? near + 2 * (1 - z) * (far - near) : near / z);
    }
    DebugScale scale = scale_of(distance, 1e-6 * unit, "units of the scene");
    scale.logarithmic = scale.low > 0;
    return in_false_colours(distance, scale, frame.width, frame.height);
}

/// In levels of 255 as they are shown, but not rounded to whole ones.
std::vector<double> level_errors(const Framebuffer& a, const Framebuffer& b,
                                 const Settings& settings) {
    const double scale = std::exp2(settings.exposure_ev);
    const auto level = [&](float radiance) {
        const double shown = std::clamp(double(radiance) * scale, 0.0, 1.0);
        return 255 * (settings.transfer == Transfer::srgb ? srgb_encode(shown) : shown);
    };
    std::vector<double> error(a.r.size(), -1.0);
    for (std::size_t i = 0; i < error.size(); ++i) {
        if (a.id[i] == Framebuffer::no_triangle) continue;
        error[i] = std::max({std::abs(level(a.r[i]) - level(b.r[i])),
                             std::abs(level(a.g[i]) - level(b.g[i])),
                             std::abs(level(a.b[i]) - level(b.b[i]))});
    }
    return error;
}

DebugPicture error_view(const Scene& scene, const Settings& settings, DebugView view) {
    Settings reference = settings;
    const bool against_double = view == DebugView::error_f64;
    if (against_double) {
        reference.renderer = RendererKind::scalar_f64;
    } else {
        reference.shading = Shading::phong;
        reference.given.insert("shading");
    }
    Framebuffer drawn, wanted;
    Renderer(scene, settings).draw(drawn);
    Renderer(scene, reference).draw(wanted);
    const std::vector<double> error = level_errors(drawn, wanted, settings);
    const std::string unit = "levels of 255";
    return in_false_colours(error,
                            against_double
                                ? DebugScale{1e-6, 1, true, unit}
                                : DebugScale{0, scale_of(error, 1, unit).high, false, unit},
                            drawn.width, drawn.height);
}

DebugPicture overdraw_view(const Scene& scene, const Settings& settings) {
    DebugPass pass(scene, settings, false);
    const std::vector<double> count = pass.coverage();
    DebugScale scale = scale_of(count, 1, "faces");
    scale.low = 0;
    return in_false_colours(count, scale, pass.width(), pass.height());
}

DebugPicture picture(const Scene& scene, const Settings& settings) {
    DebugPicture out;
    Renderer(scene, settings).draw(out.pixels);
    return out;
}

}  // namespace

DebugPicture draw_debug_view(const Scene& scene, const Settings& given, DebugView view) {
    Settings settings = given;
    if (view != DebugView::none) settings.samples = 1;
    switch (view) {
        case DebugView::none:
            return picture(scene, settings);
        case DebugView::depth:
            return depth_view(scene, settings);
        case DebugView::overdraw:
            return overdraw_view(scene, settings);
        case DebugView::error_f64:
        case DebugView::error_phong:
            return error_view(scene, settings, view);
        default:
            return DebugPass(scene, settings, view == DebugView::normals).draw(view);
    }
}

void draw_wireframe(const Scene& scene, const Framebuffer& frame, PixelBuffer& pixels) {
    // Number of each triangle's face, in the whole scene; the last is of what is no triangle.
    std::vector<std::uint32_t> face;
    std::uint32_t first = 0;
    for (const Object& object : scene.objects) {
        for (const std::uint32_t f : object.mesh->triangle_face) face.push_back(first + f);
        first += static_cast<std::uint32_t>(object.mesh->face_count());
    }
    const auto face_at = [&](std::size_t at) {
        const std::uint32_t id = frame.id[at];
        return id < face.size() ? face[id] : Framebuffer::no_triangle;
    };
    LargeVector<std::uint32_t>& rgba = pixels.edit();
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t at = frame.index(x, y);
            const bool edge =
                (x + 1 < frame.width && face_at(at + 1) != face_at(at)) ||
                (y + 1 < frame.height && face_at(at + std::size_t(frame.width)) != face_at(at));
            // A quarter of each channel.
            if (edge) rgba[at] = ((rgba[at] >> 2) & 0x3f3f3fu) | 0xff000000u;
        }
}

}  // namespace scanshade
