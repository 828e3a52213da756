#pragma once
/// A scene in the making, of things that a text describes where they are simple and puts elsewhere by maps: what
/// readers of instances have in common.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "durero/io/formats.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "durero/scene/wrap.hpp"
#include "io/axis.hpp"
#include "io/mesh/numbered_materials.hpp"
#include "placement.hpp"

namespace durero::io {

/// A cylinder without caps, by the middles of its ends; or a cone, whose apex is the second.
struct OpenCylinder {
  std::array<glm::dvec3, 2> ends;
  double radius;  ///< at the first end
  bool is_cone = false;
};

/// A box along the axes, as a solid, by two corners.
struct AxisBox {
  std::array<glm::dvec3, 2> corners;
};

/// A triangle of a mesh, with its looks.
struct MeshTriangle {
  scene::Triangle triangle;
  std::optional<scene::VertexNormals> normals{};
  std::optional<scene::Wrap> wrap{};
};

/// The triangles of a mesh, which its instances share.
using MeshTriangles = std::shared_ptr<const std::vector<MeshTriangle>>;

/// A surface where it is simple.
using SimpleSurface = std::variant<scene::Sphere, OpenCylinder, scene::Disc, AxisBox, MeshTriangles>;

/// A surface, its material, and where it is put.
struct PlacedThing {
  SimpleSurface surface;
  AffinePlacement by{};
  std::optional<std::uint32_t> material{};  ///< a number of PlacedScene::material()
};

/// Adds things, and counts what of them is rounded or left out. Elements are named s1, c1, k1, d1, v1, … by type,
/// solids and copies b1, …, groups m1, … of meshes and u1, … of instances.
class PlacedScene {
 public:
  /// How many elements are added at most, those that are left out included: instances repeat a mesh without end.
  static constexpr std::size_t most_elements = std::size_t{1} << 24U;

  PlacedScene() { scene_.put_off_audits(); }

  scene::Stage& stage() { return scene_.stage(); }
  /// The number of a material that looks so.
  std::uint32_t material(scene::Material look) { return materials_.number(std::move(look)); }
  /// Adds a thing to the scene, and to a group. False where the scene would have too many elements.
  [[nodiscard]] bool add(const PlacedThing& thing, scene::Group& into);
  /// Makes a group of an instance, within another; nothing of an empty one.
  void add_instance(scene::Group own, scene::Group& into);
  /// The scene, once nothing follows. What is lost stands behind what a reader has lost.
  Imported take(std::vector<std::string> lost);

 private:
  /// How a thing is added: where, and as what.
  struct Place {
    const AffinePlacement& by;
    std::optional<std::uint32_t> material;
    scene::Group& into;
  };

  void add(const scene::Sphere& sphere, const Place& place);
  void add(const OpenCylinder& cylinder, const Place& place);
  void add(const scene::Disc& disc, const Place& place);
  void add(const AxisBox& box, const Place& place);
  void add(const MeshTriangles& mesh, const Place& place);
  template <class Shape>
  void add_shape(const Shape& shape, const Place& place);
  void add_copy(const scene::AnyShape& shape, const Place& place);
  void add_body(scene::Body body, const Place& place);
  void add_group(std::string name, scene::Group own, scene::Group& into);
  glm::dvec3 moved(const glm::dvec3& p, const AffinePlacement& by);

  scene::Scene scene_;
  scene::Groups groups_;
  NumberedMaterials materials_{scene_};
  std::array<std::size_t, std::tuple_size_v<scene::Shapes>> numbered_{};
  std::size_t tried_ = 0;
  std::size_t bodies_ = 0, meshes_ = 0, instances_ = 0;  // numbers of names
  EndRoundings rounded_;
  std::size_t moved_ = 0, directions_ = 0, aligned_ = 0, beyond_ = 0, without_ = 0, flat_ = 0;  // losses
  std::map<std::string, std::size_t> refused_;
};

/// The triangles of a scene of a mesh file, in their order.
MeshTriangles triangles_of(const scene::Scene& mesh, bool with_normals);

}  // namespace durero::io
