// How far a picture is from its reference: every measure of error that programs and reports know,
// as rows of one table.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "scanshade/image/framebuffer.hpp"
#include "scanshade/image/image.hpp"
#include "scanshade/image/mask.hpp"

namespace scanshade {

/// Where two pictures of one view show surfaces.
struct Regions {
    Mask covered;     // in both
    Mask interior;    // covered in both, and no edge of either at it or at a pixel around it
    Mask silhouette;  // the rest of what is covered in either, or has such an edge
};

/// By ids and depth; they are those of a pixel's first sample. An *edge* runs between two
/// neighbours, beside or above each other, where one is covered and the other not, or where depth
/// jumps: where neither side's depth, continued linearly by a pixel, comes within 1 % of the other's.
/// So the border between two triangles or a crease is none, and an object in front of another has
/// one. Pixels of neither interior nor silhouette show the background in both. Throws Error(format)
/// where the sizes differ.
Regions regions_of(const Framebuffer& a, const Framebuffer& b);

/// A picture and its reference, in linear light and as they are shown. Linear values are as they
/// come, before exposure and however large; encoded ones are exposed, clamped to [0, 1] and sent
/// through the transfer curve, but not rounded to bytes. NaN stays NaN in both.
/// Used by one thread at a time: maps are made when they are first asked for.
class Comparison {
public:
    /// Throw Error(format) where the sizes differ. Nothing of the arguments is kept.
    Comparison(const Framebuffer& picture, const Framebuffer& reference, Transfer transfer,
               double exposure_ev);
    /// sRGB bytes; linear values are the decoded ones.
    Comparison(const Image& picture, const Image& reference);
    ~Comparison();
    Comparison(Comparison&&) noexcept;
    Comparison& operator=(Comparison&&) noexcept;

    using Plane = std::vector<float>;     // [y·width + x]
    using Planes = std::array<Plane, 3>;  // r, g, b
    struct Side {
        Planes linear, encoded;
    };

    int width() const;
    int height() const;
    const Side& picture() const;
    const Side& reference() const;
    const Plane& ssim_map(std::size_t channel) const;  // the index of the window around each pixel
    const Plane& flip_map() const;                     // FLIP of each pixel, 0 to 1

    /// Pixels with a value that is NaN or infinite in either picture.
    std::size_t not_finite(const Mask* mask = nullptr) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Channels first to last − 1 of r, g, b, measured together.
struct Channels {
    std::size_t first = 0, last = 3;
};

enum class Better { lower, higher };
enum class Pool { mean, max };

/// One measure: an error of each pixel, pooled over pixels, and put into its unit.
struct Metric {
    std::string_view name;     // "rmse": options, JSON and CSV
    std::string_view title;    // "root mean square error"
    std::string_view symbol;   // "RMSE": axes and headings
    std::string_view unit;     // "1", "dB", "%"
    std::string_view picture;  // what it looks at: "linear" or "encoded"
    Better better;             // which way a good picture lies
    bool per_channel;          // it also has a value for each channel alone
    std::string_view source;

    double (*pixel)(const Comparison& pair, Channels channels, std::size_t index);
    Pool pool;
    double (*finish)(double pooled);
    double (*shown)(double pixel);  // what a heat map shows: 0 where there is no error
};

/// mae, rmse, psnr, max, over1, relmse, ssim, flip.
std::span<const Metric> all_metrics();

/// Throws Error(usage) that names the nearest one.
const Metric& find_metric(std::string_view name);

/// Over the pixels of `mask`, or over all. NaN where there are none, or where one of them (or, for
/// SSIM and FLIP, one near enough to count) is not finite: nothing is averaged away. PSNR of equal
/// pictures is infinite. Of `channels`, FLIP takes all or none.
double measure(const Metric& metric, const Comparison& pair, Channels channels = {},
               const Mask* mask = nullptr);

/// The error of each pixel as a heat map shows it, all channels together.
Comparison::Plane error_map(const Metric& metric, const Comparison& pair);

/// a is nearer to the reference than b; never where one of them is NaN.
bool is_better(const Metric& metric, double a, double b);

}  // namespace scanshade
