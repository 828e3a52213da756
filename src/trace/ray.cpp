#include "durero/trace/ray.hpp"

#include <cmath>

#include "durero/scene/attributes.hpp"

namespace durero::trace {
namespace {

/// 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰; without branches, as it is asked for every ray.
inline bool in_range(double x) {
  const double size = std::abs(x);
  const bool above = size >= 0x1p-100, below = size <= 0x1p100, zero = size == 0;
  return (above & below) | zero;
}
inline bool in_range(const glm::dvec3& a) {
  const bool x = in_range(a.x), y = in_range(a.y), z = in_range(a.z);
  return x & y & z;
}
inline bool in_range(const scene::Corners& v) { return in_range(v[0]) && in_range(v[1]) && in_range(v[2]); }

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

}  // namespace

Ray::Ray(const model::Rayo& rayo)
    : p(rayo.p().xyz()), v(rayo.v().xyz()), speed(extent(v)), ordinary(in_range(p) && in_range(v)) {}

bool ordinary(scene::ShapeView element) {
  return element.visit([]<class Shape>(const Shape& shape) {
    bool all = true;
    scene::for_each_attribute<Shape>([&](const auto& attribute) { all = all && in_range(shape.*attribute.field); });
    return all;
  });
}

}  // namespace durero::trace
