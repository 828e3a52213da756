#pragma once
/// Rays and where they start, as NumPy holds them. What is not as it must be is refused by name, and nothing is
/// converted: a number that was changed on the way would be another question.

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "durero/scene/query.hpp"
#include "state.hpp"

namespace durero::python {

namespace py = pybind11;

/// Rays that stay where the caller's array has them: float64 of shape (n, 6), C-contiguous, finite, v other than 0.
class Rays {
 public:
  /// Throws py::type_error and py::value_error, which say which row and number is wrong.
  explicit Rays(const py::object& given);

  std::size_t size() const noexcept { return size_; }
  /// Any thread may ask. Throws where the caller has made a wrong ray of it since.
  model::Rayo operator[](std::size_t i) const {
    const double* n = numbers_ + 6 * i;
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }

 private:
  py::array array_;  // holds the numbers
  const double* numbers_ = nullptr;
  std::size_t size_ = 0;
};

/// The rays of one array that has one: refuses any other number of them.
model::Rayo single_ray(const Rays& rays);

/// The elements that each ray starts on: by none; by an array of the number of one for each ray, −1 for none; or by a
/// pair of arrays, offsets and numbers, of which ray i has those from offsets[i] to offsets[i + 1].
class Origins {
 public:
  /// Throws py::type_error and py::value_error.
  Origins(const py::object& given, std::size_t rays, std::int32_t elements);

  bool empty() const noexcept { return numbers_.empty(); }
  scene::ElementSet of(std::size_t ray, const Numbering& numbering) const;

 private:
  void check(const char* name, std::int64_t least, std::int32_t elements) const;

  std::optional<std::vector<std::int64_t>> offsets_;  // absent: a number for each ray
  std::vector<std::int64_t> numbers_;
};

}  // namespace durero::python
