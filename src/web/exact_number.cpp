#include "exact_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "durero/number/surd.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

using number::Integer;
using number::Rational;
using number::Surd;

Integer power_of_ten(int exponent) { return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent)); }

Rational scale(int exponent) {
  return exponent < 0 ? Rational(1) / Rational(power_of_ten(-exponent)) : Rational(power_of_ten(exponent));
}

/// ⌊a/b⌋. Precondition: b > 0.
Integer floor_quotient(const Integer& a, const Integer& b) {
  Integer quotient = a / b;
  if (quotient * b > a) --quotient;
  return quotient;
}

Integer floor_of(const Rational& value) { return floor_quotient(numerator(value), denominator(value)); }

/// ⌊value⌋. The root √r of a fraction r = n/d is √(n·d)/d, whose integer part is found by that of √(n·d); what is then
/// off by less than two is put right by exact comparisons.
Integer floor_of(const Surd& value) {
  if (value.y == 0) return floor_of(value.x);
  const Rational square = value.y * value.y * value.delta;
  const Integer n = numerator(square), d = denominator(square);
  const Integer root = boost::multiprecision::sqrt(Integer(n * d));
  const Rational near = value.x + Rational(value.y > 0 ? root : Integer(-root), d);
  Integer floor = floor_of(near);
  while (compare(Surd(Rational(floor)), value) > 0) --floor;
  while (compare(Surd(Rational(floor + 1)), value) <= 0) ++floor;
  return floor;
}

Surd scaled(const Surd& value, int exponent) {
  const Rational by = scale(exponent);
  return value.y == 0 ? Surd(Rational(value.x * by)) : Surd(value.x * by, value.y * by, value.delta);
}

/// Significant digits as an integer: ⌊value·10^exponent⌋ has told_digits digits.
struct SignificantDigits {
  Integer digits;
  int exponent;
};

/// Precondition: value > 0. Each turn corrects the exponent by the number of digits that are too many or too few; from
/// a digit on that is within one of the right one, and from none it goes up by 300, which passes no positive binary64
/// more than twice.
SignificantDigits significant_digits(const Surd& value) {
  int exponent = told_digits;
  for (;;) {
    const Integer floor = floor_of(scaled(value, exponent));
    const int count = floor == 0 ? 0 : static_cast<int>(floor.str().size());
    if (count == told_digits) return {floor, exponent};
    exponent += count == 0 ? 300 : told_digits - count;
  }
}

/// The digits with their point, of which the first `before` stand before it; fewer than 0 mean zeros behind it.
/// `rest` stands behind them.
std::string placed(const std::string& digits, int before, const char* rest) {
  const auto count = static_cast<int>(digits.size());
  const auto zeros = [](int many) { return std::string(static_cast<std::size_t>(many), '0'); };
  const auto cut = [&](int at) {
    const auto point = static_cast<std::size_t>(at);
    return digits.substr(0, point) + (count > at ? "." + digits.substr(point) : "") + rest;
  };
  if (before > told_digits || before < -6) return cut(1) + fmt::format("e{}", before - 1);
  if (before <= 0) return "0." + zeros(-before) + digits + rest;
  return count <= before ? digits + zeros(before - count) + rest : cut(before);
}

std::string digits_of_surd(const Surd& value) {
  const int side = sign(value);
  if (side == 0) return "0";
  const Surd magnitude = side < 0 ? -value : value;
  const auto [digits, exponent] = significant_digits(magnitude);
  const bool is_whole = compare(Surd(Rational(digits)), scaled(magnitude, exponent)) == 0;
  std::string text = digits.str();
  if (is_whole) text.erase(text.find_last_not_of('0') + 1);
  return (side < 0 ? "-" : "") + placed(text, told_digits - exponent, is_whole ? "" : "…");
}

}  // namespace

std::string digits_of(const number::DyadicSurd& value) { return digits_of_surd(Surd(value)); }

std::string fraction(const number::Dyadic& value) { return value.rational().str(); }

std::string exact_number(const number::DyadicSurd& value) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Surd exact(value);
  const double rounded = number::round_to_binary64(value);
  return ObjectText()
      .member("x", exact.x.str())
      .member("y", exact.y.str())
      .member("delta", exact.y == 0 ? std::string("0") : exact.delta.str())
      .member("digits", digits_of_surd(exact))
      .member("binary64", rounded)
      .member("hex", fmt::format("{:a}", rounded))
      .member("below", std::nextafter(rounded, -infinity))
      .member("above", std::nextafter(rounded, infinity))
      .text();
}

double distance_between(const number::DyadicSurd& a, const number::DyadicSurd& b) {
  if (compare(a, b) == 0) return 0;
  const Surd from(a), to(b);
  for (int exponent = told_digits;; exponent *= 2) {
    // Each integer part is off by less than one, so the difference of 10¹² and more by less than 10⁻¹² of itself.
    const Integer apart = floor_of(scaled(to, exponent)) - floor_of(scaled(from, exponent));
    if (apart > power_of_ten(12)) return number::round_to_binary64(Rational(Rational(apart) * scale(-exponent)));
  }
}

}  // namespace durero::web
