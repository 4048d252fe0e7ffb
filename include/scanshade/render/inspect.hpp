// The equation at one pixel with its numbers: what the scalar renderers compute on their way to it,
// in float and in double.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanshade/brdf/light_report.hpp"
#include "scanshade/scene/scene.hpp"

namespace scanshade {

/// How a value travels from the corners of a polygon to a sample.
enum class Travel : std::uint8_t { weights, scanline, patch };

/// The row of a sample in its polygon. Numbers of corners: the row crosses the edges a–b and c–d,
/// at x = ab_x and cd_x on the picture. Where the polygon is a triangle, one corner is in both.
template <class T>
struct Scanline {
    std::uint32_t a, b, c, d;
    T ab_x, cd_x;             // pixels
    std::array<T, 3> ab, cd;  // I_AB and I_AC (C3), or N_AB and N_AC (C5)
};

/// One sample's shading in one number type.
template <class T>
struct SampleNumbers {
    Travel travel;
    std::vector<T> weight;                 // of the corners, where travel is by weights
    T u, v;                                // of a patch
    std::optional<Scanline<T>> scanline;   // flat shading and clipped triangles have none
    std::vector<std::array<T, 3>> corner;  // [corner] N (phong) or I (gouraud)
    std::array<T, 3> carried;              // N_X before it is made unit, or I_X
    std::vector<PointReport<T>> lit;  // the sample (phong), its face (flat), each corner (gouraud)
    std::array<T, 3> radiance;        // L of this sample
};

struct InspectedCorner {
    std::uint32_t vertex;  // in its mesh
    double x, y;           // pixels
    bool on_picture;       // else behind the eye or beyond far
};

/// One sample of the pixel.
struct InspectedSample {
    double x, y;  // pixels
    bool covered;
    // Where something is seen:
    std::uint32_t triangle;  // in the whole scene
    std::size_t object, face;
    std::string object_name, material_name;
    std::string brdf;  // or "unlit"
    Shading shading;
    bool back;  // seen from behind
    bool textured;
    bool clipped;  // reaches beyond the near plane or the guard band
    float depth;
    std::vector<InspectedCorner> corners;
    SampleNumbers<float> f32;
    SampleNumbers<double> f64;
};

struct Inspection {
    int x, y, width, height;
    Interpolation interpolation;
    std::vector<Light> lights;  // of the scene, in the order of the reports
    // A point p of normalised space stands at origin + unit · p.
    glm::dvec3 origin;
    double unit;
    std::vector<InspectedSample> samples;         // in the order in which they are drawn
    std::array<float, 3> radiance32, radiance64;  // of the pixel, as the framebuffer keeps it
    std::array<std::uint8_t, 3> byte32, byte64;   // encoded as the settings say
};

/// Runs the stages of both scalar renderers for that pixel alone, with the settings' choices but
/// their renderer. Throws Error(usage) for a pixel outside the picture, and what Renderer throws.
Inspection inspect_pixel(const Scene& scene, const Settings& settings, int x, int y);

}  // namespace scanshade
