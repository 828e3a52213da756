#pragma once
/// Everything that a scene has of one name: kept before an edit, it can be put back after it.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "durero/model/tipos.hpp"
#include "durero/scene/any_shape.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/mesh.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "durero/scene/wrap.hpp"

namespace durero::scene {

/// An element by itself: its geometry, its looks and its group.
struct KeptElement {
  AnyShape shape;                         ///< the row of its table
  std::optional<std::uint32_t> material;  ///< as an index into the stage's materials
  std::optional<Wrap> wrap;               ///< of a triangle, how textures lie on it
  std::optional<VertexNormals> normals;   ///< of a triangle, how it is shaded
  std::optional<glm::dvec3> motion;       ///< its way in a unit of time; none where it rests
  std::optional<Body> body;               ///< where it has one, for which the row stands
  std::string group;                      ///< the group that it is directly in; empty where it is in none
};

/// What a scene has of a name of an element: nothing, or the element. Of a face it has nothing.
struct ElementRecord {
  std::string name;                    ///< the name
  std::optional<KeptElement> element;  ///< what bears it
};

/// What the scene has of that name. O(log n).
ElementRecord record_of(const GroupedScene& scene, const std::string& name);
/// Gives the scene of that name what it had: an element that bears it now leaves, and the kept one comes back with its
/// looks, and into its group if that exists. O(log n). Precondition: no face has the name. Where memory runs out the
/// element may be missing.
void restore(GroupedScene& scene, const ElementRecord& record);

/// What a scene has of a name of a mesh: nothing, or the mesh, with all groups, which its faces may be in.
struct MeshRecord {
  model::Elemento m;         ///< the name
  std::optional<Mesh> mesh;  ///< what bears it
  Groups groups;             ///< of the whole scene
};

/// What the scene has of that name. It costs as much as the mesh and the groups are large.
MeshRecord mesh_record_of(const GroupedScene& scene, const model::Elemento& m);
/// Gives the scene of that name what it had, and the groups of then.
void restore(GroupedScene& scene, const MeshRecord& record);

}  // namespace durero::scene
