#include "durero/model/haces.hpp"

#include <stdexcept>

#include "durero/model/puntos.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Rational part(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

const Rational little = part(1, 1000000007);
const Rayo eastwards(origin, Vector(2, 0, 0));

/// A number that a random deviation or matrix may have.
rc::Gen<Rational> any_part() {
  return rc::gen::apply(part, rc::gen::inRange<std::int64_t>(-20, 21), rc::gen::inRange<std::int64_t>(1, 9));
}
rc::Gen<Desvio> any_row() {
  return rc::gen::apply(
      [](const Rational& x, const Rational& y, const Rational& u, const Rational& v) {
        return Desvio{x, y, u, v};
      },
      any_part(), any_part(), any_part(), any_part());
}
rc::Gen<Matriz> any_matrix() {
  return rc::gen::apply(
      [](const Desvio& x, const Desvio& y, const Desvio& u, const Desvio& v) {
        return Matriz{x, y, u, v};
      },
      any_row(), any_row(), any_row(), any_row());
}

}  // namespace

TEST_CASE("cono_de_rayos.def.1: an angle of which 9/25 is the square of the cosine") {
  const Rational c = part(9, 25);
  CHECK(cono_de_rayos(eastwards, Rayo(origin, Vector(3, 4, 0)), c));  // equality is in
  CHECK(cono_de_rayos(eastwards, Rayo(origin, Vector(3, 0, -4)), c));
  CHECK_FALSE(cono_de_rayos(eastwards, Rayo(origin, Vector(3, 4, 0)), c + little));
  CHECK_FALSE(cono_de_rayos(eastwards, Rayo(origin, Vector(-3, 4, 0)), c));  // behind
  CHECK_FALSE(cono_de_rayos(eastwards, Rayo(far, Vector(3, 4, 0)), c));      // from elsewhere
  CHECK_FALSE(cono_de_rayos(eastwards, Rayo(origin, Vector(0, 1, 0)), 0));   // at a right angle
  CHECK(cono_de_rayos(eastwards, Rayo(origin, Vector(0x1p-500, 1, 0)), 0));
}

TEST_CASE("cono_de_rayos.def.1: a cone of no angle holds the rays along its axis, of any length, and no other") {
  CHECK(cono_de_rayos(eastwards, Rayo(origin, Vector(0.25, 0, 0)), 1));
  CHECK_FALSE(cono_de_rayos(eastwards, Rayo(origin, Vector(1, 0x1p-500, 0)), 1));
  property("random axes", [] {
    const Punto p = *any_point(), v = *any_point(), w = *any_point();
    RC_PRE(v != Punto(0, 0, 0) && w != Punto(0, 0, 0));
    const Rayo axis(p, Vector(v.xyz())), ray(p, Vector(w.xyz()));
    const ExactDirection a(v), b(w);
    const bool same_way =
        a.y * b.z == a.z * b.y && a.z * b.x == a.x * b.z && a.x * b.y == a.y * b.x && producto(a, b) > 0;
    RC_ASSERT(cono_de_rayos(axis, ray, 1) == same_way);
    RC_ASSERT(cono_de_rayos(axis, axis, 1));
  });
}

TEST_CASE("cubierto.def.1: the rays of the cone that meet the element") {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, Punto(10, 0, 0), 6});
  const Rational c = part(1, 2);
  CHECK(cubierto(escena, eastwards, Rayo(origin, Vector(4, 3, 0)), c, esfera));  // it grazes the ball
  CHECK_FALSE(cubierto(escena, eastwards, Rayo(origin, Vector(4, 3 + 0x1p-40, 0)), c, esfera));
  CHECK_FALSE(cubierto(escena, eastwards, Rayo(origin, Vector(4, 3, 0)), part(16, 25) + little, esfera));
  CHECK_FALSE(cubierto(escena, eastwards, Rayo(origin, Vector(4, 3, 0)), c, plano));
}

TEST_CASE("haz.def.1: the rays from a point through a triangle") {
  const Escena escena = one_of_each();
  const Punto eye(1, 1, 5);
  const auto towards = [&](double x, double y, double z) { return Rayo(eye, Vector(x - 1, y - 1, z - 5)); };
  CHECK(haz(eye, escena, triangulo, towards(1, 1, 0)));
  CHECK(haz(eye, escena, triangulo, towards(2, 2, 0)));  // through the edge
  CHECK_FALSE(haz(eye, escena, triangulo, towards(2 + 0x1p-40, 2, 0)));
  CHECK_FALSE(haz(eye, escena, triangulo, towards(1, 1, 10)));  // away from it
  CHECK_FALSE(haz(far, escena, triangulo, towards(1, 1, 0)));   // from elsewhere
}

