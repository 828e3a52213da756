#include "durero/model/interseccion.hpp"

#include <algorithm>

#include "durero/model/type_list.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using Names = std::set<Elemento>;

namespace {

const Elemento a("a"), b("b");

/// A sphere of radius 1 at (0, 0, 5) and a cylinder of radius 1 and height 4 around the z axis from the origin: the
/// sphere's near pole (0, 0, 4) lies in the plane of the cylinder's far rim.
Escena sphere_and_cylinder() {
  Escena s = Init();
  model::apply(s, Agregar_Esfera{esfera, Punto(0, 0, 5), 1});
  model::apply(s, Agregar_Cilindro{cilindro, origin, 1, axis, 4});
  return s;
}

/// Two spheres that touch at (2, 0, 0).
Escena touching() {
  Escena s = Init();
  model::apply(s, Agregar_Esfera{a, origin, 2});
  model::apply(s, Agregar_Esfera{b, Punto(5, 0, 0), 3});
  return s;
}

template <class Outcome>
Outcome answer(const Escena& s, const Rayo& rayo, const Names& en = {}) {
  return std::get<Outcome>(Primera_Interseccion(s, {rayo, en}));
}

}  // namespace

TEST_CASE("interseccion.def.1") {
  const Puntos both = interseccion(puntos_esfera(origin, Rmas(2)), puntos_esfera(Punto(5, 0, 0), Rmas(3)));
  CHECK(both.contains(Punto(2, 0, 0)));
  CHECK_FALSE(both.contains(Punto(-2, 0, 0)));
  CHECK_FALSE(both.contains(Punto(8, 0, 0)));
  Random random(1);
  CHECK_FALSE(both.sample(random));
}

TEST_CASE("distancia.def.1") {
  CHECK(distancia(origin, Punto(3, 4, 12)).square == 169);
  CHECK(distancia(origin, origin).square == 0);
  CHECK(distancia({Surd(0, 1, 2), Surd(0), Surd(0)}, origin).square == 2);
  CHECK(distancia(origin, Punto(1, 0, 0)) < distancia(origin, Punto(1, 1, 0)));
  property("the triangle of distances", [] {
    const Punto p = *any_point(), q = *any_point();
    RC_ASSERT(distancia(p, q) == distancia(q, p));
    RC_ASSERT((distancia(p, q).square == 0) == (p == q));
  });
}

TEST_CASE("reduccion.def.1: where there is no nearest point, or there are several, there is no reduction") {
  CHECK(reduccion(std::vector<ExactPoint>{}, origin) == std::nullopt);
  CHECK(reduccion(std::vector<ExactPoint>{Punto(1, 0, 0), Punto(-1, 0, 0), Punto(2, 0, 0)}, origin) == std::nullopt);
  CHECK(reduccion(std::vector<ExactPoint>{Punto(1, 0, 0), Punto(1, 0, 0)}, origin) == ExactPoint(Punto(1, 0, 0)));
}

TEST_CASE("reduccion.def.2: the nearest point, in whatever order they come") {
  const ExactPoint near{Surd(0, 1, 2), Surd(0), Surd(0)};  // at √2, in another field than the others
  std::vector<ExactPoint> points{Punto(2, 0, 0), Punto(1, 1, 1), near};
  for (int i = 0; i < 3; ++i) {
    std::rotate(points.begin(), points.begin() + 1, points.end());
    CHECK(reduccion(points, origin) == near);
  }
  property("no point is nearer", [] {
    std::vector<ExactPoint> ps;
    for (const Punto& p : *rc::gen::container<std::vector<Punto>>(any_point())) ps.emplace_back(p);
    const Punto eye = *any_point();
    const auto nearest = reduccion(ps, eye);
    int as_near = 0;
    for (const ExactPoint& p : ps) {
      if (nearest) RC_ASSERT(distancia(*nearest, eye) <= distancia(p, eye));
      as_near += nearest && distancia(*nearest, eye) == distancia(p, eye);
    }
    RC_ASSERT(!nearest || as_near >= 1);
  });
}

