#pragma once
/// A face of a solid: a polynomial whose sign tells the side of a point, negative inside.

#include <glm/vec3.hpp>

#include "durero/composed/form.hpp"

namespace durero::composed {

/// A face, and what is computed of it in binary64.
class SolidFace {
 public:
  /// Of a polynomial other than 0.
  explicit SolidFace(const SpaceForm<Dyadic>& form);

  /// The polynomial times a power of two.
  const SpaceForm<Dyadic>& form() const { return form_; }
  /// Its coefficients to about 50 bits.
  const SpaceForm<RealBall>& rough() const { return rough_; }

  /// Whether the polynomial may be 0 at a point whose rounding this is. False is certain.
  bool may_hold_near(const glm::dvec3& rounded) const;

  /// @{ The value and the gradient at a point, to some digits.
  double value(const glm::dvec3& w) const;
  glm::dvec3 gradient(const glm::dvec3& w) const;
  /// @}

 private:
  bool is_surely_far(const glm::dvec3& w) const;

  SpaceForm<Dyadic> form_, magnitudes_;  // in step; the magnitudes are not negative
  SpaceForm<RealBall> rough_;
  std::array<double, matrix_places> rounded_;
};

/// 1 where a is a positive multiple of b, −1 a negative one, 0 where it is none (multiplo.def.1). Precondition: neither
/// is 0.
int multiple(const SpaceForm<Dyadic>& a, const SpaceForm<Dyadic>& b);

}  // namespace durero::composed
