#pragma once
/// The retrieve function: which scene of the specification a table-held scene stands for.

#include "durero/model/malla.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// Its elements, the faces of meshes among them. O(n log n).
model::Escena retrieve(const Scene& scene);

/// The points and faces of a mesh. O(n).
model::Red red_of(const Mesh& mesh);

/// Its elements and its meshes: the tables hold its sueltas (Retrieve), and its mallas. O(n log n).
model::Mallas retrieve_mallas(const Scene& scene);

}  // namespace durero::scene