TEST_CASE("de_que_elemento.def.1: a set, since surfaces touch") {
  CHECK(de_que_elemento(touching(), Punto(2, 0, 0)) == Names{a, b});
  CHECK(de_que_elemento(touching(), Punto(-2, 0, 0)) == Names{a});
  CHECK(de_que_elemento(touching(), Punto(1, 0, 0)) == Names{});
}

TEST_CASE("potencia.def.1: the choice by type") {
  const Escena s = one_of_each();
  const Punto w(3, 4, 2);
  CHECK(potencia(s, esfera, w) == potencia_esfera(w, origin, Rmas(1)));
  CHECK(potencia(s, cilindro, w) == potencia_cilindro(w, origin, Rmas(1), axis));
  CHECK(potencia(s, cono, w) == potencia_cono(w, origin, Rmas(0.5), axis, Rmas(3)));
  CHECK(potencia(s, tronco, w) == potencia_tronco(w, origin, Rmas(1), Rmas(0.5), axis, Rmas(3)));
  CHECK(potencia(s, plano, w) == potencia_plano(w, origin, axis));
  CHECK(potencia(s, disco, w) == potencia_plano(w, origin, axis));
  CHECK(potencia(s, triangulo, w) == potencia_triangulo(w, corners));
  CHECK_THROWS_AS(potencia(s, nuevo, w), std::out_of_range);
}

TEST_CASE("tramo.def.1: a bounded element keeps its stretch of the axis") {
  const Escena s = one_of_each();
  CHECK(tramo(s, esfera).contains(Punto(7, 8, 9)));
  for (const Elemento& e : {cilindro, cono}) {
    CHECK(tramo(s, e).contains(Punto(7, 8, 0)));
    CHECK(tramo(s, e).contains(Punto(7, 8, 3)));
    CHECK_FALSE(tramo(s, e).contains(Punto(7, 8, 3.5)));
    CHECK_FALSE(tramo(s, e).contains(Punto(7, 8, -0.5)));
  }
}

TEST_CASE("tramo.def.1: a disc keeps its ball, a triangle its prism") {
  const Escena s = one_of_each();
  CHECK(tramo(s, plano).contains(Punto(7, 8, 9)));
  CHECK(tramo(s, disco).contains(Punto(0, 0, -1)));
  CHECK_FALSE(tramo(s, disco).contains(Punto(0, 0, 1 + 0x1p-52)));
  CHECK_FALSE(tramo(s, disco).contains(Punto(0.75, 0.75, 0)));
  CHECK(tramo(s, triangulo).contains(Punto(2, 2, -9)));
  CHECK(tramo(s, triangulo).contains(Punto(0, 0, 9)));
  CHECK_FALSE(tramo(s, triangulo).contains(Punto(2 + 0x1p-51, 2, 0)));
  CHECK_FALSE(tramo(s, triangulo).contains(Punto(-0x1p-1074, 1, 0)));
  CHECK_FALSE(tramo(s, triangulo).contains(Punto(1, -0x1p-1074, 0)));
  CHECK_THROWS_AS(tramo(s, nuevo), std::out_of_range);
}

