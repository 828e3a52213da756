#pragma once
/// The compact refinement of model::Escena: a dense table for each type of element, and an index from names to rows.
/// An edit is O(1): an addition appends a row, a removal moves the last row into the gap.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "durero/model/operation.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/held_stage.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/name_index.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/scene/table.hpp"

namespace durero::scene {

struct Body;
struct Edit;

/// Elements, and the stage that a picture of them needs. Many threads may read it while none edits it.
class Scene {
 public:
  /// The elements of one shape by themselves, in no mesh: the element {Shape::tipo, i} is row i.
  template <class Shape>
  std::span<const Shape> singles() const noexcept {
    return table<Shape>().shapes;
  }
  /// All elements of one shape: the element {Shape::tipo, i} is row i. The faces of meshes stand behind the triangles
  /// by themselves, in the order of the meshes.
  template <class Shape>
  auto shapes() const noexcept {
    if constexpr (std::is_same_v<Shape, Triangle>)
      return Triangles(singles<Triangle>(), meshes_);
    else
      return singles<Shape>();
  }

  /// visit(shape) with the geometry of an element.
  template <class Visit>
  decltype(auto) visit(ElementRef element, Visit&& visit) const {
    return with_shape(element.tipo, [&]<class Shape>(std::type_identity<Shape>) -> decltype(auto) {
      return visit(shapes<Shape>()[element.index]);
    });
  }

