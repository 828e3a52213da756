// What the Z text finds of a ray on an element, against the closed forms of the exact oracle: points, stretches, and
// the end of nothing. Neither knows the other.
#include "durero/spec/ray.hpp"

#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

namespace durero::spec {
namespace {

using number::Surd;
using test::Random;

/// Elements and rays on a grid of few points, so that rays touch, run in surfaces, and start on elements.
scene::Scene grid_scene(Random& random) {
  const auto small = [&] { return static_cast<double>(random.below(3)) - 1; };
  const auto length = [&] { return static_cast<double>(1 + random.below(2)); };
  const model::Vector axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  scene::Scene scene;
  for (const char* name : {"a", "b", "c"}) {
    const model::Elemento e(name);
    const double z = small(), y = small(), x = small();
    const model::Punto centro(x, y, z);
    const model::Vector axis = axes[random.below(3)];
    switch (random.below(7)) {
      case 0:
        scene.apply(model::Agregar_Esfera{e, centro, length()});
        break;
      case 1:
        scene.apply(model::Agregar_Cilindro{e, centro, length(), axis, length()});
        break;
      case 2:
        scene.apply(model::Agregar_Plano{e, centro, axis});
        break;
      case 5:
        scene.apply(model::Agregar_Disco{e, centro, length(), axis});
        break;
      case 6: {
        const double width = length(), height = 1 + length(), lean = small();
        scene.apply(model::Agregar_Triangulo{
            e, {centro, model::Punto(x + width, y, z), model::Punto(x, y + height, z + lean)}});
        break;
      }
      case 3:
        scene.apply(model::Agregar_Cono{e, centro, 1, axis, length()});
        break;
      default:
        scene.apply(model::Agregar_Tronco{e, centro, length(), 1, axis, length()});
    }
  }
  return scene;
}

model::Rayo grid_ray(Random& random) {
  const auto at = [&] { return static_cast<double>(random.below(7)) - 3; };
  const auto step = [&] { return static_cast<double>(random.below(3)) - 1; };
  for (;;) {
    const double v[] = {step(), step(), step()};
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) continue;
    const double z = at(), y = at(), x = at();
    return {model::Punto(x, y, z), model::Vector(v[0], v[1], v[2])};
  }
}

/// A ray in a straight line of an element's surface, from before it, its ends, its middle or behind it; any ray of the
/// grid where the scene has spheres only.
model::Rayo generator_ray(Random& random, const scene::Scene& scene) {
  glm::dvec3 foot, to_top;
  const auto across = [&](const glm::dvec3& axis) {
    return random.below(2) == 0 ? glm::dvec3(axis.y, axis.z, axis.x) : -glm::dvec3(axis.z, axis.x, axis.y);
  };
  if (!scene.shapes<scene::Cylinder>().empty()) {
    const scene::Cylinder& c = scene.shapes<scene::Cylinder>().front();
    foot = c.centro + c.radio * across(c.vector);
    to_top = c.altura * c.vector;
  } else if (!scene.shapes<scene::Cone>().empty()) {
    const scene::Cone& c = scene.shapes<scene::Cone>().front();
    const glm::dvec3 arm = c.proporcion * c.altura * across(c.vector);
    foot = c.centro + arm;
    to_top = c.altura * c.vector - arm;
  } else if (!scene.shapes<scene::TruncatedCone>().empty()) {
    const scene::TruncatedCone& c = scene.shapes<scene::TruncatedCone>().front();
    const glm::dvec3 arm = c.proporcion * c.altura * across(c.vector);
    foot = c.centro + arm + c.radio * arm / glm::length(arm);
    to_top = c.altura * c.vector - arm;
  } else {
    return grid_ray(random);
  }
  const glm::dvec3 p = foot + (static_cast<double>(random.below(5)) / 2 - 0.5) * to_top;
  const glm::dvec3 v = random.below(2) == 0 ? to_top : -to_top;
  return {model::Punto(p.x, p.y, p.z), model::Vector(v.x, v.y, v.z)};
}

struct Counts {
  std::size_t none = 0, points = 0, stretches = 0, no_minimum = 0, from_element = 0;
};

/// The t that are on, one for each point, and the two ends of each stretch.
std::vector<Surd> members(const Extent& extent) {
  std::vector<Surd> made;
  for (std::size_t i = 0; i < extent.at.size(); ++i) {
    if (extent.on[i]) made.push_back(extent.at[i]);
  }
  return made;
}

void judge_element(const Extent& said, const surface::exact::Reach& reach, Counts& counts) {
  REQUIRE(said.empty() == reach.empty());
  REQUIRE(said.no_minimum() == reach.no_minimum());
  ++(reach.empty() ? counts.none : reach.segment ? counts.stretches : counts.points);
  counts.no_minimum += reach.no_minimum();
  if (reach.empty()) return;
  if (!reach.no_minimum()) CHECK(*said.first() == Surd(reach.first()));
  const auto on = members(said);
  const auto stretches = std::count(said.between.begin(), said.between.end(), true);
  if (reach.segment) {
    CHECK(stretches == 1);
    CHECK(said.between.back() == !reach.segment->end);
    if (reach.segment->end) CHECK(on.back() == Surd(*reach.segment->end));
  } else {
    CHECK(stretches == 0);
    REQUIRE(on.size() == reach.points().size());
    for (std::size_t i = 0; i < on.size(); ++i) CHECK(on[i] == Surd(reach.points()[i]));
  }
}

void judge_ray(const Judge& judge, const scene::Scene& scene, const model::Rayo& rayo, Counts& counts) {
  const model::Escena escena = scene::retrieve(scene);
  const zed::Value theta = value(escena);
  std::set<model::Elemento> en = judge.de_que_elemento(theta, rayo.p());
  if (en.empty()) en.insert(*escena.elementos.begin());  // a rounded origin: alcance takes it for one on the element
  for (const bool from : {false, true}) {
    const std::set<model::Elemento> origin = from ? en : std::set<model::Elemento>{};
    std::vector<scene::ElementRef> refs;
    for (const model::Elemento& e : origin) refs.push_back(*scene.find(e.name()));
    bool some = false, near = false;
    for (const model::Elemento& e : escena.elementos) {
      CAPTURE(e.name(), from, value(rayo).text(), theta.text());
      const Extent said = alcance(judge, theta, rayo, origin, e);
      judge_element(said, surface::exact::reach(scene, *scene.find(e.name()), rayo, refs), counts);
      some = some || !said.empty();
      near = near || said.any_below(1);
      counts.from_element += from && origin.contains(e) && !said.empty();
    }
    CHECK(some == surface::exact::occluded(scene, rayo, refs));
    CHECK(near == surface::exact::occluded_segment(scene, rayo, refs));
  }
}

// alcance.def.1, alcances.def.1, puntos_desde.def.1, occluded.def.1, occluded_segment.def.1
TEST_CASE("the Z text finds on a ray what the exact oracle finds, points and stretches") {
  const std::uint64_t seed = 20260105;
  CAPTURE(seed);
  Random random(seed);
  const Judge judge;
  Counts counts;
  for (std::size_t i = 0; i < test::fewer_when_sanitized(2000); ++i) {
    const scene::Scene scene = i % 4 == 0 ? test::random_scene(random, 3) : grid_scene(random);
    const model::Rayo rayo = i % 4 == 0   ? test::random_ray(random)
                             : i % 4 == 1 ? generator_ray(random, scene)
                                          : grid_ray(random);
    judge_ray(judge, scene, rayo, counts);
  }
  // Floors for the number of rays tried, about half of what this seed gives.
  using test::fewer_when_sanitized;
  CHECK(counts.none > fewer_when_sanitized(5000));
  CHECK(counts.points > fewer_when_sanitized(700));
  CHECK(counts.stretches > fewer_when_sanitized(300));
  CHECK(counts.no_minimum > fewer_when_sanitized(200));
  CHECK(counts.from_element > fewer_when_sanitized(350));
}

TEST_CASE("an extent: its least member, if any, and what lies below a limit") {
  const Extent points{{1, 2}, {true, false}, {false, false, false}};
  CHECK(*points.first() == Surd(1));
  CHECK(points.any_below(2));
  CHECK_FALSE(points.any_below(1));
  const Extent open{{1, 2}, {false, false}, {false, true, false}};
  CHECK(open.no_minimum());
  CHECK(open.any_below(2));
  CHECK_FALSE(open.any_below(1));
  const Extent closed{{1, 2}, {true, true}, {false, true, false}};
  CHECK(*closed.first() == Surd(1));
  const Extent from_the_start{{1}, {true}, {true, false}};
  CHECK(from_the_start.no_minimum());
  CHECK(from_the_start.any_below(0x1p-99));
  CHECK(Extent{{}, {}, {false}}.empty());
}

}  // namespace
}  // namespace durero::spec
