#include "durero/render/light/directions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace durero::render {

glm::dvec3 unit_of_any_length(const glm::dvec3& v) {
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

}  // namespace durero::render
