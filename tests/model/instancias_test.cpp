#include "durero/model/instancias.hpp"

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Rational third(std::int64_t n) { return Rational(n) / Rational(3); }

/// A map that leans, mirrors, and has entries that are no binary64.
Mapa leaning() { return {{1, third(-2), 3}, {third(1), -1, 0}, {0, -2, third(5)}, {1, 0, third(2)}}; }

Mapa stretched(const Rational& across, const Rational& along, const ExactVector& centro = {0, 0, 0}) {
  return {centro, {across, 0, 0}, {0, across, 0}, {0, 0, along}};
}

ExactVector vector_of(const Punto& p) { return {number::exact(p.x()), number::exact(p.y()), number::exact(p.z())}; }

bool is_map(const Mapa& m) { return inv(m).front().holds; }

rc::Gen<Mapa> any_map() {
  const auto column = rc::gen::map(any_point(), vector_of);
  return rc::gen::apply(
      [](const ExactVector& c, const ExactVector& x, const ExactVector& y, const ExactVector& z) {
        const auto thirds = [](const ExactVector& v) { return ExactVector(v.x / 3, v.y / 3, v.z / 3); };
        const Mapa m{c, thirds(x), y, thirds(z)};
        return is_map(m) ? m : leaning();  // small cases are often no maps
      },
      column, column, column, column);
}

/// Some points of the element, which a set finds by itself.
void check_drawn(const Puntos& original, const Mapa& m, Random& random) {
  const Puntos copy = copia(m, original);
  for (int i = 0; i < 5; ++i) {
    const auto u = original.sample(random), w = copy.sample(random);
    if (!u) continue;
    CHECK(copy.contains(puesto(m, *u)));
    CHECK(w);
    CHECK(original.contains(visto(m, *w)));
  }
}

}  // namespace

