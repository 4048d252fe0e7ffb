// The lessons in the order in which they are taught, each in a file of its own or with its kin.
#pragma once

#include "scanshade/report/lesson.hpp"

namespace scanshade::lessons {

extern const LessonInfo shading, highlight, mach_bands, rotation, perspective;
extern const LessonInfo half_vector, exponent, energy, microfacets, rough_diffuse, fresnel;
extern const LessonInfo attenuation, lights, normals, depth, fill_rule, plan;

inline constexpr const LessonInfo* rows[] = {
    &shading,  &highlight, &mach_bands,  &rotation,      &perspective, &half_vector,
    &exponent, &energy,    &microfacets, &rough_diffuse, &fresnel,     &attenuation,
    &lights,   &normals,   &depth,       &fill_rule,     &plan,
};

}  // namespace scanshade::lessons
