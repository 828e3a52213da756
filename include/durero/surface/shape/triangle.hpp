#pragma once
/// The surface of a triangle: the equation of its plane, its ball and box.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// The vector from one point to another, over the numbers N.
template <class N>
Point<N> between(const glm::dvec3& from, const glm::dvec3& to) {
  return {N(to.x) - N(from.x), N(to.y) - N(from.y), N(to.z) - N(from.z)};
}

/// The volume over the triangle's edges, (w − a)·((b − a) × (c − a)) (potencia_triangulo.def.1).
template <class T>
T potencia(const scene::Triangle& triangle, const Point<T>& w) {
  using C = Constant<T>;
  const auto& [a, b, c] = triangle.vertices;
  const Point<C> p = between<C>(a, b), q = between<C>(a, c);
  const Point<T> r = from(a, w);
  return r.x * (p.y * q.z - p.z * q.y) + r.y * (p.z * q.x - p.x * q.z) + r.z * (p.x * q.y - p.y * q.x);
}

/// The box of the triangle's vertices, exactly.
inline Box box(const scene::Triangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

/// The ball about the middle of the triangle's box. Each distance errs by at most 4u of itself, where nothing overflows
/// or underflows. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Ball ball(const scene::Triangle& triangle) {
  const Box around = box(triangle);
  const glm::dvec3 middle = 0.5 * around.low + 0.5 * around.high;
  double squared = 0;
  for (const glm::dvec3& vertex : triangle.vertices) {
    const glm::dvec3 out = vertex - middle;
    squared = std::max(squared, out.x * out.x + out.y * out.y + out.z * out.z);
  }
  return {middle, std::sqrt(squared) * (1 + 0x1p-48)};
}

}  // namespace durero::surface
