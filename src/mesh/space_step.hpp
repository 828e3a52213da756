#pragma once
/// Vectors between points whose components are exact numbers or enclosures.

#include <glm/vec3.hpp>
#include <utility>

namespace durero::mesh {

/// The vector from one point to another.
template <class Number>
struct SpaceStep {
  SpaceStep(Number u, Number v, Number w) : x(std::move(u)), y(std::move(v)), z(std::move(w)) {}
  SpaceStep(const glm::dvec3& from, const glm::dvec3& to)
      : x(Number(to.x) - Number(from.x)), y(Number(to.y) - Number(from.y)), z(Number(to.z) - Number(from.z)) {}

  SpaceStep operator-() const { return {-x, -y, -z}; }
  bool has_sign() const { return sign(x) != 0 || sign(y) != 0 || sign(z) != 0; }

  Number x, y, z;
};

template <class Number>
Number dot(const SpaceStep<Number>& u, const SpaceStep<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Number>
SpaceStep<Number> cross(const SpaceStep<Number>& u, const SpaceStep<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace durero::mesh
