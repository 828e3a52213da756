#include "rounded_map.hpp"

#include <cmath>

#include "durero/number/quotient.hpp"

namespace durero::io {
namespace {

using number::Dyadic;

struct TwoTerms {
  double value, error;
};

/// a + b = value + error, where nothing overflows (Knuth).
TwoTerms exact_sum(double a, double b) {
  const double value = a + b, of_b = value - a;
  return {value, (a - (value - of_b)) + (b - of_b)};
}

/// The leading 26 bits of a number, and the rest (Veltkamp).
TwoTerms halves(double a) {
  const double spread = (0x1p27 + 1) * a, leading = spread - (spread - a);
  return {leading, a - leading};
}

/// a · b = value + error, where nothing overflows and but for 2⁻¹⁰⁷² where something underflows (Dekker).
TwoTerms exact_product(double a, double b) {
  const auto [a1, a2] = halves(a);
  const auto [b1, b2] = halves(b);
  const double value = a * b;
  return {value, ((a1 * b1 - value) + a1 * b2 + a2 * b1) + a2 * b2};
}

}  // namespace

RoundedMap::RoundedMap(AffineMap map) : map_(std::move(map)) {
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = near(i);
}

std::optional<RoundedMap::Row> RoundedMap::near(std::size_t row) const {
  Row near;
  for (std::size_t j = 0; j < near.size(); ++j) {
    const Dyadic& exact = map_.numerator(row, j);
    if (sign(exact) == 0) continue;
    const double high = number::round_quotient(exact, map_.divisor());
    if (!(std::abs(high) > 0x1p-400 && std::abs(high) < 0x1p400)) return std::nullopt;
    const Dyadic rest = exact - Dyadic(high) * map_.divisor();
    near[j] = {high, number::round_quotient(rest, map_.divisor())};
  }
  return near;
}

glm::dvec3 RoundedMap::point(const glm::dvec3& numerators, double denominator) const {
  glm::dvec3 image;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto sure = rows_[i] && denominator == 1 ? certain(*rows_[i], numerators) : std::nullopt;
    if (!sure) return map_.point(numerators, denominator);
    image[static_cast<int>(i)] = *sure;
  }
  return image;
}

// Let A be the sum of the magnitudes of the four terms. The rows err by 2⁻¹⁰⁶ A; each low · p by as much, and its sum
// with the error of a product by 2⁻¹⁰⁵ A. The eight additions to `low` have results below 2⁻⁴⁹ A, so that each errs by
// 2⁻¹⁰² A. All that is less than 2⁻⁹⁸ A; the computed A may be too small by 2⁻⁵⁰ of itself. Underflow adds less than
// 2⁻⁸⁰⁰, since rows have no numbers beyond 2⁴⁰⁰, and rows with points beyond 2⁴⁰⁰ are not certain.
std::optional<double> RoundedMap::certain(const Row& row, const glm::dvec3& p) {
  double high = row[3].high, low = row[3].low, magnitude = std::abs(high);
  bool is_null = high == 0;
  for (int j = 0; j < 3; ++j) {
    const TwoDoubles& m = row[static_cast<std::size_t>(j)];
    if (m.high == 0 || p[j] == 0) continue;
    if (!(std::abs(p[j]) < 0x1p400)) return std::nullopt;
    is_null = false;
    const TwoTerms product = exact_product(m.high, p[j]), sum = exact_sum(high, product.value);
    high = sum.value;
    low += sum.error;
    low += product.error + m.low * p[j];
    magnitude += std::abs(product.value);
  }
  if (is_null) return 0.0;
  const TwoTerms all = exact_sum(high, low);
  const double bound = magnitude * 0x1p-97 + 0x1p-800;
  // Twice the bound, and the last term, pay for the roundings of these two sums. Rounding ascends: where both ends of
  // what the image may be round to one number, so does the image.
  const double widened = 2 * bound + std::abs(all.error) * 0x1p-50;
  const bool is_certain =
      all.value + (all.error - widened) == all.value && all.value + (all.error + widened) == all.value;
  return is_certain ? std::optional(all.value) : std::nullopt;
}

}  // namespace durero::io
