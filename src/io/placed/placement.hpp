#pragma once
/// Where a scene's text puts a thing: an affine map of exact numbers, and by how much it stretches lengths.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/model/instancias.hpp"
#include "io/mesh/affine_map.hpp"

namespace durero::io {

/// A map, and what a text tells of it that its numbers, once rounded, do not.
struct AffinePlacement {
  AffineMap map{};
  std::optional<double> scale = 1;  ///< of all lengths alike; nothing where directions differ
  std::size_t steps = 0;            ///< how many maps but translations it is composed of

  /// How many maps may be composed: the numbers of a map grow with each.
  static constexpr std::size_t most_steps = 256;

  /// @{ A translation, a scale along the axes, a turn about an axis by degrees, and the map of sixteen numbers, column
  /// by column, whose last row is 0 0 0 w, above 0. Nothing where the axis of a turn is 0.
  static AffinePlacement translation(const glm::dvec3& by);
  static AffinePlacement scaling(const glm::dvec3& by);
  static std::optional<AffinePlacement> rotation(const glm::dvec3& axis, double degrees);
  static AffinePlacement of_matrix(const std::array<double, 16>& matrix);
  /// @}
  /// What the formula of a turn makes of an axis of another length than 1, which stretches and shears.
  static AffinePlacement turn_unscaled(const glm::dvec3& axis, double degrees);
  /// Puts the origin at a point, +z along the way to another, and +y on the side of `up`; +x is up × way. Nothing where
  /// these give no such frame.
  static std::optional<AffinePlacement> looking(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& up);

  /// The placement that does `inner` first.
  AffinePlacement after(const AffinePlacement& inner) const;
  /// The way back; nothing where there is none.
  std::optional<AffinePlacement> inverse() const;
  /// The same map as a scene has it. Precondition: it has a way back.
  model::Mapa mapa() const;
};

}  // namespace durero::io
