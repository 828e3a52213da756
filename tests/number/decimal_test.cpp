#include "durero/number/decimal.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "surds.hpp"

namespace durero::number {
namespace {

using test::anySurd;

/// What the text denotes.
Rational read(std::string text) {
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  int exponent = 0;
  if (const std::size_t e = text.find('e'); e != text.npos) {
    exponent = std::stoi(text.substr(e + 1));
    text.erase(e);
  }
  if (const std::size_t point = text.find('.'); point != text.npos) {
    exponent -= static_cast<int>(text.size() - point - 1);
    text.erase(point, 1);
  }
  text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));  // a leading 0 would make it octal
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  const Rational value = exponent >= 0 ? Rational(Integer(text) * power) : Rational(Integer(text), power);
  return negative ? Rational(-value) : value;
}

TEST_CASE("decimals of numbers that are known") {
  CHECK(decimal_text(Surd(0), 5) == "0");
  CHECK(decimal_text(Surd(Rational(5, 4)), 40) == "1.25");
  CHECK(decimal_text(Surd(Rational(-1, 3)), 5) == "-0.33333");
  CHECK(decimal_text(Surd(0, 1, 2), 40) == "1.41421356237309504880168872420969807857");
  CHECK(decimal_text(Surd(Rational(1, 2), Rational(1, 2), 5), 30) == "1.61803398874989484820458683437");
  CHECK(decimal_text(Surd(Rational(1, 2), Rational(-1, 2), 5), 10) == "-0.6180339887");
  CHECK(decimal_text(Surd(Rational(9995, 1000)), 3) == "10");
  CHECK(decimal_text(Surd(Rational(99949, 10000)), 3) == "9.99");
  CHECK(decimal_text(Surd(Integer(123000000)), 4) == "123000000");
  CHECK(decimal_text(Surd(0x1p-1074), 5) == "4.9407e-324");
  CHECK(decimal_text(Surd(exact(0x1p1023) * exact(0x1p1023)), 3) == "8.08e615");
  CHECK(decimal_text(Surd(exact(0x1p-1074) * exact(0x1p-1074)), 3) == "2.44e-647");
}

TEST_CASE("a surd is written as it stands") {
  CHECK(surd_text(Surd(Rational(3, 2))) == "3/2");
  CHECK(surd_text(Surd(Rational(3, 2), Rational(-1, 2), 5)) == "3/2 − 1/2·√(5)");
  CHECK(surd_text(Surd(1, 2, 5)) == "1 + 2·√(5)");
  CHECK(surd_text(Surd(0, -2, 5)) == "-2·√(5)");
}

/// Whether the text is within half a unit of its last digit, which is at least 10^(1 − digits) times the value.
bool is_nearest(const Surd& value, int digits) {
  const Surd difference = value - Surd(read(decimal_text(value, digits)));
  const Surd off = sign(difference) < 0 ? -difference : difference, size = sign(value) < 0 ? -value : value;
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(digits - 1));
  return off * Surd(Rational(2 * power)) <= size;
}

TEST_CASE("no decimal of as many digits is nearer") {
  for (int digits = 1; digits <= 40; ++digits) {
    for (const int n : {2, 3, 5, 7}) {
      CHECK(is_nearest(Surd(n, -1, n), digits));
      CHECK(is_nearest(Surd(n, 1, n), digits));
    }
  }
  test::property("any surd, 1 to 45 digits", [] {
    const Surd value((*anySurd()).surd());
    const int digits = *rc::gen::resize(100, rc::gen::inRange(1, 46));
    RC_PRE(sign(value) != 0);
    RC_ASSERT(is_nearest(value, digits));
  });
}

}  // namespace
}  // namespace durero::number
