#pragma once
/// Maps of the unit square: a pair of numbers, each anywhere in (0, 1), becomes a point or a direction with a known
/// density. Each stands here once, for lenses, lights and materials alike.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace durero::render {

/// Two unit vectors across a unit vector and each other.
std::array<glm::dvec3, 2> across(const glm::dvec3& axis);

/// A point of the unit disc, by the concentric map (Shirley and Chiu, 1997): squares become rings, and areas keep their
/// proportion. Density 1/π.
glm::dvec2 in_disc(const glm::dvec2& pair);

/// A point of the unit sphere: its height and its longitude are even (Archimedes). Density 1/4π.
glm::dvec3 on_sphere(const glm::dvec2& pair);

/// The weights of two edges of a triangle from a common corner, neither negative, that add to at most 1. Density
/// 1/area.
glm::dvec2 in_triangle(const glm::dvec2& pair);

/// A direction about a unit normal, with the density cos/π of cosine_density().
glm::dvec3 by_cosine(const glm::dvec2& pair, const glm::dvec3& normal);
/// cos/π, and 0 from a right angle on.
double cosine_density(double cosine);

/// A direction about a unit axis, with the density of lobe_density(); the axis itself where the exponent is infinite.
glm::dvec3 in_lobe(const glm::dvec2& pair, const glm::dvec3& axis, double exponent);
/// (exponent + 1)/2π·cosᵉˣᵖᵒⁿᵉⁿᵗ, and 0 from a right angle on.
double lobe_density(double cosine, double exponent);

/// A direction within a cone about a unit axis, whose half angle has that versine (1 − cos). Density 1/(2π·versine).
glm::dvec3 in_cone(const glm::dvec2& pair, const glm::dvec3& axis, double versine);

}  // namespace durero::render
