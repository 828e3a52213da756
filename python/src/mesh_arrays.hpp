#pragma once
/// The arrays of a mesh, as NumPy holds them.

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <cmath>
#include <vector>

#include "bindings.hpp"
#include "durero/model/cara.hpp"

namespace durero::python {

/// An array of two dimensions, with so many columns, of one of the kinds of NumPy; messages call it `name`, and what it
/// holds `numbers`. Throws py::type_error and py::value_error.
py::array checked_table(const py::object& given, const char* name, py::ssize_t columns, const char* kinds,
                        const char* numbers);

/// Faces: three whole numbers each. Throws as checked_table does.
std::vector<model::Cara> faces_of(const py::object& given);

/// Rows of so many finite numbers, of float64 or float32. Throws as checked_table does.
template <class Row>
std::vector<Row> rows_of(const py::object& given, const char* name) {
  constexpr py::ssize_t columns = Row::length();
  const py::array array = checked_table(given, name, columns, "f", "float64 or float32, finite");
  if (array.itemsize() != 8 && array.itemsize() != 4)
    throw py::type_error(fmt::format("{} has another dtype; expected float64 or float32", name));
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>(array);  // each as it is
  std::vector<Row> rows(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (py::ssize_t j = 0; j < columns; ++j) {
      const double x = numbers.data()[static_cast<py::ssize_t>(i) * columns + j];
      if (!std::isfinite(x))
        throw py::value_error(fmt::format("{}[{}, {}] is {}; expected a finite number", name, i, j, x));
      rows[i][static_cast<int>(j)] = x;
    }
  return rows;
}

}  // namespace durero::python
