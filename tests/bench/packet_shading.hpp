// Light on many points at once, for the ray tracer: plain loops that a compiler makes vectors of.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bench/peer_light.hpp"

namespace scanshade::bench {

struct PacketLighting {
    const PeerLight* lights;
    std::size_t light_count;
    float eye[3], base[3];
    bool blinn;
};

/// Arrays of `count` values, padded to a multiple of `packet_block`.
struct Points {
    std::size_t count;
    const float* position[3];
    const float* normal[3];  // any length but 0
    float* radiance[3];
};
inline constexpr std::size_t packet_block = 16;

/// (C7). On the best instruction set of this machine.
void shade_points(const Points& points, const PacketLighting& lighting);

/// To RGBA bytes, linear, rounded to nearest.
void encode_points(const Points& points, std::uint32_t* rgba);

}  // namespace scanshade::bench
