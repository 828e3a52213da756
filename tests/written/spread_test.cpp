#include "durero/written/spread.hpp"

#include "durero/written/formula.hpp"
#include "support/catch.hpp"

namespace durero::written {
namespace {

using number::Rational;
using number::RealBall;

const Formula x = Formula::coordinate(0);
/// More than the roundings of errors of 1/1024 and the like.
constexpr double tiny = 0x1p-55;

double magnitude(const RealBall& ball) {
  const RealBall both = either_way(ball);
  return std::ldexp(both.radius, static_cast<int>(both.exponent));
}
double magnitude(const RoughTerms& terms, std::uint8_t power) {
  const auto found = terms.find(Exponents{power, 0, 0});
  return found == terms.end() ? 0 : magnitude(found->second);
}
/// About how far one error moves the coefficient of a power of x.
double moved_by(const Formula& formula, std::size_t error, std::uint8_t power) {
  const auto found = formula.spread().linear().find(error);
  return found == formula.spread().linear().end() ? 0 : magnitude(found->second, power);
}

TEST_CASE("A number that is off moves a formula by its derivative, and by a bound on the rest") {
  const Formula a = Formula::off_by(3, 0, Rational(1, 1024)), b = Formula::off_by(5, 1, Rational(1, 2048));
  const Formula product = a * b;
  CHECK(product.constant() == 15);
  CHECK(moved_by(product, 0, 0) == Approx(5.0 / 1024));
  CHECK(moved_by(product, 1, 0) == Approx(3.0 / 2048));
  CHECK(magnitude(product.spread().rest(), 0) == Approx(1.0 / 1024 / 2048));
  const Formula square = a * a;
  CHECK(moved_by(square, 0, 0) == Approx(6.0 / 1024));
  CHECK(magnitude(square.spread().rest(), 0) == Approx(1.0 / 1024 / 1024));
}

TEST_CASE("Errors of one number cancel to the first order, and those of two do not") {
  const Formula a = Formula::off_by(3, 0, Rational(1, 1024)), b = Formula::off_by(3, 1, Rational(1, 1024));
  CHECK(moved_by(a - a, 0, 0) < tiny);
  CHECK(moved_by(a * x - x * a, 0, 1) < tiny);
  CHECK(moved_by(a - b, 0, 0) == Approx(1.0 / 1024));
  CHECK(moved_by(a - b, 1, 0) == Approx(1.0 / 1024));
  // (a + x)² − (a − x)² − 4·a·x is 0 whatever a is.
  const Formula zero = (a + x) * (a + x) - (a - x) * (a - x) - Formula(4) * a * x;
  CHECK(zero.terms().empty());
  for (std::uint8_t power = 0; power < 3; ++power) CHECK(moved_by(zero, 0, power) < tiny);
}

TEST_CASE("A formula in which nothing is off has no spread") {
  CHECK((x * x + Formula(3)).spread().is_none());
  CHECK_FALSE((x * Formula::off_by(1, 0, 1)).spread().is_none());
  CHECK((x * x + Formula(3)) == (Formula(3) + x * x));
  CHECK_FALSE(Formula::off_by(1, 0, 1) == Formula(1));
  CHECK(Formula::off_by(1, 0, 1) == Formula::off_by(1, 0, 1));
}

TEST_CASE("A sign is certain where no errors change it") {
  CHECK(Formula::off_by(1, 0, Rational(1, 2)).certain_sign() == 1);
  CHECK(Formula::off_by(-1, 0, Rational(1, 2)).certain_sign() == -1);
  CHECK_FALSE(Formula::off_by(1, 0, 1).certain_sign());
  CHECK_FALSE(Formula::off_by(0, 0, Rational(1, 1024)).certain_sign());
  const Signs positive{false, false, true};
  CHECK(compared(Formula::off_by(1, 0, Rational(1, 2)), positive).is(true));
  const Condition open = compared(Formula::off_by(1, 0, 2), positive);
  CHECK(open.kind == Condition::Kind::comparison);
  CHECK(holds_as_given(open));
  CHECK_FALSE(holds_as_given(negated(open)));
  CHECK_FALSE(holds_as_given(compared(x, positive)));
}

TEST_CASE("A degree counts what only errors have") {
  const Formula a = Formula::off_by(1, 0, Rational(1, 1024)), only = a * x - x;
  CHECK(only.terms().empty());
  CHECK(only.degree() == 1);
  CHECK_FALSE(only.is_constant());
}

}  // namespace
}  // namespace durero::written
