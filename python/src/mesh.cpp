// Meshes: added, replaced and read as arrays of NumPy.
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "bindings.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/stage.hpp"
#include "errors.hpp"
#include "mesh_arrays.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

model::Elemento name_of(const std::string& m) {
  if (!model::Elemento::is_name(m))
    throw py::value_error(fmt::format("{} is no name; expected 1 to 128 of A-Z a-z 0-9 _ . : -", m));
  return model::Elemento(m);
}

std::uint32_t material_of(const Scene& scene, const std::optional<std::string>& name) {
  if (!name) return scene::no_material;
  const auto& all = scene.value().stage().materials;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name == *name) return static_cast<std::uint32_t>(i);
  throw py::value_error(fmt::format("no material {}; expected one of the scene's", *name));
}

scene::Mesh mesh_of(const Scene& scene, const std::string& m, const py::object& vertices, const py::object& faces,
                    const py::object& normals, const py::object& uv, const std::optional<std::string>& material) {
  scene::Mesh mesh{name_of(m)};
  mesh.puntos = rows_of<glm::dvec3>(vertices, "vertices");
  mesh.caras = faces_of(faces);
  mesh.material = material_of(scene, material);
  if (!normals.is_none()) mesh.normals = rows_of<glm::dvec3>(normals, "normals");
  if (!uv.is_none()) mesh.uv = rows_of<glm::dvec2>(uv, "uv");
  return mesh;
}

/// r!; raises Refused.
template <class Edit>
std::string done(Scene& scene, Edit edit, std::string_view operation, const std::string& m) {
  const io::EditAnswer answer = scene.history().apply_total(scene.edited(), {1, scene::MeshEdit(std::move(edit))});
  if (answer.ok()) return answer.r;
  py::dict inputs;
  inputs["m"] = m;
  raise("Refused", answer.violated, answer.predicate, answer.r, std::string(operation), inputs, 1);
}

std::string add_mesh(Scene& scene, const std::string& m, const py::object& vertices, const py::object& faces,
                     const py::object& normals, const py::object& uv, const std::optional<std::string>& material,
                     bool replace) {
  scene::Mesh mesh = mesh_of(scene, m, vertices, faces, normals, uv, material);
  if (replace) return done(scene, scene::MeshReplacement{std::move(mesh)}, "Reemplazar_Malla", m);
  return done(scene, scene::MeshAddition{std::move(mesh)}, "Agregar_Malla", m);
}

std::vector<std::string> meshes(const Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.value().meshes().size(); ++i) names.push_back(scene.value().meshes()[i].m.name());
  return names;
}

/// A copy of rows of numbers.
template <class Number, class Row>
py::array table_of(const std::vector<Row>& rows, py::ssize_t columns) {
  static_assert(sizeof(Row) % sizeof(Number) == 0);
  py::array_t<Number> table({static_cast<py::ssize_t>(rows.size()), columns});
  if (!rows.empty()) std::memcpy(table.mutable_data(), rows.data(), rows.size() * sizeof(Row));
  return std::move(table);
}

/// Its vertices, faces, normals, uv and material.
py::tuple mesh(const Scene& scene, const std::string& m) {
  const auto place = scene.value().meshes().find(m);
  if (!place) throw py::key_error(m);
  const scene::Mesh& found = scene.value().meshes()[*place];
  std::vector<glm::dvec3> points;
  points.reserve(found.puntos.size());
  for (const glm::dvec3 p : found.puntos) points.push_back(p);
  const auto optional = [](bool is_there, auto&& make) { return is_there ? py::object(make()) : py::none(); };
  return py::make_tuple(table_of<double>(points, 3), table_of<std::uint32_t>(found.caras, 3),
                        optional(!found.normals.empty(), [&] { return table_of<double>(found.normals, 3); }),
                        optional(!found.uv.empty(), [&] { return table_of<double>(found.uv, 2); }),
                        optional(found.material != scene::no_material,
                                 [&] { return py::str(scene.value().stage().materials[found.material].name); }));
}

/// For each element, by number: the place of its mesh and the number of its face, −1 where it is in none.
py::array faces(const Scene& scene) {
  const auto state = scene.state();
  const Numbering& numbering = state->numbering();
  py::array_t<std::int32_t> table({static_cast<py::ssize_t>(numbering.size()), py::ssize_t{2}});
  std::int32_t* row = table.mutable_data();
  const scene::Meshes& all = state->scene().meshes();
  std::size_t place = 0;
  for (std::int32_t i = 0; i < numbering.size(); ++i) {
    const auto face = state->scene().face(numbering.element(i));
    if (face)
      while (&all[place] != &face->mesh) ++place;  // faces stand in the order of the meshes
    *row++ = face ? static_cast<std::int32_t>(place) : -1;
    *row++ = face ? static_cast<std::int32_t>(face->number) : -1;
  }
  return std::move(table);
}

}  // namespace

void add_meshes(py::module_& module) {
  module.def("add_mesh", add_mesh);
  module.def("meshes", meshes);
  module.def("mesh", mesh);
  module.def("faces", faces);
}

}  // namespace durero::python
