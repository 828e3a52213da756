#include "durero/number/quotient.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/nearest.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

using test::anyFinite;
using test::nonZero;

TEST_CASE("a quotient is rounded once") {
  test::property("of products of binary64", [] {
    const Dyadic n = Dyadic(*anyFinite()) * Dyadic(*anyFinite());
    const Dyadic d = Dyadic(*nonZero(anyFinite())) * Dyadic(*nonZero(anyFinite()));
    const Rational value = n.rational() / d.rational();
    RC_ASSERT(
        test::is_nearest(round_quotient(n, d), [&](const Rational& m) { return sign(Rational(value - m)) <=> 0; }));
  });
  test::property("of two binary64, as the machine divides them", [] {
    const double n = *anyFinite(), d = *nonZero(anyFinite());
    RC_PRE(n != 0);
    RC_ASSERT(round_quotient(Dyadic(n), Dyadic(d)) == n / d);
  });
  test::property("of integers of any length", [] {
    const Integer n = numerator(exact(*anyFinite())), d = numerator(exact(*nonZero(anyFinite())));
    RC_ASSERT(round_quotient(n, d) == round_to_binary64(Rational(n, d)));
  });
}

TEST_CASE("a quotient beside the middle of two binary64 is rounded to its side, however near it is") {
  const Integer middle = (Integer(1) << 53) + 1, d = Integer(1) << 5000;
  CHECK(round_quotient(Integer(middle * d), d) == 0x1p53);
  CHECK(round_quotient(Integer(middle * d + 1), d) == 0x1p53 + 2);
  CHECK(round_quotient(Integer(middle * d - 1), d) == 0x1p53);
}

TEST_CASE("a quotient that is 0 is +0; one that is too small or too great has its sign") {
  CHECK_FALSE(std::signbit(round_quotient(Dyadic(0), Dyadic(-3))));
  CHECK_FALSE(std::signbit(round_quotient(Integer(0), Integer(-3))));
  const double small = round_quotient(Dyadic(-1), shifted(Dyadic(3), 2000));
  CHECK(small == 0);
  CHECK(std::signbit(small));
  CHECK(round_quotient(shifted(Dyadic(1), 2000), Dyadic(-3)) == -std::numeric_limits<double>::infinity());
  CHECK(round_quotient(Integer(1), Integer(3)) == 1.0 / 3);
}

TEST_CASE("a root is cut after its bits, and says whether that was all") {
  test::property("value ≤ √of < value + unit", [] {
    const Dyadic of = Dyadic(std::abs(*nonZero(anyFinite())));
    const auto bits = *rc::gen::resize(100, rc::gen::inRange(2, 700));
    const SquareRoot root = square_root(of, bits);
    RC_ASSERT(square(root.value) <= of);
    RC_ASSERT(of < square(root.value + root.unit));
    RC_ASSERT(root.exact == (square(root.value) == of));
    RC_ASSERT(shifted(root.unit, bits - 1) <= root.value);  // it has as many bits as were asked for
  });
  test::property("the root of a square of few bits is exact", [] {
    const Dyadic value = Dyadic(std::abs(*nonZero(anyFinite())));
    const SquareRoot root = square_root(square(value), 60);
    RC_ASSERT(root.exact);
    RC_ASSERT(root.value == value);
  });
  CHECK_FALSE(square_root(2, 600).exact);
  CHECK_FALSE(square_root(square(Dyadic(1) + shifted(Dyadic(1), -200)), 100).exact);
}

}  // namespace
}  // namespace durero::number
