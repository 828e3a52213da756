#pragma once
/// Elements along an axis as formats have them that hold the ends of the axis, and the radii there.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axis.hpp"

namespace durero::io {

/// The ends of an element, the wide one first, each number rounded.
struct AxisEnds {
  glm::dvec3 base;
  double wide;
  glm::dvec3 top;
  double narrow;
};

/// Writes elements so, and counts what of them is lost.
class WrittenEnds {
 public:
  /// Of a shape with an axis: radio + proporcion·(altura − s) at the advance s, as far as it has them. Nothing where
  /// its ends, once they are rounded, give no such element.
  template <class Shape>
  std::optional<AxisEnds> of(const Shape& shape) {
    double narrow = 0, proportion = 0;
    if constexpr (requires { shape.radio; }) narrow = shape.radio;
    if constexpr (requires { shape.proporcion; }) proportion = shape.proporcion;
    return of(shape.centro, {shape.vector, shape.altura}, narrow, proportion);
  }
  void name_losses(std::vector<std::string>& lost, std::string_view format) const;

 private:
  std::optional<AxisEnds> of(const glm::dvec3& base, const Axis& axis, double narrow, double proportion);

  std::size_t too_wide_ = 0, endless_ = 0, straight_ = 0, rounded_axes_ = 0, rounded_radii_ = 0;
};

}  // namespace durero::io
