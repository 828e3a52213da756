// Instances and solids against the oracle of points, which knows neither their polynomials nor the walk along a ray:
// right hits stand, hits that are taken away are missed, and points of a leaf that are not on the solid are seen.
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "composed/random_solids.hpp"
#include "durero/composed/engine.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/oracle/sampled.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using oracle::sampled::Oracle;
using oracle::sampled::SampledVerdict;

namespace {

constexpr std::uint64_t seed = 20'261'127;
const int rounds = test::sanitized ? 8 : 60;

/// The verdicts of the samples on the right hits of rays towards a scene, and on none in their place.
struct Judged {
  std::size_t wrong = 0, hits = 0, missed = 0;

  void add(const scene::Scene& scene, const std::vector<model::Rayo>& rays) {
    const auto engine = composed::prepared(*engine::find("fast"), scene);
    const Oracle samples(scene);
    for (const model::Rayo& ray : rays) {
      const std::vector<scene::Query> query{{ray, {}}};
      const scene::Hit hit = engine::first_hits(*engine, query).front();
      wrong += !agrees(samples.judge(ray, hit));
      if (hit.resultado != model::Resultado::hit) continue;
      ++hits;
      missed += samples.judge(ray, {}) == SampledVerdict::unsound;
    }
  }
};

scene::ElementRef add_body(scene::Scene& scene, const std::string& name, scene::Body body) {
  const scene::ElementRef place = test::add(scene, model::Elemento(name), scene::stand_in);
  scene.set_body(place, std::move(body));
  return place;
}

std::vector<model::Rayo> rays_near(test::Random& random, double reach) {
  std::vector<model::Rayo> rays;
  while (rays.size() < 40) {
    const glm::dvec3 from = random.in_cube(3 * reach), to = random.in_cube(reach);
    rays.emplace_back(model::Punto(from), model::Vector(to - from));
  }
  return rays;
}

/// A map that turns, leans and stretches, by no more than some times one way than another.
model::Mapa random_map(test::Random& random) {
  const auto exact = [](const glm::dvec3& v) -> model::ExactVector {
    return {number::exact(v.x), number::exact(v.y), number::exact(v.z)};
  };
  for (;;) {
    const glm::dvec3 x = random.in_cube(1), y = random.in_cube(1), z = random.in_cube(1);
    if (std::abs(glm::dot(x, glm::cross(y, z))) > 0.2) return {exact(random.in_cube(1)), exact(x), exact(y), exact(z)};
  }
}

/// The verdicts on so many scenes; put(scene) fills one, and answers rays towards it.
template <class Put>
Judged judged_rounds(Put put) {
  Judged judged;
  for (int round = 0; round < rounds; ++round) {
    scene::Scene scene;
    const std::vector<model::Rayo> rays = put(scene);
    judged.add(scene, rays);
  }
  return judged;
}

scene::Compound joined(scene::Compound::Operation operation, std::vector<scene::Body> parts) {
  return {operation, std::move(parts)};
}

model::Rayo towards_z(double x, double y) { return {{x, y, -9}, {0, 0, 1}}; }

scene::Hit hit(double x, double y, double z, scene::ElementRef element) {
  return {model::Resultado::hit, z + 9, {x, y, z}, {element}};
}

const scene::Sphere unit{{0, 0, 0}, 1}, second{{0, 0, 1}, 1};

}  // namespace

TEST_CASE("the first hits of copies stand, and nearly all are missed once they are taken away") {
  test::Random random(seed);
  const Judged judged = judged_rounds([&](scene::Scene& scene) {
    const scene::Scene originals = test::random_scene(random, 5);
    originals.for_each([&](scene::ElementRef e, const auto& shape) {
      add_body(scene, originals.name(e).name(), {scene::Instance{shape, random_map(random)}});
    });
    return rays_near(random, 1.5);
  });
  CAPTURE(seed, judged.hits, judged.missed);
  CHECK(judged.wrong == 0);
  CHECK(judged.hits > 10u * static_cast<unsigned>(rounds));
  CHECK(judged.missed > judged.hits * 9 / 10);
}

TEST_CASE("the first hits of solids anywhere stand, and nearly all are missed once they are taken away") {
  test::SolidDraw draw(seed, false);
  test::Random random(seed);
  const Judged judged = judged_rounds([&](scene::Scene& scene) {
    add_body(scene, "s", scene::copied(random_map(random), draw.tree(3).body));
    return rays_near(random, 2);
  });
  CAPTURE(seed, judged.hits, judged.missed);
  CHECK(judged.wrong == 0);
  CHECK(judged.hits > 10u * static_cast<unsigned>(rounds));
  CHECK(judged.missed > judged.hits * 8 / 10);
}

TEST_CASE("the first hits of solids whose faces coincide stand") {
  test::SolidDraw draw(seed, true);
  test::Random random(seed);
  const Judged judged = judged_rounds([&](scene::Scene& scene) {
    add_body(scene, "s", draw.tree(3).body);
    std::vector<model::Rayo> rays = rays_near(random, 2);
    for (int i = 0; i < 20; ++i) rays.push_back(draw.ray());
    return rays;
  });
  CAPTURE(seed, judged.hits, judged.missed);
  CHECK(judged.wrong == 0);
  CHECK(judged.missed > judged.hits / 2);
}

