#include "durero/model/tipo/tronco.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

TEST_CASE("potencia_tronco.def.1: the radius of the top at s = h, and prop more for each unit below") {
  const auto power = [](double x, double z) {
    return potencia_tronco(Punto(x, 0, z), origin, Rmas(1), Rmas(0.5), axis, Rmas(4));
  };
  CHECK(power(1, 4) == 0);
  CHECK(power(3, 0) == 0);
  CHECK(power(2, 2) == 0);
  CHECK(power(0, 4) == -1);
  CHECK(power(0, 6) == 0);  // the apex of the double cone, beyond the top
  CHECK(power(1, 8) == 0);  // its other half
}

TEST_CASE("puntos_tronco.def.1: closed at both rims, and without base and top") {
  const Puntos points = puntos_tronco(origin, Rmas(1), Rmas(0.5), axis, Rmas(4));
  CHECK(points.contains(Punto(3, 0, 0)));
  CHECK(points.contains(Punto(0, -2, 2)));
  CHECK(points.contains(Punto(0, 1, 4)));
  CHECK_FALSE(points.contains(Punto(0, 0, 6)));
  CHECK_FALSE(points.contains(Punto(0, 1 - 0x1p-53, 4)));
  CHECK_FALSE(points.contains(Punto(3.5, 0, -1)));
  CHECK_FALSE(points.contains(Punto(0, 0, 0)));
  property("sampled points are members; farther from the axis, or beyond a rim, they are not", [] {
    const Punto centro = *any_point();
    const Vector dir = *rc::gen::element(Vector(1, 0, 0), Vector(0, -1, 0), Vector(0, 0, 1));
    const Rmas radio = *any_rmas(), prop = *any_rmas(), h = *any_rmas();
    const Puntos points = puntos_tronco(centro, radio, prop, dir, h);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    RC_ASSERT(!points.contains(off(*w, foot_of(*w, centro, dir))));
    // On the generator through w: the way from the apex of the double cone, stretched, leaves by one rim or the other.
    const Surd height(h.value()), apex_at = height + Surd(radio.value()) / Surd(prop.value());
    const ExactPoint apex = on_axis(centro, dir, apex_at);
    const auto on_generator = [&](const Surd& k) {
      return ExactPoint{apex.x + (w->x - apex.x) * k, apex.y + (w->y - apex.y) * k, apex.z + (w->z - apex.z) * k};
    };
    const Surd below = apex_at - avance(*w, centro, dir);  // the height of w below the apex, > 0
    RC_ASSERT(points.contains(on_generator(apex_at / below)));
    RC_ASSERT(points.contains(on_generator((apex_at - height) / below)));
    RC_ASSERT(!points.contains(on_generator(apex_at / below + Surd(0x1p-60))));
    RC_ASSERT(!points.contains(on_generator((apex_at - height) / below - Surd(0x1p-60))));
  });
  property("an axis that is not quite a unit vector: sampled points are members", [] {
    const Puntos points = puntos_tronco(*any_point(), *any_rmas(), *any_rmas(), *any_axis(), *any_rmas());
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
  });
}
