#include "durero/model/exact_point.hpp"

#include <stdexcept>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

const Surd root2(0, 1, 2);

}  // namespace

TEST_CASE("a stored point denotes its rational point, and a stored vector its rational vector") {
  property("every coordinate is the number that the binary64 denotes", [] {
    const Rayo rayo = *any_ray();
    const ExactPoint p = rayo.p();
    const ExactVector v = rayo.v();
    RC_ASSERT(p.x == Surd(rayo.p().x()) && p.y == Surd(rayo.p().y()) && p.z == Surd(rayo.p().z()));
    RC_ASSERT(v.x == number::exact(rayo.v().x()));
    RC_ASSERT(v.y == number::exact(rayo.v().y()));
    RC_ASSERT(v.z == number::exact(rayo.v().z()));
  });
  CHECK(ExactPoint(Punto(0.1, 0, 0)).x.x != Rational(1, 10));  // 0.1 is no binary64
  CHECK(ExactPoint(Punto(-0.0, 0, 0)) == ExactPoint(Punto(0, 0, 0)));
}

TEST_CASE("points are equal where each coordinate is, in whatever form") {
  const ExactPoint p(root2, 1, 0);
  CHECK(p == ExactPoint(Surd(0, Rational(1, 2), 8), 1, 0));
  CHECK_FALSE(p == ExactPoint(root2, 1, Surd(0x1p-1000)));
  CHECK_FALSE(p == ExactPoint(root2, 2, 0));
  CHECK_FALSE(p == ExactPoint(-root2, 1, 0));
}

TEST_CASE("along is p + t·v") {
  const ExactPoint p = Punto(1, 2, 3);
  const ExactVector v = Vector(1, 0, -2);
  CHECK(along(p, v, 0) == p);
  CHECK(along(p, v, root2) == ExactPoint(Surd(1, 1, 2), 2, Surd(3, -2, 2)));
  CHECK_THROWS_AS(along({root2, 0, 0}, v, Surd(0, 1, 3)), std::domain_error);  // √2 + √3
  property("a step of s after a step of t is a step of s + t", [] {
    const Rayo rayo = *any_ray();
    const Surd s(*moderate()), t(*moderate());
    RC_ASSERT(along(along(rayo.p(), rayo.v(), t), rayo.v(), s) == along(rayo.p(), rayo.v(), s + t));
  });
}
