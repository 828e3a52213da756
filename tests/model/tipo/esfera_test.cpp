#include "durero/model/tipo/esfera.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

const Surd root2(0, 1, 2);

}  // namespace

TEST_CASE("potencia_esfera.def.1") {
  CHECK(potencia_esfera(Punto(3, 4, 0), origin, Rmas(2)) == 21);
  CHECK(potencia_esfera(origin, origin, Rmas(2)) == -4);
}

TEST_CASE("puntos_esfera.def.1") {
  const Puntos sphere = puntos_esfera(Punto(1, 0, 0), Rmas(2));
  CHECK(sphere.contains(Punto(3, 0, 0)));
  CHECK(sphere.contains({Surd(1) + root2, root2, Surd(0)}));
  CHECK_FALSE(sphere.contains(Punto(1, 0, 0)));
  CHECK_FALSE(sphere.contains(Punto(3, 0x1p-537, 0)));
  property("sampled points are members, and perturbed ones are not", [] {
    const Punto centro = *any_point();
    const Puntos points = puntos_esfera(centro, *any_rmas());
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    RC_ASSERT(!points.contains(off(*w, centro)));
  });
}