TEST_CASE("mixto.def.1: the volume over three vectors, with a sign") {
  CHECK(mixto({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
  CHECK(mixto({0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == -1);
  CHECK(mixto({2, 1, 0}, {0, 3, 1}, {1, 0, 5}) == 31);
  CHECK(mixto({1, 2, 3}, {4, 5, 6}, {5, 7, 9}) == 0);
}

TEST_CASE("Mapa.inv.1: the axes do not come to lie in one plane") {
  CHECK(is_map(leaning()));
  CHECK(mixto(leaning().x, leaning().y, leaning().z) < 0);  // a mirror is a map
  Mapa flat = leaning();
  flat.z = {flat.x.x + flat.y.x, flat.x.y + flat.y.y, flat.x.z + flat.y.z};
  const Judgements judged = inv(flat);
  REQUIRE(judged.size() == 1);
  CHECK(judged.front().what->label == "Mapa.inv.1");
  CHECK_FALSE(judged.front().holds);
}

TEST_CASE("puesto.def.1, dirigido.def.1: a point has a place, a direction has none") {
  const Mapa m = leaning();
  CHECK(puesto(m, Punto(0, 0, 0)) == ExactPoint(1, Surd(third(-2)), 3));
  CHECK(puesto(m, Punto(3, 1, 6)) == ExactPoint(8, Surd(third(-17)), Surd(third(26))));
  const ExactVector d = dirigido(m, {3, 1, 6});
  CHECK((d.x == 7 && d.y == -5 && d.z == third(17)));
}

TEST_CASE("visto.def.1: what is put at a point, exactly") {
  CHECK(visto(leaning(), ExactPoint(8, Surd(third(-17)), Surd(third(26)))) == ExactPoint(3, 1, 6));
  property("it takes back what puesto does, and the other way round", [] {
    const Mapa m = *any_map();
    const ExactPoint w = *any_point();
    RC_ASSERT(visto(m, puesto(m, w)) == w);
    RC_ASSERT(puesto(m, visto(m, w)) == w);
  });
  const ExactPoint on_a_sphere(Surd(0, 1, 2), Surd(0, -1, 2), 1);
  CHECK(visto(leaning(), puesto(leaning(), on_a_sphere)) == on_a_sphere);
}

TEST_CASE("copia.def.1: where the map puts the points, and no other") {
  const Escena escena = one_of_each();
  Random random(1);
  for (const Elemento& e : escena.elementos) check_drawn(puntos_de_elemento(escena, e), leaning(), random);
  const Puntos one([](const ExactPoint& w) { return w == ExactPoint(3, 1, 6); });
  CHECK(copia(leaning(), one).contains(ExactPoint(8, Surd(third(-17)), Surd(third(26)))));
  CHECK_FALSE(copia(leaning(), one).contains(ExactPoint(3, 1, 6)));
}

TEST_CASE("movido.def.1: the point at t is put at the point at t") {
  property("for every t", [] {
    const Mapa m = *any_map();
    const Rayo rayo = *any_ray();
    const Surd t((*any_rmas()).value());
    const ExactRay otro = movido(m, rayo);
    RC_ASSERT(puesto(m, along(otro.p, otro.v, t)) == along(rayo.p(), ExactVector(rayo.v()), t));
  });
}

TEST_CASE("compuesto.def.1: first the second, then the first") {
  property("as the two maps one after the other", [] {
    const Mapa m = *any_map(), n = *any_map(), k = compuesto(m, n);
    const ExactPoint u = *any_point();
    RC_ASSERT(puesto(k, u) == puesto(m, puesto(n, u)));
    RC_ASSERT(mixto(k.x, k.y, k.z) == mixto(m.x, m.y, m.z) * mixto(n.x, n.y, n.z));
  });
  const Mapa wide = stretched(2, 1), shifted = stretched(1, 1, {1, 0, 0});
  CHECK(puesto(compuesto(wide, shifted), Punto(0, 0, 0)) == ExactPoint(2, 0, 0));
  CHECK(puesto(compuesto(shifted, wide), Punto(0, 0, 0)) == ExactPoint(1, 0, 0));
}

TEST_CASE("identidad.def.1: no point leaves its place") {
  CHECK(identidad(identity()));
  CHECK_FALSE(identidad(stretched(1, 2)));
  CHECK_FALSE(identidad(stretched(1, 1, {0, 0, 1})));
  CHECK(compuesto(leaning(), identity()) == leaning());
  CHECK(compuesto(identity(), leaning()) == leaning());
}

TEST_CASE("estirado.def.1: the surfaces of one become those of the types") {
  const Mapa m = stretched(2, 5, {3, 4, 12});
  CHECK(estirado(m, Rmas(2), Rmas(5)));
  CHECK_FALSE(estirado(m, Rmas(5), Rmas(2)));
  CHECK_FALSE(estirado(leaning(), Rmas(2), Rmas(5)));
  Escena units = Init(), moved = Init();
  apply(units, Agregar_Esfera{esfera, origin, 1});
  apply(units, Agregar_Cilindro{cilindro, origin, 1, axis, 1});
  apply(units, Agregar_Cono{cono, origin, 1, axis, 1});
  apply(moved, Agregar_Esfera{esfera, far, 2});
  apply(moved, Agregar_Cilindro{cilindro, far, 2, axis, 5});
  apply(moved, Agregar_Cono{cono, far, 0.4, axis, 5});
  Random random(2);
  const auto same = [&](const Elemento& e, const Mapa& by) {
    const Puntos copy = puntos_de_instancia(units, by, e), own = puntos_de_elemento(moved, e);
    for (int i = 0; i < 20; ++i) {
      if (const auto w = own.sample(random)) CHECK(copy.contains(*w));
      if (const auto w = copy.sample(random)) CHECK(own.contains(*w));
    }
  };
  same(esfera, stretched(2, 2, {3, 4, 12}));
  same(cilindro, m);
  same(cono, stretched(number::exact(0.4) * 5, 5, {3, 4, 12}));
}

TEST_CASE("puntos_de_instancia.def.1: the copy of an element's points") {
  const Escena escena = one_of_each();
  const Puntos pebble = puntos_de_instancia(escena, stretched(2, third(1)), esfera);
  CHECK(pebble.contains(Punto(2, 0, 0)));
  CHECK(pebble.contains(ExactPoint(0, 0, Surd(third(-1)))));
  CHECK_FALSE(pebble.contains(Punto(0, 0, 1)));
  CHECK_THROWS_AS(puntos_de_instancia(escena, identity(), nuevo), std::out_of_range);
}

TEST_CASE("instancia_desde.def.1: the points whose power is the origin's, seen in the space of the original") {
  const Escena escena = one_of_each();
  const Mapa m = stretched(2, 3);
  const Puntos inner = instancia_desde(escena, m, esfera, Punto(1, 0, 0));  // half as large as the instance
  CHECK(inner.contains(Punto(-1, 0, 0)));
  CHECK(inner.contains(ExactPoint(0, 0, Surd(Rational(3) / 2))));
  CHECK_FALSE(inner.contains(Punto(2, 0, 0)));
  CHECK_THROWS_AS(instancia_desde(escena, m, nuevo, origin), std::out_of_range);
}
