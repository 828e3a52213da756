#pragma once
/// Files of points: text, `x y z` a line; or .npy, float64, shape (n, 3).

#include <glm/vec3.hpp>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// Reads points. What starts as a .npy file does, or is named so, is read as one, the others as text: numbers decimal
/// or C's hexadecimal, `#` comments, blank lines. Throws InputError on what is no finite number; the place in a .npy
/// file is the point (from 1) and its number.
std::vector<glm::dvec3> read_points(const Source& source);

}  // namespace durero::io
