#pragma once
/// Transformations of things, as texts of other programs move them: affine maps of binary64, whose entries are what a
/// scene has exactly.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/model/instancias.hpp"

namespace durero::io {

/// What becomes of a point p is linear·p + shift.
struct Transform {
  glm::dmat3 linear{1};            ///< what becomes of the axes
  glm::dvec3 shift{0};             ///< of the origin
  std::optional<double> scale{1};  ///< of all lengths alike; nothing where directions differ

  glm::dvec3 point(const glm::dvec3& p) const { return linear * p + shift; }
  glm::dvec3 direction(const glm::dvec3& v) const { return linear * v; }
  /// What stands across a plane is across what becomes of it; of another length.
  glm::dvec3 normal(const glm::dvec3& n) const;
  /// Whether it moves nothing, or moves all points alike.
  bool is_identity() const { return is_shift() && shift == glm::dvec3(0); }
  bool is_shift() const { return linear == glm::dmat3(1); }
  /// Whether the axes stay along themselves.
  bool keeps_axes() const;
  /// This one, and then another.
  Transform then(const Transform& other) const;
  /// The same map in exact numbers.
  model::Mapa map() const;
};

/// The cosine and the sine of an angle.
struct CosineSine {
  double cosine, sine;
};
/// Of an angle in degrees; exact where it is of whole right angles, else of binary64.
CosineSine turn_of(double degrees);

/// The turn about an axis, 0 to 2, of so many degrees, from the next axis to the one behind it. It is exact where the
/// angle is of whole right angles; another has the sine and cosine of binary64.
Transform turn_about(int axis, double degrees);

/// The scaling along the axes.
Transform scaling_by(const glm::dvec3& factors);

/// The shift.
Transform shift_by(const glm::dvec3& way);

}  // namespace durero::io