TEST_CASE("alcance: in its plane a flat element is met in a segment, a point or nothing") {
  const Escena s = one_of_each();
  const auto of = [&](const Elemento& e, const Punto& p, const Vector& v, const Names& en = {}) {
    return alcance(s, Rayo(p, v), en, e).parameters;
  };
  const Surd half_root3(0, Rational(1, 2), 3);
  const Parameters chord = of(disco, Punto(-2, 0.5, 0), Vector(1, 0, 0));
  REQUIRE(chord.interval);
  CHECK(chord.minimum() == Surd(2) - half_root3);
  CHECK(chord.contains(Surd(2) + half_root3));
  CHECK_FALSE(chord.contains(Surd(2) + half_root3 + Surd(0x1p-300)));
  const Parameters touch = of(disco, Punto(-2, 1, 0), Vector(1, 0, 0));
  CHECK(touch.minimum() == Surd(2));
  CHECK_FALSE(touch.contains(Surd(2) + Surd(0x1p-300)));
  CHECK(of(disco, Punto(-2, 1.5, 0), Vector(1, 0, 0)).is_empty());
  CHECK(of(disco, Punto(0, 0, 0), Vector(1, 1, 0)).minimum() == std::nullopt);
  CHECK(of(disco, Punto(1, 0, 0), Vector(1, 0, 0)).is_empty());  // it leaves at the rim
  CHECK(of(disco, Punto(0, 0, 1), Vector(1, 0, 0)).is_empty());
  CHECK(of(disco, Punto(0.5, 0, 0.5), Vector(1, 0, 0), {disco}).minimum() == std::nullopt);
  CHECK(of(disco, Punto(0.5, 0, 0), Vector(0, 0, 1), {disco}).is_empty());

  const Parameters through = of(triangulo, Punto(-1, 1, 0), Vector(1, 0, 0));
  REQUIRE(through.interval);
  CHECK(through.minimum() == Surd(1));
  CHECK(through.contains(4));
  CHECK_FALSE(through.contains(Surd(4) + Surd(0x1p-300)));
  CHECK(of(triangulo, Punto(-4, 8, 0), Vector(1, -1, 0)).minimum() == Surd(4));  // along an edge
  CHECK(of(triangulo, Punto(-1, 4, 0), Vector(1, 0, 0)).minimum() == Surd(1));   // at a vertex
  CHECK_FALSE(of(triangulo, Punto(-1, 4, 0), Vector(1, 0, 0)).contains(Surd(1) + Surd(0x1p-300)));
  CHECK(of(triangulo, Punto(1, 1, 0), Vector(1, 0, 0)).minimum() == std::nullopt);
  CHECK(of(triangulo, Punto(1, 1, 1), Vector(1, 0, 0)).is_empty());
  CHECK(of(triangulo, Punto(1, 1, 0x1p-60), Vector(1, 0, 0), {triangulo}).minimum() == std::nullopt);
  CHECK(of(triangulo, Punto(1, 1, -1), Vector(0, 0, 1)).minimum() == Surd(1));
  CHECK(of(triangulo, Punto(2, 2, -1), Vector(0, 0, 1)).minimum() == Surd(1));
  CHECK(of(triangulo, Punto(2, 2 + 0x1p-51, -1), Vector(0, 0, 1)).is_empty());
}

TEST_CASE("puntos_desde.def.1: the surface of the same equation through the origin") {
  const Escena s = one_of_each();
  const Punto p(1 + 0x1p-52, 0, 1);  // beside the sphere of radius 1 about (0, 0, 0), at its own distance
  CHECK(puntos_desde(s, cilindro, p).contains(p));
  CHECK(puntos_desde(s, cilindro, p).contains(Punto(0, 1 + 0x1p-52, 2)));
  CHECK_FALSE(puntos_desde(s, cilindro, p).contains(Punto(1, 0, 1)));
  CHECK_FALSE(puntos_desde(s, cilindro, p).contains(Punto(1 + 0x1p-52, 0, 4)));
}