TEST_CASE("a copy is judged where its map has put it") {
  scene::Scene scene;
  const model::Mapa wide{{3, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, number::exact(1.25)}};
  const scene::ElementRef copy = add_body(scene, "i", {scene::Instance{unit, wide}});
  const Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(3, 0), hit(3, 0, -1.25, copy)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(3, 0), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(3, 0), hit(3, 0, 1.25, copy)) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(3, 0), hit(3, 0, -0.9, copy)) == SampledVerdict::incomplete);
  CHECK(oracle.judge(towards_z(4.5, 0), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(5.5, 0), {}) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(0, 0), {}) == SampledVerdict::agrees);  // where the original is there is nothing
  CHECK(oracle.first_hit(towards_z(3, 0)).t == Approx(7.75).margin(0.2));
}

TEST_CASE("of what is joined the surface is judged, and no other part of the leaves") {
  using enum scene::Compound::Operation;
  const auto scene_of = [](scene::Compound::Operation operation) {
    scene::Scene scene;
    add_body(scene, "s", {joined(operation, {test::body_of(unit), test::body_of(second)})});
    return scene;
  };
  const scene::ElementRef solid{model::Tipo::soy_esfera, 0};
  const model::Rayo ray = towards_z(0.1, 0.2);  // it meets the leaves near −1, 0, 1 and 2
  const double r = std::sqrt(1 - 0.05);
  const auto verdict = [&](scene::Compound::Operation operation, const scene::Hit& claim) {
    return Oracle(scene_of(operation)).judge(ray, claim);
  };
  const scene::Hit at_first = hit(0.1, 0.2, -r, solid), within = hit(0.1, 0.2, 1 - r, solid),
                   at_last = hit(0.1, 0.2, 1 + r, solid);
  CHECK(verdict(united, at_first) == SampledVerdict::agrees);
  CHECK(verdict(united, within) == SampledVerdict::incomplete);
  CHECK(verdict(united, at_last) == SampledVerdict::unsound);
  CHECK(verdict(united, {}) == SampledVerdict::unsound);
  CHECK(verdict(intersected, at_first) == SampledVerdict::incomplete);
  CHECK(verdict(intersected, within) == SampledVerdict::agrees);
  CHECK(verdict(intersected, {}) == SampledVerdict::unsound);
  CHECK(verdict(subtracted, at_first) == SampledVerdict::agrees);
  CHECK(verdict(subtracted, at_last) == SampledVerdict::incomplete);
  CHECK(verdict(subtracted, {}) == SampledVerdict::unsound);
  CHECK(Oracle(scene_of(intersected)).first_hit(ray).punto.z == Approx(1 - r).margin(0.2));
}

TEST_CASE("planes alone bound a solid, and their patches hold it; lids are of the surface") {
  scene::Scene scene;
  const auto box = scene::box_between({-1, -1, -1}, {1, 1, 1}).value();
  const scene::Cylinder rod{{0, 0, -2}, 0.5, {0, 0, 1}, 2};
  const scene::ElementRef drilled =
      add_body(scene, "d", {joined(scene::Compound::Operation::subtracted, {{box}, test::body_of(rod)})});
  const scene::ElementRef peg = add_body(
      scene, "p",
      {joined(scene::Compound::Operation::united, {test::body_of(scene::Cylinder{{9, 0, 0}, 1, {0, 0, 1}, 2})})});
  const Oracle oracle(scene);
  CHECK(oracle.judge(towards_z(0.8, 0.7), hit(0.8, 0.7, -1, drilled)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(0.8, 0.7), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(0.1, 0.1), hit(0.1, 0.1, 0, drilled)) == SampledVerdict::agrees);  // the hole's end
  CHECK(oracle.judge(towards_z(0.1, 0.1), hit(0.1, 0.1, -1, drilled)) == SampledVerdict::incomplete);
  CHECK(oracle.judge(towards_z(0.1, 0.1), hit(0.1, 0.1, 1, drilled)) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(0.1, 0.1), {}) == SampledVerdict::unsound);
  CHECK(oracle.judge(towards_z(1.5, 0), {}) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(9.3, 0.2), hit(9.3, 0.2, 0, peg)) == SampledVerdict::agrees);
  CHECK(oracle.judge(towards_z(9.3, 0.2), {}) == SampledVerdict::unsound);
}

TEST_CASE("a wall between parts that share a face excuses a ray, and a map that is too flat is refused") {
  scene::Scene scene;
  const auto box = [](double low, double high) {
    return scene::Body{scene::box_between({-1, -1, low}, {1, 1, high}).value()};
  };
  const scene::ElementRef boxes =
      add_body(scene, "b", {joined(scene::Compound::Operation::united, {box(-1, 0), box(0, 1)})});
  const Oracle oracle(scene);
  CHECK(agrees(oracle.judge({{0.1, 0.1, -0.5}, {0, 0, 1}}, {model::Resultado::hit, 1.5, {0.1, 0.1, 1}, {boxes}})));
  CHECK(oracle.judge({{0.1, 0.1, -0.5}, {0, 0, 1}}, {}) == SampledVerdict::unsound);

  scene::Scene flat;
  add_body(flat, "i", {scene::Instance{unit, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, number::exact(0x1p-17)}}}});
  try {
    const Oracle refused(flat);
    FAIL("a map that stretches 2^17 times as much one way as another is taken");
  } catch (const std::domain_error& error) {
    CHECK(std::string(error.what())
              .starts_with("element i is stretched more one way than another by a factor of up to "));
  }
}
