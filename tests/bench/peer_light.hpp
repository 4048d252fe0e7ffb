// What peers know of a light. No standard header: packet_shading.cpp says why.
#pragma once

namespace scanshade::bench {

/// A point light: f_att = 1/(c + q d²); the factors of cosθ_i and of the power, f_r's 1/π and the
/// irradiance's π cancelled: I k_d and I k_s.
struct PeerLight {
    float position[3], diffuse[3], specular[3];
    float c, q;
};

/// The exponent of highlights is 2 to this, so that peers can raise by squaring.
inline constexpr int specular_squarings = 6;

}  // namespace scanshade::bench
