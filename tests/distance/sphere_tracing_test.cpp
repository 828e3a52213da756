#include "durero/distance/sphere_tracing.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using distance::SphereTracer;
using distance::Walk;
using distance::WalkEnd;

namespace {

/// The exact parameter of the first hit; infinite without one.
double exact_parameter(const scene::Scene& scene, const scene::Query& query) {
  const scene::Hit hit = surface::exact::first_hit(scene, query.rayo, query.en);
  return hit.resultado == model::Resultado::miss ? INFINITY : hit.t;
}

void check_that_nothing_is_passed(std::uint64_t seed, int rays) {
  INFO("seed " << seed);
  test::Random random(seed);
  const scene::Scene scene = test::random_scene(random, 8);
  const SphereTracer tracer(scene);
  int passed = 0, met = 0;
  for (int i = 0; i < rays; ++i) {
    const scene::Query query{test::random_ray(random)};
    const Walk walk = tracer.walk(query);
    const double t = exact_parameter(scene, query);
    if (walk.t > t * (1 + 0x1p-50) || (walk.end == WalkEnd::outside && t < INFINITY)) ++passed;
    if (walk.end == WalkEnd::near) ++met;
  }
  CHECK(passed == 0);
  CHECK(met > rays / 20);
}

}  // namespace

TEST_CASE("A walk ends within epsilon before the first point, on its element") {
  scene::Scene scene;
  const auto ball = test::add(scene, scene::Sphere{{0, 0, 0}, 1});
  const SphereTracer tracer(scene, 0x1p-20);
  CHECK(SphereTracer(scene).epsilon() == Approx(0x1p-19));
  const Walk walk = tracer.walk({test::ray({0, 0, -5}, {0, 0, 2})});
  CHECK(walk.end == WalkEnd::near);
  CHECK(walk.element == ball);
  CHECK(walk.t <= 2);
  CHECK(walk.t >= 2 - 0x1p-20);
  CHECK(walk.steps <= 3);
  CHECK(tracer.walk({test::ray({0, 0, -5}, {0, 0, -1})}).end == WalkEnd::outside);
  CHECK(tracer.walk({test::ray({0, 3, -5}, {0, 0, 1})}).end == WalkEnd::outside);
  CHECK(SphereTracer(scene::Scene()).walk({test::ray({0, 0, 0}, {0, 0, 1})}).end == WalkEnd::outside);
}

TEST_CASE("What passes within epsilon is taken for met; what goes along a plane for ever is given up") {
  scene::Scene scene;
  test::add(scene, scene::Sphere{{0, 0, 0}, 1});
  const scene::Query grazing{test::ray({-5, 1 + 0x1p-14, 0}, {1, 0, 0})};
  CHECK(SphereTracer(scene, 0x1p-12).walk(grazing).end == WalkEnd::near);
  CHECK(SphereTracer(scene, 0x1p-17).walk(grazing).end == WalkEnd::outside);
  scene::Scene floor;
  test::add(floor, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  const Walk along = SphereTracer(floor).walk({test::ray({0, 0, 1}, {1, 0, 0})});
  CHECK(along.end == WalkEnd::tired);
  CHECK(along.steps == SphereTracer::most_steps);
  CHECK(SphereTracer(floor).walk({test::ray({0, 0, 1}, {1, 0, 1})}).end == WalkEnd::outside);
}

TEST_CASE("A ray that starts on an element leaves it, and may meet it again on the other side") {
  scene::Scene scene;
  const auto ball = test::add(scene, scene::Sphere{{0, 0, 0}, 1});
  const SphereTracer tracer(scene);
  const Walk out = tracer.walk({test::ray({0, 0, 1}, {0, 0, 1}), {ball}});
  CHECK(out.end == WalkEnd::outside);
  const Walk across = tracer.walk({test::ray({0, 0, 1}, {0, 0, -1}), {ball}});
  CHECK(across.end == WalkEnd::near);
  CHECK(across.t == Approx(2).margin(1e-5));
  CHECK(tracer.walk({test::ray({0, 0, 1}, {0, 0, 1})}).end == WalkEnd::near);  // unless it is told of the start
}

TEST_CASE("A walk passes no point of any element") { check_that_nothing_is_passed(std::random_device()(), 4000); }
TEST_CASE("A walk passes no point of any element, 10⁷ rays [long]", "[long]") {
  for (std::uint64_t seed = std::random_device()(), end = seed + 1000; seed < end; ++seed)
    check_that_nothing_is_passed(seed, 10'000);
}
