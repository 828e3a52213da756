#pragma once
/// The edits of meshes: the operations of spec/malla.tex, with a mesh as the tables hold it.

#include <variant>

#include "durero/model/cara.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/mesh.hpp"

namespace durero::scene {

/// Adds a mesh: its triangles, all or none (Agregar_Malla).
struct MeshAddition {
  Mesh mesh;  ///< m?, red?, and the looks, of which the text does not speak
};

/// Removes a mesh with its triangles (Eliminar_Malla).
struct MeshRemoval {
  model::Elemento m;  ///< m?
};

/// Replaces a mesh by another of its name (Reemplazar_Malla).
struct MeshReplacement {
  Mesh mesh;  ///< m?, red?, and the looks
};

/// Moves a vertex of a mesh, that is the corner of every face that has it (Mover_Vertice).
struct VertexMove {
  model::Elemento m;   ///< m?
  model::Ordinal n;    ///< n?
  model::Punto punto;  ///< punto?
};

/// Any edit of the meshes of a scene.
using MeshEdit = std::variant<MeshAddition, MeshRemoval, MeshReplacement, VertexMove>;

}  // namespace durero::scene
