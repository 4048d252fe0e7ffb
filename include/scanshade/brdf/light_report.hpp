// What the illumination of one surface point computed, term by term.
#pragma once

#include <string_view>
#include <vector>

namespace scanshade {

/// Directions at a surface point, unit length, by their cosines. Where ω_i = −ω_o there is no half
/// vector, and h counts as grazing: n_h = i_h = 0, sin2_h = 1.
template <class R>
struct Cosines {
    R n_i;  // cosθ_i = n·ω_i, > 0
    R n_o;  // cosθ_o = n·ω_o, ≥ 1e-12
    R n_h;  // cosθ_h = n·h, [0, 1]
    R r_o;  // cosθ_r = ω_r·ω_o, [0, 1]: 0 where the mirror direction points away from the viewer
    R i_h;     // ω_i·h = ω_o·h, [0, 1]
    R sin2_h;  // sin²θ_h = |n × h|², [0, 1]
    R s_io;    // sinθ_i sinθ_o cos(φ_i − φ_o) = (n × ω_i)·(n × ω_o), [−1, 1]
};

/// A quantity inside a model's equation, by the symbol that the equation has for it.
template <class T>
struct NamedTerm {
    std::string_view symbol;
    T value[3];  // a channel; a number has it in all three
    bool is_rgb;
};

/// Parts of π f_r cosθ_i, the bracket of (C7): they add up to it. Factors are what parts are made of.
template <class T>
struct BracketTerms {
    std::vector<NamedTerm<T>> factors, parts;

    void factor(std::string_view symbol, T value) {
        factors.push_back({symbol, {value, value, value}, false});
    }
    template <class Rgb>
    void factor_rgb(std::string_view symbol, const Rgb& value) {
        factors.push_back({symbol, {value.r, value.g, value.b}, true});
    }
    template <class Rgb>
    void part(std::string_view symbol, const Rgb& value) {
        parts.push_back({symbol, {value.r, value.g, value.b}, true});
    }
};

/// One light at one surface point.
template <class T>
struct LightAtPoint {
    T wi[3];     // towards the light, unit
    T distance;  // |light − P| in normalised space; directional: infinite
    T f_att;     // attenuation
    T emission;  // spot and cosine lights: what leaves in this direction, of 1
    T factor;    // f_att · emission; 0 where the light is behind the surface
    Cosines<T> cosines;
    BracketTerms<T> bracket;
    T irradiance[3];  // π I
    T f_cos[3];       // f_r cosθ_i in 1/sr; of no meaning where factor is 0
    T term[3];        // radiance that this light adds
};

/// One surface point with all of its light.
template <class T>
struct PointReport {
    T position[3];  // normalised scene space
    T normal[3];    // unit
    T wo[3];        // towards the viewer, unit
    T albedo[3];    // of a texture; 1 where there is none
    T ambient[3];   // I_a k_a
    T emission[3];
    std::vector<LightAtPoint<T>> lights;
    T radiance[3];  // the sum
};

}  // namespace scanshade
