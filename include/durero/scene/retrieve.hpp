#pragma once
/// The retrieve function: which scene of the specification a table-held scene stands for.

#include "durero/model/operation.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// O(n log n).
model::Escena retrieve(const Scene& scene);

}  // namespace durero::scene
