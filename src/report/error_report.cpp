#include "scanshade/report/error_report.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "report/error_parts.hpp"
#include "scanshade/base/parallel.hpp"
#include "scanshade/kernels/isa.hpp"
#include "scanshade/scene/clusters.hpp"

namespace scanshade {
namespace {

constexpr int most_at_once = 8;  // comparisons: each takes as much memory as thirty pictures

constexpr std::string_view region_names[] = {"all", "covered", "interior", "silhouette"};

/// A method made ready: its kernels are those of its own instruction set whenever it draws.
class Subject {
public:
    Subject(const ReportInput& input, const MakeDrawing& make) : isa_(input.settings.isa) {
        const std::uint64_t before = held_bytes();
        use_instruction_set(isa_);
        drawing_ = make(input.scene, input.settings);
        drawing_.pixels(pixels_);
        const std::uint64_t picture = pixels_.rgba().size() * sizeof(std::uint32_t);
        const std::uint64_t after = held_bytes();
        memory = after > before + picture ? after - before - picture : 0;
    }

    FrameStats draw() {
        use_instruction_set(isa_);
        return drawing_.pixels(pixels_);
    }
    Framebuffer planes() const {
        use_instruction_set(isa_);
        Framebuffer picture;
        drawing_.planes(picture);
        return picture;
    }
    Image image() const { return to_image(pixels_); }

    std::uint64_t memory;

private:
    std::string isa_;
    Drawing drawing_;
    PixelBuffer pixels_;
};

RegionErrors errors_in(const Comparison& pair, const Mask* mask, std::size_t pixels) {
    RegionErrors errors{pixels, {}, {}};
    for (const Metric& metric : all_metrics())
        errors.values.push_back(measure(metric, pair, {}, mask));
    return errors;
}

void add_channels(const Comparison& pair, RegionErrors& errors) {
    for (const Metric& metric : all_metrics()) {
        errors.channels.emplace_back();
        for (std::size_t c = 0; metric.per_channel && c < 3; ++c)
            errors.channels.back()[c] = measure(metric, pair, {c, c + 1});
    }
}

std::array<RegionErrors, error_region_count> errors_of(const Framebuffer& picture,
                                                       const Framebuffer& reference,
                                                       const Settings& s) {
    const Comparison pair(picture, reference, s.transfer, s.exposure_ev);
    const Regions regions = regions_of(picture, reference);
    const auto within = [&](const Mask& mask) { return errors_in(pair, &mask, mask.count()); };
    std::array<RegionErrors, error_region_count> errors{
        errors_in(pair, nullptr, picture.r.size()), within(regions.covered),
        within(regions.interior), within(regions.silhouette)};
    add_channels(pair, errors[std::size_t(ErrorRegion::all)]);
    return errors;
}

/// A name for files: lower case, digits and dashes.
std::string file_name(std::string_view name) {
    std::string file;
    for (const char c : name) {
        const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (kept || (c >= 'A' && c <= 'Z'))
            file += kept ? c : char(c - 'A' + 'a');
        else if (c == '.')
            file += '_';
        else if (!file.empty() && file.back() != '-')
            file += '-';
    }
    return file + ".png";
}

/// What is made when it is first needed must not be counted as a method's own.
void prepare(const Scene& scene) {
    for (const Object& object : scene.objects) clusters_of(*object.mesh);
}

/// One axis of one scene on its way through the measurement.
class AxisMeasurement {
public:
    AxisMeasurement(const ErrorAxis& axis, const ReportInput& input, const std::string& name,
                    Steps& steps, const KeepPicture& keep, const MakeDrawing& make)
        : axis_(axis), input_(input), name_(name), steps_(steps), keep_(keep), make_(make) {}

    ErrorAxisResult run(const Rounds& rounds) {
        ErrorAxisResult result{&axis_, {}, {}, 0, {}, {}, {}};
        tell("the reference");
        ErrorReference reference = axis_.reference(input_, make_);
        result.reference = std::move(reference.what);
        result.own_from = std::move(reference.own_from);
        result.own_rmse = reference.own_rmse;
        const Settings& s = input_.settings;
        result.reference_picture = file_name(name_ + " " + std::string(axis_.name) + " reference");
        keep_(result.reference_picture, encode(reference.picture, s.transfer, s.exposure_ev));
        ++steps_.done;
        std::vector<ErrorMethod> methods = axis_.methods(input_);
        const std::size_t at_once = std::size_t(std::min(available_threads(), most_at_once));
        for (std::size_t i = 0; i < methods.size() && !steps_.watch.stopped(); i += at_once)
            add_rows(std::span(methods).subspan(i, std::min(at_once, methods.size() - i)),
                     reference.picture, result.rows);
        time_rows(rounds, result.rows);
        mark_front(result.rows);
        finish_orders(result);
        use_instruction_set(s.isa);
        return result;
    }

private:
    void tell(const std::string& what) const {
        steps_.tell(fmt::format("{}: {}: {}", input_.scene.name, axis_.name, what));
    }

    /// Draws them one by one, and compares all of them at once: that takes one thread each.
    void add_rows(std::span<ErrorMethod> methods, const Framebuffer& reference,
                  std::vector<ErrorRow>& rows) {
        const std::size_t before = rows.size();
        std::vector<Framebuffer> pictures;
        for (ErrorMethod& method : methods) {
            tell(method.name);
            pictures.push_back(add_row(std::move(method), rows));
        }
        parallel_for(methods.size(), 1, 0, [&](std::size_t begin, std::size_t end, int) {
            for (std::size_t i = begin; i < end; ++i)
                rows[before + i].regions = errors_of(pictures[i], reference, input_.settings);
        });
        steps_.done += methods.size();
    }

