#pragma once
/// Clear elements let a share of a light through: the coloured shadows of spec/luz.tex.

#include <glm/vec3.hpp>

#include "durero/scene/query.hpp"
#include "durero/surface/exact.hpp"
#include "followed.hpp"

namespace durero::render {

/// The clear elements of a context, which must outlive them: those of a material that lets light through.
class ClearElements {
 public:
  explicit ClearElements(const TracingContext& context) : context_(context) {}

  /// Whether shadows are to be coloured, and some material lets light through.
  bool count() const;

  /// The shares of red, green and blue that all elements on the stretch of a shadow ray let through
  /// (transmitido.def.1): the product of k_t·M_T over the points of each element, in the order of their names. 0 where
  /// the ray runs along an element. `way` is the length from the eye to the start of the ray, for mipmaps.
  glm::dvec3 share_through(const scene::Query& shadow, surface::exact::RayStretch stretch, double way) const;

 private:
  const TracingContext& context_;
};

}  // namespace durero::render
