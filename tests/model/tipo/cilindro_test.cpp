#include "durero/model/tipo/cilindro.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

TEST_CASE("potencia_cilindro.def.1") { CHECK(potencia_cilindro(Punto(3, 4, 9), origin, Rmas(2), axis) == 21); }

TEST_CASE("puntos_cilindro.def.1: closed at both rims, and without caps") {
  const Puntos cylinder = puntos_cilindro(origin, Rmas(1), axis, Rmas(2));
  CHECK(cylinder.contains(Punto(1, 0, 1)));
  CHECK(cylinder.contains(Punto(0.6, 0.8, 0)) == false);  // 0.6 and 0.8 are not 3/5 and 4/5
  CHECK(cylinder.contains({Rational(3, 5), Rational(4, 5), Surd(0)}));
  CHECK(cylinder.contains(Punto(1, 0, 0)));
  CHECK(cylinder.contains(Punto(1, 0, 2)));
  CHECK_FALSE(cylinder.contains(Punto(1, 0, -5e-324)));
  CHECK_FALSE(cylinder.contains(Punto(1, 0, 2 + 0x1p-51)));
  CHECK_FALSE(cylinder.contains(Punto(0, 0, 0)));
  property("sampled points are members; farther from the axis, or beyond a rim, they are not", [] {
    const Punto centro = *any_point();
    const Vector dir = *any_axis();
    const Rmas h = *any_rmas();
    const Puntos points = puntos_cilindro(centro, *any_rmas(), dir, h);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    RC_ASSERT(!points.contains(off(*w, foot_of(*w, centro, dir))));
    const Surd s = avance(*w, centro, dir), height(h.value());
    RC_ASSERT(!points.contains(along(*w, dir, (height - s) * Surd(1.5) + Surd(1))));
    RC_ASSERT(!points.contains(along(*w, dir, -s * Surd(1.5) - Surd(1))));
  });
}
