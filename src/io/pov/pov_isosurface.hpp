#pragma once
/// The isosurfaces of a POV-Ray text whose function is a polynomial.

#include <optional>
#include <vector>

#include "pov_words.hpp"
#include "pov_written.hpp"

namespace durero::io {

/// Reads an isosurface from behind its { to behind its own settings: where the function has its threshold within the
/// box or the ball that holds it, and the parts of that where it is below. Nothing where the function is no polynomial
/// of degree four at most.
std::optional<std::vector<PovPiece>> read_pov_isosurface(PovWords& in);

}  // namespace durero::io
