#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/distance/fractals.hpp"

namespace durero::distance {
namespace {

constexpr double escape = 2, least_radius = 0x1p-40;
constexpr std::uint32_t most_iterations = 64;

double dot(const Quaternion& a, const Quaternion& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/// z² + c
Quaternion next(const Quaternion& z, const Quaternion& c) {
  const double twice = 2 * z[0];
  return {z[0] * z[0] - z[1] * z[1] - z[2] * z[2] - z[3] * z[3] + c[0], twice * z[1] + c[1], twice * z[2] + c[2],
          twice * z[3] + c[3]};
}

/// The numbers up to the first that is not within the radius of escape, and some more.
struct Orbit {
  std::array<double, most_iterations + 3> sizes{};  ///< |z₀|, |z₁|, …
  std::uint32_t count = 0;                          ///< how many there are
  std::uint32_t kept = 0;                           ///< how many of them, from the first, are within
};

Orbit orbit(const QuaternionJulia& set, const glm::dvec3& p) {
  constexpr std::uint32_t more = 2;  // beyond the first that escapes
  Orbit found;
  Quaternion z{p.x, p.y, p.z, 0};
  while (found.count <= set.iterations && found.count < found.kept + 1 + more) {
    const double size = std::sqrt(dot(z, z));
    found.sizes[found.count++] = size;
    if (size <= escape && found.kept + 1 == found.count) found.kept = found.count;
    z = next(z, set.c);
  }
  return found;
}

/// Whether all points of the ball of a radius about the orbit's point escape. The image of a ball about z of the radius
/// r is within one of the radius (2|z| + r)·r about z², for (z + e)² − z² = ze + ez + e². What the computed numbers are
/// off by is in the radius too: less than 16u·(|z|² + 2) is lost by each step, u = 2⁻⁵³, and as much of |z|. All points
/// escape where the ball about some number lies beyond the radius of escape.
bool all_escape(const Orbit& orbit, double radius) {
  double r = radius;
  for (std::uint32_t n = 0; n < orbit.count; ++n) {
    const double size = orbit.sizes[n] * (1 + 0x1p-49);
    if (n >= orbit.kept && orbit.sizes[n] * (1 - 0x1p-49) - r > escape) return true;
    r = ((2 * size + r) * r + (size * size + 2) * 0x1p-49) * (1 + 0x1p-49);
  }
  return false;
}

}  // namespace

bool QuaternionJulia::keeps(const glm::dvec3& p) const {
  const Orbit of_point = orbit(*this, p);
  return of_point.kept == of_point.count;
}

/// By halves, to a thirty-second of itself: the greatest radius of which it is shown that all points escape. No more
/// than
/// (|zₙ| − 2)/∏ 2|zₖ| is, for a ball grows by 2|z| at least.
double QuaternionJulia::below(const glm::dvec3& p) const {
  const Orbit of_point = orbit(*this, p);
  if (of_point.kept == of_point.count) return 0;
  double high = 0, growth = 1;
  for (std::uint32_t n = 0; n < of_point.count; growth *= 2 * of_point.sizes[n++])
    if (n >= of_point.kept) high = std::max(high, (of_point.sizes[n] - escape) / growth);
  double low = high / 2;
  while (low > least_radius && !all_escape(of_point, low)) low /= 2;
  if (low <= least_radius) return 0;
  high = std::min(high, 2 * low);
  for (int turn = 0; turn < 4; ++turn) {
    const double middle = (low + high) / 2;
    (all_escape(of_point, middle) ? low : high) = middle;
  }
  return low;
}

/// The gradient of |zₙ|²/2 is (∂zₙ·zₙ), by each coordinate of p; ∂zₙ₊₁ = zₙ·∂zₙ + ∂zₙ·zₙ.
glm::dvec3 QuaternionJulia::normal(const glm::dvec3& p) const {
  Quaternion z{p.x, p.y, p.z, 0};
  std::array<Quaternion, 3> slopes{Quaternion{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  for (std::uint32_t n = 0; n < iterations && dot(z, z) <= escape * escape; ++n) {
    for (Quaternion& d : slopes) {
      const double real = 2 * (z[0] * d[0] - z[1] * d[1] - z[2] * d[2] - z[3] * d[3]);
      d = {real, 2 * (z[0] * d[1] + d[0] * z[1]), 2 * (z[0] * d[2] + d[0] * z[2]), 2 * (z[0] * d[3] + d[0] * z[3])};
    }
    z = next(z, c);
  }
  const glm::dvec3 slope(dot(slopes[0], z), dot(slopes[1], z), dot(slopes[2], z));
  const double length = glm::length(slope);
  return length > 0 && std::isfinite(length) ? slope / length : glm::dvec3(0, 1, 0);
}

}  // namespace durero::distance
