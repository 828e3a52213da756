#pragma once
/// Points of the integer lattice on circles and spheres around 0: a shape with such numbers has exact coincidences.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "durero/conform/random.hpp"

namespace durero::conform {

// Radii with many integer points: products of primes 4k + 1 for the circle, odd numbers for the sphere.
inline constexpr std::array circle_radii{5, 25, 65, 85, 130};
inline constexpr std::array sphere_radii{9, 15, 27, 35, 45, 63};

/// A lattice point at the distance `radius` from 0, for a radius of circle_radii; the scaled point for 2^j times such a
/// radius. For any other radius the point is (radius, 0).
glm::dvec2 on_circle(Random& random, double radius);
/// A point at the distance `radius` from 0 in space, by sphere_radii; otherwise as on_circle.
glm::dvec3 on_sphere(Random& random, double radius);

}  // namespace durero::conform
