#include "durero/model/on_ray.hpp"

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

const Interval positive{0, false, std::nullopt};
const Surd nudge(0x1p-300);

Rational any_number() { return number::exact(*rc::gen::oneOf(moderate(), dyadicGrid())); }

}  // namespace

TEST_CASE("the stretch is where t > 0 and 0 ≤ at_zero + t·slope ≤ h") {
  property("parameter by parameter", [] {
    const Rational at_zero = any_number(), slope = any_number(), h = abs(any_number());
    const auto interval = stretch(at_zero, slope, h);
    const Parameters inside = interval ? Parameters{{}, interval} : Parameters{};
    Rational t = any_number();
    if (!slope.is_zero() && *rc::gen::arbitrary<bool>())  // exactly at an end
      t = ((*rc::gen::arbitrary<bool>() ? h : Rational(0)) - at_zero) / slope;
    const Rational advance = at_zero + t * slope;
    RC_ASSERT(inside.contains(Surd(t)) == (t > 0 && advance >= 0 && advance <= h));
  });
  const auto whole = stretch(0.5, 0, 1);
  REQUIRE(whole);
  CHECK_FALSE(whole->last);
  CHECK_FALSE(stretch(2, 0, 1));
  CHECK_FALSE(stretch(0, -1, 1));  // it leaves at t = 0, which is not one of them
  CHECK_FALSE(stretch(-1, -1, 1));
  const auto closed = stretch(-1, 1, 1);
  REQUIRE(closed);
  CHECK(closed->first == 1);
  CHECK(closed->has_first);
  CHECK(closed->last == Rational(2));
}

TEST_CASE("the zeros inside an interval: the roots that it holds, or all of it") {
  const Quadratic one_and_three{1, -4, 3};
  CHECK(zeros(one_and_three, positive).points == std::vector<Surd>{1, 3});
  CHECK(zeros(one_and_three, {1, true, Rational(2)}).points == std::vector<Surd>{1});
  CHECK(zeros(one_and_three, {1, false, Rational(3)}).points == std::vector<Surd>{3});
  CHECK(zeros(one_and_three, {Rational(3, 2), true, Rational(2)}).is_empty());
  CHECK(zeros({1, 0, 0}, positive).is_empty());  // 0 is not one of them
  CHECK(zeros({0, 0, 7}, positive).is_empty());
  const Parameters all = zeros({0, 0, 0}, {1, true, Rational(2)});
  CHECK(all.points.empty());
  REQUIRE(all.interval);
  CHECK(all.contains(1));
  CHECK(all.contains(2));
  CHECK_FALSE(all.contains(Surd(2) + nudge));
}

TEST_CASE("the least parameter, and whether one is less than a bound") {
  const Parameters none{}, points{{Surd(0, 1, 2), Surd(2)}, std::nullopt};
  const Parameters closed{{}, Interval{1, true, Rational(2)}}, open{{}, Interval{0, false, Rational(2)}};
  CHECK(none.is_empty());
  CHECK(none.minimum() == std::nullopt);
  CHECK_FALSE(none.any_below(1000));

  CHECK(points.minimum() == Surd(0, 1, 2));
  CHECK(points.contains(2));
  CHECK_FALSE(points.contains(1));
  CHECK_FALSE(points.any_below(Surd(0, 1, 2)));
  CHECK(points.any_below(Surd(0, 1, 2) + Surd(0, Rational(1, 1000), 2)));

  CHECK(closed.minimum() == Surd(1));
  CHECK_FALSE(closed.any_below(1));
  CHECK(closed.any_below(Surd(1) + nudge));

  CHECK_FALSE(open.is_empty());
  CHECK(open.minimum() == std::nullopt);  // another one is nearer to 0, whichever is taken
  CHECK(open.any_below(nudge));
  CHECK(open.contains(nudge));
  CHECK_FALSE(open.contains(0));
}
