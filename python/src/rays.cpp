#include "rays.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace durero::python {
namespace {

std::string shown(const py::handle& object) { return py::str(object); }
std::string type_of(const py::handle& object) { return py::str(py::type::of(object).attr("__name__")); }

constexpr const char* expected_rays = "expected a numpy.ndarray of float64, shape (n, 6), C-contiguous";

bool is_wrong(const double* n) {
  const bool is_finite = std::all_of(n, n + 6, [](double x) { return std::isfinite(x); });
  return !is_finite || (n[3] == 0 && n[4] == 0 && n[5] == 0);
}

/// The least row that is no ray, or their number.
std::size_t first_wrong(const double* numbers, std::size_t size) {
  using Range = tbb::blocked_range<std::size_t>;
  return tbb::parallel_reduce(
      Range(0, size, 1 << 16), size,
      [&](const Range& rows, std::size_t least) {
        for (std::size_t i = rows.begin(); i < std::min(rows.end(), least); ++i)
          if (is_wrong(numbers + 6 * i)) return i;
        return least;
      },
      [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

[[noreturn]] void refuse_row(const double* n, std::size_t row) {
  for (int i = 0; i < 6; ++i)
    if (!std::isfinite(n[i]))
      throw py::value_error(fmt::format("rays[{}, {}] is {}; expected a finite number", row, i, n[i]));
  throw py::value_error(fmt::format("rays[{}, 3:] is (0, 0, 0); expected {} ({})", row, model::Rayo_inv_1.predicate,
                                    model::Rayo_inv_1.label));
}

/// A mask or the units of another subclass would be lost; a memory map is an array like any other.
bool is_plain_array(const py::object& given) {
  if (!py::isinstance<py::array>(given)) return false;
  return !py::isinstance(given, py::module_::import("numpy.ma").attr("MaskedArray"));
}

void check_layout(const py::object& given) {
  if (!is_plain_array(given)) throw py::type_error(fmt::format("rays is a {}; {}", type_of(given), expected_rays));
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!array.dtype().equal(py::dtype::of<double>()))
    throw py::type_error(fmt::format("rays has the dtype {}; {}", shown(array.dtype().attr("str")), expected_rays));
  if (array.ndim() != 2 || array.shape(1) != 6)
    throw py::value_error(fmt::format("rays has the shape {}; {}", shown(array.attr("shape")), expected_rays));
  if ((array.flags() & py::array::c_style) == 0)
    throw py::value_error(fmt::format("rays has the strides {}; {}: numpy.ascontiguousarray(rays)",
                                      shown(array.attr("strides")), expected_rays));
  if ((array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) == 0)
    throw py::value_error("rays is not aligned in memory; expected a copy: rays.copy()");
}

/// A copy, as whole numbers; what is no array of whole numbers is refused.
std::vector<std::int64_t> whole_numbers(const py::handle& given, const std::string& name) {
  if (!py::isinstance<py::array>(given))
    throw py::type_error(fmt::format("{} is a {}; expected a numpy.ndarray of whole numbers", name, type_of(given)));
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (array.dtype().kind() != 'i')
    throw py::type_error(
        fmt::format("{} has the dtype {}; expected signed whole numbers", name, shown(array.dtype().attr("str"))));
  if (array.ndim() != 1)
    throw py::value_error(fmt::format("{} has the shape {}; expected (n,)", name, shown(array.attr("shape"))));
  const auto copy = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
  return {copy.data(), copy.data() + copy.size()};
}

}  // namespace

Rays::Rays(const py::object& given) {
  check_layout(given);
  array_ = py::reinterpret_borrow<py::array>(given);
  numbers_ = static_cast<const double*>(array_.data());
  size_ = static_cast<std::size_t>(array_.shape(0));
  const std::size_t wrong = [&] {
    const py::gil_scoped_release released;
    return first_wrong(numbers_, size_);
  }();
  if (wrong != size_) refuse_row(numbers_ + 6 * wrong, wrong);
}

model::Rayo single_ray(const Rays& rays) {
  if (rays.size() != 1) throw py::value_error(fmt::format("{} rays; expected one", rays.size()));
  return rays[0];
}

Origins::Origins(const py::object& given, std::size_t rays, std::int32_t elements) {
  if (given.is_none()) return;
  if (!py::isinstance<py::tuple>(given)) {
    numbers_ = whole_numbers(given, "en");
    if (numbers_.size() != rays)
      throw py::value_error(fmt::format("en has {} numbers; expected one for each of {} rays", numbers_.size(), rays));
    check("en", -1, elements);
    return;
  }
  const auto pair = py::reinterpret_borrow<py::tuple>(given);
  if (pair.size() != 2) throw py::value_error("en is a tuple; expected (offsets, elements)");
  offsets_ = whole_numbers(pair[0], "en[0]");
  numbers_ = whole_numbers(pair[1], "en[1]");
  if (offsets_->size() != rays + 1 || offsets_->front() != 0 || !std::is_sorted(offsets_->begin(), offsets_->end()) ||
      offsets_->back() != static_cast<std::int64_t>(numbers_.size()))
    throw py::value_error(fmt::format("en[0] has no offsets of {} rays; expected {} numbers that ascend from 0 to {}",
                                      rays, rays + 1, numbers_.size()));
  check("en[1]", 0, elements);
}

void Origins::check(const char* name, std::int64_t least, std::int32_t elements) const {
  const auto is_none = [&](std::int64_t number) { return number < least || number >= elements; };
  const auto wrong = std::find_if(numbers_.begin(), numbers_.end(), is_none);
  if (wrong != numbers_.end())
    throw py::value_error(fmt::format("{}[{}] is {}; expected {} to {}, the number of an element of the scene", name,
                                      wrong - numbers_.begin(), *wrong, least, elements - 1));
}

scene::ElementSet Origins::of(std::size_t ray, const Numbering& numbering) const {
  scene::ElementSet elements;
  const auto add = [&](std::int64_t number) {
    elements.push_back(numbering.element(static_cast<std::int32_t>(number)));
  };
  if (!offsets_) {
    if (!numbers_.empty() && numbers_[ray] >= 0) add(numbers_[ray]);
    return elements;
  }
  for (std::int64_t i = (*offsets_)[ray]; i < (*offsets_)[ray + 1]; ++i) add(numbers_[static_cast<std::size_t>(i)]);
  std::ranges::sort(elements);
  const auto repeated = std::ranges::unique(elements);
  elements.erase(repeated.begin(), repeated.end());
  return elements;
}

}  // namespace durero::python
