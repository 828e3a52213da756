// The general method of the realism seed (R36): the roots of F along the ray, less those that fail C, and the least
// that is positive. F and C are the text's potencia and tramo, of which it sees values alone; the program's own
// equations must give the same bytes. And its problems: a sphere by transforming the ray (R42), solids closed by discs
// (R41, R43).
#include <cmath>

#include "durero/model/interseccion.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/points_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using model::Elemento;
using model::ExactPoint;
using model::ExactVector;
using model::Rational;
using model::Surd;

namespace {

/// The least t > 0 with F(o + t·v) = 0 and C there; nothing where there is none. F has degree two at most along a line,
/// and is not zero along all of this one, or it is open which t is the least.
template <class Field, class Condition>
std::optional<Surd> intersect(const Field& F, const Condition& C, const ExactPoint& o, const ExactVector& v) {
  for (const Surd& t : roots(model::restricted(F, o, v)))
    if (t > 0 && C(along(o, v, t))) return t;
  return std::nullopt;
}

/// p·p − 1
Surd unit_sphere(const ExactPoint& p) { return producto(p, p) - 1; }

constexpr auto anywhere = [](const ExactPoint&) { return true; };

scene::Scene random_scene() {
  scene::Scene scene;
  for (const model::Operation& operation : *any_operations()) scene.apply_total(operation);
  return scene;
}

scene::Hit hit_at(const Surd& t, const model::Rayo& rayo, scene::ElementRef element) {
  const ExactPoint w = along(rayo.p(), ExactVector(rayo.v()), t);
  const auto rounded = [](const Surd& x) { return number::round_to_binary64(x); };
  return {model::Resultado::hit, rounded(t), {rounded(w.x), rounded(w.y), rounded(w.z)}, {element}};
}

}  // namespace

TEST_CASE("F and C of any type of element give the bytes of its own equations") {
  property("of each element of a random scene alone", [] {
    const scene::Scene all = random_scene();
    const model::Escena escena = retrieve(all);
    const model::Rayo rayo = *any_ray();
    for (const Elemento& e : escena.elementos) {
      const auto F = [&](const ExactPoint& w) { return potencia(escena, e, w); };
      const model::Puntos within = tramo(escena, e);
      if (model::restricted(F, rayo.p(), ExactVector(rayo.v())).is_zero()) continue;
      const auto t = intersect(
          F, [&](const ExactPoint& w) { return within.contains(w); }, rayo.p(), ExactVector(rayo.v()));
      const scene::ElementRef element = *all.find(e.name());
      const auto reach = surface::exact::reach(all, element, rayo);
      RC_ASSERT(t.has_value() == !reach.empty());
      if (!t) continue;
      RC_ASSERT(!reach.no_minimum());

      RC_ASSERT(surface::exact::rounded_hit(rayo, reach.first(), {element}) == hit_at(*t, rayo, element));
    }
  });
}

TEST_CASE("a sphere by the one of radius one: the ray is moved to its space, and t stays what it is, byte for byte") {
  property("of any centre and radius", [] {
    const model::Punto centro = *any_point();
    const double radio = *any_length();
    const model::Rayo rayo = *any_ray();
    scene::Scene scene;
    scene.apply(model::Agregar_Esfera{Elemento("ball"), centro, radio});
    const scene::ElementRef ball = *scene.find("ball");
    const Rational r = number::exact(radio), scale = 1 / r;
    const ExactPoint c(centro), p(rayo.p());
    const ExactVector v(rayo.v());
    const auto t = intersect(unit_sphere, anywhere,
                             {(p.x - c.x) * Surd(scale), (p.y - c.y) * Surd(scale), (p.z - c.z) * Surd(scale)},
                             {v.x * scale, v.y * scale, v.z * scale});
    const scene::Hit direct = surface::exact::first_hit(scene, rayo);
    RC_CLASSIFY(t.has_value(), "hit");
    RC_ASSERT(direct == (t ? hit_at(*t, rayo, ball) : scene::Hit{}));
  });
}

TEST_CASE("discs close a cylinder and a cone: a ray from inside meets the solid, whichever way it goes") {
  scene::Scene scene;
  scene.apply(model::Agregar_Cilindro{Elemento("side"), {0, 0, 0}, 1, {0, 0, 1}, 2});
  scene.apply(model::Agregar_Disco{Elemento("bottom"), {0, 0, 0}, 1, {0, 0, 1}});
  scene.apply(model::Agregar_Disco{Elemento("top"), {0, 0, 2}, 1, {0, 0, 1}});
  scene.apply(model::Agregar_Cono{Elemento("hat"), {8, 0, 0}, 0.5, {0, 0, 1}, 2});
  scene.apply(model::Agregar_Disco{Elemento("brim"), {8, 0, 0}, 1, {0, 0, 1}});
  for (int x = -6; x <= 6; ++x)
    for (int y = -6; y <= 6; ++y)
      for (int z = -6; z <= 6; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const model::Vector v(x, y, z);
        for (const model::Punto& inside : {model::Punto(0, 0, 1), model::Punto(8, 0, 1)}) {
          const scene::Hit hit = surface::exact::first_hit(scene, {inside, v});
          REQUIRE(hit.resultado == model::Resultado::hit);
          CHECK(hit.punto.z >= 0);
          CHECK(hit.punto.z <= 2);
          CHECK(std::abs(hit.punto.x - inside.x()) <= 1);
        }
      }
  // The rims are shared: both names are the answer, and nothing slips between.
  CHECK(surface::exact::first_hit(scene, {{0, 0, 1}, {1, 0, 1}}).elementos.size() == 2);
  CHECK(surface::exact::first_hit(scene, {{0, 0, 1}, {0, -1, -1}}).elementos.size() == 2);
  CHECK(surface::exact::first_hit(scene, {{8, 0, 1}, {1, 0, -1}}).elementos.size() == 2);
  // Beyond its apex the cone has a second nappe that is none of its points.
  CHECK(surface::exact::first_hit(scene, {{8, 0, 3}, {1, 0, 0}}).resultado == model::Resultado::miss);
}

TEST_CASE("a ray in the plane of a disc, parallel to it, and from it") {
  scene::Scene scene;
  scene.apply(model::Agregar_Disco{Elemento("disc"), {0, 0, 0}, 1, {0, 0, 1}});
  const auto outcome = [&](const model::Punto& p, const model::Vector& v) {
    return surface::exact::first_hit(scene, {p, v}).resultado;
  };
  CHECK(outcome({-2, 0, 1}, {1, 0, 0}) == model::Resultado::miss);
  CHECK(outcome({-2, 0, 0}, {1, 0, 0}) == model::Resultado::hit);  // its rim is its own
  CHECK(outcome({-2, 1, 0}, {1, 0, 0}) == model::Resultado::hit);
  CHECK(outcome({0, 0, 0}, {1, 0, 0}) == model::Resultado::no_minimum);
  CHECK(outcome({0, 0, 0}, {0, 0, 1}) == model::Resultado::miss);
  CHECK(outcome({1, 0, 1}, {0, 0, -1}) == model::Resultado::hit);
  CHECK(outcome({std::nextafter(1.0, 2.0), 0, 1}, {0, 0, -1}) == model::Resultado::miss);
}
