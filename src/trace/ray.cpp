#include "durero/trace/ray.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "durero/scene/attributes.hpp"

namespace durero::trace {
namespace {

/// Two numbers side by side, and what is true of them.
using Pair [[gnu::vector_size(16)]] = double;
using Truths [[gnu::vector_size(16)]] = std::int64_t;

/// 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰; without branches and two at a time, as it is asked for every ray.
inline Truths in_range(Pair x) {
  const auto size = std::bit_cast<Pair>(std::bit_cast<Truths>(x) & std::numeric_limits<std::int64_t>::max());
  const Truths above = size >= 0x1p-100, below = size <= 0x1p100, zero = size == 0;
  return (above & below) | zero;
}
inline bool both(Truths truths) { return (truths[0] & truths[1]) != 0; }
inline bool in_range(double x) { return both(in_range(Pair{x, x})); }
inline bool in_range(const glm::dvec3& a) { return both(in_range(Pair{a.x, a.y}) & in_range(Pair{a.z, a.z})); }
inline bool in_range(const glm::dvec3& a, const glm::dvec3& b) {
  return both(in_range(Pair{a.x, a.y}) & in_range(Pair{a.z, b.x}) & in_range(Pair{b.y, b.z}));
}
inline bool in_range(const scene::Corners& v) { return in_range(v[0]) && in_range(v[1]) && in_range(v[2]); }

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

}  // namespace

Ray::Ray(const model::Rayo& rayo)
    : p(rayo.p().xyz()),
      v(rayo.v().xyz()),
      speed(extent(rayo.v().xyz())),
      ordinary(in_range(rayo.p().xyz(), rayo.v().xyz())) {}

bool ordinary(scene::ShapeView element) {
  return element.visit([]<class Shape>(const Shape& shape) {
    bool all = true;
    scene::for_each_attribute<Shape>([&](const auto& attribute) { all = all && in_range(shape.*attribute.field); });
    return all;
  });
}

}  // namespace durero::trace