TEST_CASE("alcance.def.1: by membership and by parameters it is the same set") {
  property("on a random ray of a random scene", [] {
    const Escena s = any_scene();
    RC_PRE(!s.elementos.empty());
    const Rayo rayo = *any_ray();
    const Elemento e = *rc::gen::elementOf(s.elementos);
    const Names en = *rc::gen::element(Names{}, Names{e});
    const Alcance reach = alcance(s, rayo, en, e);
    RC_CLASSIFY(!reach.parameters.is_empty(), "met");
    for (const Surd& t : reach.parameters.points) {
      RC_ASSERT(t > 0);
      RC_ASSERT(reach.puntos.contains(along(rayo.p(), rayo.v(), t)));
      RC_ASSERT(!reach.puntos.contains(along(rayo.p(), rayo.v(), t + Surd(0x1p-300))));
    }
    for (const double t : {-1.0, 0.0, 0x1p-30, 0.5, 1.0, 2.0, 100.0})
      RC_ASSERT(reach.puntos.contains(along(rayo.p(), rayo.v(), Surd(t))) == reach.parameters.contains(Surd(t)));
  });

  property("where the power changes its sign along the ray, inside the stretch, the ray meets the surface", [] {
    const Escena s = any_scene();
    RC_PRE(!s.elementos.empty());
    const Rayo rayo = *any_ray();
    const Elemento e = *rc::gen::elementOf(s.elementos);
    const auto points = alcance(s, rayo, {}, e).parameters.points;
    const auto inside = [&](double t) { return tramo(s, e).contains(along(rayo.p(), rayo.v(), Surd(t))); };
    const auto power = [&](double t) { return number::sign(potencia(s, e, along(rayo.p(), rayo.v(), Surd(t)))); };
    double before = 0x1p-30;
    for (const double after : {0.25, 0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 100.0}) {
      const bool changes = inside(before) && inside(after) && power(before) * power(after) < 0;
      RC_CLASSIFY(changes, "changes");
      const auto between = [&](const Surd& t) { return Surd(before) < t && t < Surd(after); };
      if (changes) RC_ASSERT(std::count_if(points.begin(), points.end(), between) == 1);
      before = after;
    }
  });
}

TEST_CASE("alcance: a ray in the surface meets an interval of it") {
  const Escena s = sphere_and_cylinder();
  const auto of = [&](const Punto& p, const Vector& v, const Names& en = {}) {
    return alcance(s, Rayo(p, v), en, cilindro).parameters;
  };
  const Parameters from_below = of(Punto(1, 0, -2), Vector(0, 0, 2));
  REQUIRE(from_below.interval);
  CHECK(from_below.minimum() == Surd(1));
  CHECK(from_below.contains(1));
  CHECK(from_below.contains(3));
  CHECK_FALSE(from_below.contains(Surd(3 + 0x1p-50)));
  CHECK(from_below.any_below(2));
  CHECK_FALSE(from_below.any_below(1));

  const Parameters from_inside = of(Punto(1, 0, 1), axis);
  REQUIRE(from_inside.interval);
  CHECK(from_inside.minimum() == std::nullopt);
  CHECK(from_inside.any_below(Surd(0x1p-1000)));
  CHECK_FALSE(from_inside.contains(0));

  const Parameters from_the_rim = of(Punto(1, 0, 0), axis);
  CHECK(from_the_rim.interval);
  CHECK(from_the_rim.minimum() == std::nullopt);
  CHECK(of(Punto(1, 0, 4), axis).is_empty());
  CHECK(of(Punto(1, 0, 5), axis).is_empty());
  CHECK(of(Punto(1, 0, 0), Vector(0, 0, -1)).is_empty());
  // Beside the surface but known to start on it: its own surface.
  CHECK(of(Punto(1 + 0x1p-52, 0, 1), axis).is_empty());
  CHECK(of(Punto(1 + 0x1p-52, 0, 1), axis, {cilindro}).interval);
  // On it and leaving it: nothing but the far side.
  CHECK(of(Punto(1 + 0x1p-52, 0, 1), Vector(1, 0, 0), {cilindro}).is_empty());
  CHECK(of(Punto(1 + 0x1p-52, 0, 1), Vector(-1, 0, 0), {cilindro}).minimum() == Surd(2 + 0x1p-51));
}

TEST_CASE("alcances.def.1: those of every element") {
  const auto all = alcances(touching(), Rayo(Punto(-9, 0, 0), Vector(1, 0, 0)), {});
  REQUIRE(all.size() == 2);
  CHECK(all.at(a).parameters.points == std::vector<Surd>{7, 11});
  CHECK(all.at(b).parameters.points == std::vector<Surd>{11, 17});
  CHECK(reduccion(all) == Surd(7));
}

