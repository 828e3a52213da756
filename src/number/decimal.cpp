#include "durero/number/decimal.hpp"

#include <cmath>

namespace durero::number {
namespace {

Integer power_of_ten(int k) { return boost::multiprecision::pow(Integer(10), static_cast<unsigned>(k)); }

Rational scale(int k) { return k >= 0 ? Rational(power_of_ten(k)) : Rational(1, power_of_ten(-k)); }

Integer floor_quotient(const Integer& a, const Integer& b) {
  Integer quotient, rest;
  divide_qr(a, b, quotient, rest);
  return rest < 0 ? Integer(quotient - 1) : quotient;
}

/// ⌊value⌋. With x = m/n, y² · delta = p/q and s the sign of y, the value is (m·q + s·√(n²·p·q))/(n·q); and
/// ⌊(a ± √N)/c⌋ of integers is that of a and √N rounded to an integer, down for + and up for −.
Integer floor_of(const Surd& value) {
  const Rational square = value.y * value.y * value.delta;
  const Integer n = denominator(value.x), q = denominator(square);
  const Integer under_root = n * n * numerator(square) * q;
  Integer root = sqrt(under_root);
  if (sign(value.y) < 0) root = root * root == under_root ? Integer(-root) : Integer(-root - 1);
  return floor_quotient(numerator(value.x) * q + root, n * q);
}

/// The nearest integer to value · 10^k; a tie goes up.
Integer rounded(const Surd& value, int k) { return floor_of(value * Surd(scale(k)) + Surd(Rational(1, 2))); }

/// Digits and exponent as people write them.
std::string written(std::string digits, int exponent) {
  digits.erase(digits.find_last_not_of('0') + 1);
  const int count = static_cast<int>(digits.size());
  if (exponent >= 0 && exponent < 21) {
    if (count <= exponent + 1) return digits + std::string(static_cast<std::size_t>(exponent) + 1 - digits.size(), '0');
    return digits.insert(static_cast<std::size_t>(exponent) + 1, ".");
  }
  if (exponent < 0 && exponent >= -6) return "0." + std::string(static_cast<std::size_t>(-exponent) - 1, '0') + digits;
  if (count > 1) digits.insert(1, ".");
  return digits + "e" + std::to_string(exponent);
}

}  // namespace

std::string decimal_text(const Surd& value, int digits) {
  if (sign(value) == 0) return "0";
  if (sign(value) < 0) return "-" + decimal_text(-value, digits);
  // k places behind the point give that many digits, or one more where the rounding carries.
  const double near = std::abs(round_to_binary64(value));
  int k = digits - 1 - static_cast<int>(std::floor(std::log10(std::clamp(near, 0x1p-1074, 0x1.fffffffffffffp1023))));
  for (;;) {
    const std::string text = rounded(value, k).str();
    const int surplus = text == "0" ? -digits : static_cast<int>(text.size()) - digits;
    if (surplus == 0) return written(text, digits - 1 - k);
    k -= surplus;
  }
}

std::string surd_text(const Surd& value) {
  if (value.y == 0) return value.x.str();
  const std::string root = Rational(abs(value.y)).str() + "·√(" + value.delta.str() + ")";
  if (value.x == 0) return (sign(value.y) < 0 ? "-" : "") + root;
  return value.x.str() + (sign(value.y) < 0 ? " − " : " + ") + root;
}

}  // namespace durero::number
