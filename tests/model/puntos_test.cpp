#include "durero/model/puntos.hpp"

#include <stdexcept>

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

const Surd root2(0, 1, 2);

Rational ratio(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

rc::Gen<Rational> any_rational() {
  return rc::gen::apply(ratio, rc::gen::inRange<std::int64_t>(-1000, 1001), rc::gen::inRange<std::int64_t>(1, 1000));
}

}  // namespace

TEST_CASE("cuadrado.def.1 and raizcuadrada.def.1") {
  CHECK(cuadrado(Surd(-3)) == 9);
  CHECK(cuadrado(root2) == 2);
  CHECK(raizcuadrada(0) == 0);
  CHECK(raizcuadrada(Rational(9, 4)) == Surd(1.5));
  CHECK(raizcuadrada(2) == root2);
  CHECK_THROWS_AS(raizcuadrada(-1), std::domain_error);
  property("the root is not negative, and its square is the number", [] {
    const Rational r = abs(*any_rational());
    RC_ASSERT(raizcuadrada(r) >= 0);
    RC_ASSERT(raizcuadrada(r) * raizcuadrada(r) == Surd(r));
  });
}

TEST_CASE("avance.def.1 and alejamiento.def.1") {
  const Punto centro(1, 2, 3);
  CHECK(avance(Punto(1, 2, 3), centro, axis) == 0);
  CHECK(avance(Punto(4, 6, 5), centro, axis) == 2);
  CHECK(alejamiento(Punto(4, 6, 5), centro, axis) == 25);
  CHECK(avance({root2, Surd(0), Surd(1)}, origin, Vector(1, 0, 0)) == root2);
  CHECK(alejamiento({root2, Surd(0), Surd(1)}, origin, Vector(0, 0, 1)) == 2);
  property("Pythagoras, where the axis is exactly a unit vector", [] {
    const Punto w = *any_point(), c = *any_point();
    const Vector dir = *rc::gen::element(Vector(1, 0, 0), Vector(0, -1, 0), Vector(0, 0, 1));
    const Surd squared = cuadrado(Surd(w.x()) - c.x()) + cuadrado(Surd(w.y()) - c.y()) + cuadrado(Surd(w.z()) - c.z());
    RC_ASSERT(alejamiento(w, c, dir) + cuadrado(avance(w, c, dir)) == squared);
  });
}

TEST_CASE("producto.def.1") {
  CHECK(producto({1, 2, 3}, {4, -5, 6}) == 12);
  CHECK(producto({root2, 0, 1}, {root2, 7, 1}) == 3);
}

TEST_CASE("puntos_de_rayo.def.1: every positive parameter, and not the origin") {
  const Rayo ray(Punto(1, 2, 3), Vector(0, 2, -1));
  const Puntos points = puntos_de_rayo(ray);
  CHECK(points.contains(Punto(1, 4, 2)));
  CHECK(points.contains({Surd(1), Surd(2) + Surd(2) * root2, Surd(3) - root2}));
  CHECK_FALSE(points.contains(Punto(1, 2, 3)));
  CHECK_FALSE(points.contains(Punto(1, 0, 4)));
  CHECK_FALSE(points.contains(Punto(1 + 0x1p-52, 4, 2)));
  CHECK(parameter(ray, Punto(1, 0, 4)) == Surd(-1));
  CHECK(parameter(ray, Punto(2, 0, 4)) == std::nullopt);
  property("sampled points are members; beside the ray and behind its origin they are not", [] {
    const Rayo any = *any_ray();
    Random random = *any_random();
    const auto w = puntos_de_rayo(any).sample(random);
    RC_ASSERT(w.has_value());
    RC_ASSERT(puntos_de_rayo(any).contains(*w));
    const Surd t = parameter(any, *w).value();
    RC_ASSERT(!puntos_de_rayo(any).contains(along(any.p(), any.v(), -t)));
    const bool x_moves = any.v().y() != 0 || any.v().z() != 0;
    const ExactPoint beside{w->x + Surd(x_moves ? 0x1p-200 : 0), w->y + Surd(x_moves ? 0 : 0x1p-200), w->z};
    RC_ASSERT(!puntos_de_rayo(any).contains(beside));
  });
}

TEST_CASE("puntos_de_elemento.def.1 and puntos_de_escena.def.1") {
  const Escena scene = one_of_each();
  CHECK(puntos_de_elemento(scene, esfera).contains(Punto(0, 0, 1)));
  CHECK(puntos_de_elemento(scene, cilindro).contains(Punto(0, 1, 3)));
  CHECK(puntos_de_elemento(scene, cono).contains(Punto(0, 0, 3)));
  CHECK(puntos_de_elemento(scene, tronco).contains(Punto(0, 2, 1)));
  CHECK(puntos_de_elemento(scene, plano).contains(Punto(5, 7, 0)));
  CHECK(puntos_de_elemento(scene, disco).contains(Punto(0, 1, 0)));
  CHECK_FALSE(puntos_de_elemento(scene, disco).contains(Punto(5, 7, 0)));
  CHECK(puntos_de_elemento(scene, triangulo).contains(Punto(2, 2, 0)));
  CHECK_FALSE(puntos_de_elemento(scene, triangulo).contains(Punto(5, 7, 0)));
  CHECK_FALSE(puntos_de_elemento(scene, cono).contains(Punto(0, 0, 1)));
  CHECK_THROWS_AS(puntos_de_elemento(scene, nuevo), std::out_of_range);

  CHECK(puntos_de_escena(scene).contains(Punto(0, 1, 3)));
  CHECK_FALSE(puntos_de_escena(scene).contains(Punto(0, 0, 0.5)));
  Random random(1);
  CHECK_FALSE(puntos_de_escena(Init()).sample(random));
  CHECK_FALSE(puntos_de_escena(Init()).contains(origin));
  property("a point of the scene is one of some element", [] {
    const Escena any = any_scene();
    RC_PRE(!any.elementos.empty());
    Random seed = *any_random();
    const auto w = puntos_de_escena(any).sample(seed);
    RC_ASSERT(w.has_value());
    RC_ASSERT(puntos_de_escena(any).contains(*w));
    const auto contains = [&](const Elemento& e) { return puntos_de_elemento(any, e).contains(*w); };
    RC_ASSERT(std::any_of(any.elementos.begin(), any.elementos.end(), contains));
  });
}
