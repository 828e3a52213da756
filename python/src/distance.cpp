// How far points are from a scene, and what is nearest.
#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bindings.hpp"
#include "blocks.hpp"
#include "durero/distance/distances.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

/// A row of the array that answers. `element` is the first by name, `tied` says that there are more.
struct ProximityRow {
  std::uint8_t count;
  bool tied;
  std::int32_t element;
  double distance;
  double point[3];
};

/// The points, refused by name where they are not as they must be; nothing is converted.
py::array checked_points(const py::object& given) {
  constexpr const char* expected = "expected a numpy.ndarray of float64, shape (n, 3), C-contiguous, finite";
  if (!py::isinstance<py::array>(given)) throw py::type_error(fmt::format("points is no array; {}", expected));
  auto array = py::reinterpret_borrow<py::array>(given);
  if (!array.dtype().equal(py::dtype::of<double>()))
    throw py::type_error(fmt::format("points has another dtype; {}", expected));
  constexpr int layout = int{py::array::c_style} | int{py::detail::npy_api::NPY_ARRAY_ALIGNED_};
  if (array.ndim() != 2 || array.shape(1) != 3 || (array.flags() & layout) != layout)
    throw py::value_error(fmt::format("points has another shape or layout; {}", expected));
  const auto* const numbers = static_cast<const double*>(array.data());
  for (py::ssize_t i = 0; i < 3 * array.shape(0); ++i)
    if (!std::isfinite(numbers[i]))
      throw py::value_error(fmt::format("points[{}, {}] is {}; expected a finite number", i / 3, i % 3, numbers[i]));
  return array;
}

ProximityRow row_of(const scene::Proximity& found, const Numbering& numbering) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  ProximityRow row{static_cast<std::uint8_t>(found.count), found.elementos.size() > 1, -1, none, {none, none, none}};
  if (found.count == scene::NearestCount::none) return row;
  const auto by_number = [&](scene::ElementRef a, scene::ElementRef b) {
    return numbering.number(a) < numbering.number(b);
  };
  row.element = numbering.number(*std::ranges::min_element(found.elementos, by_number));
  row.distance = found.distance;
  for (int i = 0; i < 3; ++i) row.point[i] = found.point[i];
  return row;
}

py::array_t<ProximityRow> distance(const Scene& scene, const py::object& given) {
  const std::shared_ptr<const State> state = scene.state();
  require_own_shapes(*state, "distance");
  const py::array points = checked_points(given);
  const auto* const numbers = static_cast<const double*>(points.data());
  const auto size = static_cast<std::size_t>(points.shape(0));
  py::array_t<ProximityRow> answers(points.shape(0));
  ProximityRow* const rows = answers.mutable_data();
  const Numbering& numbering = state->numbering();
  const distance::Distances distances(state->scene());
  for_each_block(size, [&](std::size_t begin, std::size_t end) {
    distance::DistanceWork unseen;
    for (std::size_t i = begin; i < end; ++i)
      rows[i] = row_of(distances.nearest({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}, unseen), numbering);
  });
  return answers;
}

}  // namespace

void add_distance(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ProximityRow, count, tied, element, distance, point);
  module.attr("proximity_dtype") = py::dtype::of<ProximityRow>();
  module.def("distance", distance);
}

}  // namespace durero::python
