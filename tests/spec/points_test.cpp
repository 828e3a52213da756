// Membership: the Z text evaluated, against the model's functions of the same names.
#include <optional>

#include "durero/model/interseccion.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/spec.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

namespace durero::spec {
namespace {

using model::ExactPoint;
using test::Random;

/// A scene whose numbers have few bits, so that points with rational coordinates lie on it, and rays meet it exactly.
scene::Scene coarse_scene(Random& random) {
  const auto eighth = [&](double low, double high) { return std::round(random.uniform(low, high) * 8) / 8; };
  const model::Vector axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.8, 0}};
  scene::Scene scene;
  for (const char* name : {"a", "b", "c"}) {
    const model::Elemento e(name);
    const double z = eighth(-1, 1), y = eighth(-1, 1), x = eighth(-1, 1);
    const model::Punto centro(x, y, z);
    const model::Vector axis = axes[random.below(3)];
    if (random.below(3) == 0) {
      scene.apply(model::Agregar_Esfera{e, centro, eighth(0.25, 1)});
    } else if (random.below(2) == 0) {
      scene.apply(model::Agregar_Cilindro{e, centro, eighth(0.25, 1), axis, eighth(0.25, 2)});
    } else if (random.below(4) == 0) {
      scene.apply(model::Agregar_Plano{e, centro, axis});
    } else if (random.below(4) == 0) {
      scene.apply(model::Agregar_Disco{e, centro, eighth(0.25, 1), axis});
    } else if (random.below(4) == 0) {
      const double width = eighth(0.25, 1), height = eighth(0.25, 1);
      scene.apply(
          model::Agregar_Triangulo{e, {centro, model::Punto(x + width, y, z), model::Punto(x, y + height, z + 0.5)}});
    } else if (random.below(2) == 0) {
      scene.apply(model::Agregar_Cono{e, centro, eighth(0.25, 2), axis, eighth(0.25, 1)});
    } else {
      const double radio = eighth(0.25, 1), proporcion = eighth(0.25, 2);
      scene.apply(model::Agregar_Tronco{e, centro, radio, proporcion, axis, eighth(0.25, 1)});
    }
  }
  return scene;
}

model::Rayo coarse_ray(Random& random) {
  const auto one = [&] { return std::round(random.uniform(-16, 16)) / 8; };
  for (;;) {
    const double v[] = {one(), one(), one()};
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) continue;
    const double z = one(), y = one(), x = one();
    return {model::Punto(x, y, z), model::Vector(v[0], v[1], v[2])};
  }
}

struct Counts {
  std::size_t points = 0, on_ray = 0, on_scene = 0, irrational = 0;
};

/// One point: on the ray, on an element, or near by.
void judge_point(const Judge& judge, const ExactPoint& p, const model::Rayo& rayo, const model::Escena& escena,
                 const zed::Value& theta, Counts& counts) {
  ++counts.points;
  const bool on_ray = model::puntos_de_rayo(rayo).contains(p);
  CHECK(judge.in_puntos_de_rayo(p, rayo) == on_ray);
  const bool on_scene = model::puntos_de_escena(escena).contains(p);
  CHECK(judge.in_puntos_de_escena(p, theta) == on_scene);
  CHECK(judge.de_que_elemento(theta, p) == model::de_que_elemento(escena, p));
  counts.on_ray += on_ray;
  counts.on_scene += on_scene;
  counts.irrational += !p.x.y.is_zero() || !p.y.y.is_zero() || !p.z.y.is_zero();
}

/// The points where a ray meets a scene; nothing where it runs inside a surface.
std::optional<std::vector<ExactPoint>> meetings(const scene::Scene& scene, const model::Rayo& rayo) {
  std::vector<ExactPoint> points;
  for (const surface::exact::Crossing& one : surface::exact::all_hits(scene, rayo)) {
    if (!one.segment.begin || !one.segment.end || surface::exact::order(*one.segment.begin, *one.segment.end) != 0)
      return {};
    points.push_back(model::along(rayo.p(), rayo.v(), number::Surd(*one.segment.begin)));
  }
  return points;
}

void judge_points(std::uint64_t seed, std::size_t least) {
  CAPTURE(seed);
  Random random(seed);
  const Judge judge;
  Counts counts;
  while (counts.points < least) {
    const bool coarse = random.below(4) != 0;
    const scene::Scene scene = coarse ? coarse_scene(random) : test::random_scene(random, 3);
    const model::Escena escena = scene::retrieve(scene);
    const zed::Value theta = value(escena);
    for (int i = 0; i < 20; ++i) {
      const model::Rayo rayo = coarse ? coarse_ray(random) : test::random_ray(random);
      const auto points = meetings(scene, rayo);
      for (const ExactPoint& p : points.value_or(std::vector<ExactPoint>{})) {
        judge_point(judge, p, rayo, escena, theta, counts);
        CHECK(judge.in_puntos_de_rayo(p, rayo));
        CHECK(judge.in_puntos_de_escena(p, theta));
      }
      judge_point(judge, model::Punto(random.in_cube(1)), rayo, escena, theta, counts);
      judge_point(judge, model::along(rayo.p(), rayo.v(), number::Surd(random.uniform(-1, 2))), rayo, escena, theta,
                  counts);
      judge_point(judge, rayo.p(), rayo, escena, theta, counts);
      if (!points) continue;
      const auto nearest = model::reduccion(*points, rayo.p());
      const auto said = judge.reduccion(*points, rayo.p());
      CHECK(said.has_value() == nearest.has_value());
      if (said && nearest) CHECK(said->text() == value(*nearest).text());
    }
  }
  CHECK(counts.on_ray > least / 10);
  CHECK(counts.on_scene > least / 20);
  CHECK(counts.irrational > least / 50);
}

// puntos_de_rayo.def.1, puntos_de_escena.def.1, puntos_de_elemento.def.1, de_que_elemento.def.1, reduccion.def.1 and 2,
// and all that they are defined by.
TEST_CASE("the Z text and the model agree on 100000 random points") {
  judge_points(20260103, test::fewer_when_sanitized(100000));
}

TEST_CASE("the Z text and the model agree on a million points", "[long]") { judge_points(20260104, 1000000); }

TEST_CASE("points from an element: alcance") {
  const Judge judge;
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("a"), model::Punto(0, 0, 0), 1});
  const zed::Value theta = value(scene::retrieve(scene));
  const model::Elemento a("a");
  // The stored origin is a little outside, and known to lie on a: what it sees of a is the sphere through it.
  const model::Punto origin(0, 0, 1 + 0x1p-52);
  const model::Rayo inwards(origin, model::Vector(0, 0, -1));
  const ExactPoint opposite(0, 0, number::Surd(-(1 + 0x1p-52)));
  CHECK(judge.in_alcance(opposite, theta, inwards, {a}, a));
  CHECK_FALSE(judge.in_alcance(opposite, theta, inwards, {}, a));
  CHECK_FALSE(judge.in_alcance(ExactPoint(0, 0, -1), theta, inwards, {a}, a));
  CHECK(judge.in_alcance(ExactPoint(0, 0, -1), theta, inwards, {}, a));
}

}  // namespace
}  // namespace durero::spec
