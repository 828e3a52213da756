#include "durero/engine/sphere_tracing_figures.hpp"

#include <random>

#include "durero/engine/engine.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using engine::sphere_tracing_figures;
using engine::SphereTracingFigures;

TEST_CASE("Rays that sphere tracing takes for hits go to none as epsilon does, and none is passed") {
  const std::uint64_t seed = std::random_device()();
  INFO("seed " << seed);
  test::Random random(seed);
  const scene::Scene scene = test::random_scene(random, 10);
  std::vector<scene::Query> rays;
  for (int i = 0; i < 20'000; ++i) rays.push_back({test::random_ray(random)});
  std::vector<std::uint64_t> lost;
  for (const double epsilon : {0x1p-5, 0x1p-9, 0x1p-13, 0x1p-17}) {
    const SphereTracingFigures of = sphere_tracing_figures(scene, rays, epsilon);
    CHECK(of.epsilon == epsilon);
    CHECK(of.passed == 0);
    CHECK(of.rays == rays.size());
    CHECK(of.right + of.grazed + of.other + of.tired == of.rays);
    lost.push_back(of.grazed + of.other);
  }
  // The shell about the elements is 16 times as thin each time; that a quarter is left is far from what is expected.
  CHECK(lost[0] > 100);
  for (std::size_t i = 1; i < lost.size(); ++i) CHECK(lost[i] < lost[i - 1] / 4 + 20);
}

TEST_CASE("The engine's hits are within epsilon of the exact ones, where these are the same elements") {
  test::Random random(3);
  const scene::Scene scene = test::random_scene(random, 10);
  std::vector<scene::Query> rays;
  for (int i = 0; i < 2000; ++i) rays.push_back({test::random_ray(random)});
  const auto hits = engine::first_hits(*engine::find("sdf")->prepare(scene), rays),
             exact = engine::first_hits(*engine::find("exact")->prepare(scene), rays);
  std::size_t same = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].elementos != exact[i].elementos) continue;
    ++same;
    CHECK(hits[i].t <= exact[i].t * (1 + 0x1p-50));
  }
  CHECK(same > rays.size() * 99 / 100);
  CHECK(engine::occluded_segment(*engine::find("sdf")->prepare(scene), rays[0]) ==
        (exact[0].resultado != model::Resultado::miss && exact[0].t < 1));
}
