// (C7) at one point, light by light.
#include <fmt/format.h>

#include "report/inspection_rows.hpp"

namespace scanshade {
namespace {

InspectionSection point_section(const Inspection& inspection, const InspectedSample& s,
                                std::size_t number, const std::string& where) {
    InspectionSection section{"C7 " + where, {}};
    Rows rows(section, s.f32.lit[number], s.f64.lit[number]);
    rows.add("P", "position in the scene", [&](const auto& p) {
        std::array<double, 3> world{};
        for (int c = 0; c < 3; ++c)
            world[std::size_t(c)] = inspection.origin[c] + inspection.unit * double(p.position[c]);
        return world;
    });
    rows.add("N", "normal", [](const auto& p) { return array_of(p.normal); });
    rows.add("V", "towards the viewer", [](const auto& p) { return array_of(p.wo); });
    if (s.textured)
        rows.add_rgb("texture", "factor of k_d and k_a",
                     [](const auto& p) { return array_of(p.albedo); });
    rows.add_rgb("I_a k_a", "ambient", [](const auto& p) { return array_of(p.ambient); });
    const double(&glow)[3] = s.f64.lit[number].emission;
    if (glow[0] > 0 || glow[1] > 0 || glow[2] > 0)
        rows.add_rgb("L_e", "emission", [](const auto& p) { return array_of(p.emission); });
    return section;
}

void add_cosines(Rows<LightAtPoint<float>, LightAtPoint<double>>& rows) {
    rows.add("N·V", "", [](const auto& l) { return l.cosines.n_o; });
    rows.add("R·V", "", [](const auto& l) { return l.cosines.r_o; });
    rows.add("N·H", "", [](const auto& l) { return l.cosines.n_h; });
}

void add_bracket(const LightAtPoint<double>& light,
                 Rows<LightAtPoint<float>, LightAtPoint<double>>& rows) {
    for (std::size_t i = 0; i < light.bracket.factors.size(); ++i) {
        const auto get = [i](const auto& l) {
            const auto& term = l.bracket.factors[i];
            return array_of(term.value);
        };
        const std::string symbol(light.bracket.factors[i].symbol);
        if (light.bracket.factors[i].is_rgb)
            rows.add_rgb(symbol, "", get);
        else
            rows.add(symbol, "", [get](const auto& l) { return get(l)[0]; });
    }
    for (std::size_t i = 0; i < light.bracket.parts.size(); ++i)
        rows.add_rgb(std::string(light.bracket.parts[i].symbol), "part of the bracket",
                     [i](const auto& l) { return array_of(l.bracket.parts[i].value); });
}

InspectionSection light_section(const Inspection& inspection, const InspectedSample& s,
                                std::size_t point, std::size_t number) {
    const LightAtPoint<float>& f32 = s.f32.lit[point].lights[number];
    const LightAtPoint<double>& f64 = s.f64.lit[point].lights[number];
    const Light& light = inspection.lights[number];
    InspectionSection section{
        fmt::format("  light {}: {}", number + 1, light_kind_names()[std::size_t(light.kind)]), {}};
    Rows rows(section, f32, f64);
    rows.add("L", "towards the light", [](const auto& l) { return array_of(l.wi); });
    if (light.kind != LightKind::directional) {
        rows.add("d", "distance",
                 [&](const auto& l) { return double(l.distance) * inspection.unit; });
        rows.add("f_att", "1/(c + l d + q d²)", [](const auto& l) { return l.f_att; });
    }
    if (light.kind == LightKind::spot || light.kind == LightKind::cosine)
        rows.add("emission", "share of I that leaves this way",
                 [](const auto& l) { return l.emission; });
    rows.add("N·L", f64.cosines.n_i > 0 ? "" : "the light is behind the surface",
             [](const auto& l) { return l.cosines.n_i; });
    if (f64.cosines.n_i > 0 || f32.cosines.n_i > 0) {
        add_cosines(rows);
        add_bracket(f64, rows);
        rows.add_rgb("I", "intensity", [&](const auto&) {
            return std::array<double, 3>{light.intensity.x, light.intensity.y, light.intensity.z};
        });
    }
    rows.add_rgb("f_att I [...]", "what this light adds",
                 [](const auto& l) { return array_of(l.term); });
    return section;
}

}  // namespace

void add_lit_point(const Inspection& inspection, const InspectedSample& s, std::size_t number,
                   const std::string& where, std::vector<InspectionSection>& out) {
    out.push_back(point_section(inspection, s, number, where));
    for (std::size_t i = 0; i < s.f64.lit[number].lights.size(); ++i)
        out.push_back(light_section(inspection, s, number, i));
    InspectionSection sum{"  sum", {}};
    Rows rows(sum, s.f32.lit[number], s.f64.lit[number]);
    rows.add_rgb("I", "all of it", [](const auto& p) { return array_of(p.radiance); });
    out.push_back(std::move(sum));
}

}  // namespace scanshade
