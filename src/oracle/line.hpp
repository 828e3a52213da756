#pragma once
/// A ray as the sampled oracle sees it: a place and a direction of length 1.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "durero/model/tipos.hpp"

namespace durero::oracle::sampled {

class ScaledRay {
 public:
  explicit ScaledRay(const model::Rayo& ray) : p(ray.p().xyz()) {
    // The greatest coordinate becomes one of [1/2, 1), so no square overflows, and none that counts underflows.
    const glm::dvec3& v = ray.v().xyz();
    std::frexp(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), &exponent_);
    const glm::dvec3 scaled(std::ldexp(v.x, -exponent_), std::ldexp(v.y, -exponent_), std::ldexp(v.z, -exponent_));
    length_ = glm::length(scaled);
    direction = scaled / length_;
  }

  glm::dvec3 p, direction;

  /// The t of the point at a distance from p; ∞ where it is beyond binary64.
  double parameter(double distance) const { return std::ldexp(distance / length_, -exponent_); }
  /// The distance from p to the point of the ray that is nearest to x.
  double foot(const glm::dvec3& x) const { return std::max(0.0, glm::dot(x - p, direction)); }
  glm::dvec3 at(double distance) const { return p + direction * distance; }

 private:
  int exponent_ = 0;
  double length_;
};

}  // namespace durero::oracle::sampled
