#pragma once
/// The prisms of a POV-Ray text whose sides are curved.

#include <optional>
#include <vector>

#include "pov_object.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Reads a prism from behind its { to behind its points, as the parts of a group: a curved side is an element of a Z
/// text, and a straight one two triangles. Nothing of a closed one, of which no polynomial bounds the lids, of one of
/// lines alone, and where an outline does not come back. `at` is its word.
std::optional<std::vector<PovObject>> read_pov_curved_prism(PovWords& in, std::size_t at);

}  // namespace durero::io
