#include "durero/model/tipo/plano.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

TEST_CASE("potencia_plano.def.1: positive on the side of the normal") {
  CHECK(potencia_plano(Punto(3, 4, 9), origin, axis) == 9);
  CHECK(potencia_plano(Punto(3, 4, -9), Punto(0, 0, 1), axis) == -10);
  CHECK(potencia_plano(Punto(3, 4, 1), Punto(7, 7, 1), axis) == 0);
}

TEST_CASE("puntos_plano.def.1: without a bound") {
  const Puntos plane = puntos_plano(Punto(0, 0, 1), axis);
  CHECK(plane.contains(Punto(1e300, -1e300, 1)));
  CHECK(plane.contains({Surd(0, 1, 2), Surd(0), Surd(1)}));
  CHECK_FALSE(plane.contains(Punto(0, 0, 1 + 0x1p-52)));
  CHECK_FALSE(plane.contains(origin));
  property("sampled points are members; beside the plane they are not", [] {
    const Punto centro = *any_point();
    const Vector dir = *any_axis();
    const Puntos points = puntos_plano(centro, dir);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    RC_ASSERT(!points.contains(along(*w, dir, Surd(0x1p-200))));
    RC_ASSERT(!points.contains(along(*w, dir, Surd(-0x1p-200))));
  });
}
