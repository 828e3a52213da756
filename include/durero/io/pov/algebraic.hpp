#pragma once
/// The types of elements that POV-Ray's algebraic surfaces become. No table of the program has them: the Z text
/// demo/surfaces/algebraic.tex says what their points are.

#include <cstddef>
#include <span>

#include "durero/io/json/written_elements.hpp"

namespace durero::io {

/// @{ The places of the types: a torus that an affine map has moved, any surface of degree four at most, part of one, a
/// lid of one, a curve turned about an axis, one swept along it, a superellipsoid, and a blob.
inline constexpr std::size_t moved_torus = 0, quartic = 1, clipped_surface = 2, lid_of_surface = 3, turned_curve = 4,
                             swept_curve = 5, superellipsoid = 6, written_blob = 7;
/// @}

/// The types, with the attributes that the text gives them.
std::span<const WrittenType> algebraic_types();

}  // namespace durero::io
