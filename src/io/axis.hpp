#pragma once
/// Between two ways to write an element's axis: by its end points, and by base, direction and length.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/any_shape.hpp"

namespace durero::io {

/// A direction whose exact squared length is within tolerancia_unidad of 1, and a length.
struct Axis {
  glm::dvec3 vector;
  double altura;
  bool operator==(const Axis&) const = default;
};

/// From base to end; nothing where they are one point, or where the length is no finite binary64.
std::optional<Axis> axis_between(const glm::dvec3& base, const glm::dvec3& end);

/// base + altura·vector, each coordinate rounded.
glm::dvec3 end_of(const glm::dvec3& base, const Axis& axis);

/// How much the radius narrows for each unit of height, rounded.
double proportion_between(double wide, double narrow, double altura);

/// An end of a surface about an axis.
struct RoundEnd {
  glm::dvec3 at;
  double radius;  ///< from 0
};

/// Roundings of surfaces that a text gives by their ends.
struct EndRoundings {
  std::size_t axes = 0;         ///< whose other end is not quite where the text says
  std::size_t proportions = 0;  ///< whose wide radius is not quite the text's

  /// Adds a line for each kind.
  void name_losses(std::vector<std::string>& lost) const;
};

/// The cylinder, cone or truncated cone between two ends, from the wide one on; nothing where they give no axis.
std::optional<scene::AnyShape> surface_between(RoundEnd one, RoundEnd other, EndRoundings& rounded);

}  // namespace durero::io