TEST_CASE("occluded.def.1 and occluded_segment.def.1") {
  const Escena s = touching();
  CHECK(occluded(s, Rayo(Punto(-9, 0, 0), Vector(1, 0, 0)), {}));
  CHECK_FALSE(occluded(s, Rayo(Punto(-9, 0, 0), Vector(-1, 0, 0)), {}));
  CHECK_FALSE(occluded_segment(s, Rayo(Punto(-9, 0, 0), Vector(1, 0, 0)), {}));
  CHECK_FALSE(occluded_segment(s, Rayo(Punto(-9, 0, 0), Vector(7, 0, 0)), {}));  // the light lies on the sphere
  CHECK(occluded_segment(s, Rayo(Punto(-9, 0, 0), Vector(7 + 0x1p-50, 0, 0)), {}));
  CHECK_FALSE(occluded(s, Rayo(Punto(8, 0, 0), Vector(1, 0, 0)), {b}));
  // A ray inside the surface is hindered at once.
  CHECK(occluded_segment(sphere_and_cylinder(), Rayo(Punto(1, 0, 1), Vector(0, 0, 0x1p-900)), {}));
}

TEST_CASE("Primera_Interseccion: a point, nothing, or no nearest point") {
  const auto hit = answer<Hay_Interseccion>(touching(), Rayo(Punto(2, 0, 9), Vector(0, 0, -1)));
  CHECK(hit.elementos == Names{a, b});
  CHECK(hit.t == 9);
  CHECK(hit.punto == ExactPoint(Punto(2, 0, 0)));

  const auto irrational = answer<Hay_Interseccion>(touching(), Rayo(Punto(1, 0, 0), Vector(0, 0, 1)));
  CHECK(irrational.elementos == Names{a});
  CHECK(irrational.t == Surd(0, 1, 3));

  CHECK(answer<No_Hay_Interseccion>(touching(), Rayo(Punto(0, 0, 9), Vector(0, 0, 1))).elementos.empty());

  const auto in_surface = answer<No_Hay_Minimo>(sphere_and_cylinder(), Rayo(Punto(1, 0, 1), axis));
  CHECK(in_surface.elementos == Names{cilindro});
}

TEST_CASE("Pregunta.pre.1: the elements that the ray starts on are elements") {
  const Rayo rayo(Punto(0, 0, 9), Vector(0, 0, -1));
  CHECK(violated([&] { Primera_Interseccion(touching(), {rayo, {a, nuevo}}); }) == "Pregunta.pre.1");
}

namespace {

const Rayo hits(Punto(-9, 0, 0), Vector(1, 0, 0)), misses(Punto(0, 0, 9), Vector(0, 0, 1));
const Rayo in_surface(Punto(1, 0, 1), axis);

template <class Schema>
std::set<std::string> not_this(const Escena& s, const Rayo& rayo) {
  return broken(pre<Schema>(s, {rayo, {}}));
}

/// The one label that sees that an outcome was spoiled.
template <class Outcome, class Spoil>
std::string spoiled(const Escena& s, const Rayo& rayo, Spoil&& spoil) {
  Outcome out = answer<Outcome>(s, rayo);
  CHECK(broken(post(s, {rayo, {}}, out)).empty());
  spoil(out);
  const Judgements judged = post(s, {rayo, {}}, out);
  CHECK(broken(judged).size() == 1);
  return violated([&] { check(judged, contract::cost::normal); });
}

}  // namespace

