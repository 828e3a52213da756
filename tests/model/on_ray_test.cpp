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

TEST_CASE("where a concave polynomial is not negative, of the t > 0") {
  property("parameter by parameter", [] {
    const Rational a = -abs(any_number());
    const RationalQuadratic q{*rc::gen::arbitrary<bool>() ? a : Rational(0), any_number(), any_number()};
    const auto interval = not_negative(q);
    const Parameters inside = interval ? Parameters{{}, interval} : Parameters{};
    const Surd t = *rc::gen::arbitrary<bool>() || q.is_zero() || roots(q).empty()
                       ? Surd(any_number())
                       : roots(q)[*rc::gen::inRange<std::size_t>(0, roots(q).size())];
    const Surd value = Surd(q.a) * t * t + Surd(q.b) * t + Surd(q.c);
    RC_ASSERT(inside.contains(t) == (t > 0 && value >= 0));
  });
  const auto whole = not_negative({0, 0, 0});
  REQUIRE(whole);
  CHECK_FALSE(whole->last);
  CHECK_FALSE(not_negative({0, 0, -1}));
  CHECK_FALSE(not_negative({0, -1, 0}));  // it is negative from t = 0 on, which is not one of them
  CHECK_FALSE(not_negative({-1, 0, -1}));
  const auto closed = not_negative({-1, 4, -2});  // between 2 − √2 and 2 + √2
  REQUIRE(closed);
  CHECK(closed->first == Surd(2, -1, 2));
  CHECK(closed->has_first);
  CHECK(closed->last == Surd(2, 1, 2));
  const auto point = not_negative({-1, 2, -1});
  REQUIRE(point);
  CHECK(point->first == 1);
  CHECK(point->last == Surd(1));
}

TEST_CASE("the parameters that two intervals share") {
  property("parameter by parameter", [] {
    const auto any_interval = [] {
      const Rational first = abs(any_number());
      const bool has_first = *rc::gen::arbitrary<bool>() && first > 0;
      const Rational last = first + 1 + abs(any_number());
      return Interval{Surd(first), has_first, *rc::gen::arbitrary<bool>() ? std::optional<Surd>(last) : std::nullopt};
    };
    const Interval a = any_interval();
    Interval b = any_interval();
    if (*rc::gen::arbitrary<bool>()) b.first = a.first;  // one may hold it and the other not
    if (a.last && *rc::gen::arbitrary<bool>()) b.first = *a.last;
    if (b.last && *b.last < b.first) b.last = b.first;
    const auto both = intersection(a, b);
    const Parameters in_a{{}, a}, in_b{{}, b}, in_both = both ? Parameters{{}, both} : Parameters{};
    for (const Surd& t : {a.first, b.first, a.last.value_or(Surd(1)), b.last.value_or(Surd(1)), Surd(any_number())})
      RC_ASSERT(in_both.contains(t) == (in_a.contains(t) && in_b.contains(t)));
  });
  CHECK_FALSE(intersection({1, true, Surd(2)}, {3, true, std::nullopt}));
  CHECK_FALSE(intersection({1, true, Surd(3)}, {3, false, std::nullopt}));
  const auto point = intersection({1, true, Surd(3)}, {3, true, std::nullopt});
  REQUIRE(point);
  CHECK(point->first == 3);
  CHECK(point->last == Surd(3));
}

TEST_CASE("the zeros inside an interval: the roots that it holds, or all of it") {
  const RationalQuadratic one_and_three{1, -4, 3};
  CHECK(zeros(one_and_three, positive).points == std::vector<Surd>{1, 3});
  CHECK(zeros(one_and_three, {1, true, Surd(2)}).points == std::vector<Surd>{1});
  CHECK(zeros(one_and_three, {1, false, Surd(3)}).points == std::vector<Surd>{3});
  CHECK(zeros(one_and_three, {Surd(Rational(3, 2)), true, Surd(2)}).is_empty());
  CHECK(zeros({1, 0, 0}, positive).is_empty());  // 0 is not one of them
  CHECK(zeros({0, 0, 7}, positive).is_empty());
  const Parameters all = zeros({0, 0, 0}, {1, true, Surd(2)});
  CHECK(all.points.empty());
  REQUIRE(all.interval);
  CHECK(all.contains(1));
  CHECK(all.contains(2));
  CHECK_FALSE(all.contains(Surd(2) + nudge));
}

TEST_CASE("the least parameter, and whether one is less than a bound") {
  const Parameters none{}, points{{Surd(0, 1, 2), Surd(2)}, std::nullopt};
  const Parameters closed{{}, Interval{1, true, Surd(2)}}, open{{}, Interval{0, false, Surd(2)}};
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