    Framebuffer add_row(ErrorMethod method, std::vector<ErrorRow>& rows) {
        prepare(method.input.scene);
        subjects_.push_back(std::make_unique<Subject>(method.input, make_));
        Subject& subject = *subjects_.back();
        ErrorRow row{std::move(method), {}, subject.memory, 0, {}, {}, {}, false};
        row.triangles = row.method.input.scene.triangle_count();
        row.picture = file_name(fmt::format("{} {} {}", name_, axis_.name, row.method.name));
        keep_(row.picture, subject.image());
        row.method.input.scene = {};  // the drawing has what it needs
        rows.push_back(std::move(row));
        return subject.planes();
    }

    /// Every round is a step.
    void time_rows(const Rounds& rounds, std::vector<ErrorRow>& rows) {
        const std::size_t all = rounds.warm_ups + rounds.runs;
        std::size_t round = 0;
        const auto stopped = [&] {
            tell(fmt::format("times, round {} of {}", std::min(round + 1, all), all));
            if (round++ > 0) ++steps_.done;
            return steps_.watch.stopped();
        };
        std::vector<std::function<FrameStats()>> draws;
        for (const auto& subject : subjects_) draws.emplace_back([&] { return subject->draw(); });
        const FrameTable frames = time_interleaved(draws, rounds, stopped);
        if (!steps_.watch.stopped()) ++steps_.done;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (!frames[i].empty()) {
                rows[i].run_ms = frame_ms(frames[i]);
                rows[i].time = times_of(rows[i].run_ms);
            }
    }

    const ErrorAxis& axis_;
    const ReportInput& input_;
    const std::string& name_;
    Steps& steps_;
    const KeepPicture& keep_;
    const MakeDrawing& make_;
    std::vector<std::unique_ptr<Subject>> subjects_;
};

std::size_t steps_of(const ErrorAxis& axis, const ReportInput& input, const Rounds& rounds) {
    return 1 + axis.methods(input).size() + rounds.warm_ups + rounds.runs;
}

void measure_scene(const ReportInput& input, std::span<const ErrorAxis* const> axes,
                   std::size_t number, const Rounds& rounds, Steps& steps, const KeepPicture& keep,
                   const MakeDrawing& make, ErrorReport& report) {
    const Settings& s = input.settings;
    report.scenes.push_back({input.scene.name, s.width, s.height, {}, {}});
    ErrorSceneResult& scene = report.scenes.back();
    constexpr std::size_t longest = 40;  // of what a scene adds to the names of files
    const std::string name = fmt::format("{} {}", number, input.scene.name.substr(0, longest));
    for (const ErrorAxis* axis : axes)
        if (!steps.watch.stopped())
            scene.axes.push_back(measure_error_axis(*axis, input, name, rounds, steps, keep, make));
    scene.verdict = verdict_of(scene);
}

}  // namespace

std::span<const std::string_view> error_region_names() { return region_names; }

std::uint64_t held_bytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 held = ::mallinfo2();
    return held.uordblks + held.hblkhd;
#else
    return 0;
#endif
}

double ErrorRow::error(std::string_view metric, ErrorRegion region) const {
    const std::size_t index = std::size_t(&find_metric(metric) - all_metrics().data());
    return regions[std::size_t(region)].values[index];
}

double ErrorRow::efficiency() const {
    const double rmse = error("rmse");
    if (!time) return std::numeric_limits<double>::quiet_NaN();
    return 1 / (rmse * rmse * time->median / 1000);
}

void mark_front(std::vector<ErrorRow>& rows) {
    for (ErrorRow& row : rows)
        row.on_front =
            row.time && std::none_of(rows.begin(), rows.end(), [&](const ErrorRow& o) {
                return o.time && o.time->median <= row.time->median &&
                       o.error("rmse") <= row.error("rmse") &&
                       (o.time->median < row.time->median || o.error("rmse") < row.error("rmse"));
            });
}

ErrorAxisResult measure_error_axis(const ErrorAxis& axis, const ReportInput& input,
                                   const std::string& name, const Rounds& rounds, Steps& steps,
                                   const KeepPicture& keep, const MakeDrawing& make) {
    return AxisMeasurement(axis, input, name, steps, keep, make).run(rounds);
}

ErrorReport measure_error(const std::vector<ReportInput>& inputs, const Settings& settings,
                          const Rounds& rounds, const Watch& watch, const KeepPicture& keep,
                          const MakeDrawing& make) {
    std::vector<const ErrorAxis*> axes;
    for (const ErrorAxis& axis : error_axes()) axes.push_back(&axis);
    const std::vector<ErrorStudy> studies = convergence_studies(settings);
    ErrorReport report{provenance(settings, rounds.seed), false, {}};
    Steps steps{watch};
    for (const ReportInput& input : inputs)
        for (const ErrorAxis* axis : axes) steps.all += steps_of(*axis, input, rounds);
    for (const ErrorStudy& study : studies) steps.all += steps_of(*study.axis, study.input, rounds);
    std::size_t number = 0;
    for (const ReportInput& input : inputs)
        if (!watch.stopped())
            measure_scene(input, axes, ++number, rounds, steps, keep, make, report);
    for (const ErrorStudy& study : studies)
        if (!watch.stopped())
            measure_scene(study.input, std::span(&study.axis, 1), ++number, rounds, steps, keep,
                          make, report);
    report.partial = watch.stopped();
    return report;
}

}  // namespace scanshade
