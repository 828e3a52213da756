#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/transform.hpp"

namespace durero::io {
namespace {

/// The columns of a matrix, and where the origin goes.
AffineMap of_columns(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& shift) {
  return AffineMap::of_matrix({x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, shift.x, shift.y, shift.z, 1});
}

bool has_numbers(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

/// By how much a matrix stretches all lengths, where it exchanges and reverses axes and does nothing else besides. One
/// whose rows have several numbers may be a turn that its text rounds, which no number proves.
std::optional<double> exact_scale(const std::array<double, 16>& m) {
  double scale = 0;
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t in_column = 0, in_row = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      const double entry = std::abs(m[4 * column + row]);
      in_column += entry != 0;
      in_row += m[4 * row + column] != 0;
      if (entry != 0 && scale != 0 && entry != scale) return std::nullopt;
      if (entry != 0) scale = entry;
    }
    if (in_column != 1 || in_row != 1) return std::nullopt;
  }
  return scale / m[15];
}

/// The formula of a turn about a unit vector, with whatever vector.
AffineMap turned_by_formula(const glm::dvec3& axis, const CosineSine& by) {
  const auto column = [&](int i) {
    glm::dvec3 e(0);
    e[i] = 1;
    return by.cosine * e + by.sine * glm::cross(axis, e) + (1 - by.cosine) * axis[i] * axis;
  };
  return of_columns(column(0), column(1), column(2), glm::dvec3(0));
}

}  // namespace

AffinePlacement AffinePlacement::translation(const glm::dvec3& by) {
  return {of_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by), 1, 0};
}

AffinePlacement AffinePlacement::scaling(const glm::dvec3& by) {
  return of_matrix({by.x, 0, 0, 0, 0, by.y, 0, 0, 0, 0, by.z, 0, 0, 0, 0, 1});
}

std::optional<AffinePlacement> AffinePlacement::rotation(const glm::dvec3& axis, double degrees) {
  const double longest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  if (longest == 0) return std::nullopt;
  const glm::dvec3 unit = glm::normalize(axis / longest);
  return AffinePlacement{turned_by_formula(unit, turn_of(degrees)), 1, 1};
}

AffinePlacement AffinePlacement::turn_unscaled(const glm::dvec3& axis, double degrees) {
  return AffinePlacement{turned_by_formula(axis, turn_of(degrees)), std::nullopt, 1};
}

AffinePlacement AffinePlacement::of_matrix(const std::array<double, 16>& matrix) {
  return {AffineMap::of_matrix(matrix), exact_scale(matrix), 1};
}

std::optional<AffinePlacement> AffinePlacement::looking(const glm::dvec3& from, const glm::dvec3& at,
                                                        const glm::dvec3& up) {
  const glm::dvec3 way = glm::normalize(at - from), side = glm::normalize(glm::cross(glm::normalize(up), way));
  if (!has_numbers(way) || !has_numbers(side)) return std::nullopt;
  return AffinePlacement{of_columns(side, glm::cross(way, side), way, from), 1, 1};
}

AffinePlacement AffinePlacement::after(const AffinePlacement& inner) const {
  return {map.after(inner.map), scale && inner.scale ? std::optional(*scale * *inner.scale) : std::nullopt,
          steps + inner.steps};
}

std::optional<AffinePlacement> AffinePlacement::inverse() const {
  auto back = map.inverse();
  if (!back) return std::nullopt;
  return AffinePlacement{std::move(*back), scale ? std::optional(1 / *scale) : std::nullopt, steps};
}

model::Mapa AffinePlacement::mapa() const {
  const number::Rational divisor = map.divisor().rational();
  const auto column = [&](std::size_t j) {
    const auto entry = [&](std::size_t i) { return number::Rational(map.numerator(i, j).rational() / divisor); };
    return model::ExactVector{entry(0), entry(1), entry(2)};
  };
  return {column(3), column(0), column(1), column(2)};
}

}  // namespace durero::io
