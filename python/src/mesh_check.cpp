// The audit of a mesh: its answer as the text of JSON, which Python reads.
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "durero/io/mesh/mesh_report.hpp"
#include "mesh_arrays.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

glm::dvec3 finite_point(const std::array<double, 3>& p, const std::string& name) {
  for (const double coordinate : p)
    if (!std::isfinite(coordinate))
      throw py::value_error(fmt::format("{} has {}; expected finite numbers", name, coordinate));
  return {p[0], p[1], p[2]};
}

std::string audit(const io::SceneMesh& mesh, const std::optional<std::array<double, 3>>& point) {
  std::optional<glm::dvec3> asked;
  if (point) asked = finite_point(*point, "point");
  const py::gil_scoped_release released;
  return mesh_check_json(io::check_mesh("", mesh, asked));
}

std::string mesh_check(const Scene& scene, const std::optional<std::array<double, 3>>& point) {
  return audit(io::mesh_of(scene.state()->scene()), point);
}

std::string mesh_check_of_arrays(const py::object& vertices, const py::object& faces,
                                 const std::optional<std::array<double, 3>>& point) {
  const std::vector<glm::dvec3> points = rows_of<glm::dvec3>(vertices, "vertices");
  std::vector<mesh::CornerNumbers> numbers;
  for (const auto [i, j, k] : faces_of(faces)) {
    const mesh::CornerNumbers& face = numbers.emplace_back(mesh::CornerNumbers{i, j, k});
    const auto wrong = std::ranges::find_if(face, [&](std::uint32_t number) { return number >= points.size(); });
    if (wrong != face.end())
      throw py::value_error(fmt::format("faces[{}, {}] is {}; expected the number of one of {} vertices",
                                        numbers.size() - 1, wrong - face.begin(), *wrong, points.size()));
  }
  return audit(io::mesh_of(points, numbers), point);
}

}  // namespace

void add_mesh_check(py::module_& module) {
  module.def("mesh_check", mesh_check);
  module.def("mesh_check_of_arrays", mesh_check_of_arrays);
}

}  // namespace durero::python