TEST_CASE("Hay_Interseccion") {
  CHECK(not_this<Hay_Interseccion>(touching(), misses) == std::set<std::string>{"Hay_Interseccion.pre.1"});
  CHECK(not_this<Hay_Interseccion>(touching(), hits).empty());
  const auto seen = [](auto&& spoil) { return spoiled<Hay_Interseccion>(touching(), hits, spoil); };
  CHECK(seen([](Hay_Interseccion& out) { out.t = 11; }) == "Hay_Interseccion.post.2");
  CHECK(seen([](Hay_Interseccion& out) { out.elementos = {a, b}; }) == "Hay_Interseccion.post.3");
  CHECK(seen([](Hay_Interseccion& out) { out.resultado = Resultado::miss; }) == "Hay_Interseccion.post.4");
  // A point of the ray and of both spheres, but not the nearest.
  CHECK(seen([](Hay_Interseccion& out) {
          out.t = 11;
          out.punto = Punto(2, 0, 0);
          out.elementos = {a, b};
        }) == "Hay_Interseccion.post.1");
}

TEST_CASE("No_Hay_Interseccion") {
  CHECK(not_this<No_Hay_Interseccion>(touching(), hits) == std::set<std::string>{"No_Hay_Interseccion.pre.1"});
  CHECK(not_this<No_Hay_Interseccion>(touching(), misses).empty());
  const auto seen = [](auto&& spoil) { return spoiled<No_Hay_Interseccion>(touching(), misses, spoil); };
  CHECK(seen([](No_Hay_Interseccion& out) { out.elementos = {a}; }) == "No_Hay_Interseccion.post.1");
  CHECK(seen([](No_Hay_Interseccion& out) { out.resultado = Resultado::hit; }) == "No_Hay_Interseccion.post.2");
}

TEST_CASE("No_Hay_Minimo") {
  const Escena s = sphere_and_cylinder();
  CHECK(not_this<No_Hay_Minimo>(s, Rayo(Punto(0, 0, 9), Vector(1, 0, 0))) ==
        std::set<std::string>{"No_Hay_Minimo.pre.1"});
  CHECK(not_this<No_Hay_Minimo>(s, Rayo(Punto(0, 0, 9), Vector(0, 0, -1))) ==
        std::set<std::string>{"No_Hay_Minimo.pre.2"});
  CHECK(not_this<No_Hay_Minimo>(s, in_surface).empty());
  const auto seen = [&](auto&& spoil) { return spoiled<No_Hay_Minimo>(s, in_surface, spoil); };
  CHECK(seen([](No_Hay_Minimo& out) { out.elementos.insert(esfera); }) == "No_Hay_Minimo.post.1");
  CHECK(seen([](No_Hay_Minimo& out) { out.resultado = Resultado::miss; }) == "No_Hay_Minimo.post.2");
}

TEST_CASE("Primera_Interseccion.def.1: exactly one outcome, and its clauses hold") {
  property("of a random ray in a random scene", [] {
    const Escena s = any_scene();
    const Rayo rayo = *any_ray();
    Names en;
    for (const Elemento& e : s.elementos)
      if (*rc::gen::element(0, 0, 1)) en.insert(e);
    const Pregunta in{rayo, en};
    const int outcomes = all_hold(pre<Hay_Interseccion>(s, in)) + all_hold(pre<No_Hay_Interseccion>(s, in)) +
                         all_hold(pre<No_Hay_Minimo>(s, in));
    RC_ASSERT(outcomes == 1);
    const auto outcome = Primera_Interseccion(s, in);
    RC_CLASSIFY(outcome.index() == 0, "hit");
    RC_CLASSIFY(outcome.index() == 2, "no_minimum");
    std::visit([&](const auto& out) { RC_ASSERT(broken(post(s, in, out)).empty()); }, outcome);
    RC_ASSERT(occluded(s, rayo, en) == (outcome.index() != 1));
    if (const auto* hit = std::get_if<Hay_Interseccion>(&outcome)) {
      if (en.empty()) RC_ASSERT(hit->elementos == de_que_elemento(s, hit->punto));
      RC_ASSERT(occluded_segment(s, rayo, en) == (hit->t < 1));
    }
  });
}
