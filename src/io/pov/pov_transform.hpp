#pragma once
/// The transformations of a POV-Ray text, as affine maps of binary64: their entries are what a scene has exactly.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "durero/model/instancias.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// What becomes of a point p is linear·p + shift.
struct PovTransform {
  glm::dmat3 linear{1};            ///< what becomes of the axes
  glm::dvec3 shift{0};             ///< of the origin
  std::optional<double> scale{1};  ///< of all lengths alike; nothing where directions differ
  std::size_t zeros = 0;           ///< that a text scales by, which POV-Ray takes for 1

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
  PovTransform then(const PovTransform& other) const;
  /// The same map in exact numbers.
  model::Mapa map() const;
};

/// Passes a translate, rotate, scale, matrix or transform, if one stands here. Throws InputError where it has no way
/// back.
std::optional<PovTransform> take_pov_transform(PovWords& in);
/// All that stand here, one after another.
PovTransform take_pov_transforms(PovWords& in);

}  // namespace durero::io
