// How far a picture's geometry is from the reference.
#pragma once

#include "scanshade/report/picture_stability.hpp"

namespace scanshade {

GeometryResult measure_geometry(const ReportInput& input);

}  // namespace scanshade
