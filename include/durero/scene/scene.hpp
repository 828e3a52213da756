#pragma once
/// The compact refinement of model::Escena: a dense table for each type of element, and an index from names to rows.
/// An edit is O(1): an addition appends a row, a removal moves the last row into the gap.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "durero/model/operaciones.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/name_index.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/scene/stage.hpp"
#include "durero/scene/table.hpp"

namespace durero::scene {

class Scene {
 public:
  std::span<const Sphere> spheres() const noexcept { return spheres_.shapes; }
  std::span<const Cylinder> cylinders() const noexcept { return cylinders_.shapes; }
  std::span<const Cone> cones() const noexcept { return cones_.shapes; }

  /// #elementos
  std::size_t size() const noexcept { return index_.size(); }

  /// Precondition of the members that take an ElementRef: it comes from this scene, since its last edit.
  const model::Elemento& name(ElementRef element) const noexcept;
  std::optional<ElementRef> find(std::string_view name) const noexcept;

  /// The partial operation: throws contract_violation where a clause does not hold; the scene is then as it was, also
  /// when memory runs out. Invalidates every ElementRef and span. A new element has no material.
  model::Respuesta apply(const model::Operation& operation);
  /// The total operation: where a precondition does not hold it changes nothing and answers the error.
  model::Answer apply_total(const model::Operation& operation);

  Stage& stage() noexcept { return stage_; }
  const Stage& stage() const noexcept { return stage_; }

  /// The material of an element, as an index into stage().materials.
  std::optional<std::uint32_t> material(ElementRef element) const noexcept;
  /// Throws std::out_of_range where the index names no material.
  void set_material(ElementRef element, std::optional<std::uint32_t> material);

 private:
  friend class Editor;

  const Label& label(ElementRef element) const noexcept;
  std::optional<ElementRef> find(std::string_view name, NameIndex::hash_type hash) const noexcept;

  Table<Sphere> spheres_;
  Table<Cylinder> cylinders_;
  Table<Cone> cones_;
  NameIndex index_;
  Stage stage_;
};

}  // namespace durero::scene
