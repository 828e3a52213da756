#include "durero/oracle/sampled.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using oracle::sampled::SampledVerdict;

namespace {

scene::Scene one_of_each() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {0, 0, 5}, 1});
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {5, 0, 5}, 1, {0, 1, 0}, 2});
  scene.apply(model::Agregar_Cono{model::Elemento("k"), {-5, 0, 5}, 0.5, {0, 1, 0}, 2});
  return scene;
}

model::Rayo towards_z(double x, double y) { return {{x, y, 0}, {0, 0, 2}}; }

scene::Hit hit(double x, double y, double z, scene::ElementRef element) {
  return {model::Resultado::hit, z / 2, {x, y, z}, {element}};
}

const scene::ElementRef sphere{model::Tipo::soy_esfera, 0}, cylinder{model::Tipo::soy_cilindro, 0},
    cone{model::Tipo::soy_cono, 0};

}  // namespace

TEST_CASE("the right hit agrees, for each type") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 4, sphere)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(5, 1), hit(5, 1, 4, cylinder)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(-5, 1), hit(-5, 1, 4.5, cone)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(9, 9), {}) == SampledVerdict::agrees);
}

TEST_CASE("wrong hits are seen: a miss, the far root, another element, a point in the air") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(0, 0), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(5, 1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(-5, 1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 6, sphere)) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 4, cone)) == SampledVerdict::incomplete);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 2, sphere)) == SampledVerdict::incomplete);
}

TEST_CASE("of a plane a patch is judged, wide enough for what stands about it; beyond it nothing is said") {
  scene::Scene scene = one_of_each();
  scene.apply(model::Agregar_Plano{model::Elemento("p"), {0, 0, 10}, {0, 0, 1}});
  const scene::ElementRef plane{model::Tipo::soy_plano, 0};
  const oracle::sampled::Oracle oracle(scene);
  const double reach = std::sqrt(50.0) + 3;  // from (0, 0, 10) to the axis of the cylinder, and its size
  for (const double x : {3.0, 7 * reach}) {
    CHECK(oracle.judge(towards_z(x, 3), hit(x, 3, 10, plane)) == SampledVerdict::agrees);
    CHECK(oracle.judge(towards_z(x, 3), {}) == SampledVerdict::unsound);
    CHECK(oracle.judge(towards_z(x, 3), hit(x, 3, 40, plane)) == SampledVerdict::incomplete);
  }
  for (const double z : {10.0, 40.0})
    CHECK(oracle.judge(towards_z(9 * reach, 3), hit(9 * reach, 3, z, plane)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 10, plane)) == SampledVerdict::unsound);  // the sphere is before it
}

TEST_CASE("of a disc and of a triangle right hits agree, wrong ones are seen, and near misses explained") {
  scene::Scene scene;
  scene.apply(model::Agregar_Disco{model::Elemento("d"), {0, 0, 5}, 2, {0, 0, 1}});
  scene.apply(model::Agregar_Triangulo{model::Elemento("t"), {{9, 0, 5}, {13, 0, 5}, {9, 4, 7}}});
  const scene::ElementRef disc{model::Tipo::soy_disco, 0}, triangle{model::Tipo::soy_triangulo, 0};
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(1, 1), hit(1, 1, 5, disc)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(10, 1), hit(10, 1, 5.5, triangle)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(0, 2.5), {}) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(12.5, 3.5), {}) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(1, 1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(10, 1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(10, 1), hit(10, 1, 6.5, triangle)) == SampledVerdict::incomplete);
  CHECK(oracle.judge(towards_z(12.5, 3.5), hit(12.5, 3.5, 7, triangle)) == SampledVerdict::incomplete);
  CHECK(oracle.judge(towards_z(0, 1.99999), {}) == SampledVerdict::rim);
  CHECK(oracle.judge(towards_z(10, 0.00001), {}) == SampledVerdict::rim);
  CHECK(oracle.judge(towards_z(9.00001, 3.99998), {}) == SampledVerdict::rim);
}

TEST_CASE("a near miss is explained, each by its reason") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(1.01, 0), {}) == SampledVerdict::grazing);
  CHECK(oracle.judge(towards_z(5, 2.00001), {}) == SampledVerdict::rim);
  CHECK(oracle.judge(towards_z(-5, 2.00001), {}) == SampledVerdict::rim);  // the apex
  CHECK(oracle.judge({{0, 0, 6.00001}, {0, 0, 1}}, {}) == SampledVerdict::origin);
}

