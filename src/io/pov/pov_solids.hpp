#pragma once
/// The solids of a POV-Ray text: boxes, and what `merge`, `intersection` and `difference` make of their parts.

#include <string>
#include <vector>

#include "pov_object.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Makes bodies of objects, and counts what of their looks is lost.
class PovSolids {
 public:
  explicit PovSolids(PovWords& in) : in_(in) {}

  /// Reads the two corners of a box, from behind its {; `at` is its word.
  scene::Compound box(std::size_t at);
  /// The first look that an object or one of its parts tells of; null where none does.
  static const ObjectMaterial* first_look(const PovObject& object);
  /// What an object bounds, of which the whole has that look. Fails where a part bounds nothing.
  scene::Body body(const PovObject& object, const ObjectMaterial& whole);
  void name_losses(std::vector<std::string>& lost) const;

 private:
  scene::Body body(const PovObject& object, const PovShape& shape) const;

  PovWords& in_;
  std::size_t looks_ = 0;
};

}  // namespace durero::io
