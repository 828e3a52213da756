#include "durero/render/bundle/spots.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "durero/scene/axes_across.hpp"

namespace durero::render {
namespace {

/// The standard deviation of a spot along a side, as a part of it. A row of normal distributions at distances of one
/// side is even within 2·exp(−2π²·0.6²) = 0.17 % of its mean.
constexpr double spread = 0.6;

/// The standard deviations to which a spot reaches: exp(−3.5²/2) is 1/457.
constexpr double deviations = 3.5;

}  // namespace

LightSpot spot_of(scene::ElementRef element, const glm::dvec3& centre, const glm::dvec3& n, const glm::dvec3& side,
                  const glm::dvec3& other, double blur, const glm::dvec3& flux) {
  const scene::AxesAcross axes = scene::axes_across(n);
  const glm::dvec2 a = spread * glm::dvec2(glm::dot(side, axes.first), glm::dot(side, axes.second));
  const glm::dvec2 b = spread * glm::dvec2(glm::dot(other, axes.first), glm::dot(other, axes.second));
  const glm::dmat2 covariance = glm::outerProduct(a, a) + glm::outerProduct(b, b) + blur * blur * glm::dmat2(1);
  const double greatest = std::sqrt(glm::dot(a, a) + glm::dot(b, b) + blur * blur);  // no variance is above it
  return {element,
          centre,
          axes.first,
          axes.second,
          glm::inverse(covariance),
          flux / (2 * std::numbers::pi * std::sqrt(glm::determinant(covariance))),
          deviations * greatest};
}

glm::dvec3 density(const LightSpot& spot, const glm::dvec3& point) {
  const glm::dvec3 from = point - spot.centre;
  const glm::dvec2 along(glm::dot(from, spot.first), glm::dot(from, spot.second));
  const double squared = glm::dot(along, spot.inverse * along);
  return squared > deviations * deviations ? glm::dvec3(0) : spot.peak * std::exp(-0.5 * squared);
}

std::size_t Spots::Hash::operator()(const Cube& cube) const noexcept {
  std::uint64_t hash = static_cast<std::uint64_t>(cube.level);
  for (const std::int64_t part : {cube.x, cube.y, cube.z})
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U + (hash >> 29);
  return hash;
}

Spots::Cube Spots::cube_of(int level, const glm::dvec3& point) {
  const auto place = [&](double x) { return static_cast<std::int64_t>(std::floor(std::scalbn(x, -level))); };
  return {level, place(point.x), place(point.y), place(point.z)};
}

void Spots::add(const LightSpot& spot) {
  const int level = std::ilogb(spot.reach) + 1;  // the cube is longer than the reach
  if (const auto at = std::ranges::lower_bound(levels_, level); at == levels_.end() || *at != level)
    levels_.insert(at, level);
  const auto number = static_cast<std::uint32_t>(spots_.size());
  const Cube low = cube_of(level, spot.centre - spot.reach), high = cube_of(level, spot.centre + spot.reach);
  for (std::int64_t x = low.x; x <= high.x; ++x)
    for (std::int64_t y = low.y; y <= high.y; ++y)
      for (std::int64_t z = low.z; z <= high.z; ++z) cubes_[{level, x, y, z}].push_back(number);
  spots_.push_back(spot);
}

glm::dvec3 Spots::density(scene::ElementRef element, const glm::dvec3& point) const {
  glm::dvec3 sum(0);
  for (const int level : levels_) {
    const auto found = cubes_.find(cube_of(level, point));
    if (found == cubes_.end()) continue;
    for (const std::uint32_t i : found->second)
      if (spots_[i].element == element) sum += render::density(spots_[i], point);
  }
  return sum;
}

}  // namespace durero::render
