#pragma once
/// The surfaces of revolution of a POV-Ray text: lathe and sor, as cones, cylinders, discs, cubic pieces and turned
/// curves.

#include <optional>
#include <string_view>
#include <vector>

#include "pov_object.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Reads a lathe or a sor from behind its { up to what stands behind its points, as the parts of a group. Nothing of a
/// lathe with a line that crosses its axis, or turns back upon itself. `at` is its word.
std::optional<std::vector<PovObject>> read_pov_turned(PovWords& in, std::string_view word, std::size_t at);

/// Whether an object of that word is such a surface, which bounds no solid of a scene.
bool is_turned(std::string_view word);

}  // namespace durero::io
