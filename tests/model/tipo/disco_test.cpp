#include "durero/model/tipo/disco.hpp"

#include "durero/model/puntos.hpp"
#include "durero/model/tipo/cilindro.hpp"
#include "durero/model/tipo/esfera.hpp"
#include "durero/model/tipo/plano.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

TEST_CASE("puntos_disco.def.1: a part of a plane, with its rim") {
  const Puntos disc = puntos_disco(Punto(0, 0, 1), Rmas(2), axis);
  CHECK(disc.contains(Punto(0, 0, 1)));
  CHECK(disc.contains(Punto(2, 0, 1)));
  CHECK(disc.contains({Surd(0, 1, 2), Surd(0, 1, 2), Surd(1)}));
  CHECK_FALSE(disc.contains(Punto(2 + 0x1p-51, 0, 1)));
  CHECK_FALSE(disc.contains(Punto(0, 0, 1 + 0x1p-52)));
  property("sampled points are members; beside the plane and beyond the rim they are not", [] {
    const Punto centro = *any_point();
    const Rmas radio = *any_rmas();
    const Vector dir = *any_axis();
    const Puntos points = puntos_disco(centro, radio, dir);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    RC_ASSERT(!points.contains(along(*w, dir, Surd(0x1p-200))));
    const bool on_rim = potencia_esfera(*w, centro, radio) == 0;
    RC_CLASSIFY(on_rim, "on the rim");
    if (on_rim) {
      RC_ASSERT(!points.contains(off(*w, centro)));
      // It closes a cylinder: the rim belongs to both.
      RC_ASSERT(puntos_cilindro(centro, radio, dir, *any_rmas()).contains(*w));
    }
  });
}
