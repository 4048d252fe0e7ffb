#include "report/brdf_values.hpp"

#include <cmath>

#include "brdf/cosines.hpp"
#include "scanshade/eq/directions.hpp"
#include "scanshade/eq/reflectance.hpp"

namespace scanshade {
namespace {

const Vec3<double> up = {0, 0, 1};

}  // namespace

double f_cos_at(const BrdfInfo& brdf, const MaterialParams<double>& params, const ViewedFrom& at) {
    const Vec3<double> wi = to_cartesian(Spherical<double>{at.theta_i, 0});
    const Vec3<double> wo = to_cartesian(Spherical<double>{at.theta_o, at.dphi});
    return brdf.f_cos_f64(cosines(up, wi, wo), params)[0];
}

double albedo(const BrdfInfo& brdf, const MaterialParams<double>& params, double theta_o) {
    constexpr int rings = 160, sectors = 96;
    const Vec3<double> wo = to_cartesian(Spherical<double>{theta_o, 0});
    const Vec3<double> centre = mirror_direction(wo, up), y = {0, 1, 0}, x = cross(y, centre);
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        // θ = π t⁴ has many narrow rings about the centre, for lobes of any width.
        const double t = (i + 0.5) / rings, theta = pi * t * t * t * t;
        const double dtheta = 4 * pi * t * t * t / rings, dphi = 2 * pi / sectors;
        for (int j = 0; j < sectors; ++j) {
            const double phi = (j + 0.5) * dphi;
            const Vec3<double> wi = centre * std::cos(theta) +
                                    (x * std::cos(phi) + y * std::sin(phi)) * std::sin(theta);
            if (wi.z > 0)
                sum += albedo_term(brdf.f_cos_f64(cosines(up, wi, wo), params)[0],
                                   solid_angle_of_angles(theta, dtheta, dphi));
        }
    }
    return sum;
}

}  // namespace scanshade
