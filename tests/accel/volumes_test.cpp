// That its answers are those of `analytic` is tests/engine/same_bytes_test; here is what it does for them.
#include "durero/accel/volumes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "durero/accel/structure.hpp"
#include "durero/accel/volume/choice.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::VolumeKind;
using accel::Volumes;
using accel::Work;

static_assert(accel::Structure<Volumes>);

namespace {

scene::Hit first_hit(const Volumes& structure, const model::Rayo& rayo, Work& work) {
  trace::Counts unseen;
  return trace::first_hit_among(accel::Counted(structure, work), rayo, {}, unseen);
}

}  // namespace

TEST_CASE("each ray is tested against every volume: the growth is linear, and fewer elements are tested") {
  Random random(1);
  for (const std::size_t elements : {30, 300, 3000}) {
    const scene::Scene scene = random_scene(random, elements);
    const Volumes volumes(scene, accel::kinds()[0]);
    Work work;
    const std::size_t rays = fewer_when_sanitized(100);
    for (std::size_t i = 0; i < rays; ++i) first_hit(volumes, random_ray(random), work);
    CHECK(work.rays == rays);
    CHECK(work.volumes == rays * volumes.size().elements);
    CHECK(work.volumes == work.by_miss + work.by_distance + work.candidates);
    CHECK(work.candidates < work.volumes / 2);
    CHECK(volumes.size().elements + volumes.size().apart == elements);
  }
}

TEST_CASE("answers depend on no kind; more slabs never let more elements through, and none as many as the ball") {
  Random random(2);
  const scene::Scene scene = random_scene(random, 200);
  std::vector<model::Rayo> rays;
  for (std::size_t i = 0; i < fewer_when_sanitized(1000); ++i) rays.push_back(random_ray(random));
  std::vector<std::uint64_t> m;
  for (const VolumeKind& kind : accel::kinds()) {
    const Volumes volumes(scene, kind);
    Work work;
    for (const model::Rayo& rayo : rays) REQUIRE(first_hit(volumes, rayo, work) == trace::first_hit(scene, rayo));
    UNSCOPED_INFO(kind.name << ": m/n " << double(work.candidates) / double(work.volumes));
    m.push_back(work.candidates);
  }
  CHECK(m[4] <= m[1] + 1);  // three slabs are a box
  CHECK(m[4] + 1 >= m[1]);
  CHECK(m[5] < m[4]);
  CHECK(m[6] < m[5]);
  for (std::size_t i = 1; i < m.size(); ++i) CHECK(m[i] < m[0]);
}

TEST_CASE("composed volumes give the same answers: an intersection lets through what both would, a union either") {
  Random random(3);
  const scene::Scene scene = random_scene(random, 100);
  const VolumeKind &ball = accel::kinds()[0], &oriented = accel::kinds()[2];
  const Volumes balls(scene, ball), boxes(scene, oriented);
  Volumes all(scene, ball), any(scene, ball);
  for (std::size_t i = 0; i < all.bounded().size(); ++i) {
    const accel::Simple& box = boxes.bounded()[i].volume.parts[0];
    all.bounded()[i].volume.parts.push_back(box);
    any.bounded()[i].volume = {{balls.bounded()[i].volume.parts[0], box}, accel::Volume::Rule::union_of};
  }
  Work by_ball, by_box, by_all, by_any;
  for (std::size_t i = 0; i < fewer_when_sanitized(1000); ++i) {
    const model::Rayo rayo = random_ray(random);
    const scene::Hit hit = trace::first_hit(scene, rayo);
    CHECK(first_hit(balls, rayo, by_ball) == hit);
    CHECK(first_hit(boxes, rayo, by_box) == hit);
    CHECK(first_hit(all, rayo, by_all) == hit);
    CHECK(first_hit(any, rayo, by_any) == hit);
  }
  CHECK(by_all.candidates <= std::min(by_ball.candidates, by_box.candidates));
  CHECK(by_any.candidates >= std::max(by_ball.candidates, by_box.candidates));
  CHECK(by_all.volumes == by_ball.volumes + by_ball.candidates);
  CHECK(by_any.volumes > by_ball.volumes);
}

namespace {

/// T = n·B + m·I a line, by the tests that are counted, of lines at random across the ball about the scene.
double counted_cost(const Volumes& volumes, std::size_t lines) {
  Random random(7);
  double sum = 0;
  for (std::size_t i = 0; i < lines; ++i) {
    const glm::dvec3 along = glm::normalize(random.direction()), through = random.in_cube(1);
    const trace::Ray line(model::Rayo{model::Punto(through - 100.0 * along), model::Vector(along)});
    const accel::PrecomputedRay asked(line, accel::most_slabs);
    for (const auto& [element, volume] : volumes.bounded()) {
      Work work;
      if (verdict(volume, asked, trace::no_limit, work) == accel::VolumeTest::met) sum += accel::I;
      for (std::size_t k = 0; k < work.volumes; ++k) sum += kind_of(volume.parts[k]).B;
    }
  }
  return sum / double(lines);
}

}  // namespace

TEST_CASE("with what is chosen a scene costs less than with the best kind for all, or for each, by what is counted") {
  Random random(4);
  scene::Scene mixed;
  mixed.put_off_audits();
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 centre = random.in_cube(1);
    add(mixed, scene::Sphere{centre, 0.6});
    add(mixed, scene::Cylinder{centre, 0.02, random.axis().xyz(), 2});
    add(mixed, scene::Disc{centre, 0.5, {0, 0, 1}});
  }
  const Volumes chosen(mixed);
  std::set<std::string> made;
  for (const Volumes::Bounded& one : chosen.bounded()) made.insert(described(one.volume));
  CHECK(made.size() > 2);
  CHECK(made.contains("ball"));
  CHECK(made.contains("box ∩ ellipsoid"));
  const std::size_t lines = fewer_when_sanitized(4000);
  double best = trace::no_limit;
  for (const VolumeKind& kind : accel::kinds()) {
    const double cost = counted_cost(Volumes(mixed, kind), lines);
    UNSCOPED_INFO(kind.name << ": " << cost);
    best = std::min(best, cost);
  }
  Volumes single(mixed, accel::kinds()[0]);
  for (auto& [element, volume] : single.bounded())
    mixed.visit(element, [&](const auto& shape) {
      volume.parts = {accel::cheapest(shape, Volumes::region(mixed)).around(shape, accel::outline(shape))};
    });
  const double each = counted_cost(single, lines), own = counted_cost(chosen, lines);
  INFO("the best kind of each: " << each << ", chosen: " << own);
  CHECK(own < 0.98 * best);
  CHECK(own < 0.99 * each);
}

TEST_CASE("no element, and planes alone") {
  scene::Scene scene;
  CHECK(Volumes(scene).size().elements == 0);
  scene.apply(model::Agregar_Plano{model::Elemento("p"), model::Punto(glm::dvec3(0, 0, 3)),
                                   model::Vector(glm::dvec3(0, 0, 1))});
  const Volumes volumes(scene);
  CHECK(volumes.size().apart == 1);
  Work work;
  CHECK(first_hit(volumes, {model::Punto(glm::dvec3(0)), model::Vector(glm::dvec3(0, 0, 1))}, work).t == 3);
  CHECK(work == Work{.rays = 1, .untested = 1});
}
