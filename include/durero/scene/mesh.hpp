#pragma once
/// A mesh, as the compact tables hold it, apart from the other elements (sueltas.def.1 of spec/malla.tex): each point
/// stands once, a face is the numbers of three of them, and the name of a face is made of the mesh's own.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/model/cara.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/mesh_points.hpp"
#include "durero/scene/shape/triangle.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "durero/scene/wrap.hpp"

namespace durero::scene {

/// The index of a material that stands for none.
inline constexpr std::uint32_t no_material = std::numeric_limits<std::uint32_t>::max();

/// Points and faces under one name (an entry of `mallas`, and its Red). Its faces are triangles of the scene.
struct Mesh {
  model::Elemento m;                     ///< its name
  MeshPoints puntos{};                   ///< by number
  std::vector<model::Cara> caras{};      ///< by number
  std::uint32_t material = no_material;  ///< an index into the materials of the stage, or no_material
  std::vector<glm::dvec3> normals{};     ///< of the points; none, or one for each, of any finite length but 0
  std::vector<glm::dvec2> uv{};          ///< of the points, linear in between; none, or one for each

  /// The triangle of a face (terna.def.1). Precondition: there is the face, and its points.
  Triangle triangle(std::uint32_t face) const noexcept {
    const auto [i, j, k] = caras[face];
    return {{puntos[i], puntos[j], puntos[k]}};
  }
};

/// The meshes of a scene, ascending by name. Their faces are numbered one mesh behind the other. Copies share what they
/// hold until one of them is edited.
class Meshes {
 public:
  /// A face of a mesh.
  struct Face {
    const Mesh& mesh;      ///< whose
    std::uint32_t number;  ///< which of its faces
  };

  /// How many meshes there are.
  std::size_t size() const noexcept { return meshes_.size(); }
  /// How many faces they have together.
  std::uint32_t faces() const noexcept { return first_.back(); }
  /// The mesh of a place. Precondition: place < size().
  const Mesh& operator[](std::size_t place) const noexcept { return *meshes_[place]; }
  /// The place of the mesh of a name; nothing where there is none.
  std::optional<std::size_t> find(std::string_view m) const noexcept;

  /// The face of a number among all. Precondition: number < faces().
  Face face(std::uint32_t number) const noexcept;
  /// The number, among all, of the face of a name; nothing where none has it.
  std::optional<std::uint32_t> find_face(std::string_view name) const noexcept;

  /// Adds a mesh, or replaces the one of its name.
  void put(Mesh mesh);
  /// Removes a mesh. Precondition: place < size().
  void remove(std::size_t place);
  /// A mesh, to be edited: a copy of it where another scene shares it. Precondition: place < size(); its number of
  /// faces stays.
  Mesh& edited(std::size_t place);

 private:
  void number_faces();

  std::vector<std::shared_ptr<Mesh>> meshes_;
  std::vector<std::uint32_t> first_{0};  // the first face of each mesh, and the number of all behind them
};

/// The number of the face of the mesh m that a name says (nombre_cara.def.1); nothing where it is none of its names.
std::optional<std::uint32_t> face_number(std::string_view m, std::string_view name) noexcept;

/// The triangles of a scene: those that are elements by themselves, then the faces of its meshes. Valid until the next
/// edit of the scene.
class Triangles {
 public:
  /// Both must outlive it.
  Triangles(std::span<const Triangle> singles, const Meshes& meshes) noexcept : singles_(singles), meshes_(&meshes) {}

  /// How many there are of both.
  std::size_t size() const noexcept { return singles_.size() + meshes_->faces(); }
  /// There is none.
  bool empty() const noexcept { return size() == 0; }
  /// Precondition: row < size().
  Triangle operator[](std::size_t row) const noexcept {
    if (row < singles_.size()) return singles_[row];
    const Meshes::Face face = meshes_->face(static_cast<std::uint32_t>(row - singles_.size()));
    return face.mesh.triangle(face.number);
  }

  /// @{ The first, and behind the last.
  RowIterator<Triangles> begin() const noexcept { return {*this, 0}; }
  RowIterator<Triangles> end() const noexcept { return {*this, size()}; }
  /// @}

 private:
  std::span<const Triangle> singles_;
  const Meshes* meshes_;
};

}  // namespace durero::scene
