// Every function of eq/: EQUATION(name, inputs, outputs, error in u, scale, the call, ranges of the
// inputs). Included where EQUATION is defined, more than once; calls are in equation_calls.hpp's
// terms. |error| ≤ error · u · (|result| + scale).
// clang-format off
#define COMPONENTS {-1, 1}, {-1, 1}, {-1, 1}
#define POSITIVE {0.1, 10}
#define COSINE {0, 1}

EQUATION(unit_direction, 3, 3, 5, 0, put(unit_direction(vec3_at(x)), y), {COMPONENTS})
EQUATION(to_spherical, 3, 2, 14, 6.3,
         const Spherical<R> s = to_spherical(vec3_at(x)); y[0] = s.theta; y[1] = s.phi, {COMPONENTS})
EQUATION(to_cartesian, 2, 3, 8, 1, put(to_cartesian(spherical_at(x)), y), {{0, 3}, {0, 6}})
EQUATION(solid_angle_of_area, 3, 1, 4, 0, y[0] = solid_angle_of_area(x[0], x[1], x[2]), {POSITIVE, COSINE, POSITIVE})
EQUATION(solid_angle_of_angles, 3, 1, 9, 0, y[0] = solid_angle_of_angles(x[0], x[1], x[2]), {{0, 3}, COSINE, COSINE})
EQUATION(flux, 2, 1, 1, 0, y[0] = flux(x[0], x[1]), {POSITIVE, POSITIVE})
EQUATION(flux_density, 2, 1, 1, 0, y[0] = flux_density(x[0], x[1]), {POSITIVE, POSITIVE})
EQUATION(intensity, 2, 1, 1, 0, y[0] = intensity(x[0], x[1]), {POSITIVE, POSITIVE})
EQUATION(radiance, 4, 1, 3, 0, y[0] = radiance(x[0], x[1], x[2], x[3]), {POSITIVE, POSITIVE, POSITIVE, {0.01, 1}})
EQUATION(irradiance_term, 3, 1, 2, 0, y[0] = irradiance_term(x[0], x[1], x[2]), {POSITIVE, COSINE, COSINE})
EQUATION(intensity_term, 3, 1, 2, 0, y[0] = intensity_term(x[0], x[1], x[2]), {POSITIVE, COSINE, COSINE})
EQUATION(flux_term, 4, 1, 3, 0, y[0] = flux_term(x[0], x[1], x[2], x[3]), {POSITIVE, COSINE, COSINE, COSINE})
EQUATION(cosine_light, 6, 1, 3, 3, y[0] = cosine_light(vec3_at(x), vec3_at(x + 3)), {COMPONENTS, COMPONENTS})
EQUATION(spot_light, 6, 1, 60, 1,
         y[0] = spot_light(vec3_at(x), vec3_at(x + 3), Scalar<R>(0.25), Scalar<R>(2)), {COMPONENTS, COMPONENTS})
EQUATION(brdf_by_definition, 4, 1, 3, 0, y[0] = brdf_by_definition(x[0], x[1], x[2], x[3]), {POSITIVE, POSITIVE, {0.01, 1}, POSITIVE})
EQUATION(isotropic_angles, 4, 3, 2, 6.3,
         const IsotropicAngles<R> a = isotropic_angles(spherical_at(x), spherical_at(x + 2));
         y[0] = a.theta_i; y[1] = a.theta_o; y[2] = a.dphi, {{0, 1.5}, {0, 6}, {0, 1.5}, {0, 6}})
EQUATION(reflected_term, 3, 1, 2, 0, y[0] = reflected_term(x[0], x[1], x[2]), {POSITIVE, POSITIVE, COSINE})
EQUATION(energy_ratio, 2, 1, 1, 0, y[0] = energy_ratio(x[0], x[1]), {POSITIVE, POSITIVE})
EQUATION(albedo_term, 2, 1, 1, 0, y[0] = albedo_term(x[0], x[1]), {POSITIVE, COSINE})
EQUATION(lambert_brdf, 1, 3, 2, 0, put(lambert_brdf(rgb_of(x[0])), y), {COSINE})
EQUATION(mirror_direction, 6, 3, 9, 3, put(mirror_direction(vec3_at(x), vec3_at(x + 3)), y), {COMPONENTS, COMPONENTS})
EQUATION(pow_whole, 1, 1, 36, 0, y[0] = pow_shininess(x[0], make_exponent(37)), {{0.2, 1}})
EQUATION(pow_fraction, 1, 1, 60, 0, y[0] = pow_shininess(x[0], make_exponent(12.5)), {{0.05, 1}})
EQUATION(phong_reflection, 4, 3, 20, 0,
         put(phong_reflection(rgb_of(x[0]), rgb_of(x[1]), make_exponent(10), x[2], x[3]), y), {COSINE, COSINE, COSINE, {0.1, 1}})
