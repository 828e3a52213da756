#include "conform/families/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace durero::conform {
namespace {

/// The integer points of the circle of radius n.
std::vector<glm::dvec2> circle(int n) {
  std::vector<glm::dvec2> points;
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      if (x * x + y * y == n * n) points.emplace_back(x, y);
    }
  }
  return points;
}

/// The integer points of the sphere of radius n.
std::vector<glm::dvec3> sphere(int n) {
  std::vector<glm::dvec3> points;
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      const int z = static_cast<int>(std::sqrt(std::max(0, n * n - x * x - y * y)));
      if (x * x + y * y + z * z != n * n) continue;
      points.emplace_back(x, y, z);
      points.emplace_back(x, y, -z);
    }
  }
  return points;
}

template <class Points, std::size_t n>
auto tables(const std::array<int, n>& radii, Points points_of) {
  std::array<decltype(points_of(1)), n> tables;
  for (std::size_t i = 0; i < n; ++i) tables[i] = points_of(radii[i]);
  return tables;
}

/// One of the tabulated points, scaled to `radius`, where this is a power of two times a radius of the table; otherwise
/// `other`.
template <class Tables, std::size_t n, class Point>
Point scaled_point(Random& random, double radius, const std::array<int, n>& radii, const Tables& tables, Point other) {
  for (std::size_t i = 0; i < n; ++i) {
    const double ratio = radius / radii[i];
    int exponent = 0;
    if (std::frexp(ratio, &exponent) == 0.5) return ratio * random.any_of(tables[i]);
  }
  return other;
}

}  // namespace

glm::dvec2 on_circle(Random& random, double radius) {
  static const auto points = tables(circle_radii, circle);
  return scaled_point(random, radius, circle_radii, points, glm::dvec2(radius, 0));
}

glm::dvec3 on_sphere(Random& random, double radius) {
  static const auto points = tables(sphere_radii, sphere);
  return scaled_point(random, radius, sphere_radii, points, glm::dvec3(radius, 0, 0));
}

}  // namespace durero::conform
