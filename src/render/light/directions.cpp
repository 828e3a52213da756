#include "durero/render/light/directions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace durero::render {

glm::dvec3 unit(const glm::dvec3& v) {
  // The scale is a power of two, so that no digit is lost. Nearly always it is a binary64 number.
  constexpr int bias = 1023;
  const double greatest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (greatest >= 0x1p-1000 && greatest < 0x1p1000) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(greatest) >> 52;
    const glm::dvec3 scaled = v * std::bit_cast<double>((2 * bias - exponent) << 52);
    return scaled / glm::length(scaled);
  }
  const int exponent = std::ilogb(greatest);
  const glm::dvec3 scaled{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  return scaled / glm::length(scaled);
}

glm::dvec3 mirrored(const glm::dvec3& d, const glm::dvec3& n) { return d - 2 * glm::dot(d, n) * n; }

std::optional<glm::dvec3> refracted(const glm::dvec3& d, const glm::dvec3& n, double ratio) {
  if (ratio == 1) return d;
  const double cosine = -glm::dot(d, n);
  const double squared = 1 - ratio * ratio * (1 - cosine * cosine);
  if (squared < 0) return std::nullopt;
  return (ratio * cosine - std::sqrt(squared)) * n + ratio * d;
}

}  // namespace durero::render
