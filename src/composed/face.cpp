#include "composed/face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace durero::composed {
namespace {

/// Of the two numbers whose products a form has: the coordinates and one.
using Four = std::array<Dyadic, 4>;

Dyadic magnitude(const Dyadic& value) { return sign(value) < 0 ? -value : value; }

/// Half a unit in the last place at most: 2⁻⁵³ of a normal number, 2⁻¹⁰⁷⁵ of another.
Dyadic rounding_of(const Dyadic& value) {
  return number::shifted(magnitude(value), -53) + Dyadic(number::Integer(1), -1075);
}

Dyadic value_at(const SpaceForm<Dyadic>& form, const Four& w) {
  Dyadic sum;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      const Dyadic term = form.coefficients()[matrix_place(i, j)] * w[i] * w[j];
      sum += i == j ? term : number::shifted(term, 1);
    }
  return sum;
}

// Times a power of two, so that the greatest coefficient is of magnitude 1 … 2.
SpaceForm<Dyadic> scaled(const SpaceForm<Dyadic>& form) {
  std::int64_t greatest = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic& each : form.coefficients())
    if (sign(each) != 0) greatest = std::max(greatest, number::floor_log2(each));
  std::array<Dyadic, matrix_places> m = form.coefficients();
  for (Dyadic& each : m) each = number::shifted(each, -greatest);
  return SpaceForm<Dyadic>(std::move(m));
}

SpaceForm<Dyadic> magnitudes(const SpaceForm<Dyadic>& form) {
  std::array<Dyadic, matrix_places> m = form.coefficients();
  std::ranges::transform(m, m.begin(), magnitude);
  return SpaceForm<Dyadic>(std::move(m));
}

std::array<double, matrix_places> rounded(const SpaceForm<Dyadic>& form) {
  std::array<double, matrix_places> m{};
  std::ranges::transform(form.coefficients(), m.begin(),
                         [](const Dyadic& each) { return number::round_to_binary64(each); });
  return m;
}

}  // namespace

SolidFace::SolidFace(const SpaceForm<Dyadic>& form)
    : form_(scaled(form)), magnitudes_(magnitudes(form_)), rough_(roughly(form_)), rounded_(rounded(form_)) {}

// Computed in binary64, a value errs by less than 2⁻⁴⁸ of the sum of the magnitudes of its terms, each of which has at
// most four roundings and is added in at most nine; half a unit in each coordinate changes it by less than 2⁻⁵⁰ of that
// sum. What underflows is far below 2⁻⁹⁵⁰. So a value above 2⁻⁴⁴ of the sum, computed too, is not 0 nearby.
bool SolidFace::is_surely_far(const glm::dvec3& w) const {
  const std::array<double, 4> at{w.x, w.y, w.z, 1};
  double value = 0, sum = 0;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      const double term = (i == j ? 1 : 2) * rounded_[matrix_place(i, j)] * at[i] * at[j];
      value += term;
      sum += std::abs(term);
    }
  return std::isfinite(sum) && sum > 0x1p-900 && std::abs(value) > 0x1p-44 * sum;
}

// |f(w + d) − f(w)| ≤ F(|w| + δ) − F(|w|) for |dᵢ| ≤ δᵢ, where F has the magnitudes of the coefficients.
bool SolidFace::may_hold_near(const glm::dvec3& rounded) const {
  if (is_surely_far(rounded)) return false;
  Four w, size, beyond;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    w[axis] = rounded[i];
    size[axis] = magnitude(w[axis]);
    beyond[axis] = size[axis] + rounding_of(w[axis]);
  }
  w[3] = size[3] = beyond[3] = 1;
  return magnitude(value_at(form_, w)) <= value_at(magnitudes_, beyond) - value_at(magnitudes_, size);
}

glm::dvec3 SolidFace::gradient(const glm::dvec3& w) const {
  const auto of = [&](std::size_t i) {
    const auto m = [&](std::size_t j) { return rounded_[matrix_place(i, j)]; };
    return 2 * (m(0) * w.x + m(1) * w.y + m(2) * w.z + m(3));
  };
  return {of(0), of(1), of(2)};
}

double SolidFace::value(const glm::dvec3& w) const {
  const auto of = [&](std::size_t i) {
    const auto m = [&](std::size_t j) { return rounded_[matrix_place(i, j)]; };
    return m(0) * w.x + m(1) * w.y + m(2) * w.z + m(3);
  };
  return w.x * of(0) + w.y * of(1) + w.z * of(2) + of(3);
}

int multiple(const SpaceForm<Dyadic>& a, const SpaceForm<Dyadic>& b) {
  const auto &m = a.coefficients(), &n = b.coefficients();
  const auto first =
      static_cast<std::size_t>(std::ranges::find_if(n, [](const Dyadic& each) { return sign(each) != 0; }) - n.begin());
  for (std::size_t i = 0; i < matrix_places; ++i)
    if (m[i] * n[first] != m[first] * n[i]) return 0;
  return sign(m[first]) * sign(n[first]);
}

}  // namespace durero::composed
