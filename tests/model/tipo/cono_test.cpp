#include "durero/model/tipo/cono.hpp"

#include "durero/model/puntos.hpp"
#include "model/escenas.hpp"
#include "model/places.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

TEST_CASE("potencia_cono.def.1: base, of radius prop·h, at the centre; apex at s = h") {
  CHECK(potencia_cono(Punto(2, 0, 0), origin, Rmas(0.5), axis, Rmas(4)) == 0);
  CHECK(potencia_cono(Punto(0, 0, 4), origin, Rmas(0.5), axis, Rmas(4)) == 0);
  CHECK(potencia_cono(Punto(0, 0, 0), origin, Rmas(0.5), axis, Rmas(4)) == -4);
  CHECK(potencia_cono(Punto(0, 1, 6), origin, Rmas(0.5), axis, Rmas(4)) == 0);  // the other half of the double cone
}

TEST_CASE("puntos_cono.def.1: base at the centre, apex at the height, closed at both") {
  const Puntos cone = puntos_cono(origin, Rmas(0.5), axis, Rmas(4));
  CHECK(cone.contains(Punto(2, 0, 0)));
  CHECK(cone.contains(Punto(0, 1, 2)));
  CHECK(cone.contains(Punto(0, 0, 4)));
  CHECK_FALSE(cone.contains(Punto(0, 0.5, 5)));
  CHECK_FALSE(cone.contains(Punto(2.5, 0, -1)));
  CHECK_FALSE(cone.contains(Punto(0, 0, 0)));
  property("sampled points are members; farther from the axis, or beyond the base, they are not", [] {
    const Punto centro = *any_point();
    const Vector dir = *rc::gen::element(Vector(1, 0, 0), Vector(0, -1, 0), Vector(0, 0, 1));
    const Rmas prop = *any_rmas(), h = *any_rmas();
    const Puntos points = puntos_cono(centro, prop, dir, h);
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
    const ExactPoint foot = foot_of(*w, centro, dir), apex = on_axis(centro, dir, Surd(h.value()));
    if (!(*w == apex)) RC_ASSERT(!points.contains(off(*w, foot)));
    // On the generator through w: twice the distance of the apex from the base is beyond one end or the other.
    const auto on_generator = [&](int k) {
      return ExactPoint{apex.x + (w->x - apex.x) * k, apex.y + (w->y - apex.y) * k, apex.z + (w->z - apex.z) * k};
    };
    if (!(*w == apex)) RC_ASSERT(!points.contains(on_generator(-1)));
    const Surd s = avance(*w, centro, dir), height(h.value());
    RC_ASSERT(points.contains(on_generator(2)) == (Surd(2) * s >= height));
  });
  property("an axis that is not quite a unit vector: sampled points are members", [] {
    const Puntos points = puntos_cono(*any_point(), *any_rmas(), *any_axis(), *any_rmas());
    Random random = *any_random();
    const auto w = points.sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(points.contains(*w));
  });
}
