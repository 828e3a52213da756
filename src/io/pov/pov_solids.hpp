#pragma once
/// The solids of a POV-Ray text: boxes, and what `merge`, `intersection` and `difference` make of their parts.

#include <array>
#include <string>
#include <vector>

#include "pov_object.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Makes bodies of objects, and counts what of their looks is lost.
class PovSolids {
 public:
  PovSolids(PovWords& in, PovShapes& shapes) : in_(in), shapes_(shapes) {}

  /// Reads the two corners of a box, from behind its {.
  std::array<glm::dvec3, 2> box();
  /// The first look that an object or one of its parts tells of; null where none does.
  static const ObjectMaterial* first_look(const PovObject& object);
  /// The body that an object bounds where it is put; the whole has that look. Precondition: is_solid(object).
  scene::Body body(const PovObject& object, const ObjectMaterial& whole, const PovTransform& by);
  /// Whether an object bounds a solid that a scene has.
  static bool is_solid(const PovObject& object);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  scene::Body body_of(const PovObject& object, const PovShape& shape, const PovTransform& by);
  scene::Body body_of(const std::array<glm::dvec3, 2>& box, const PovTransform& by) const;
  scene::Body checked_body(const PovObject& object, const PovShape& shape) const;

  PovWords& in_;
  PovShapes& shapes_;
  std::size_t looks_ = 0;
};

}  // namespace durero::io
