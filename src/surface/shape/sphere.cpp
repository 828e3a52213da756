#include "durero/surface/shape/sphere.hpp"

#include <cmath>
#include <limits>

namespace durero::surface {

Ball ball(const scene::Sphere& sphere) { return {sphere.centro, sphere.radio}; }

// A difference is rounded once, so its neighbour lies beyond the exact one.
Box box(const scene::Sphere& sphere) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{};
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::nextafter(sphere.centro[i] - sphere.radio, -infinity);
    box.high[i] = std::nextafter(sphere.centro[i] + sphere.radio, infinity);
  }
  return box;
}

}  // namespace durero::surface
