#pragma once
/// Points of the integer lattice on circles and spheres around 0: where a shape's numbers are such, its coincidences
/// are exact.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "durero/conform/random.hpp"

namespace durero::conform {

// Radii with many integer points: products of primes 4k + 1 for the circle, odd numbers for the sphere.
inline constexpr std::array circle_radii{5, 25, 65, 85, 130};
inline constexpr std::array sphere_radii{9, 15, 27, 35, 45, 63};

/// A point of the lattice at the distance `radius` from 0, one of circle_radii; times 2^j for radius·2^j. For any other
/// radius, (radius, 0).
glm::dvec2 on_circle(Random& random, double radius);
/// The same on a sphere, with sphere_radii.
glm::dvec3 on_sphere(Random& random, double radius);

}  // namespace durero::conform
