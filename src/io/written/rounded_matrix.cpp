#include "rounded_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace durero::io {
namespace {

model::ExactVector exact_times(const model::ExactVector& v, const number::Rational& by) {
  return {v.x * by, v.y * by, v.z * by};
}

model::ExactVector exact_sum(const model::ExactVector& a, const model::ExactVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

}  // namespace

RoundedMatrix rounded_matrix(const model::Mapa& map) {
  bool is_exact = true;
  const auto rounded = [&](const number::Rational& entry) {
    const double nearest = number::round_to_binary64(entry);
    is_exact = is_exact && std::isfinite(nearest) && number::exact(nearest) == entry;
    return nearest;
  };
  const auto vector = [&](const model::ExactVector& v) {
    const double x = rounded(v.x), y = rounded(v.y), z = rounded(v.z);
    return glm::dvec3(x, y, z);
  };
  RoundedMatrix made{{vector(map.x), vector(map.y), vector(map.z)}, vector(map.centro), false};
  made.is_exact = is_exact;
  return made;
}

model::Mapa map_of_cube(const glm::dvec3& low, const glm::dvec3& high, const model::Mapa& by) {
  const auto middle = [&](int axis) {
    return number::Rational((number::exact(low[axis]) + number::exact(high[axis])) / 2);
  };
  const auto half = [&](int axis) {
    return number::Rational((number::exact(high[axis]) - number::exact(low[axis])) / 2);
  };
  const model::ExactVector aside =
      exact_sum(exact_times(by.x, middle(0)), exact_sum(exact_times(by.y, middle(1)), exact_times(by.z, middle(2))));
  return {exact_sum(by.centro, aside), exact_times(by.x, half(0)), exact_times(by.y, half(1)),
          exact_times(by.z, half(2))};
}

bool is_finite(const RoundedMatrix& matrix) {
  const auto has_numbers = [](const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  return has_numbers(matrix.origin) && std::ranges::all_of(matrix.axes, has_numbers);
}

}  // namespace durero::io
