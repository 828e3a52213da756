#pragma once
/// A closed mesh: the triangles of a scene where every edge belongs to two of them with the very same vertices, or to
/// an even number of them.

#include <optional>

#include "conform/judge/allowance.hpp"
#include "conform/judge/scene_tree.hpp"
#include "conform/judge/zones.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::conform {

/// Facts about a closed mesh that all rays ask for. The vertices that triangles share move together here, and the ray
/// is one for all triangles: this is the claim of a watertight system.
struct ClosedMesh {
  const SceneTree* tree;  ///< of the scene
  surface::Box box;       ///< around all vertices
  double longest;         ///< the largest magnitude of a coordinate
};

/// All triangles of the tree's scene; nothing where there are none, or they are no closed mesh. The tree must outlive
/// the mesh.
std::optional<ClosedMesh> closed_mesh(const SceneTree& tree);

/// The zone of the mesh, which bears the name of the first triangle; nothing where the mesh is not around the origin.
///
/// The number of times that a point is inside a closed mesh, modulo 2, is the number of crossings of any ray from it
/// that meets no edge; it changes nowhere but on the mesh. Let vertices and origin move to their places in straight
/// lines: the mesh stays closed, each of its points moves by at most √3·δ and the origin by as much. An origin farther
/// than 2√3·δ from every triangle never meets the mesh, and stays inside; 6δ is farther. Nothing far away is inside, so
/// the ray meets the mesh, whatever its direction. There no coordinate of t·v is larger than twice the largest L of
/// vertices and origin by more than 2δ, so M ≤ (2 + 2⁻⁴)·L where 32δ ≤ L. That point lies in the box of the mesh grown
/// by δ; p is off by δ and t·v by as much, so that p + t·v lies in the box grown by 3δ. The ray leaves this box before
/// it leaves the box grown by 4δ, where the zone ends.
std::optional<Zone> zone_of(const ClosedMesh& mesh, const model::Rayo& rayo, const Precision& precision);

}  // namespace durero::conform
