#pragma once
/// Motion: an element moves evenly, as desplazado.def.1 of spec/distribuida.tex has it, while the shutter is open.

#include <cstddef>

#include "durero/scene/scene.hpp"

namespace durero::scene {

/// The number of elements that move.
std::size_t moving_elements(const Scene& scene);

/// Whether the picture of a scene is a mean over times: the shutter is open for a while, and something moves.
bool moves(const Scene& scene);

}  // namespace durero::scene
