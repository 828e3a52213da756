#include "mesh_arrays.hpp"

#include <fmt/core.h>

#include <cstring>
#include <limits>

namespace durero::python {
namespace {

/// The shape that messages name: (n, 3).
std::string shape_text(py::ssize_t columns) { return fmt::format("(n, {})", columns); }

}  // namespace

py::array checked_table(const py::object& given, const char* name, py::ssize_t columns, const char* kinds,
                        const char* numbers) {
  const std::string expected = fmt::format("expected a numpy.ndarray of {}, shape {}", numbers, shape_text(columns));
  if (!py::isinstance<py::array>(given)) throw py::type_error(fmt::format("{} is no array; {}", name, expected));
  auto array = py::reinterpret_borrow<py::array>(given);
  const bool is_swapped = array.dtype().byteorder() == '>';
  if (std::strchr(kinds, array.dtype().kind()) == nullptr || is_swapped)
    throw py::type_error(fmt::format("{} has another dtype; {}", name, expected));
  if (array.ndim() != 2 || array.shape(1) != columns)
    throw py::value_error(fmt::format("{} has another shape; {}", name, expected));
  return array;
}

std::vector<model::Cara> faces_of(const py::object& given) {
  const py::array array = checked_table(given, "faces", 3, "iu", "whole numbers");
  std::vector<model::Cara> faces(static_cast<std::size_t>(array.shape(0)));
  const auto numbers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
  const std::int64_t* const first = numbers.data();
  const auto ordinal = [&](std::size_t at) {
    const std::int64_t number = first[at];
    if (number < 0 || number > std::numeric_limits<model::Ordinal>::max())
      throw py::value_error(
          fmt::format("faces[{}, {}] is {}; expected the number of a vertex, from 0", at / 3, at % 3, number));
    return static_cast<model::Ordinal>(number);
  };
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = {ordinal(3 * i), ordinal(3 * i + 1), ordinal(3 * i + 2)};
  return faces;
}

}  // namespace durero::python
