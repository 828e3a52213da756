#pragma once
/// The bounds of a POV-Ray object, which hide from it the rays that meet none of them.

#include <vector>

#include "pov_object.hpp"

namespace durero::io {

/// Whether each of these bounds surely holds the whole object, so that it hides nothing of it. Exact numbers decide it
/// for bounds that are spheres, boxes or planes; of others nothing is known.
bool surely_hold(const std::vector<PovObject>& bounds, const PovObject& object);

}  // namespace durero::io
