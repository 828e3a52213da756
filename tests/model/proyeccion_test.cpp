#include "durero/model/proyeccion.hpp"

#include <stdexcept>

#include "durero/model/tipo/triangulo.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Rational part(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

/// A triangle at that height, over the corner of the floor.
Terna at_height(double z, double size) { return {{0, 0, z}, {size, 0, z}, {0, size, z}}; }

const ExactPoint light{0, 0, 4};

Material sheet(const Rational& k_t, const Rational& M_T) {
  Material m{};
  m.k_t = k_t;
  m.M_T = M_T;
  m.M_PS = m.C = m.indice = m.e = 1;
  return m;
}

/// A triangle of the grid, with an area.
rc::Gen<Terna> any_grid_terna() {
  return rc::gen::suchThat(rc::gen::apply(
                               [](const Punto& a, const Punto& b, const Punto& c) {
                                 return Terna{a, b, c};
                               },
                               any_point(), any_point(), any_point()),
                           [](const Terna& v) { return Vertices::contains(v); });
}

}  // namespace

TEST_CASE("entre.def.1: neither end, and nothing beside") {
  const ExactPoint x{0, 0, 0}, y{2, 4, 6};
  CHECK(entre(x, y, {1, 2, 3}));
  CHECK(entre(y, x, {Surd(part(1, 1000000007)), Surd(part(2, 1000000007)), Surd(part(3, 1000000007))}));
  CHECK_FALSE(entre(x, y, x));
  CHECK_FALSE(entre(x, y, y));
  CHECK_FALSE(entre(x, y, {-1, -2, -3}));
  CHECK_FALSE(entre(x, y, {1, 2, 4}));
  CHECK(entre({0, 0, 1}, {0, 0, 3}, {0, 0, 2}));
  CHECK(entre({0, 1, 1}, {0, 3, 3}, {0, 2, 2}));
  CHECK(entre(x, x, x));  // every s leads there
  CHECK_FALSE(entre(x, x, y));
}

TEST_CASE("sombra.def.1: rims are in it, the triangle itself is not, nor what lies before it") {
  const Puntos shadow = sombra(light, at_height(2, 1));
  CHECK(shadow.contains({Surd(part(1, 2)), Surd(part(1, 2)), 0}));
  CHECK(shadow.contains({2, 0, 0}));
  CHECK(shadow.contains({1, 1, 0}));
  CHECK_FALSE(shadow.contains({1, Surd(part(1000000008, 1000000007)), 0}));
  CHECK_FALSE(shadow.contains({0, 0, 2}));
  CHECK_FALSE(shadow.contains({0, 0, 3}));
  CHECK_FALSE(shadow.contains({0, 0, 5}));
}

TEST_CASE("sombra.def.1: of a triangle edge-on, the part of its plane behind it") {
  const Puntos shadow = sombra(ExactPoint{-4, 0, 0}, at_height(0, 1));
  CHECK(shadow.contains({2, 0, 0}));
  CHECK(shadow.contains({Surd(part(1, 2)), 0, 0}));
  CHECK(shadow.contains({1, 1, 0}));
  CHECK_FALSE(shadow.contains({0, 0, 0}));
  CHECK_FALSE(shadow.contains({-1, 0, 0}));
  CHECK_FALSE(shadow.contains({2, 2, 0}));
  CHECK_FALSE(shadow.contains({2, 0, 1}));
}

TEST_CASE("iluminada.def.1: a triangle without the shadows of others") {
  const Puntos lit = iluminada(light, at_height(0, 4), {at_height(2, 1), at_height(-1, 9)});
  CHECK(lit.contains({3, 0, 0}));
  CHECK(lit.contains({2, 1, 0}));
  CHECK_FALSE(lit.contains({1, 1, 0}));
  CHECK_FALSE(lit.contains({0, 0, 0}));
  CHECK_FALSE(lit.contains({3, 0, 1}));
  CHECK_FALSE(lit.contains({5, 0, 0}));
}

