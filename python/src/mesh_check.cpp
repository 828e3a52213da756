// The audit of a mesh: its answer as the text of JSON, which Python reads.
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "durero/io/mesh/mesh_report.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

using Corners = std::array<std::int64_t, 3>;

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

std::string mesh_check_of_arrays(const std::vector<std::array<double, 3>>& vertices, const std::vector<Corners>& faces,
                                 const std::optional<std::array<double, 3>>& point) {
  std::vector<glm::dvec3> points;
  for (std::size_t n = 0; n < vertices.size(); ++n)
    points.push_back(finite_point(vertices[n], fmt::format("vertices[{}]", n)));
  std::vector<mesh::CornerNumbers> numbers;
  for (std::size_t n = 0; n < faces.size(); ++n) {
    mesh::CornerNumbers& face = numbers.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::int64_t number = faces[n][corner];
      if (number < 0 || number >= static_cast<std::int64_t>(points.size()))
        throw py::value_error(fmt::format("faces[{}, {}] is {}; expected the number of one of {} vertices", n, corner,
                                          number, points.size()));
      face[corner] = static_cast<std::uint32_t>(number);
    }
  }
  return audit(io::mesh_of(points, numbers), point);
}

}  // namespace

void add_mesh_check(py::module_& module) {
  module.def("mesh_check", mesh_check);
  module.def("mesh_check_of_arrays", mesh_check_of_arrays);
}

}  // namespace durero::python
