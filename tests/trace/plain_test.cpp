#include "plain/plain.hpp"

#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// Whether the exact answer is much the same from origins nearby: no tie, rim, apex or touch is near.
bool is_ordinary(const scene::Scene& scene, const model::Rayo& ray, const scene::Hit& exact) {
  const auto is_same_from = [&](const glm::dvec3& step) {
    const scene::Hit beside = surface::exact::first_hit(scene, test::ray(ray.p().xyz() + step, ray.v().xyz()));
    return beside.resultado == exact.resultado && beside.elementos == exact.elementos &&
           (exact.resultado != model::Resultado::hit || std::abs(beside.t - exact.t) <= 0x1p-5 * exact.t);
  };
  for (int i = 0; i < 3; ++i) {
    for (const double way : {-0x1p-16, 0x1p-16}) {
      glm::dvec3 step(0);
      step[i] = way;
      if (!is_same_from(step)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("plain closed forms agree with the exact answer on ordinary rays") {
  int compared = 0, hits = 0;
  property("outcome, elements and t to 2⁻³⁰", [&] {
    const scene::Scene scene = some_of_each(moderate(), 3);
    const model::Rayo ray = *rays(moderate());
    const scene::Hit exact = surface::exact::first_hit(scene, ray);
    if (!is_ordinary(scene, ray, exact)) return;
    const scene::Hit plain = trace::plain::first_hit(scene, ray);
    RC_ASSERT(plain.resultado == exact.resultado);
    RC_ASSERT(plain.elementos == exact.elementos);
    RC_ASSERT(std::abs(plain.t - exact.t) <= 0x1p-30 * exact.t);
    ++compared;
    hits += exact.resultado == model::Resultado::hit;
  });
  if (!sanitized) {
    CHECK(compared > 50);
    CHECK(hits > compared / 5);
  }
}

TEST_CASE("plain closed forms name ties and the absence of a minimum") {
  scene::Scene scene;
  const auto sphere = add(scene, scene::Sphere{{0, 0, 5}, 1});
  const auto twin = add(scene, scene::Sphere{{0, 0, 4.5}, 0.5});
  const auto cylinder = add(scene, scene::Cylinder{{3, 0, 0}, 1, {0, 0, 1}, 2});
  const scene::Hit tie = trace::plain::first_hit(scene, ray({0, 0, 0}, {0, 0, 1}));
  CHECK(tie == scene::Hit{model::Resultado::hit, 4, {0, 0, 4}, {sphere, twin}});
  const scene::Hit inside = trace::plain::first_hit(scene, ray({2, 0, 1}, {0, 0, 1}));
  CHECK(inside == scene::Hit{.resultado = model::Resultado::no_minimum, .elementos = {cylinder}});
  CHECK(trace::plain::first_hit(scene, ray({0, 0, 0}, {0, 0, -1})) == scene::Hit{});
}
