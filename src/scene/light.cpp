// Lights as `--light` spells them.
#include "scanshade/scene/light.hpp"

#include <fmt/format.h>

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "scanshade/base/error.hpp"
#include "scanshade/base/text.hpp"
#include "scanshade/scene/settings.hpp"
#include "scene/limits.hpp"

namespace scanshade {
namespace {

constexpr std::string_view names[] = {"point", "directional", "spot", "cosine"};

constexpr std::string_view forms[] = {
    "point:x,y,z[:r,g,b[:c,l,q]]",
    "directional:dx,dy,dz[:r,g,b]",
    "spot:x,y,z:dx,dy,dz:degrees[:r,g,b[:c,l,q]]",
    "cosine:x,y,z:dx,dy,dz[:r,g,b[:c,l,q]]",
};

/// Takes the parts of one `--light` apart, from the left.
class LightParser {
public:
    LightParser(std::string_view text, std::string_view form)
        : text_(text), form_(form), parts_(split(text, ':')) {}

    bool more() const { return next_ < parts_.size(); }

    glm::dvec3 vector(std::string_view what) {
        const auto numbers = split(part(what), ',');
        glm::dvec3 v(0);
        if (numbers.size() != 3) fail(what);
        for (int i = 0; i < 3; ++i) v[i] = number(numbers[static_cast<std::size_t>(i)], what);
        return v;
    }
    double real(std::string_view what) { return number(part(what), what); }

    [[noreturn]] void fail(std::string_view what) const {
        throw Error(Errc::usage, fmt::format("--light '{}' has no proper {}; write it as {}", text_,
                                             what, form_));
    }

private:
    std::string_view part(std::string_view what) {
        if (!more()) fail(what);
        return parts_[next_++];
    }
    double number(std::string_view word, std::string_view what) const {
        const auto value = parse_real(word);
        if (!value) fail(what);
        return *value;
    }

    std::string_view text_, form_;
    std::vector<std::string_view> parts_;
    std::size_t next_ = 1;
};

bool is_radiance(const glm::dvec3& v) {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && max_abs(v) <= max_radiance;
}

}  // namespace

std::span<const std::string_view> light_kind_names() { return names; }

Light parse_light(std::string_view text) {
    const std::string_view name = text.substr(0, text.find(':'));
    std::size_t kind = 0;
    while (kind < std::size(names) && names[kind] != name) ++kind;
    if (kind == std::size(names))
        throw Error(Errc::usage,
                    fmt::format("--light knows no type '{}'{}", name, suggestion(name, names)));
    Light light;
    light.kind = static_cast<LightKind>(kind);
    LightParser parser(text, forms[kind]);
    if (light.kind != LightKind::directional) light.position = parser.vector("position");
    if (light.kind != LightKind::point) light.direction = parser.vector("direction");
    if (light.kind == LightKind::spot) light.cutoff_deg = parser.real("angle");
    if (parser.more()) light.intensity = parser.vector("colour");
    if (parser.more() && light.kind != LightKind::directional)
        light.attenuation = parser.vector("attenuation");
    if (parser.more()) parser.fail("end");

    if (max_abs(light.position) > max_coordinate) parser.fail("position (-1e100 to 1e100)");
    if (light.direction == glm::dvec3(0)) parser.fail("direction (not 0,0,0)");
    if (!is_radiance(light.intensity)) parser.fail("colour (0 to 1e30)");
    if (!is_radiance(light.attenuation) || light.attenuation == glm::dvec3(0))
        parser.fail("attenuation (0 to 1e30, not all 0)");
    if (!(light.cutoff_deg > 0 && light.cutoff_deg <= 180))
        parser.fail("angle (half the cone, above 0 and up to 180)");
    return light;
}

}  // namespace scanshade
