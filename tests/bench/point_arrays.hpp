// Arrays of points for packet_shading.hpp.
#pragma once

#include <array>
#include <vector>

#include "bench/packet_shading.hpp"
#include "bench/peer_scene.hpp"

namespace scanshade::bench {

/// Points with room for whole blocks of shade_points.
class PointArrays {
public:
    void resize(std::size_t count) {
        for (auto* vectors : {&position_, &normal_, &radiance_})
            for (std::vector<float>& v : *vectors)
                v.resize((count + packet_block - 1) / packet_block * packet_block);
    }
    std::size_t size() const { return position_[0].size(); }

    void set_position(std::size_t i, const Float3& position) {
        for (std::size_t c = 0; c < 3; ++c) position_[c][i] = position[c];
    }
    void set_normal(std::size_t i, const Float3& normal) {
        for (std::size_t c = 0; c < 3; ++c) normal_[c][i] = normal[c];
    }
    void set_radiance(std::size_t i, const Float3& radiance) {
        for (std::size_t c = 0; c < 3; ++c) radiance_[c][i] = radiance[c];
    }
    Float3 radiance(std::size_t i) const {
        return {radiance_[0][i], radiance_[1][i], radiance_[2][i]};
    }
    Points span(std::size_t first, std::size_t count) {
        Points points{};
        points.count = count;
        for (std::size_t c = 0; c < 3; ++c) {
            points.position[c] = position_[c].data() + first;
            points.normal[c] = normal_[c].data() + first;
            points.radiance[c] = radiance_[c].data() + first;
        }
        return points;
    }

private:
    std::array<std::vector<float>, 3> position_, normal_, radiance_;
};

}  // namespace scanshade::bench
