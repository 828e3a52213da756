#include "durero/model/solidos.hpp"

#include "durero/model/tipo/cilindro.hpp"
#include "durero/model/tipo/cono.hpp"
#include "durero/model/tipo/esfera.hpp"
#include "durero/model/tipo/plano.hpp"
#include "durero/model/tipo/tronco.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

Cuadrica quadric(std::array<int, 10> coefficients) {
  Cuadrica::Coefficients c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = coefficients[i];
  return Cuadrica(c);
}

const Cuadrica ball = quadric({1, 1, 1, 0, 0, 0, 0, 0, 0, -1}), twice = quadric({2, 2, 2, 0, 0, 0, 0, 0, 0, -2});
const Cuadrica outside = quadric({-1, -1, -1, 0, 0, 0, 0, 0, 0, 1}), plane = quadric({0, 0, 0, 0, 0, 0, 0, 0, 1, 0});

const Unitario up{Vector(0, 0, 1)};
const Punto origin(0, 0, 0);

const Solido solid_ball = solido_esfera(origin, Rmas(1)), lower = solido_plano(origin, up);

/// The cube 0 … 1, or moved by so much along x.
Solido cube(double x) {
  return solido_plano({x, 0, 0}, Unitario{Vector(-1, 0, 0)}) & solido_plano({x + 1, 0, 0}, Unitario{Vector(1, 0, 0)}) &
         solido_tramo({0, 0, 0}, Unitario{Vector(0, 1, 0)}, Rmas(1)) & solido_tramo({0, 0, 0}, up, Rmas(1));
}

Rational half() { return Rational(1) / 2; }

}  // namespace

TEST_CASE("Cuadrica.inv.1: some coefficient is not 0") {
  CHECK(violated([] { quadric({}); }) == "Cuadrica.inv.1");
  CHECK(plane.coefficients()[8] == 1);
}

TEST_CASE("valor.def.1: every coefficient by its product") {
  const Cuadrica all = quadric({1, 10, 100, 1000, 10000, 100000, 2, 20, 200, 7});
  CHECK(valor(all, {2, 3, 5}) == 4 + 90 + 2500 + 15000 + 100000 + 600000 + 4 + 60 + 1000 + 7);
  CHECK(valor(ball, {Surd(0, 1, 2), 0, 0}) == 1);
}

TEST_CASE("multiplo.def.1: by one factor, which is not 0") {
  CHECK(multiplo(twice, ball) == Rational(2));
  CHECK(multiplo(ball, outside) == Rational(-1));
  CHECK(multiplo(ball, plane) == std::nullopt);
  CHECK(multiplo(plane, ball) == std::nullopt);
  CHECK(multiplo(quadric({1, 1, 1, 0, 0, 0, 0, 0, 0, -2}), ball) == std::nullopt);
}

TEST_CASE("dentro.def.1, fuera.def.1: by the sign of the value") {
  const Cuadricas cs{ball, outside, plane};
  CHECK(dentro(cs, {0, 0, 0}) == Cuadricas{ball});
  CHECK(fuera(cs, {0, 0, 0}) == Cuadricas{outside});
  CHECK(dentro(cs, {0, 0, -1}) == Cuadricas{plane});
  CHECK(fuera(cs, {0, 0, -1}).empty());
}

TEST_CASE("repartos.def.1: inside of what is inside, and multiples together") {
  CHECK(repartos({ball, plane}, {ball}, {plane}) == std::vector{Cuadricas{ball}});
  CHECK(repartos({ball, plane}, {ball}, {}).size() == 2);
  CHECK(repartos({ball, plane}, {}, {}).size() == 4);
  CHECK(repartos({ball, twice}, {}, {}).size() == 2);
  for (const Cuadricas& l : repartos({ball, outside}, {}, {})) CHECK(l.size() == 1);
}

TEST_CASE("solido_esfera.def.1, solido_plano.def.1: the quadric of the power") {
  CHECK(solid_ball.cuadricas == Cuadricas{ball});
  CHECK(lower.cuadricas == Cuadricas{plane});
  CHECK(solid_ball.contains({ball}));
  CHECK_FALSE(solid_ball.contains({}));
}

TEST_CASE("solido_tramo.def.1, solido_cilindro.def.1, solido_cono.def.1, solido_tronco.def.1: shapes with their lids") {
  const Unitario lean{Vector(0.6, 0, 0.8)};
  const Punto c(1, -2, 0.5);
  const Rmas r(0.75), k(1.5), h(2);
  const auto inside = [&](const Solido& s, const ExactPoint& w) { return interior(s).contains(w); };
  property("inside between the lids and where the power is negative", [&] {
    const ExactPoint w = *any_point();
    const Surd s = avance(w, c, lean.vector());
    const bool between = s > 0 && s < 2;
    RC_ASSERT(inside(solido_tramo(c, lean, h), w) == between);
    RC_ASSERT(inside(solido_cilindro(c, r, lean, h), w) == (between && potencia_cilindro(w, c, r, lean.vector()) < 0));
    RC_ASSERT(inside(solido_cono(c, k, lean, h), w) == (between && potencia_cono(w, c, k, lean.vector(), h) < 0));
    RC_ASSERT(inside(solido_tronco(c, r, k, lean, h), w) ==
              (between && potencia_tronco(w, c, r, k, lean.vector(), h) < 0));
  });
  CHECK(superficie(solido_cilindro(origin, Rmas(1), up, h)).contains({0, 0, 2}));
  CHECK(superficie(solido_cono(origin, Rmas(1), up, h)).contains({0, 0, 2}));
  CHECK_FALSE(cuerpo(solido_cono(origin, Rmas(1), up, h)).contains({0, 0, 3}));
  CHECK(superficie(solido_tronco(origin, Rmas(1), Rmas(1), up, h)).contains({Surd(half()), 0, 2}));
}

