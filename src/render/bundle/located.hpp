#pragma once
/// The region of each pixel: the deepest one of the beam tree that its ray is in.

#include <cstdint>
#include <vector>

#include "durero/render/bundle/beam_tree.hpp"
#include "durero/render/render.hpp"

namespace durero::render {

/// For each pixel of the crop, row by row, the deepest region of which the exact ray of the pixel, as an engine has it,
/// passes through the inside; without_parent where it passes through none. A ray on a line between regions is in none
/// of them.
std::vector<std::uint32_t> located(const BeamTree& tree, const scene::PrimaryRays& rays, const Crop& crop);

}  // namespace durero::render
