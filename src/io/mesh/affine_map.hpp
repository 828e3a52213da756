#pragma once
/// Affine maps of space with exact numbers, which a hierarchy of nodes composes.

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/number/dyadic.hpp"

namespace durero::io {

/// The map of p to (linear·p + shift) / divisor. All its numbers are exact; those of what it maps are rounded once.
class AffineMap {
 public:
  /// The identity.
  AffineMap();
  /// Of the sixteen numbers of a matrix, column by column, the last row being 0 0 0 w: all others are then over w.
  /// Precondition: w > 0.
  static AffineMap of_matrix(const std::array<double, 16>& matrix);
  /// Scales, turns by the quaternion x y z w, and shifts. A quaternion of another length than 1 turns like the one of
  /// length 1: the matrix of its products is divided by the square of its length, which takes no root. Precondition: it
  /// is not 0.
  static AffineMap of_parts(const glm::dvec3& translation, const std::array<double, 4>& rotation,
                            const glm::dvec3& scale);

  /// The map that does `inner` first.
  AffineMap after(const AffineMap& inner) const;

  /// The image of the point numerators / denominator, each coordinate rounded once. Precondition: finite numbers, and a
  /// denominator above 0.
  glm::dvec3 point(const glm::dvec3& numerators, double denominator) const;
  /// The map of the normals of a surface to those of its image: the transposed inverse. Nothing where there is no
  /// inverse.
  std::optional<AffineMap> normals() const;
  /// The way back; nothing where there is none.
  std::optional<AffineMap> inverse() const;
  /// The map without its shift.
  AffineMap linear() const;
  /// −1 where it turns right into left, 1 where it does not, 0 where it flattens space.
  int orientation() const { return sign(determinant()); }
  /// Whether axes stay along themselves, and whether each point stays where it is.
  bool keeps_axes() const;
  bool is_identity() const;

  /// @{ A number of the map is a numerator over the divisor, which is above 0; column 3 is that of the shift.
  const number::Dyadic& numerator(std::size_t row, std::size_t column) const {
    return column < 3 ? linear_[row][column] : shift_[row];
  }
  const number::Dyadic& divisor() const { return divisor_; }
  /// @}

 private:
  using Row = std::array<number::Dyadic, 3>;

  number::Dyadic cofactor(std::size_t row, std::size_t column) const;
  number::Dyadic determinant() const;

  std::array<Row, 3> linear_;
  Row shift_;
  number::Dyadic divisor_ = 1;  ///< above 0
};

}  // namespace durero::io