TEST_CASE("iluminada.def.1 and visible.def.1: clipping by shadows and sending a ray come to one verdict") {
  property("at corners, on edges and inside, for triangles of the grid", [] {
    Escena escena = Init();
    std::vector<Terna> all;
    for (int i = 0; i < 3; ++i) {
      all.push_back(*any_grid_terna());
      apply(escena, Agregar_Triangulo{Elemento("t" + std::to_string(i)), all.back()});
    }
    const Punto y = *any_point();
    RC_PRE(potencia_triangulo(y, all[0]) != 0);
    const Punto &a = all[0].a, &b = all[0].b, &c = all[0].c;
    const double u = *rc::gen::element(0.0, 0.25, 0.5, 1.0), v = (1 - u) * *rc::gen::element(0.0, 0.5, 1.0);
    const Punto p(a.xyz() + u * (b.xyz() - a.xyz()) + v * (c.xyz() - a.xyz()));
    RC_PRE(puntos_triangulo(all[0]).contains(p));
    RC_ASSERT(iluminada(y, all[0], {all[1], all[2]}).contains(p) == visible(escena, p, y, {Elemento("t0")}));
  });
}

TEST_CASE("proyectado.def.1: on the plane, before the eye") {
  const Punto floor(0, 0, 0);
  const Vector up(0, 0, 1);
  CHECK(proyectado(light, {1, 1, 2}, floor, up) == ExactPoint{2, 2, 0});
  CHECK(proyectado(light, {1, 1, -4}, floor, up) == ExactPoint{Surd(part(1, 2)), Surd(part(1, 2)), 0});
  CHECK_FALSE(proyectado(light, {1, 1, 4}, floor, up));
  CHECK_FALSE(proyectado(light, {1, 1, 5}, floor, up));
  CHECK(proyectado({0, 0, 0}, {1, 1, 2}, floor, up) == std::nullopt);  // the eye itself is not on the ray
  CHECK_THROWS_AS(proyectado({0, 0, 0}, {1, 1, 0}, floor, up), std::domain_error);
}

TEST_CASE(
    "profundidad.def.1 and oscura.def.1: right in the map's own direction, and a plane shadows itself beside it") {
  Escena escena = Init();
  apply(escena, Agregar_Plano{plano, {0, 0, 1}, {0, 0, 1}});
  const Rayo straight({0, 0, 4}, {0, 0, -2});
  CHECK(profundidad(escena, straight)->square == 9);
  CHECK_FALSE(oscura(*profundidad(escena, straight), {0, 0, 1}, light));
  CHECK(oscura(*profundidad(escena, straight), {0, 0, 0}, light));
  CHECK(oscura(*profundidad(escena, straight), {Surd(part(1, 1000000007)), 0, 1}, light));
  CHECK_FALSE(profundidad(escena, Rayo({0, 0, 4}, {0, 0, 1})));
}

TEST_CASE("mezcla.def.1: the numbers of the print, and the order") {
  const Material one = sheet(1, part(1, 2)), two = sheet(part(1, 2), part(1, 2));
  const Surd x = part(8, 10), y = part(2, 10), z = part(1, 10);
  CHECK(mezcla(two, z, mezcla(one, y, x)) == Surd(part(1, 4)));
  CHECK(mezcla(one, z, mezcla(two, x, y)) == Surd(part(525, 1000)));
  CHECK(mezcla(one, y, mezcla(two, z, x)) == Surd(part(35, 100)));
  CHECK(mezcla(two, 0, mezcla(one, 0, x)) == mezcla(one, 0, mezcla(two, 0, x)));
  Material glass = one;
  glass.emisividad = part(1, 7);
  glass.A_G = part(2, 7);
  CHECK(mezcla(glass, part(3, 7) + y, x) == radiancia(glass, y, 5, x));
}
