#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "durero/distance/fractals.hpp"

namespace durero::distance {
namespace {

/// The greatest of some bounds, and the direction in which it grows.
struct FaceDistance {
  double value;
  glm::dvec3 away;
};

glm::dvec3 along(int axis, double sign) {
  glm::dvec3 direction(0);
  direction[axis] = sign;
  return direction;
}

/// The distance from the cube; of a point inside the negative one of the nearest face.
FaceDistance of_cube(const glm::dvec3& p) {
  const glm::dvec3 q = p - 0.5, out = glm::abs(q) - 0.5;
  int widest = 0;
  for (int i = 1; i < 3; ++i)
    if (out[i] > out[widest]) widest = i;
  const glm::dvec3 beyond = glm::max(out, glm::dvec3(0));
  const double length = glm::length(beyond);
  return {length > 0 ? length : out[widest], along(widest, q[widest] < 0 ? -1 : 1)};
}

/// How deep a point lies in the bars that the cells of side 1/scale have lost: bars without end, a third of a cell
/// wide, through the middles of the cells along each axis. With the distances x, y, z of the point from the middle of
/// its cell, it is 1/6 − max(x, y) cells deep in the bar along z; the deepest bar leaves out the greatest of the three.
FaceDistance of_bars(const glm::dvec3& p, double scale) {
  const glm::dvec3 q = p * scale, in_cell = q - glm::floor(q) - 0.5, away = glm::abs(in_cell);
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::sort(axes, [&](int a, int b) { return away[a] < away[b]; });
  const int middle = axes[1];
  return {(1.0 / 6 - away[middle]) / scale, along(middle, in_cell[middle] < 0 ? 1 : -1)};
}

/// The sponge is what the cube and all bars leave: so it is not nearer than the cube, nor than the wall of the bar that
/// the point lies in, at any level.
FaceDistance deepest(const MengerSponge& sponge, const glm::dvec3& p) {
  FaceDistance found = of_cube(p);
  double scale = 1;
  for (std::uint32_t level = 0; level < sponge.level; ++level, scale *= 3) {
    const FaceDistance bars = of_bars(p, scale);
    if (bars.value > found.value) found = bars;
  }
  return found;
}

}  // namespace

bool MengerSponge::keeps(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  for (std::uint32_t n = 0; n < level; ++n, i /= 3, j /= 3, k /= 3)
    if ((i % 3 == 1) + (j % 3 == 1) + (k % 3 == 1) >= 2) return false;
  return true;
}

// p·scale is off by u = 2⁻⁵³ of itself, which its division by scale makes u of p; the other roundings, of numbers of
// 1/2 or less over scale, and of the distance from the cube, are below 8u·(|p| + 1).
double MengerSponge::below(const glm::dvec3& p) const {
  const double lost = (std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + 1) * 0x1p-49;
  return deepest(*this, p).value - lost;
}

glm::dvec3 MengerSponge::normal(const glm::dvec3& p) const { return deepest(*this, p).away; }

}  // namespace durero::distance
