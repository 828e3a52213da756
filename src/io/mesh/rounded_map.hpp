#pragma once
/// An affine map made ready for many points.

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "affine_map.hpp"

namespace durero::io {

/// A map that also knows its numbers to about 106 bits, as sums of two binary64. The images of most points are certain
/// from these, within a bound; the others are taken from the exact map.
class RoundedMap {
 public:
  explicit RoundedMap(AffineMap map);

  /// AffineMap::point(), and the same preconditions.
  glm::dvec3 point(const glm::dvec3& numerators, double denominator) const;

 private:
  /// The number high + low, to 2⁻¹⁰⁶ of itself. `high` is 0 where the number is, and only there.
  struct TwoDoubles {
    double high = 0, low = 0;
  };
  using Row = std::array<TwoDoubles, 4>;  ///< of the linear part, and of the shift

  std::optional<Row> near(std::size_t row) const;
  static std::optional<double> certain(const Row& row, const glm::dvec3& p);

  AffineMap map_;
  std::array<std::optional<Row>, 3> rows_;  ///< nothing where a number is too large or too small for binary64
};

}  // namespace durero::io
