// Where pictures break their bounds.
#include <fmt/format.h>

#include "scanshade/report/picture_stability.hpp"

namespace scanshade {
namespace {

class Faults {
public:
    explicit Faults(const PictureCaseResult& result) : case_(result) {}

    std::vector<std::string> all() {
        for (const RendererResult& r : case_.renderers) add_renderer(r);
        add_geometry(case_.geometry);
        return std::move(sentences_);
    }

private:
    template <class Value, class Bound>
    void hold(const std::string& where, std::string_view what, Value value, Bound most) {
        if (!(value <= most))
            sentences_.push_back(
                fmt::format("picture '{}', {}: {} is {}, and at most {} is allowed", case_.name,
                            where, what, value, most));
    }

    void add_renderer(const RendererResult& r) {
        hold(r.renderer, "the number of samples that are NaN or Inf", r.not_finite, 0u);
        hold(r.renderer, "the number of samples with another triangle or depth than scalar-f64",
             r.other_id, 0u);
        hold(r.renderer, "the largest difference in levels from scalar-f64", r.levels,
             case_.bounds.levels);
        hold(r.renderer, "the number of pixels that differ by more than a level", r.beyond,
             case_.bounds.beyond);
    }

    void add_geometry(const GeometryResult& g) {
        const PictureBounds& b = case_.bounds;
        hold("geometry", "the largest displacement of a vertex in 1/256 pixel", g.displacement,
             b.displacement);
        hold("geometry", "the distance of a moved sample from its edge in 1/256 pixel",
             g.edge_distance, b.displacement);
        hold("geometry", "the share of a displacement in what rounding can come to", g.bound_share,
             1.0);
        hold("geometry", "the number of samples at which depth chooses another triangle",
             g.mistaken, b.mistaken);
    }

    const PictureCaseResult& case_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> PictureStability::faults() const {
    std::vector<std::string> sentences;
    for (const PictureCaseResult& result : cases)
        for (std::string& sentence : Faults(result).all()) sentences.push_back(std::move(sentence));
    return sentences;
}

}  // namespace scanshade