TEST_CASE("a miss that finer points tell from a near miss agrees") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(5, 2.001), {}) == SampledVerdict::agrees);
  CHECK(oracle.judge({{0, 0, 6.001}, {0, 0, 1}}, {}) == SampledVerdict::agrees);
}

TEST_CASE("a hit that is taken away is missed, just inside a rim, before the apex and at 60 degrees from the normal") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(0.98, 0), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(5.98, 1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(5, 1.99), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(-5, 1.99), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge({{0, 0, 5.99}, {0, 0, 1}}, {}) == SampledVerdict::unsound);
}

TEST_CASE("the exact hits of random rays stand, and nearly all are missed once they are taken away") {
  const std::uint64_t seed = 20261121;
  CAPTURE(seed);
  test::Random random(seed);
  std::size_t taken = 0, missed = 0;
  for (int round = 0; round < 20; ++round) {
    const scene::Scene scene = test::random_scene(random, 4);
    const oracle::sampled::Oracle oracle(scene);
    for (int i = 0; i < 200; ++i) {
      const model::Rayo ray = test::random_ray(random);
      const scene::Hit hit = surface::exact::first_hit(scene, ray, {});
      CHECK(agrees(oracle.judge(ray, hit)));
      if (hit.resultado != model::Resultado::hit) continue;
      ++taken;
      missed += oracle.judge(ray, {}) == SampledVerdict::unsound;
    }
  }
  CAPTURE(taken, missed);
  CHECK(taken > 1000);
  CHECK(missed > taken * 9 / 10);
}

TEST_CASE("the verdict is the same at every scale in range, and however long the ray's direction") {
  for (const double scale : {1e-139, 1e-70, 1.0, 1e70, 1e139}) {
    for (const double speed : {0x1p-1074, 1e-200, 1.0, 1e200, 1e308}) {
      CAPTURE(scale, speed);
      scene::Scene scene;
      scene.apply(model::Agregar_Esfera{model::Elemento("s"), {0, 0, 5 * scale}, scale});
      const oracle::sampled::Oracle oracle(scene);
      const model::Rayo ray{{0, 0, 0}, {0, 0, speed}};
      CHECK(oracle.judge(ray, {model::Resultado::hit, 4, {0, 0, 4 * scale}, {sphere}}) == SampledVerdict::agrees);
      CHECK(oracle.judge(ray, {}) == SampledVerdict::unsound);
      CHECK(oracle.judge(ray, {model::Resultado::hit, 4, {0, 0, 3 * scale}, {sphere}}) == SampledVerdict::incomplete);
      const scene::Hit found = oracle.first_hit(ray);
      CHECK(found.punto.z / scale == Approx(4).margin(1.0 / 16));
      if (scale == 1 && speed >= 1e-200) CHECK(found.t * speed == Approx(4).margin(1.0 / 16));
    }
  }
}

TEST_CASE("lengths and places out of range are refused by name") {
  using model::Elemento;
  const auto refusal = [](const model::Operation& addition) -> std::string {
    scene::Scene scene;
    scene.apply(addition);
    try {
      const oracle::sampled::Oracle oracle(scene);
    } catch (const std::domain_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal(model::Agregar_Esfera{Elemento("s"), {0, 0, 0}, 1e160}) ==
        "element s has a length of 1e+160; expected lengths from 1e-140 to 1e+140 (the sampled oracle's range)");
  CHECK(refusal(model::Agregar_Esfera{Elemento("s"), {0, 0, 0}, 1e-160}) != "");
  CHECK(refusal(model::Agregar_Esfera{Elemento("s"), {0, -1e160, 0}, 1}) ==
        "element s has a coordinate of -1e+160; expected coordinates up to 1e+140 (the sampled oracle's range)");
  CHECK(refusal(model::Agregar_Cilindro{Elemento("c"), {0, 0, 0}, 1, {0, 0, 1}, 1e-141}) != "");
  CHECK(refusal(model::Agregar_Cono{Elemento("k"), {0, 0, 0}, 1e-100, {0, 0, 1}, 1e-100}) != "");
  CHECK(refusal(model::Agregar_Esfera{Elemento("s"), {1e140, 0, 0}, 1e-140}) == "");
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  const model::Rayo far{{0, 1e146, 0}, {0, 0, 1}};
  CHECK_THROWS_AS(oracle.judge(far, {}), std::domain_error);
  CHECK_THROWS_AS(oracle.first_hit(far), std::domain_error);
}

TEST_CASE("the sampled first hit is within delta of the exact one") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  const scene::Hit found = oracle.first_hit(towards_z(0, 0));
  CHECK(found.resultado == model::Resultado::hit);
  CHECK(found.elementos == scene::ElementSet{sphere});
  CHECK(found.t == Approx(2).margin(1.0 / 16));
  CHECK(oracle.first_hit(towards_z(9, 9)).resultado == model::Resultado::miss);
}

