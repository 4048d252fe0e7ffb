#include "scanshade/report/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/inspection_rows.hpp"

namespace scanshade {
namespace {

/// Normals (Phong shading) or light (Gouraud).
bool carries_normals(const InspectedSample& s) { return s.shading == Shading::phong; }

/// The other end of an edge.
std::uint32_t other(std::uint32_t p, std::uint32_t q, std::uint32_t end) {
    return p == end ? q : p;
}

/// The two edges that the row crosses, with the corner that both have first.
struct Edges {
    std::uint32_t left[2], right[2];
    bool share_corner;
};
Edges edges_of(const Scanline<double>& s) {
    for (const std::uint32_t corner : {s.a, s.b})
        if (corner == s.c || corner == s.d)
            return {{corner, other(s.a, s.b, corner)}, {corner, other(s.c, s.d, corner)}, true};
    return {{s.a, s.b}, {s.c, s.d}, false};
}

/// Corners from A on.
std::vector<std::size_t> corner_order(const InspectedSample& sample) {
    std::vector<std::size_t> order;
    if (sample.f64.scanline) {
        const Edges edges = edges_of(*sample.f64.scanline);
        order = {edges.left[0], edges.left[1]};
        if (!edges.share_corner) order.push_back(edges.right[0]);
        order.push_back(edges.right[1]);
    }
    for (std::size_t i = 0; i < sample.corners.size(); ++i)
        if (std::find(order.begin(), order.end(), i) == order.end()) order.push_back(i);
    return order;
}

void add_scanline(const InspectedSample& s, InspectionSection& section) {
    Rows rows(section, s.f32, s.f64);
    const std::vector<std::string> name = corner_names(s);
    const Edges edges = edges_of(*s.f64.scanline);
    const std::string left = name[edges.left[0]] + name[edges.left[1]];
    const std::string right = name[edges.right[0]] + name[edges.right[1]];
    const std::string value = carries_normals(s) ? "N" : "I";
    const bool rgb = !carries_normals(s);
    rows.add(fmt::format("({})_x", left), "where the row crosses this edge, in pixels",
             [](const auto& n) { return n.scanline->ab_x; });
    rows.add(fmt::format("{}_{}", value, left), "there",
             [](const auto& n) { return n.scanline->ab; });
    section.rows.back().is_rgb = rgb;
    rows.add(fmt::format("({})_x", right), "where it crosses this one",
             [](const auto& n) { return n.scanline->cd_x; });
    rows.add(fmt::format("{}_{}", value, right), "there",
             [](const auto& n) { return n.scanline->cd; });
    section.rows.back().is_rgb = rgb;
}

void add_travel(const InspectedSample& s, InspectionSection& section) {
    Rows rows(section, s.f32, s.f64);
    const std::vector<std::string> name = corner_names(s);
    if (s.f64.travel == Travel::patch) {
        rows.add("u", "position in the patch, (C2)", [](const auto& n) { return n.u; });
        rows.add("v", "", [](const auto& n) { return n.v; });
        return;
    }
    if (s.f64.travel == Travel::weights)
        for (const std::size_t i : corner_order(s))
            rows.add("weight of " + name[i], "", [i](const auto& n) { return n.weight[i]; });
    if (s.f64.scanline) add_scanline(s, section);
}

std::string_view method(const Inspection& inspection, const InspectedSample& s) {
    if (s.f64.travel == Travel::patch) return carries_normals(s) ? "C4, C2" : "C2";
    if (inspection.interpolation == Interpolation::edges) return carries_normals(s) ? "C5" : "C3";
    return carries_normals(s) ? "C5 in perspective" : "C3 in perspective";
}

InspectionSection interpolation_section(const Inspection& inspection, const InspectedSample& s) {
    InspectionSection section{
        fmt::format("{} across the polygon ({})", carries_normals(s) ? "normal" : "light",
                    method(inspection, s)),
        {}};
    Rows rows(section, s.f32, s.f64);
    const std::string value = carries_normals(s) ? "N" : "I";
    const std::vector<std::string> name = corner_names(s);
    for (const std::size_t i : corner_order(s)) {
        rows.add(fmt::format("{}_{}", value, name[i]),
                 fmt::format("corner {}, vertex {}", name[i], s.corners[i].vertex),
                 [i](const auto& n) { return n.corner[i]; });
        section.rows.back().is_rgb = !carries_normals(s);
    }
    add_travel(s, section);
    if (!carries_normals(s)) {
        rows.add_rgb("I_X", "at the sample", [](const auto& n) { return n.carried; });
        return section;
    }
    rows.add("N_X", "at the sample, as interpolated", [](const auto& n) { return n.carried; });
    rows.add("‖N_X‖", "", [](const auto& n) {
        return std::sqrt(n.carried[0] * n.carried[0] + n.carried[1] * n.carried[1] +
                         n.carried[2] * n.carried[2]);
    });
    rows.add("N", "made unit", [](const auto& n) { return array_of(n.lit[0].normal); });
    return section;
}

InspectionSection polygon_section(const InspectedSample& s) {
    InspectionSection section{"polygon on the picture, in pixels", {}};
    const std::vector<std::string> name = corner_names(s);
    for (const std::size_t i : corner_order(s)) {
        const InspectedCorner& corner = s.corners[i];
        if (!corner.on_picture) continue;
        const std::vector<double> at{corner.x, corner.y};
        section.rows.push_back({name[i], fmt::format("vertex {}", corner.vertex), at, at, false});
    }
    const std::vector<double> at{s.x, s.y};
    section.rows.push_back({"X", "the sample", at, at, false});
    return section;
}

std::string sample_title(const Inspection& inspection, const InspectedSample& s) {
    const std::string at = inspection.samples.size() == 1
                               ? std::string("sample")
                               : fmt::format("sample at {}, {}", s.x, s.y);
    if (!s.covered) return at + ": nothing is there but the background";
    return fmt::format(
        "{}: triangle {}, face {} of object {} ({}), seen from {}; material {}, brdf {}, {} "
        "shading, "
        "interpolation {}",
        at, s.triangle, s.face, s.object + 1, s.object_name, s.back ? "behind" : "the front",
        s.material_name, s.brdf, shading_names()[std::size_t(s.shading)],
        interpolation_names()[std::size_t(inspection.interpolation)]);
}

void add_radiance(const InspectedSample& s, InspectionSection& section) {
    Rows rows(section, s.f32, s.f64);
    rows.add_rgb("L", s.textured && s.shading != Shading::phong ? "with the texture" : "",
                 [](const auto& n) { return n.radiance; });
}

void add_sample(const Inspection& inspection, const InspectedSample& s,
                std::vector<InspectionSection>& out) {
    InspectionSection head{sample_title(inspection, s), {}};
    if (!s.covered) {
        out.push_back(std::move(head));
        return;
    }
    const std::vector<double> depth{double(s.depth)};
    head.rows.push_back({"z", "depth, near/w: 1 is near", depth, depth, false});
    out.push_back(std::move(head));
    out.push_back(polygon_section(s));
    const bool gouraud = s.shading == Shading::gouraud;
    if (s.shading == Shading::phong) out.push_back(interpolation_section(inspection, s));
    const std::vector<std::string> name = corner_names(s);
    if (s.shading == Shading::flat)
        add_lit_point(inspection, s, 0, "in the middle of the face", out);
    if (s.shading == Shading::phong) add_lit_point(inspection, s, 0, "at the sample", out);
    if (gouraud)
        for (const std::size_t i : corner_order(s))
            add_lit_point(inspection, s, i, "at corner " + name[i], out);
    if (gouraud) out.push_back(interpolation_section(inspection, s));
    InspectionSection light{"radiance of the sample", {}};
    add_radiance(s, light);
    out.push_back(std::move(light));
}

}  // namespace

std::vector<std::string> corner_names(const InspectedSample& sample) {
    std::vector<std::string> names(sample.corners.size());
    const std::vector<std::size_t> order = corner_order(sample);
    for (std::size_t i = 0; i < order.size(); ++i)
        names[order[i]] = i < 26 ? std::string(1, char('A' + i)) : fmt::format("V{}", i);
    return names;
}

std::vector<InspectionSection> inspection_sections(const Inspection& inspection,
                                                   bool every_sample) {
    std::vector<InspectionSection> out;
    bool whole = true;
    for (const InspectedSample& sample : inspection.samples) {
        if (whole || !sample.covered) {
            add_sample(inspection, sample, out);
        } else {
            InspectionSection& head = out.emplace_back();
            head.title = sample_title(inspection, sample);
            add_radiance(sample, head);
        }
        whole = whole && (every_sample || !sample.covered);
    }
    InspectionSection pixel{"pixel", {}};
    pixel.rows.push_back({"L",
                          inspection.samples.size() > 1 ? "mean of its samples" : "linear radiance",
                          numbers(inspection.radiance32), numbers(inspection.radiance64), true});
    pixel.rows.push_back({"byte", "exposed, clamped, encoded, rounded", numbers(inspection.byte32),
                          numbers(inspection.byte64), true});
    out.push_back(std::move(pixel));
    return out;
}

namespace {

std::string text(const std::vector<double>& values, bool is_rgb, int digits) {
    const bool grey = is_rgb && values[0] == values[1] && values[1] == values[2];
    std::string out;
    // Adding 0 makes 0 of −0.
    for (std::size_t i = 0; i < (grey ? 1 : values.size()); ++i)
        out += fmt::format("{}{:.{}g}", i > 0 ? " " : "", values[i] + 0.0, digits);
    return out;
}

}  // namespace

std::string f32_text(const InspectionRow& row) { return text(row.f32, row.is_rgb, 9); }
std::string f64_text(const InspectionRow& row) { return text(row.f64, row.is_rgb, 12); }

}  // namespace scanshade
