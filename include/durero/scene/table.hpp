#pragma once
/// The dense table of one type of element. Row i of each column belongs to one element.

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/mesh.hpp"
#include "durero/scene/name_index.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "durero/scene/wrap.hpp"

namespace durero::scene {

struct Body;

/// Few elements have these, and a table keeps them apart.
struct RareAttributes {
  std::optional<Wrap> wrap{};                         ///< how textures lie on a triangle
  std::optional<VertexNormals> normals{};             ///< how a triangle is shaded
  std::optional<glm::dvec3> motion{};                 ///< its way in a unit of time; none where it rests
  std::optional<std::shared_ptr<const Body>> body{};  ///< what it is, where the row is a sphere that stands in for it
};

/// What an element has beside its geometry. One column, since an edit needs all of it.
struct Label {
  model::Elemento name;                          ///< what it is called
  NameIndex::hash_type hash;                     ///< of the name
  std::uint32_t material = no_material;          ///< an index into the materials of the stage
  std::shared_ptr<const RareAttributes> rare{};  ///< null where it has none of them
};

/// One element, out of the table.
template <class Shape>
struct TableRow {
  Shape shape;  ///< its geometry
  Label label;  ///< the rest
};

/// The elements of one type. Its columns are of one length.
template <class Shape>
struct Table {
  std::vector<Shape> shapes;  ///< the geometry
  std::vector<Label> labels;  ///< the rest

  /// How many rows it has.
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(shapes.size()); }

  /// Makes room for one more row. The only member that asks for memory; nothing that can be seen changes.
  void reserve_one_more() {
    if (size() > NameIndex::last_index) throw std::length_error("a table holds no more elements of this type");
    grow(shapes);
    grow(labels);
  }

  /// Precondition: room for the row.
  void push_back(TableRow<Shape>&& row) noexcept {
    shapes.push_back(row.shape);
    labels.push_back(std::move(row.label));
  }

  /// Takes the last row out. Precondition: there is one.
  void pop_back() noexcept {
    shapes.pop_back();
    labels.pop_back();
  }

  /// Takes row i out; the last row moves into the gap.
  TableRow<Shape> take(std::uint32_t i) noexcept {
    TableRow<Shape> row{shapes[i], std::move(labels[i])};
    if (i + 1 != size()) {
      shapes[i] = shapes.back();
      labels[i] = std::move(labels.back());
    }
    pop_back();
    return row;
  }

  /// Undoes take(i).
  void put_back(std::uint32_t i, TableRow<Shape>&& row) noexcept {
    if (i == size()) return push_back(std::move(row));
    push_back({shapes[i], std::move(labels[i])});
    shapes[i] = row.shape;
    labels[i] = std::move(row.label);
  }

 private:
  template <class T>
  static void grow(std::vector<T>& column) {
    if (column.size() == column.capacity()) column.reserve(std::max<std::size_t>(16, 2 * column.size()));
  }
};

/// A table for each shape of a list.
template <class List>
struct TablesOf;
/// The only list that there is: a tuple.
template <class... Shape>
struct TablesOf<std::tuple<Shape...>> {
  using type = std::tuple<Table<Shape>...>;  ///< in the order of the list
};
/// A table for each shape of a list, in its order.
template <class List>
using Tables = typename TablesOf<List>::type;

}  // namespace durero::scene
