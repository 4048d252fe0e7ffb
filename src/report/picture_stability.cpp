#include "scanshade/report/picture_stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "report/picture_cases.hpp"
#include "report/picture_geometry.hpp"
#include "scanshade/kernels/isa.hpp"

namespace scanshade {
namespace {

/// Of a highlight: more, and one rounding of a float cosine shows.
constexpr double largest_sure_exponent = 2e4;

/// The planes and the bytes of one picture.
struct DrawnPicture {
    Framebuffer planes;
    PixelBuffer bytes;
    FrameStats stats;
};

struct RendererChoice {
    std::string name, isa;
    RendererKind kind;
};

/// What the others are compared with comes first.
std::vector<RendererChoice> renderers() {
    std::vector<RendererChoice> choices{{"scalar-f64", "", RendererKind::scalar_f64},
                                        {"scalar-f32", "", RendererKind::scalar_f32}};
    for (const std::string& isa : instruction_sets())
        choices.push_back({"simd " + isa, isa, RendererKind::simd});
    return choices;
}

DrawnPicture draw(const ReportInput& input, const RendererChoice& renderer,
                  const MakeDrawing& make) {
    Settings settings = input.settings;
    settings.renderer = renderer.kind;
    settings.isa = renderer.isa;
    settings.tolerance = 0;  // a difference that was asked for
    const Drawing drawing = make(input.scene, settings);
    DrawnPicture picture;
    picture.stats = drawing.planes(picture.planes);
    drawing.pixels(picture.bytes);
    return picture;
}

std::uint64_t count_not_finite(const DrawnPicture& picture) {
    const Framebuffer& f = picture.planes;
    std::uint64_t count = picture.stats.events[Event::not_finite];
    for (std::size_t i = 0; i < f.id.size(); ++i)
        count += !std::isfinite(f.r[i]) || !std::isfinite(f.g[i]) || !std::isfinite(f.b[i]) ||
                 !std::isfinite(f.depth[i]);
    return count;
}

/// Largest difference of the bytes of a pixel.
int byte_difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8)
        most = std::max(most, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return most;
}

RendererResult compare(const std::string& renderer, const DrawnPicture& drawn,
                       const DrawnPicture& reference) {
    RendererResult result;
    result.renderer = renderer;
    result.events = drawn.stats.events;
    result.not_finite = count_not_finite(drawn);
    const Framebuffer &a = drawn.planes, &b = reference.planes;
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        result.other_id += a.id[i] != b.id[i] || std::bit_cast<std::uint32_t>(a.depth[i]) !=
                                                     std::bit_cast<std::uint32_t>(b.depth[i]);
        const int levels = byte_difference(drawn.bytes.rgba()[i], reference.bytes.rgba()[i]);
        result.levels = std::max(result.levels, levels);
        result.differing += levels > 0;
        result.beyond += levels > 1;
    }
    return result;
}

PictureCaseResult measure_case(const ReportInput& input, const MakeDrawing& make) {
    PictureCaseResult result;
    result.name = input.scene.name;
    result.width = input.settings.width;
    result.height = input.settings.height;
    result.triangles = input.scene.triangle_count();
    result.loading = input.scene.events;
    const std::vector<RendererChoice> choices = renderers();
    const DrawnPicture reference = draw(input, choices.front(), make);
    result.renderers.push_back(compare(choices.front().name, reference, reference));
    for (std::size_t i = 1; i < choices.size(); ++i) {
        const DrawnPicture drawn = draw(input, choices[i], make);
        result.renderers.push_back(compare(choices[i].name, drawn, reference));
        if (i + 1 == choices.size()) result.picture = to_image(drawn.bytes);
    }
    result.geometry = measure_geometry(input);
    return result;
}

double largest_exponent(const ReportInput& input) {
    double most = 0;
    for (const ResolvedMaterial& m : make_plan(normalised(input.scene), input.settings).materials)
        for (std::size_t i = 0; i < m.brdf->params.size(); ++i)
            if (m.brdf->params[i].kind == ParamKind::exponent)
                most = std::max(most, double(m.params.exponent[i].whole));
    return most;
}

/// Of a scene that nobody made to be hard: one pixel in 2000 may lie where light branches on a
/// quantity that is within its error of the threshold. Its geometry is held to what rounding can
/// come to, and to no number.
PictureBounds bounds_of_scene(const ReportInput& input) {
    const auto pixels = std::uint64_t(input.settings.width) * std::uint64_t(input.settings.height);
    PictureBounds bounds;
    bounds.levels = 255;
    bounds.beyond = pixels / 2000;
    bounds.displacement = std::numeric_limits<double>::infinity();
    bounds.mistaken = pixels;
    bounds.reason =
        "0.05 % of the pixels may lie where light branches on a quantity that is within its error "
        "of the threshold";
    if (largest_exponent(input) <= largest_sure_exponent) return bounds;
    bounds.beyond = pixels;
    bounds.reason = "an exponent above 2e4 magnifies one rounding of the cosine beyond a level";
    return bounds;
}

/// Kernels use the best instruction set afterwards, whatever happens.
struct BestIsaAfterwards {
    ~BestIsaAfterwards() { use_instruction_set(""); }
};

}  // namespace

PictureStability measure_picture_stability(const std::vector<ReportInput>& scenes,
                                           const Watch& watch, const MakeDrawing& make) {
    const BestIsaAfterwards best;
    PictureStability report;
    Steps steps{watch};
    steps.all = hard_cases().size() + scenes.size();
    const auto measure = [&](const ReportInput& input) {
        steps.tell(input.scene.name);
        report.cases.push_back(measure_case(input, make));
        ++steps.done;
    };
    for (const HardCase& hard : hard_cases()) {
        if (watch.stopped()) break;
        measure(hard.input());
        report.cases.back().difficulty = hard.difficulty;
        report.cases.back().bounds = hard.bounds;
    }
    for (const ReportInput& input : scenes) {
        if (watch.stopped()) break;
        measure(input);
        report.cases.back().generated = false;
        report.cases.back().bounds = bounds_of_scene(input);
    }
    report.partial = watch.stopped();
    return report;
}

}  // namespace scanshade
