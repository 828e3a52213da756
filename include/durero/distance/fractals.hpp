#pragma once
/// Fractals that are known by a lower bound of the distance from them: a Menger sponge and a quaternion Julia set. In
/// the ball of that radius about a point nothing of the fractal lies, roundings included, so that sphere tracing passes
/// nothing of it.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace durero::distance {

/// The sponge of a level: of the cube [0, 1]³, cut into 3 × 3 × 3 cells, those cells go that are the middle one along
/// two axes or three, and each other cell is a sponge of a level less. A sponge of level 0 is the cube.
struct MengerSponge {
  std::uint32_t level;  ///< at most 20

  /// Whether the cell (i, j, k) of 3^level along each axis is one of the sponge's. Precondition: it is in the cube.
  bool keeps(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  /// A number that the distance from the sponge is not less than; negative inside.
  double below(const glm::dvec3& p) const;
  /// The outer unit normal of the face that is nearest to a point beside the sponge.
  glm::dvec3 normal(const glm::dvec3& p) const;
};

/// A quaternion, real part first.
using Quaternion = std::array<double, 4>;

/// The points (x, y, z) for which the numbers z₀ = x + yi + zj, zₙ₊₁ = zₙ² + c keep within 2 of the origin as far as
/// `iterations`. They hold the filled Julia set of c, where |c| ≤ 2.
struct QuaternionJulia {
  Quaternion c;              ///< |c| ≤ 2
  std::uint32_t iterations;  ///< at most 64

  /// Whether a point is of the set, as the computed numbers tell.
  bool keeps(const glm::dvec3& p) const;

  /// A number that the distance from the set is not less than; 0 inside, and near to it perhaps.
  double below(const glm::dvec3& p) const;
  /// The direction in which |zₙ| grows the fastest, with n the last number that is within 2.
  glm::dvec3 normal(const glm::dvec3& p) const;
};

}  // namespace durero::distance
