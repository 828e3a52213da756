#include "durero/model/quadratic.hpp"

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Rational any_coefficient() { return number::exact(*rc::gen::oneOf(moderate(), dyadicGrid())); }

Surd at(const RationalQuadratic& q, const Surd& t) { return Surd(q.a) * t * t + Surd(q.b) * t + Surd(q.c); }

}  // namespace

TEST_CASE("a polynomial is known by its values at -1, 0 and 1") {
  property("any", [] {
    const RationalQuadratic q{any_coefficient(), any_coefficient(), any_coefficient()};
    const RationalQuadratic again = through(q.a - q.b + q.c, q.c, q.a + q.b + q.c);
    RC_ASSERT(again.a == q.a && again.b == q.b && again.c == q.c);
  });
  CHECK(through(0, 0, 0).is_zero());
  CHECK_FALSE(through(0, 0, 1).is_zero());
  CHECK_FALSE(through(1, 1, 1).is_zero());
}

TEST_CASE("a function of points, restricted to a line, has the function's values") {
  const auto square_of_distance = [](const ExactPoint& w) { return w.x * w.x + w.y * w.y + w.z * w.z; };
  property("at every parameter", [&] {
    const ExactPoint p = Punto(*dyadicGrid(), *dyadicGrid(), *dyadicGrid());
    const ExactVector v = Vector(*dyadicGrid(), *dyadicGrid(), *dyadicGrid());
    const Surd t(*dyadicGrid());
    RC_ASSERT(at(restricted(square_of_distance, p, v), t) == square_of_distance(along(p, v, t)));
  });
}

TEST_CASE("the roots are where it is 0: all of them, ascending, each once") {
  property("of any coefficients", [] {
    const RationalQuadratic q{any_coefficient(), any_coefficient(), any_coefficient()};
    RC_PRE(!q.is_zero());
    const std::vector<Surd> all = roots(q);
    const Rational discriminant = q.b * q.b - 4 * q.a * q.c;
    const std::size_t expected = q.a.is_zero() ? !q.b.is_zero() : discriminant.sign() + 1U;
    RC_ASSERT(all.size() == expected);
    for (const Surd& t : all) RC_ASSERT(at(q, t) == Surd(0));
    if (all.size() == 2) RC_ASSERT(all[0] < all[1]);
  });
  property("of given roots", [] {
    const Rational a = any_coefficient(), one = any_coefficient(), other = any_coefficient();
    RC_PRE(!a.is_zero());
    const std::vector<Surd> all = roots({a, -a * (one + other), a * one * other});
    RC_ASSERT(all.front() == Surd(std::min(one, other)));
    RC_ASSERT(all.back() == Surd(std::max(one, other)));
    RC_ASSERT(all.size() == (one == other ? 1U : 2U));
  });
  CHECK(roots({0, 2, -3}) == std::vector<Surd>{Surd(1.5)});
  CHECK(roots({0, 0, 5}).empty());
  CHECK(roots({1, 0, 1}).empty());
  CHECK(roots({4, -12, 9}) == std::vector<Surd>{Surd(1.5)});
  CHECK(roots({-1, 0, 2}) == std::vector<Surd>{Surd(0, -1, 2), Surd(0, 1, 2)});
}
