#include "durero/written/formula.hpp"

#include "support/catch.hpp"

namespace durero::written {
namespace {

const Formula x = Formula::coordinate(0), y = Formula::coordinate(1), z = Formula::coordinate(2);
constexpr Signs is_zero{false, true, false}, is_positive{false, false, true}, not_negative{false, true, true};

TEST_CASE("Formulas are added and multiplied as polynomials are, and what cancels is gone") {
  CHECK((x + y) * (x - y) == x * x - y * y);
  CHECK((x - x).is_constant());
  CHECK((x - x).terms().empty());
  CHECK((x * Formula(number::Rational(2, 3)) * Formula(3)) == x + x);
  CHECK((x * y * z * z).degree() == 4);
  CHECK(Formula(7).constant() == 7);
  CHECK((x + Formula(7)).constant() == 7);
  CHECK_FALSE(x.is_constant());
  CHECK((x * x * y + z).derivative(0) == Formula(2) * x * y);
  CHECK((x * x * y + z).derivative(2) == Formula(1));
}

TEST_CASE("A degree that is too high is refused, and so is a number that is too long") {
  Formula power = x;
  for (int degree = 2; degree <= Formula::max_degree; ++degree) power = power * x;
  CHECK(power.degree() == Formula::max_degree);
  CHECK_THROWS_AS(power * y, std::length_error);
  Formula number(3);
  CHECK_THROWS_AS(
      [&] {
        for (int i = 0; i < 60; ++i) number = number * number;
      }(),
      std::length_error);
}

TEST_CASE("What is known of a condition is seen in it, and a negation asks for the other signs") {
  CHECK(compared(Formula(2), is_positive).is(true));
  CHECK(compared(Formula(), is_positive).is(false));
  const Condition a = compared(x, is_zero), b = compared(y, is_positive);
  CHECK(both(a, always(true)).kind == Condition::Kind::comparison);
  CHECK(both(always(false), a).is(false));
  CHECK(either(a, always(true)).is(true));
  CHECK(either(always(false), a).formula == x);
  CHECK(both(both(a, b), a).parts.size() == 3);
  CHECK(either(both(a, b), a).parts.size() == 2);
  const Condition neither = negated(either(a, b));
  CHECK(neither.kind == Condition::Kind::all);
  CHECK(neither.parts[0].signs == Signs{true, false, true});
  CHECK(neither.parts[1].signs == Signs{true, true, false});
  CHECK(negated(compared(z, not_negative)).signs == Signs{true, false, false});
  CHECK(negated(negated(both(a, b))).kind == Condition::Kind::all);
}

}  // namespace
}  // namespace durero::written
