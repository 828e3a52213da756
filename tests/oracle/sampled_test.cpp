#include "durero/oracle/sampled.hpp"

#include <glm/geometric.hpp>

#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using oracle::sampled::Verdict;

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
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 4, sphere)) == Verdict::agrees);
  CHECK(oracle.judge(towards_z(5, 1), hit(5, 1, 4, cylinder)) == Verdict::agrees);
  CHECK(oracle.judge(towards_z(-5, 1), hit(-5, 1, 4.5, cone)) == Verdict::agrees);
  CHECK(oracle.judge(towards_z(9, 9), {}) == Verdict::agrees);
}

TEST_CASE("wrong hits are seen: a miss, the far root, another element, a point in the air") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(0, 0), {}) == Verdict::unsound);
  CHECK(oracle.judge(towards_z(5, 1), {}) == Verdict::unsound);
  CHECK(oracle.judge(towards_z(-5, 1), {}) == Verdict::unsound);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 6, sphere)) == Verdict::unsound);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 4, cone)) == Verdict::incomplete);
  CHECK(oracle.judge(towards_z(0, 0), hit(0, 0, 2, sphere)) == Verdict::incomplete);
}

TEST_CASE("a near miss is explained, each by its reason") {
  const scene::Scene scene = one_of_each();
  const oracle::sampled::Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(1.01, 0), {}) == Verdict::grazing);
  CHECK(oracle.judge(towards_z(5, 2.01), {}) == Verdict::rim);
  CHECK(oracle.judge({{0, 0, 6.01}, {0, 0, 1}}, {}) == Verdict::origin);
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
  CHECK(judged(0.9) != Verdict::incomplete);
  CHECK(judged(1.1) == Verdict::incomplete);
}
