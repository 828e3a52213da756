#pragma once
/// Vectors of exact numbers.

#include <glm/vec3.hpp>

#include "support/exact_ratio.hpp"

namespace durero::test {

struct Exact_Vector {
  Dyadic x, y, z;

  Exact_Vector(Dyadic a, Dyadic b, Dyadic c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  explicit Exact_Vector(const glm::dvec3& a) : x(a.x), y(a.y), z(a.z) {}
  friend Exact_Vector operator-(const Exact_Vector& a, const Exact_Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Exact_Vector operator+(const Exact_Vector& a, const Exact_Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Exact_Vector operator*(const Dyadic& a, const Exact_Vector& b) { return {a * b.x, a * b.y, a * b.z}; }
};
inline Dyadic dot(const Exact_Vector& a, const Exact_Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Dyadic length(const Exact_Vector& a) { return root(dot(a, a)); }
inline Exact_Vector cross(const Exact_Vector& a, const Exact_Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace durero::test