  /// visit(element, shape) for every element, ascending, until it answers true. Whether it did.
  template <class Visit>
  bool any_of(Visit&& visit) const {
    bool answered = false;
    for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      const auto rows = shapes<Shape>();
      for (std::uint32_t i = 0; i < rows.size() && !answered; ++i)
        answered = visit(ElementRef{Shape::tipo, i}, rows[i]);
    });
    return answered;
  }

  /// visit(element, shape) for every element by itself, in no mesh, ascending.
  template <class Visit>
  void for_each_single(Visit&& visit) const {
    for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      const std::span<const Shape> rows = singles<Shape>();
      for (std::uint32_t i = 0; i < rows.size(); ++i) visit(ElementRef{Shape::tipo, i}, rows[i]);
    });
  }

  /// visit(element, shape) for every element, ascending.
  template <class Visit>
  void for_each(Visit&& visit) const {
    any_of([&](ElementRef element, const auto& shape) {
      visit(element, shape);
      return false;
    });
  }

  /// #elementos
  std::size_t size() const noexcept { return index_.size() + meshes_.faces(); }

  /// Precondition of the members that take an ElementRef: it comes from this scene, since its last edit.
  model::Elemento name(ElementRef element) const;
  /// The element of a name; nothing where it has none.
  std::optional<ElementRef> find(std::string_view name) const noexcept;

  /// The partial operation: throws contract_violation where a clause does not hold; the scene is then as it was, also
  /// when memory runs out. Invalidates every ElementRef and span. A new element has no material.
  model::Respuesta apply(const model::Operation& operation);
  /// The total operation: where a precondition does not hold it changes nothing and answers the error.
  model::Answer apply_total(const model::Operation& operation);
  /// @{ The partial and the total change of an attribute: the element keeps its name, its place, its material and its
  /// group. A face of a mesh is changed with its mesh alone (es_de_malla).
  model::Respuesta change(const model::AttributeChange& change);
  model::Answer change_total(const model::AttributeChange& change);
  /// @}
  /// The same of an edit: a new element gets the edit's material. Throws std::out_of_range, and changes nothing, where
  /// the edit's material is none of the stage's.
  model::Answer apply_total(const Edit& edit);
  /// The total operation on meshes: it costs as much as the mesh is large. Throws, and changes nothing,
  /// std::domain_error where a point is not finite, where normals or uv are not one for each point, or where a normal
  /// has no direction, std::out_of_range where the material is none of the stage's, and std::length_error where the
  /// triangles are more than places.
  model::Answer apply_total(MeshEdit edit);
  /// The total addition of an element of that geometry, for whoever reads no operations. Of every shape.
  template <class Shape>
  model::Answer add(const model::Elemento& e, const Shape& shape, std::optional<std::uint32_t> material = {});

  /// The meshes. Of a face, the name, the material and the looks are those of its mesh.
  const Meshes& meshes() const noexcept { return meshes_; }
  /// The face that an element is; nothing where it is none.
  std::optional<Meshes::Face> face(ElementRef element) const noexcept;

  /// Puts the audits of edits off until audit(): for a reader, whose additions are audited together.
  void put_off_audits() noexcept { audits_are_put_off_ = true; }
  /// Evaluates the whole invariant over what the scene stands for, where audit clauses are evaluated. From now on each
  /// edit is audited. O(n log n). Throws contract_violation.
  void audit();

  /// @{ What a picture needs beside the elements (scene/stage.hpp).
  Stage& stage() { return *stage_; }
  const Stage& stage() const noexcept { return *stage_; }
  /// @}

  /// The material of an element, as an index into stage().materials.
  std::optional<std::uint32_t> material(ElementRef element) const noexcept;
  /// Throws std::out_of_range where the index names no material, and std::domain_error where the element is a face.
  void set_material(ElementRef element, std::optional<std::uint32_t> material);

  /// How textures lie on a triangle; nothing where they follow its own (u, v), as on every other shape.
  std::optional<Wrap> wrap(ElementRef element) const;
  /// Throws std::domain_error where the element is no triangle by itself.
  void set_wrap(ElementRef element, const Wrap& wrap);

  /// The normals of the vertices of a triangle; nothing where it is shaded as it lies, as every other shape.
  std::optional<VertexNormals> vertex_normals(ElementRef element) const noexcept;
  /// Throws std::domain_error where the element is no triangle by itself, or a normal is null or not finite.
  void set_vertex_normals(ElementRef element, const VertexNormals& normals);

  /// The way of an element in a unit of time; null where it rests.
  const glm::dvec3* motion(ElementRef element) const noexcept;
  /// Makes an element move evenly: at the time 0 it is where its attributes say. Throws std::domain_error where the
  /// element is a face.
  void set_motion(ElementRef element, const glm::dvec3& motion);
  /// What an element is that no table holds; null of one that is the shape in its row.
  const Body* body(ElementRef element) const noexcept;
  /// Gives an element a body. Throws std::domain_error where it is no sphere: `stand_in` is what a body stands as.
  void set_body(ElementRef element, Body body);
  /// Whether some element has a body.
  bool has_bodies() const noexcept;

  /// The scene at a time: elements and camera are where their motions have brought them, each coordinate rounded once,
  /// and keep their tables and rows. Throws std::domain_error where a coordinate is not finite any more, or three
  /// vertices lie on one line then.
  Scene at_time(double time) const;

 private:
  friend class Editor;
  friend class MeshEditor;

  bool is_face(ElementRef element) const noexcept {
    return element.tipo == Triangle::tipo && element.index >= table<Triangle>().size();
  }
  /// @{ Precondition: the element is no face.
  const Label& label(ElementRef element) const noexcept;
  Label& label(ElementRef element) noexcept;
  /// @}
  template <class Attribute>
  const Attribute* rare(ElementRef element, std::optional<Attribute> RareAttributes::*which) const noexcept;
  template <class Attribute>
  void set_rare(ElementRef element, std::optional<Attribute> RareAttributes::*which,
                const std::optional<Attribute>& value);
  /// Throws std::domain_error where the element is a face.
  void require_single(ElementRef element) const;
  std::optional<ElementRef> find(std::string_view name, NameIndex::hash_type hash) const noexcept;

  template <class Shape>
  const Table<Shape>& table() const noexcept {
    return std::get<Table<Shape>>(tables_);
  }
  template <class Shape>
  Table<Shape>& table() noexcept {
    return std::get<Table<Shape>>(tables_);
  }

  Tables<Shapes> tables_;
  NameIndex index_;  // of the elements by themselves
  Meshes meshes_;
  HeldStage stage_;
  std::shared_ptr<const model::Escena> audited_;  // what the scene stands for, where its last edit was audited
  bool audits_are_put_off_ = false;
};

}  // namespace durero::scene
