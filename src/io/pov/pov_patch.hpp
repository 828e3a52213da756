#pragma once
/// The bicubic patches of a POV-Ray text, as the triangles that POV-Ray itself makes of them.

#include <array>
#include <optional>
#include <vector>

#include "pov_shapes.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A patch as it stands in a text.
struct PovPatch {
  /// Its 16 points: a row at each place along u.
  std::array<std::array<glm::dvec3, 4>, 4> points{};
  double flatness = 0;
  int u_steps = 0, v_steps = 0;
};

/// Reads a bicubic_patch from behind its { to behind its points; nothing where its steps are more than 20 in all.
std::optional<PovPatch> read_pov_patch(PovWords& in);

/// The triangles of a patch that is moved. A part of it that is flat there is two of them; any other is halved, along
/// both sides, as often as the steps say.
std::vector<PovShape> triangles_of(const PovPatch& patch, const PovTransform& by);

}  // namespace durero::io
