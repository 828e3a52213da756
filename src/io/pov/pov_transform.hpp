#pragma once
/// The transformations of a POV-Ray text.

#include <optional>

#include "io/transform.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A transformation, as a text tells it.
struct PovTransform : Transform {
  std::size_t zeros = 0;  ///< that it scales by, which POV-Ray takes for 1

  /// This one, and then another.
  PovTransform then(const PovTransform& other) const { return {Transform::then(other), zeros + other.zeros}; }
};

/// Passes a translate, rotate, scale, matrix or transform, if one stands here. Throws InputError where it has no way
/// back.
std::optional<PovTransform> take_pov_transform(PovWords& in);
/// All that stand here, one after another.
PovTransform take_pov_transforms(PovWords& in);

}  // namespace durero::io