EQUATION(phong_f_cos, 4, 3, 22, 0,
         put(phong_f_cos(rgb_of(x[0]), rgb_of(x[1]), make_exponent(10), x[2], x[3]), y), {COSINE, COSINE, COSINE, {0.1, 1}})
EQUATION(modified_phong_brdf, 3, 3, 16, 0,
         put(modified_phong_brdf(rgb_of(x[0]), rgb_of(x[1]), make_exponent(10), R(12), x[2]), y), {COSINE, COSINE, {0.1, 1}})
EQUATION(half_vector, 6, 3, 5, 30, put(half_vector(vec3_at(x), vec3_at(x + 3)), y), {COMPONENTS, {-1, 1}, {-1, 1}, {1.1, 2}})
EQUATION(cos_half, 8, 1, 12, 1, y[0] = cos_half(x[6], x[7], vec3_at(x), vec3_at(x + 3)), {COMPONENTS, {-1, 1}, {-1, 1}, {1.1, 2}, {-1, 1}, {-1, 1}})
EQUATION(oren_nayar_coefficients, 1, 2, 6, 0,
         const OrenNayarCoefficients<R> k = oren_nayar_coefficients(x[0]); y[0] = k.A; y[1] = k.B, {{0, 1.57}})
EQUATION(oren_nayar_f_cos, 4, 3, 9, 0,
         put(oren_nayar_f_cos(rgb_of(x[0]), some_roughness<R>(), x[1], x[2], x[3]), y),
         {COSINE, {1e-6, 1}, {1e-6, 1}, {-1, 1}})
EQUATION(snell_cos2, 2, 1, 4, 3, y[0] = snell_cos2(x[0], x[1]), {COSINE, {0.5, 2}})
EQUATION(refracted_direction, 7, 3, 40, 2, put(refracted_direction(vec3_at(x), vec3_at(x + 3), x[6]), y),
         {COSINE, COSINE, COSINE, COSINE, COSINE, COSINE, {0.3, 0.99}})
EQUATION(critical_angle, 1, 1, 5, 0, y[0] = critical_angle(x[0]), {{0.1, 0.99}})
EQUATION(refracted_radiance, 2, 1, 2, 0, y[0] = refracted_radiance(x[0], x[1]), {POSITIVE, {0.3, 3}})
EQUATION(ideal_mirror, 7, 4, 9, 3,
         const DeltaLobe<R> l = ideal_mirror(vec3_at(x), vec3_at(x + 3), x[6]); put(l.wi, y); y[3] = l.weight, {COMPONENTS, COMPONENTS, COSINE})
EQUATION(fresnel_s, 2, 1, 24, 0, y[0] = fresnel_s(x[0], x[1]), {COSINE, {0.2, 1}})
EQUATION(fresnel_p, 2, 1, 40, 0.02, y[0] = fresnel_p(x[0], x[1]), {COSINE, {0.5, 1}})
EQUATION(fresnel_dielectric, 2, 1, 40, 0, y[0] = fresnel_dielectric(x[0], x[1]), {COSINE, {0.2, 1}})
EQUATION(ideal_refractor, 4, 4, 45, 2,
         const DeltaLobe<R> l = ideal_refractor(vec3_at(x), constant<R>(0, 0, 1), x[3]); put(l.wi, y); y[3] = l.weight,
         {COSINE, COSINE, {0.1, 1}, {0.3, 0.99}})
