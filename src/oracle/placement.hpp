#pragma once
/// An affine map in binary64, as the sampled oracle uses it: where it puts points, and how it stretches lengths.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "durero/model/instancias.hpp"

namespace durero::oracle {

/// A map with each entry rounded (puesto.def.1). By default the identity, which changes no bit of a point.
class Placement {
 public:
  Placement() = default;
  /// Precondition: inv(mapa). A map whose vectors are equal once rounded has stretches that are no numbers.
  explicit Placement(const model::Mapa& mapa);

  /// The place where a point is put.
  glm::dvec3 point(const glm::dvec3& u) const { return linear_ * u + centro_; }
  /// The point that is put there.
  glm::dvec3 original(const glm::dvec3& w) const { return inverse_ * (w - centro_); }
  /// The normal of length 1 of what a surface with that normal becomes.
  glm::dvec3 normal(const glm::dvec3& n) const;

  /// @{ No length becomes more than `most` times as long, and none less than `least` times.
  double most() const noexcept { return most_; }
  double least() const noexcept { return least_; }
  /// @}
  /// How far the image may be off of a point that is no farther from the origin than that.
  double rounding(double from_origin) const noexcept;

 private:
  glm::dmat3 linear_{1}, inverse_{1};
  glm::dvec3 centro_{0};
  double most_ = 1, least_ = 1;
  bool is_identity_ = true;
};

}  // namespace durero::oracle
