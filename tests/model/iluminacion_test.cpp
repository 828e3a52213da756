#include "durero/model/iluminacion.hpp"

#include <cmath>
#include <numbers>
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

Rational ratio(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

/// A rational unit vector: the image of a rational point of the plane on the sphere (stereographic projection).
rc::Gen<ExactDirection> any_unit() {
  const auto number = [] {
    return rc::gen::apply(ratio, rc::gen::inRange<std::int64_t>(-60, 61), rc::gen::inRange<std::int64_t>(1, 30));
  };
  return rc::gen::apply(
      [](const Rational& a, const Rational& b, int pole) {
        const Rational s = a * a + b * b, d = s + 1;
        return ExactDirection{2 * a / d, 2 * b / d, pole * (s - 1) / d};
      },
      number(), number(), rc::gen::element(-1, 1));
}

/// A pair of incidencia: the first is turned to the side of the second.
rc::Gen<std::pair<ExactDirection, ExactDirection>> any_incidence() {
  return rc::gen::apply(
      [](const ExactDirection& i, const ExactDirection& n) {
        return std::pair(producto(i, n) < 0 ? ExactDirection{-i.x, -i.y, -i.z} : i, n);
      },
      any_unit(), any_unit());
}

ExactDirection turned(const ExactDirection& v) { return {-v.x, -v.y, -v.z}; }

const ExactDirection up{0, 0, 1};

}  // namespace

TEST_CASE("reflexion.def.1: a mirror of any normal but zero, from either side") {
  CHECK(reflexion({1, 2, 3}, up, {-1, -2, 3}));
  CHECK(reflexion({1, 2, 3}, {0, 0, -5}, {-1, -2, 3}));
  CHECK_FALSE(reflexion({1, 2, 3}, up, {-1, -2, -3}));
  CHECK_FALSE(reflexion({1, 2, 3}, up, {-1, 2, 3}));
  CHECK_FALSE(reflexion({1, 2, 3}, up, {1, -2, 3}));
  CHECK_FALSE(reflexion({1, 2, 3}, {0, 0, 0}, {-1, -2, -3}));
  CHECK_THROWS_AS(reflected({1, 2, 3}, ExactDirection{0, 0, 0}), std::domain_error);
  property("it keeps length and angle, and undoes itself", [] {
    const Punto a = *any_point(), b = *any_point();
    const ExactDirection v(a), n(b);
    RC_PRE(producto(n, n) > 0);
    const ExactDirection r = reflected(v, n);
    RC_ASSERT(reflexion(v, n, r));
    RC_ASSERT(producto(r, r) == producto(v, v));
    RC_ASSERT(producto(r, n) == producto(v, n));
    RC_ASSERT(reflected(r, n) == v);
  });
}

TEST_CASE("incidencia.def.1: unit vectors, the normal on the side of the light") {
  CHECK(incidencia({0, Surd(Rational(3, 5)), Surd(Rational(4, 5))}, up));
  CHECK(incidencia({1, 0, 0}, up));
  CHECK_FALSE(incidencia({0, 0, -1}, up));
  CHECK_FALSE(incidencia({0, 3, 4}, up));
  CHECK_FALSE(incidencia(up, {0, 0, 2}));
}

TEST_CASE("coseno_cuadrado.def.1 and reflexion_total.def.1: equality refracts") {
  const ExactDirection i{Rational(3, 5), 0, Rational(4, 5)};
  CHECK(coseno_cuadrado(i, up, 1) == Surd(Rational(16, 25)));
  CHECK(coseno_cuadrado(i, up, Rational(5, 3)) == 0);
  CHECK_FALSE(reflexion_total(i, up, Rational(5, 3)));
  CHECK(reflexion_total(i, up, Rational(5, 3) + Rational(1, 1000000007)));
  CHECK_FALSE(reflexion_total(turned(i), up, 2));
  // The greatest angles from glass of 1.5 and from water of 1.33 into air have the sines 2/3 and 100/133.
  CHECK_FALSE(reflexion_total({Rational(2, 3), 0, Surd(0, Rational(1, 3), 5)}, up, Rational(3, 2)));
  CHECK(reflexion_total({Rational(2, 3), 0, Surd(0, Rational(1, 3), 5)}, up, Rational(3, 2) + Rational(1, 1000000007)));
  CHECK_FALSE(reflexion_total({Rational(100, 133), 0, Surd(0, Rational(1, 133), 7689)}, up, Rational(133, 100)));
}

TEST_CASE("coseno_cuadrado.def.1: the numbers of the source text, 28.1255° at 45° into 1.5") {
  const Surd half_root(0, Rational(1, 2), 2);
  const Surd squared = coseno_cuadrado({half_root, 0, half_root}, up, Rational(2, 3));
  CHECK(squared == Surd(Rational(7, 9)));
  CHECK(number::round_to_binary64(raizcuadrada(squared.x)) == 0.88191710368819688694);
  CHECK(std::acos(number::round_to_binary64(raizcuadrada(squared.x))) * 180 / std::numbers::pi == Approx(28.1255057));
  CHECK(number::round_to_binary64(raizcuadrada(1 - squared.x)) == 0.47140452079103168293);
}

TEST_CASE("refraccion.def.1, where the root is rational") {
  const ExactDirection i{Rational(4, 5), 0, Rational(3, 5)};
  const ExactDirection t = refracted(i, up, Rational(3, 4)).value();
  CHECK(t == ExactDirection{Rational(-3, 5), 0, Rational(-4, 5)});
  CHECK(refraccion(i, up, Rational(3, 4), t));
  CHECK_FALSE(refraccion(i, up, Rational(3, 4), {Rational(-3, 5), 0, Rational(4, 5)}));   // on the near side
  CHECK_FALSE(refraccion(i, up, Rational(3, 4), {0, Rational(-3, 5), Rational(-4, 5)}));  // in another plane
  CHECK_FALSE(refraccion(i, up, Rational(3, 4), {Rational(-3, 5), 0, Rational(-1, 2)}));  // by another angle
  CHECK_FALSE(refraccion(i, up, Rational(1, 2), t));
  CHECK_FALSE(refraccion(turned(i), up, Rational(3, 4), t));
}

TEST_CASE("refraccion.def.1: Snell, one plane, back again, and straight on between equal media") {
  property("where it exists", [] {
    const auto [i, n] = *any_incidence();
    const Rational razon = ratio(*rc::gen::inRange<std::int64_t>(1, 50), *rc::gen::inRange<std::int64_t>(1, 50));
    RC_ASSERT(refracted(i, n, 1) == turned(i));
    const Surd squared = coseno_cuadrado(i, n, razon);
    RC_ASSERT(reflexion_total(i, n, razon) == (squared < 0));
    if (squared < 0) {
      RC_ASSERT(razon > 1);
      RC_ASSERT(!refracted(i, n, razon));
      return;
    }
    // The root is irrational as a rule, and t then lies in its field.
    const ExactDirection t = refracted(i, n, razon).value();
    RC_ASSERT(refraccion(i, n, razon, t));
    RC_ASSERT(producto(t, t) == 1);
    RC_ASSERT(producto(t, n) <= 0);
    RC_ASSERT(Surd(1) - producto(t, n) * producto(t, n) ==
              Surd(razon * razon) * (Surd(1) - producto(i, n) * producto(i, n)));
    RC_ASSERT(refraccion(t, turned(n), 1 / razon, i));
  });
}
