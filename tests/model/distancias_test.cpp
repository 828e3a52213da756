#include "durero/model/distancias.hpp"

#include <array>

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

const std::array<ExactPoint, 4> about{ExactPoint{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -2}};

Surd root(int of) { return {0, 1, of}; }

/// A sphere of radius two about (1, 0, 0), and one that it touches from outside.
Escena two_spheres() {
  Escena escena = Init();
  apply(escena, Agregar_Esfera{esfera, Punto(1, 0, 0), 2});
  apply(escena, Agregar_Esfera{nuevo, Punto(6, 0, 0), 3});
  return escena;
}

}  // namespace

TEST_CASE("cercanos.def.1: one, several, or none of the empty set") {
  CHECK(cercanos(about, Punto(3, 0, 0)) == std::vector<ExactPoint>{{1, 0, 0}});
  CHECK(cercanos(about, Punto(0, 0, 0)) == std::vector<ExactPoint>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}});
  CHECK(cercanos({}, Punto(0, 0, 0)).empty());
  const std::array<ExactPoint, 2> twice{ExactPoint{root(2), 0, 0}, {root(2), 0, 0}};
  CHECK(cercanos(twice, Punto(0, 0, 0)).size() == 1);
}

TEST_CASE("a_distancia.def.1: the distance of the nearest points, which is one") {
  CHECK(a_distancia(about, Punto(3, 0, 0)) == Distancia{4});
  CHECK(a_distancia(about, Punto(0, 0, 1)) == Distancia{2});
  CHECK_FALSE(a_distancia({}, Punto(0, 0, 0)));
  property("it holds no point nearer, and changes no faster than the point moves", [] {
    const auto points = *rc::gen::container<std::vector<Punto>>(5, any_point());
    const std::vector<ExactPoint> ps(points.begin(), points.end());
    const Punto p = *any_point(), q = *any_point();
    const Surd r = a_distancia(ps, p)->square, s = a_distancia(ps, q)->square, step = distancia(p, q).square;
    for (const ExactPoint& w : ps) RC_ASSERT(distancia(w, p).square >= r);
    // √r ≤ √s + √step, without the roots: r − s − step ≤ 2√(s·step)
    const Surd more = r - s - step;
    RC_ASSERT(more <= 0 || cuadrado(more) <= Surd(4) * s * step);
  });
}

TEST_CASE("con_signo.def.1: negative inside a sphere, and of a sphere alone") {
  const Escena escena = two_spheres();
  const std::array<ExactPoint, 2> ends{ExactPoint{3, 0, 0}, {-1, 0, 0}};
  CHECK(con_signo(escena, esfera, Punto(2, 0, 0), -1, ends));
  CHECK_FALSE(con_signo(escena, esfera, Punto(2, 0, 0), 1, ends));
  CHECK(con_signo(escena, esfera, Punto(-4, 0, 0), 3, ends));
  CHECK_FALSE(con_signo(escena, esfera, Punto(-4, 0, 0), -3, ends));
  CHECK_FALSE(con_signo(escena, esfera, Punto(-4, 0, 0), 2, ends));
  CHECK(con_signo(escena, esfera, Punto(3, 0, 0), 0, ends));
  CHECK_FALSE(con_signo(escena, esfera, Punto(2, 0, 0), -1, {}));
  const std::array<ExactPoint, 1> on_cylinder{ExactPoint{1, 0, 1}};
  CHECK_FALSE(con_signo(one_of_each(), cilindro, Punto(2, 0, 1), 1, on_cylinder));  // open: no inside, no sign
  CHECK_THROWS_AS(con_signo(escena, disco, Punto(2, 0, 0), 1, ends), std::out_of_range);
}

TEST_CASE("antes.def.1: by x, then by y, then by z") {
  CHECK(antes({0, 5, 5}, {1, 0, 0}));
  CHECK_FALSE(antes({1, 0, 0}, {0, 5, 5}));
  CHECK(antes({1, 0, 5}, {1, 1, 0}));
  CHECK_FALSE(antes({1, 1, 0}, {1, 0, 5}));
  CHECK(antes({1, 1, -1}, {1, 1, 1}));
  CHECK_FALSE(antes({1, 1, 1}, {1, 1, -1}));
  CHECK(antes({root(2), 0, 0}, {root(2), 0, 0}));
}

TEST_CASE("mas_cercano.def.1: the distance, the first of the nearest points, and the elements that have it") {
  const Escena escena = two_spheres();
  const std::array<ExactPoint, 4> some{ExactPoint{3, 0, 0}, {9, 0, 0}, {-1, 0, 0}, {1, 2, 0}};
  // Outside, beyond the second sphere; where the two touch; and at the centre of the first, all of which is as near.
  CHECK(mas_cercano(escena, Punto(10, 0, 0), {1}, {9, 0, 0}, {nuevo}, some));
  CHECK_FALSE(mas_cercano(escena, Punto(10, 0, 0), {1}, {9, 0, 0}, {nuevo, esfera}, some));
  CHECK_FALSE(mas_cercano(escena, Punto(10, 0, 0), {2}, {9, 0, 0}, {nuevo}, some));
  CHECK_FALSE(mas_cercano(escena, Punto(10, 0, 0), {49}, {3, 0, 0}, {nuevo, esfera}, some));  // another is nearer
  CHECK_FALSE(mas_cercano(escena, Punto(10, 0, 0), {4}, {8, 0, 0}, {nuevo}, {}));             // no point of the scene
  CHECK(mas_cercano(escena, Punto(3, 0, 0), {0}, {3, 0, 0}, {esfera, nuevo}, some));
  CHECK_FALSE(mas_cercano(escena, Punto(3, 0, 0), {0}, {3, 0, 0}, {esfera}, some));
  CHECK(mas_cercano(escena, Punto(1, 0, 0), {4}, {-1, 0, 0}, {esfera, nuevo}, some));
  CHECK_FALSE(mas_cercano(escena, Punto(1, 0, 0), {4}, {1, 2, 0}, {esfera, nuevo}, some));  // another comes before
}