TEST_CASE("a claimed point has delta and 2^-40 of the lengths at hand, no more and no less") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {0, 0, 0}, 1});
  const double fineness = oracle::sampled::default_fineness, far = 0x1p20;
  const oracle::Cover cover = oracle::cover(scene.shapes<scene::Sphere>()[0], fineness);
  const double slack = 0x1p-40 * (far + 1);
  const glm::dvec3 sample = cover.samples.front();
  const auto judged = [&](double part) {
    const glm::dvec3 claimed = sample + glm::normalize(sample) * (cover.delta + part * slack);
    const scene::Hit claim{model::Resultado::hit, far, claimed, {sphere}};
    return oracle::sampled::Oracle(scene, fineness).judge({{-far, 0, 0}, {1, 0, 0}}, claim);
  };
  CHECK(judged(0.9) != SampledVerdict::incomplete);
  CHECK(judged(1.1) == SampledVerdict::incomplete);
}

TEST_CASE("samples that are made part by part judge as those that are kept, many rays at once and one by one") {
  test::Random random(17);
  scene::Scene scene = test::random_scene(random, 12);
  scene.apply(model::Agregar_Plano{model::Elemento("p"), {0, 0, -2}, {0, 0, 1}});
  scene.apply(model::Agregar_Esfera{model::Elemento("far"), {40, 40, 40}, 1});  // which no ray comes near
  std::vector<scene::Query> rays;
  std::vector<scene::Hit> claims;
  for (int i = 0; i < 400; ++i) {
    const scene::Query ray{test::random_ray(random), {}};
    rays.push_back(ray);
    claims.push_back(surface::exact::first_hit(scene, ray.rayo));
    if (i % 5 == 1) claims.back() = {};
    if (i % 5 == 2) claims.back().punto += glm::dvec3(0.5);
    if (i % 5 == 3) claims.back().elementos = {scene.find("far").value()};
  }
  const double fineness = oracle::sampled::default_fineness;
  const oracle::sampled::Oracle kept(scene);
  const std::vector<SampledVerdict> verdicts = kept.judge(rays, claims);
  std::vector<scene::Hit> hits(rays.size()), others(rays.size());
  kept.first_hits(rays, hits);
  for (const SampledVerdict verdict : {SampledVerdict::agrees, SampledVerdict::incomplete, SampledVerdict::unsound})
    CHECK(std::ranges::count(verdicts, verdict) > 10);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{200'000}, std::size_t{500'000}}) {
    const oracle::sampled::Oracle parts(scene, fineness, bytes);
    CHECK(parts.judge(rays, claims) == verdicts);
    parts.first_hits(rays, others);
    CHECK(others == hits);
  }
  const oracle::sampled::Oracle parts(scene, fineness, 0);
  for (std::size_t i = 0; i < 40; ++i) {
    CHECK(parts.judge(rays[i].rayo, claims[i]) == verdicts[i]);
    CHECK(kept.judge(rays[i].rayo, claims[i]) == verdicts[i]);
    CHECK(parts.first_hit(rays[i].rayo) == hits[i]);
  }
}

TEST_CASE("all pairs of a ray and an element are told of, whether samples are kept or not") {
  test::Random random(18);
  const scene::Scene scene = test::random_scene(random, 7);
  std::vector<scene::Query> rays;
  for (int i = 0; i < 50; ++i) rays.push_back({test::random_ray(random), {}});
  const std::vector<scene::Hit> misses(rays.size());
  for (const std::size_t bytes : {std::size_t{0}, oracle::sampled::Oracle::usual_bytes}) {
    std::atomic<std::uint64_t> pairs = 0;
    oracle::sampled::Oracle(scene, oracle::sampled::default_fineness, bytes)
        .judge(rays, misses, [&](std::uint64_t more) { pairs += more; });
    CHECK(pairs == 7 * 50);
  }
}
