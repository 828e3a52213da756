// The evaluator's reals against the number layer's, in and beyond the reach of a machine word.
#include "durero/zed/value/real.hpp"

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

namespace durero::zed {
namespace {

using number::Rational;
using number::Surd;

bool is(const Real& real, const Rational& value) {
  return real.is_surd() && real.surd().y.is_zero() && real.surd().x == value;
}

TEST_CASE("arithmetic and order are those of the rationals") {
  const auto check = [](double x, double y) {
    const Rational p = number::exact(x), q = number::exact(y);
    RC_ASSERT(is(Real(x) + Real(y), p + q));
    RC_ASSERT(is(Real(x) - Real(y), p - q));
    RC_ASSERT(is(Real(x) * Real(y), p * q));
    RC_ASSERT(is(Real(x) * Real(y) * Real(y) - Real(x), p * q * q - p));
    RC_ASSERT((Real(x) < Real(y)) == (p < q));
    RC_ASSERT((Real(x) == Real(y)) == (p == q));
    RC_ASSERT(sign(Real(x)) == p.sign());
    if (!q.is_zero()) RC_ASSERT(is(Real(x) / Real(y), p / q));
  };
  test::property("of every finite binary64", [&] { check(*test::anyFinite(), *test::anyFinite()); });
  test::property("of ordinary numbers", [&] { check(*test::moderate(), *test::moderate()); });
  test::property("where coincidences are frequent", [&] { check(*test::dyadicGrid(), *test::dyadicGrid()); });
}

TEST_CASE("a number has one form, however it was made") {
  test::property("what cancels is small again", [] {
    const double x = *test::anyFinite(), y = *test::anyFinite();
    const Real again = Real(x) + Real(y) - Real(y);
    RC_ASSERT(again == Real(x));
    RC_ASSERT(again.text() == Real(x).text());
  });
}

TEST_CASE("roots are compared by their radicands") {
  const Real two(2), three(3), root_two = square_root(two);
  CHECK(root_two * root_two == two);
  CHECK(square_root(Real(4)) == two);
  CHECK(root_two < square_root(three));
  CHECK(root_two > Real(1.414));
  CHECK(root_two < Real(1.415));
  const Real nested = square_root(Real(1) + root_two);  // √(1+√2) = 1.5537…
  CHECK_FALSE(nested.is_surd());
  CHECK(nested * nested == Real(1) + root_two);
  CHECK(nested > Real(1.553));
  CHECK(nested < Real(1.554));
  CHECK(nested > -root_two);
  CHECK(square_root(Real(2) + root_two) > nested);
  CHECK(nested - nested == Real(0));
  CHECK(nested.text() == "√(1+√2)");
}

TEST_CASE("what has no form is an error") {
  const Real root_two = square_root(Real(2)), root_three = square_root(Real(3));
  CHECK_THROWS_AS(root_two + root_three, std::domain_error);
  CHECK_THROWS_AS(square_root(Real(1) + root_two) + Real(1), std::domain_error);
  CHECK_THROWS_AS(square_root(Real(-1)), std::domain_error);
  CHECK_THROWS_AS(Real(1) / Real(0), std::domain_error);
  CHECK_THROWS_AS(integer_quotient(Real(0.5), Real(1)), std::domain_error);
  CHECK(integer_quotient(Real(-7), Real(2)) == Real(-4));
}

}  // namespace
}  // namespace durero::zed
