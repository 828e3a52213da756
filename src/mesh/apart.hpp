#pragma once
/// Quick answers about two faces, by binary64 and bounds of its error.

#include "few_points.hpp"

namespace durero::mesh {

/// Whether the two faces surely have no more points in common than those between the corners that both have. False says
/// "cannot tell".
bool are_surely_apart(const SharedCorners& corners);

}  // namespace durero::mesh
