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

/// w moved away from its foot on the axis through centro by 2⁻²⁰⁰ of its distance, at the same advance where dir is a
/// unit vector.
ExactPoint off(const ExactPoint& w, const ExactPoint& foot) {
  const Surd stretch(Rational(1 + number::exact(0x1p-200)));
  return {foot.x + stretch * (w.x - foot.x), foot.y + stretch * (w.y - foot.y), foot.z + stretch * (w.z - foot.z)};
}

/// The foot of w on the line through centro.
ExactPoint foot_of(const ExactPoint& w, const Punto& centro, const Vector& dir) {
  return along(centro, dir, avance(w, centro, dir));
}

/// The point of the line through centro with this advance, where dir is exactly a unit vector.
ExactPoint on_axis(const Punto& centro, const Vector& dir, const Surd& s) { return along(centro, dir, s); }

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

TEST_CASE("potencia_esfera.def.1, potencia_cilindro.def.1, potencia_cono.def.1") {
  CHECK(potencia_esfera(Punto(3, 4, 0), origin, Rmas(2)) == 21);
  CHECK(potencia_esfera(origin, origin, Rmas(2)) == -4);
  CHECK(potencia_cilindro(Punto(3, 4, 9), origin, Rmas(2), axis) == 21);
  // The cone's base, of radius prop·h, is at the centre; its apex at s = h.
  CHECK(potencia_cono(Punto(2, 0, 0), origin, Rmas(0.5), axis, Rmas(4)) == 0);
  CHECK(potencia_cono(Punto(0, 0, 4), origin, Rmas(0.5), axis, Rmas(4)) == 0);
  CHECK(potencia_cono(Punto(0, 0, 0), origin, Rmas(0.5), axis, Rmas(4)) == -4);
  CHECK(potencia_cono(Punto(0, 1, 6), origin, Rmas(0.5), axis, Rmas(4)) == 0);  // the other half of the double cone
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
  CHECK_FALSE(puntos_de_elemento(scene, cono).contains(Punto(0, 0, 1)));
  CHECK_THROWS_AS(puntos_de_elemento(scene, nuevo), std::out_of_range);

  CHECK(puntos_de_escena(scene).contains(Punto(0, 1, 3)));
  CHECK_FALSE(puntos_de_escena(scene).contains(Punto(0, 0, 0)));
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