TEST_CASE("seccion.def.1: the part of a beam on a plane, behind its base too") {
  const Escena escena = one_of_each();
  const Punto eye(0, 0, 4), below(0, 0, -4);
  CHECK(seccion(eye, escena, triangulo, below, axis, Punto(8, 0, -4)));
  CHECK(seccion(eye, escena, triangulo, below, axis, Punto(1, 1, -4)));
  CHECK_FALSE(seccion(eye, escena, triangulo, below, axis, Punto(8.5, 0, -4)));
  CHECK_FALSE(seccion(eye, escena, triangulo, below, axis, Punto(1, 1, -5)));  // on another plane
  CHECK_FALSE(seccion(eye, escena, triangulo, eye, axis, eye));                // the origin is on no ray
  CHECK_FALSE(seccion(eye, escena, triangulo, Punto(0, 0, 8), axis, Punto(1, 1, 8)));
  CHECK_THROWS_AS(seccion(Punto(0x1p60, 0, 4), escena, triangulo, below, axis, Punto(1, 1, -4)), std::domain_error);
}

TEST_CASE("imagen.def.1: the mirror image of a point, whatever the length of the normal") {
  const ExactPoint p(far), below{3, 4, -12};
  CHECK(imagen(origin, axis, p, below));
  CHECK(imagen(origin, Vector(0, 0, -8), p, below));
  CHECK(image(Punto(0, 0, 1), axis, p) == ExactPoint{3, 4, -10});
  CHECK_FALSE(imagen(origin, axis, p, p));
  CHECK_FALSE(imagen(origin, Vector(0, 0, 0), p, p));
  CHECK_THROWS_AS(image(origin, Vector(0, 0, 0), p), std::domain_error);
  property("it undoes itself, and the mirror sends on what comes from it", [] {
    const Punto a = *any_point(), b = *any_point(), eye = *any_point(), other = *any_point();
    RC_PRE(b != Punto(0, 0, 0));
    const Vector n(b.xyz());
    const ExactPoint o(eye), i = image(a, n, o);
    RC_ASSERT(image(a, n, i) == o);
    RC_ASSERT(imagen(a, n, i, o));
    RC_ASSERT(avance(i, a, n) == -avance(o, a, n));
    // The middle of another point and its image is on the mirror.
    const ExactPoint w(other), away = image(a, n, w);
    const ExactPoint q{(w.x + away.x) / 2, (w.y + away.y) / 2, (w.z + away.z) / 2};
    RC_ASSERT(avance(q, a, n) == 0);
    RC_ASSERT(reflexion({o.x - q.x, o.y - q.y, o.z - q.z}, ExactDirection(b), {q.x - i.x, q.y - i.y, q.z - i.z}));
  });
}

TEST_CASE("aplicado.def.1 and traslado.def.1: rows times a deviation, and the way along the axis") {
  const Matriz m{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
  CHECK(aplicado(m, {1, 10, 100, 1000}) == Desvio{4321, 8765, 13209, 17653});
  CHECK(traslado(3, {1, 2, 10, 20}) == Desvio{31, 62, 10, 20});
  const Pincel pencil{eastwards, {{1, 0, 3, 0}, {0, 1, 0, 3}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  property("ways add up, and are matrices", [&] {
    const Desvio d = *any_row();
    const Rational s = *any_part(), t = *any_part();
    RC_ASSERT(traslado(s + t, d) == traslado(t, traslado(s, d)));
    RC_ASSERT(aplicado(pencil.m, d) == traslado(3, d));
    const Matriz other = *any_matrix();
    const Desvio e = *any_row(), sum{d.x + s * e.x, d.y + s * e.y, d.u + s * e.u, d.v + s * e.v};
    const Desvio left = aplicado(other, d), right = aplicado(other, e);
    const Desvio both{left.x + s * right.x, left.y + s * right.y, left.u + s * right.u, left.v + s * right.v};
    RC_ASSERT(aplicado(other, sum) == both);
  });
}

TEST_CASE("refraccion_paraxial.def.1: a ball unites what comes along its axis at n·r/2(n − 1) from its centre") {
  CHECK(refraccion_paraxial(2, part(2, 3), {1, 3, 0, 6}) == Desvio{1, 3, part(-1, 6), part(7, 2)});
  CHECK_THROWS_AS(refraccion_paraxial(0, 1, {1, 0, 0, 0}), std::domain_error);
  property("any ball, any distance", [] {
    const Rational r = part(*rc::gen::inRange<std::int64_t>(1, 30), 7), x = *any_part(), y = *any_part();
    const Rational n = 1 + part(*rc::gen::inRange<std::int64_t>(1, 30), 11);
    const Desvio inside = traslado(2 * r, refraccion_paraxial(r, 1 / n, {x, y, 0, 0}));
    const Desvio focus = traslado(n * r / (2 * (n - 1)) - r, refraccion_paraxial(-r, n, inside));
    RC_ASSERT(focus.x == 0);
    RC_ASSERT(focus.y == 0);
  });
}
