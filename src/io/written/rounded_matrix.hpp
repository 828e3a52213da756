#pragma once
/// Maps as the numbers of a matrix that other programs read.

#include <array>
#include <glm/vec3.hpp>

#include "durero/model/instancias.hpp"

namespace durero::io {

/// What becomes of the axes, and where the origin goes, each number rounded once.
struct RoundedMatrix {
  std::array<glm::dvec3, 3> axes;
  glm::dvec3 origin;
  bool is_exact;  ///< whether no number was rounded
};

/// The matrix of a map; nothing finite stands for an entry beyond binary64.
RoundedMatrix rounded_matrix(const model::Mapa& map);

/// The map that puts the cube from −1 to 1 where a map puts the box between two corners.
model::Mapa map_of_cube(const glm::dvec3& low, const glm::dvec3& high, const model::Mapa& by);

/// Whether all numbers are finite.
bool is_finite(const RoundedMatrix& matrix);

}  // namespace durero::io
