"""The numbering of the formula sheet: every equation that Scanshade knows of, by chapter.

A row is (number, name, note). The note says where the usual printed form is wrong ("Corrected: ")
or right on paper and unsafe in floating point ("Care: "), and what is done instead.
"""

CHAPTERS = {
    "A": "Directions and radiometry",
    "B": "Reflection",
    "C": "Shading",
    "D": "Ray casting",
    "E": "Probability and Monte Carlo",
    "F": "Light transport",
    "G": "Radiosity",
}

# Chapters or equations that must have a function and a test. Extend it with the work.
FINISHED = ([f"A{i}" for i in range(1, 16)]
            + [f"B{i}" for i in range(1, 21) if i not in (17, 18)]
            + ["B17a", "B17b", "B17c", "B17d", "B18a", "B18b"]
            + [f"C{i}" for i in range(1, 8)] + ["D1", "D2", "D3"])

EQUATIONS = [
    ("A1", "unit direction", ""),
    ("A2", "spherical direction", ""),
    ("A3", "Cartesian to spherical",
     "Corrected: the quadrant of φ needs atan2, wrapped to [0, 2π). Care: arccos z loses half of "
     "the digits near the poles; θ is taken by atan2 as well."),
    ("A4", "spherical to Cartesian", ""),
    ("A5", "solid angle of a small area", ""),
    ("A6", "solid angle of a patch of angles", ""),
    ("A7", "flux", ""),
    ("A8", "irradiance and radiosity", ""),
    ("A9", "intensity", ""),
    ("A10", "radiance", ""),
    ("A11", "irradiance from radiance", ""),
    ("A12", "intensity from radiance", ""),
    ("A13", "flux from radiance", ""),
    ("A14", "cosine light", "Care: zero behind the light."),
    ("A15", "spot light", "Care: τ is the half angle of the cone."),
    ("B1", "definition of the BRDF", ""),
    ("B2", "isotropic BRDF", ""),
    ("B3", "reflection equation", ""),
    ("B4", "energy conservation", ""),
    ("B5", "albedo", ""),
    ("B6", "Lambert reflection", ""),
    ("B7", "mirror direction", ""),
    ("B8", "ideal mirror",
     "Corrected: the delta function is of ω_i and the mirror direction of ω_o."),
    ("B9", "refracted direction",
     "Corrected: as printed it does not fulfil Snell's law for ω_i on the side of n. Care: "
     "1 − cos² cancels, and the root is of a negative number in total internal reflection."),
    ("B10", "critical angle and BTDF of an ideal refractor",
     "Corrected: the delta function is of ω_i and the refracted direction of ω_o. Care: there is "
     "a critical angle only towards the thinner medium."),
    ("B11", "Fresnel reflectance of dielectrics", "Care: 1 in total internal reflection."),
    ("B12", "Phong reflection", ""),
    ("B13", "Phong reflection as a BRDF",
     "Care: unbounded where θ_i is grazing, so f_r cosθ_i (B12) is what is computed. Its k_d is in "
     "1/sr, while that of C7 is an albedo, larger by π."),
    ("B14", "modified Phong reflection", ""),
    ("B15", "half vector", "Care: opposite directions have none."),
    ("B16", "Torrance–Sparrow reflection",
     "Corrected: F is of the angle between ω_i and the half vector; with θ_i of the normal the "
     "model is not reciprocal. Care: 0/0 at grazing angles."),
    ("B17a", "facet distribution: Gaussian",
     "Corrected: the printed form is not normalised; its integral is 0.03 at m = 0.1 and 1.7 at "
     "m = 1."),
    ("B17b", "facet distribution: Blinn", "Care: the exponent 2/m² − 2 overflows as m → 0."),
    ("B17c", "facet distribution: Beckmann", "Care: 0/0 where the half vector is grazing."),
    ("B17d", "facet distribution: GGX", "Care: the denominator cancels as m → 0."),
    ("B18a", "shadowing: V-cavity", "Care: cosines are clamped."),
    ("B18b", "shadowing: Smith", "Care: cosines are clamped."),
    ("B19", "Schlick's Fresnel reflectance", ""),
    ("B20", "Oren–Nayar reflection",
     "Corrected: the cosine is of the difference of azimuths, not of polar angles. Care: no "
     "azimuth at θ = 0; tan β is unbounded where both angles are grazing."),
    ("C1", "vertex normal",
     "Care: opposite normals cancel; a degenerate face has none."),
    ("C2", "Gouraud shading of a quadrilateral",
     "Care: the corners are A (0,0), B (1,0), C (0,1), D (1,1), which is not the cyclic order of "
     "files."),
    ("C3", "Gouraud shading along a scanline", "Care: horizontal edges and empty spans divide by 0."),
    ("C4", "Phong interpolation on a quadrilateral",
     "Care: the interpolated normal is normalised, and may be of zero length."),
    ("C5", "Phong interpolation along a scanline", "Care: as C3 and C4."),
    ("C6", "colour as three channels", ""),
    ("C7", "local illumination",
     "Care: negative cosines count as 0, and nothing is reflected where N·L ≤ 0. Corrected: the "
     "form with the half vector is printed as an approximation with the same exponent; near the "
     "highlight it needs four times the exponent to be one."),
    ("D1", "segment and plane", ""),
    ("D2", "parallelogram and triangle",
     "Care: solve the two best conditioned of the three coordinate equations."),
    ("D3", "ray and sphere",
     "Corrected: t is in units of the direction's length, which must be 1. Care: R² − D² cancels "
     "for far and for huge spheres."),
    ("D4", "whether a bounding volume pays", ""),
    ("D5", "coherence of rays between two spheres",
     "Corrected: the ratio under the root is squared."),
    ("E1", "density and distribution function", ""),
    ("E2", "expectation", ""),
    ("E3", "variance", "Care: E[X²] − E[X]² cancels."),
    ("E4", "variance of a sum", "Care: only of independent variables."),
    ("E5", "expectation of a function", ""),
    ("E6", "Monte Carlo estimator", ""),
    ("E7", "primary estimator", ""),
    ("E8", "the mean of estimators is unbiased", ""),
    ("E9", "variance of the mean", ""),
    ("E10", "bias and consistency", ""),
    ("E11", "irradiance by hemisphere samples", "Corrected: the sum runs over the samples."),
    ("E12", "irradiance and reflected radiance by area samples",
     "Corrected: the integral runs over the emitter."),
    ("E13", "sampling by inversion", ""),
    ("E14", "cosine sampling", ""),
    ("E15", "power-cosine sampling",
     "Corrected: z = r₂^(1/(n+1)), without a further root. Care: 1 − r₂^(2/(n+1)) cancels for "
     "large n."),
    ("E16", "control variate", ""),
    ("E17", "stratified sampling", "Care: for strata of equal measure, scaled by the domain's."),
    ("E18", "multiple importance sampling", "Corrected: each integral runs over the whole domain."),
    ("E19", "balance heuristic", ""),
    ("F1", "rendering equation over directions", ""),
    ("F2", "rendering equation over surfaces", ""),
    ("F3", "radiosity equation", ""),
    ("F4", "constant elements and form factors", "Corrected: the radiosity in the sum is B_k."),
    ("F5", "Neumann series", ""),
    ("F6", "Russian roulette", ""),
    ("F7", "sampling in proportion to f_r cosθ", ""),
    ("F8", "direct light by BRDF and by area samples",
     "Corrected: the area estimator is divided by its density once, and runs over the emitter."),
    ("F9", "direct light by both, balance heuristic",
     "Corrected: with N samples of each technique the factor is 1/N, and the density of directions "
     "carries cosθ_x."),
    ("F10", "importance", ""),
    ("F11", "path integral and measurement", "Care: this G includes visibility, that of F3 does not."),
    ("F12", "bidirectional estimator", "Corrected: the weights sum to 1 only with the last term."),
    ("G1", "radiosity of elements", ""),
    ("G2", "form factor", ""),
    ("G3", "radiosity as a linear system", "Care: stiff as ρ → 1."),
    ("G4", "form factors by a hemicube", "Care: sums to 1 only as its resolution grows."),
]
