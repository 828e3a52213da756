#include "durero/written/moved_points.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace durero::written {
namespace {

using number::Rational;

const Formula s = Formula::coordinate(0);
constexpr Signs is_zero{false, true, false}, not_negative{false, true, true};

Condition equation(const Formula& formula) { return compared(formula, is_zero); }

/// Points with (s − 1)·(s − 2) = 0, where 1 is off by 1/8, and s ≤ `end`.
MovedPoints two_points(const Rational& end) {
  const Formula one = Formula::off_by(1, 0, Rational(1, 8));
  return MovedPoints(both(equation((s - one) * (s - Formula(2))), compared(Formula(end) - s, not_negative)));
}

TEST_CASE("Points are in a stretch perhaps, or certainly, as far as numbers are off") {
  const MovedPoints points = two_points(10);
  CHECK_FALSE(points.may_be_within({-1, 0}));
  CHECK_FALSE(points.may_be_within({Rational(3, 4), Rational(3, 4)}));
  CHECK(points.may_be_within({0, Rational(15, 16)}));
  CHECK(points.may_be_within({1, 1}));
  CHECK_FALSE(points.may_be_within({Rational(3, 2), Rational(3, 2)}));
  CHECK(points.may_be_within({2, 2}));
  CHECK_FALSE(points.may_be_within({Rational(33, 16), Rational(33, 16)}));
  CHECK(points.is_certain_within({Rational(3, 4), Rational(5, 4)}));
  CHECK_FALSE(points.is_certain_within({Rational(15, 16), Rational(17, 16)}));
  CHECK_FALSE(points.is_certain_within({Rational(3, 4), 3}));  // as there are two
}

TEST_CASE("Points beyond a clip are none") {
  const MovedPoints clipped = two_points(Rational(3, 2));
  CHECK_FALSE(clipped.may_be_within({Rational(7, 4), 3}));
  CHECK_FALSE(clipped.is_certain_within({Rational(7, 4), Rational(9, 4)}));
  CHECK(clipped.is_certain_within({Rational(3, 4), Rational(5, 4)}));
}

TEST_CASE("Points are sought far away by the last coefficients") {
  const MovedPoints points = two_points(10);
  CHECK(points.may_be_from(2));
  CHECK_FALSE(points.may_be_from(64));
  // (1 ± 1/4)·s − 1 has its point before 2; (0 ± 1/4)·s − 1 may have it anywhere from 4 on.
  const Formula slope = Formula::off_by(1, 0, Rational(1, 4)), flat = Formula::off_by(0, 0, Rational(1, 4));
  CHECK_FALSE(MovedPoints(equation(slope * s - Formula(1))).may_be_from(2));
  CHECK(MovedPoints(equation(flat * s - Formula(1))).may_be_from(1024));
}

TEST_CASE("A stretch has as many points as an equation has slopes or degrees") {
  const MovedPoints points = two_points(10);
  CHECK(points.most_within({Rational(3, 4), Rational(5, 4)}) == 1);
  CHECK(points.most_within({1, 2}) == 2);
}

TEST_CASE("A reach is about that of the error over the slope") {
  const Formula number = Formula::off_by(0, 0, Rational(1, 1024));
  CHECK(MovedPoints(equation(Formula(4) * s + number)).rough_reach() == Approx(1.0 / 4096));
  CHECK(MovedPoints(equation(s * s + number)).rough_reach() == 0);
}

TEST_CASE("A condition of a union is met where one of its parts is") {
  const MovedPoints either_one(either(equation(s - Formula::off_by(1, 0, Rational(1, 8))), equation(s - Formula(5))));
  CHECK(either_one.is_certain_within({Rational(1, 2), 2}));
  CHECK(either_one.is_certain_within({4, 6}));
  CHECK_FALSE(either_one.may_be_within({2, 4}));
  CHECK(either_one.most_within({0, 6}) == 2);
}

}  // namespace
}  // namespace durero::written