EQUATION(normal_reflectance, 1, 1, 7, 0, y[0] = normal_reflectance(x[0]), {{0.2, 4}})
EQUATION(fresnel_schlick, 2, 3, 10, 0, put(fresnel_schlick(rgb_of(x[0]), x[1]), y), {COSINE, COSINE})
EQUATION(gaussian_norm, 1, 1, 100, 0, y[0] = gaussian_norm(x[0]), {{0.001, 1}})
EQUATION(D_gaussian, 2, 1, 270, 0, y[0] = D_gaussian(sqrt(R(1) - x[0]), x[0], x[1], R(1)), {{0, 0.5}, {0.25, 1}})
EQUATION(D_blinn, 2, 1, 240, 0, y[0] = D_blinn(sqrt(R(1) - x[0]), x[0], x[1]), {{0, 0.8}, {0.3, 1}})
EQUATION(D_beckmann, 2, 1, 120, 0, y[0] = D_beckmann(sqrt(R(1) - x[0]), x[0], x[1]), {{0, 0.5}, {0.25, 1}})
EQUATION(D_ggx, 3, 1, 13, 0, y[0] = D_ggx(x[0], x[1], x[2]), {COSINE, {1e-8, 1}, {1e-4, 1}})
EQUATION(G_v_cavity, 4, 1, 3, 0, y[0] = G_v_cavity(x[0], x[1], x[2], x[3]), {{-0.1, 1}, {-0.1, 1}, COSINE, {0.01, 1}})
EQUATION(v_cavity_over_4_cos_o, 4, 1, 4, 0, y[0] = v_cavity_over_4_cos_o(x[0], x[1], x[2], x[3]), {COSINE, {0.001, 1}, COSINE, {0.01, 1}})
EQUATION(G1_smith_over_cos, 2, 1, 6, 0, y[0] = G1_smith_over_cos(x[0], x[1]), {{-0.1, 1}, {1e-4, 1}})
EQUATION(smith_over_4_cos_o, 3, 1, 15, 0, y[0] = smith_over_4_cos_o(x[0], x[1], x[2]), {{-0.1, 1}, {-0.1, 1}, {1e-4, 1}})
EQUATION(torrance_sparrow_f_cos, 3, 3, 2, 0, put(torrance_sparrow_f_cos(rgb_of(x[0]), x[1], x[2]), y), {COSINE, POSITIVE, POSITIVE})
EQUATION(vertex_normal, 3, 3, 5, 0, put(vertex_normal(vec3_at(x), R(3), R(1e-6)), y), {COMPONENTS})
EQUATION(bilinear, 6, 1, 5, 1, y[0] = bilinear(x[0], x[1], x[2], x[3], x[4], x[5]), {COSINE, COSINE, COSINE, COSINE, COSINE, COSINE})
EQUATION(along_edge, 5, 1, 6, 100, y[0] = along_edge(x[0], x[1], x[2], x[3], x[4]), {COSINE, COSINE, {0, 1}, {2, 3}, {1, 2}})
EQUATION(along_span, 5, 1, 6, 100, y[0] = along_span(x[0], x[1], x[2], x[3], x[4]), {COSINE, COSINE, {0, 1}, {2, 3}, {1, 2}})
EQUATION(bilinear_normal, 8, 3, 9, 10,
         put(bilinear_normal(vec3_at(x), vec3_at(x + 3), vec3_at(x), vec3_at(x + 3), x[6], x[7]), y), {COSINE, COSINE, {1, 2}, COSINE, COSINE, {1, 2}, COSINE, COSINE})
EQUATION(span_normal, 8, 3, 14, 10,
         put(span_normal(vec3_at(x), vec3_at(x + 3), x[6], R(2), x[7]), y), {COSINE, COSINE, {1, 2}, COSINE, COSINE, {1, 2}, COSINE, {1, 2}})
EQUATION(attenuation, 1, 1, 5, 0, y[0] = attenuation(x[0], Scalar<R>(1), Scalar<R>(0.5), Scalar<R>(0.25)), {{0, 100}})
EQUATION(ambient_term, 2, 3, 1, 0, put(ambient_term(rgb_of(x[0]), rgb_of(x[1])), y), {POSITIVE, COSINE})
EQUATION(light_term, 3, 3, 2, 0, put(light_term(x[0], rgb_of(x[1]), rgb_of(x[2])), y), {POSITIVE, POSITIVE, COSINE})
EQUATION(within, 1, 1, 0, 0, y[0] = within(x[0], R(0), R(1)), {{-1, 2}})
EQUATION(segment_plane, 9, 2, 30, 10,
         const PlaneHit<R> h = segment_plane(vec3_at(x), vec3_at(x + 3), vec3_at(x + 6), R(-0.5)); y[0] = h.hit; y[1] = h.t,
         {COMPONENTS, {0.1, 1}, {0.1, 1}, {0.1, 1}, {0.1, 1}, {0.1, 1}, {0.1, 1}})
EQUATION(plane_coordinates, 9, 2, 40, 10,
         const PlaneCoordinates<R> c = plane_coordinates(vec3_at(x), constant<R>(0.1, 0.2, 0.3), vec3_at(x + 3), vec3_at(x + 6));
         y[0] = c.u; y[1] = c.v, {COMPONENTS, {0.5, 1}, {0, 0.25}, {0, 0.25}, {0, 0.25}, {0.5, 1}, {0, 0.25}})
EQUATION(in_parallelogram, 2, 1, 0, 0, y[0] = in_parallelogram(plane_at(x)), {{-1, 2}, {-1, 2}})
EQUATION(in_triangle, 2, 1, 0, 0, y[0] = in_triangle(plane_at(x)), {{-1, 2}, {-1, 2}})
EQUATION(ray_sphere, 9, 3, 400, 10,
         const SphereHits<R> h = ray_sphere(vec3_at(x), vec3_at(x + 3), vec3_at(x + 6), R(3)); y[0] = h.hit; y[1] = h.t_near; y[2] = h.t_far,
         {COMPONENTS, {-1, 1}, {-1, 1}, {0.5, 1}, COMPONENTS})

#undef COSINE
#undef POSITIVE
#undef COMPONENTS
#undef EQUATION
// clang-format on