TEST_CASE("cuerpo.def.1, interior.def.1, superficie.def.1: off the faces those of sets") {
  property("unions, intersections and differences", [] {
    const Solido s = solid_ball, t = solido_esfera(*any_point(), Rmas(1));
    const ExactPoint w = *any_point();
    const bool in_s = interior(s).contains(w), in_t = interior(t).contains(w);
    RC_PRE(!superficie(s).contains(w) && !superficie(t).contains(w));
    RC_ASSERT(interior(s | t).contains(w) == (in_s || in_t));
    RC_ASSERT(interior(s & t).contains(w) == (in_s && in_t));
    RC_ASSERT(interior(s - t).contains(w) == (in_s && !in_t));
    RC_ASSERT(interior(complemento(s)).contains(w) == !in_s);
    RC_ASSERT(cuerpo(s - t).contains(w) == (in_s && !in_t));
  });
}

TEST_CASE("solido_union.def.1, solido_interseccion.def.1, solido_diferencia.def.1: those of sets of allotments") {
  for (const Cuadricas& l : {Cuadricas{}, Cuadricas{ball}, Cuadricas{plane}, Cuadricas{ball, plane}}) {
    const bool in_ball = l.contains(ball), in_lower = l.contains(plane);
    CHECK(solido_union(solid_ball, lower).contains(l) == (in_ball || in_lower));
    CHECK(solido_interseccion(solid_ball, lower).contains(l) == (in_ball && in_lower));
    CHECK(solido_diferencia(solid_ball, lower).contains(l) == (in_ball && !in_lower));
  }
}

TEST_CASE("superficie.def.1: shared faces, edges and what is taken from itself") {
  const Solido two = cube(0) | cube(1);
  const ExactPoint shared(1, Surd(half()), Surd(half())), edge(1, 1, Surd(half())), side(Surd(half()), 1, Surd(half()));
  CHECK(interior(two).contains(shared));
  CHECK(superficie(two).contains(edge));
  CHECK(superficie(two).contains(side));
  CHECK_FALSE(cuerpo(cube(0) & cube(1)).contains(shared));
  CHECK(superficie(cube(0) - cube(1)).contains(shared));
  CHECK_FALSE(cuerpo(cube(0) - cube(0)).contains(side));
  CHECK(interior(cube(0) | complemento(cube(0))).contains(side));
  const Solido touching = solid_ball & solido_esfera({2, 0, 0}, Rmas(1));
  CHECK(superficie(touching).contains({1, 0, 0}));
  CHECK_FALSE(cuerpo(touching).contains({0, 0, 0}));
}

TEST_CASE("con_multiplos.def.1: with a quadric all its multiples") {
  const Cuadricas cs{ball, twice, outside, plane};
  CHECK(con_multiplos(cs, {ball, twice, outside}));
  CHECK(con_multiplos(cs, {plane}));
  CHECK_FALSE(con_multiplos(cs, {ball, twice}));
}

TEST_CASE("dentro_desde.def.1, fuera_desde.def.1: values less those of the origin") {
  const Punto off(0, 0, 1 + 0x1p-40);  // a point of the sphere, badly rounded
  const Cuadricas cs{ball, plane};
  CHECK(dentro_desde(cs, off, {ball}, {0, 0, 1}) == Cuadricas{ball});
  CHECK(fuera_desde(cs, off, {ball}, {0, 0, 2}) == Cuadricas{ball, plane});
  CHECK(fuera_desde(cs, off, {}, off) == Cuadricas{ball, plane});
  CHECK(fuera_desde(cs, off, {ball}, off) == Cuadricas{plane});
}

TEST_CASE("superficie_desde.def.1: the way out, and no face that the ray leaves") {
  const Rayo through(Punto(0, 0, -2), Vector(0, 0, 1));
  CHECK(superficie_desde(solid_ball, through, {}, {0, 0, -1}));
  CHECK(superficie_desde(solid_ball, through, {}, {0, 0, 1}));
  CHECK_FALSE(superficie_desde(solid_ball, through, {}, {0, 0, 0}));
  CHECK_FALSE(superficie_desde(solid_ball, through, {}, {1, 0, 0}));  // a point of it, and none of the ray
  const Rayo leaving(Punto(0, 0, 1 - 0x1p-40), Vector(0, 0, 1));
  CHECK(superficie_desde(solid_ball, leaving, {}, {0, 0, 1}));
  CHECK_FALSE(superficie_desde(solid_ball, leaving, {ball}, {0, 0, 1}));
}

TEST_CASE("en_parametro.def.1: p + t·v") {
  CHECK(en_parametro(Rayo(Punto(1, 2, 3), Vector(1, 0, -1)), 2) == ExactPoint(3, 2, 1));
}

TEST_CASE("hecho_de.def.1: the quadrics that tell what is in a solid") {
  CHECK(hecho_de(solid_ball, {ball}));
  CHECK(hecho_de(solid_ball, {ball, plane}));
  CHECK_FALSE(hecho_de(solid_ball & lower, {ball}));
  CHECK(hecho_de((solid_ball & lower) | (solid_ball - lower), {ball}));
}
