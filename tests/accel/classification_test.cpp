#include "durero/accel/classification.hpp"

#include <set>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using accel::Classification;
using accel::Work;
using scene::ElementRef;
using scene::Scene;

namespace {

constexpr auto unlimited = [] { return trace::no_limit; };

/// Every element that the ray meets is handed over, once each; up to the nearest, enough of them.
void check(const Classification& lists, const model::Rayo& rayo, Work& work) {
  const trace::Ray as_ray(rayo);
  REQUIRE(as_ray.ordinary);
  std::set<ElementRef> met(lists.extraordinary().begin(), lists.extraordinary().end());
  const auto visit = [&](ElementRef e) {
    if (!met.insert(e).second) FAIL("handed over twice");
    return false;
  };
  lists.any(as_ray, unlimited, visit, work);
  trace::Counts unseen;
  const trace::Search search(lists.scene(), rayo, {}, unseen);
  lists.scene().for_each([&](ElementRef e, const auto&) {
    if (search.blocks(e) && !met.contains(e)) FAIL(lists.scene().name(e).name() << " is met and not handed over");
  });
  if (first_hit_among(accel::CandidateSource(lists), rayo, {}, unseen) != trace::first_hit(lists.scene(), rayo))
    FAIL("another first hit");
}

/// From within the scene and from far away, at random and along the borders of squares and boxes.
model::Rayo some_ray(Random& random, int number) {
  const glm::dvec3 towards = random.direction();
  const glm::dvec3 lattice = random.lattice_vector(3);
  const glm::dvec3 within = random.in_cube(1);
  switch (number % 5) {
    case 0:
      return {model::Punto(within), model::Vector(lattice * 0.5)};
    case 1:
      return {model::Punto(lattice * 0.25), model::Vector(towards)};
    case 2:
      return {model::Punto(within - towards * 50.0), model::Vector(towards)};
    case 3:
      return {model::Punto(within - towards * 1e5), model::Vector(towards * 1e3)};
    default:
      return random_ray(random);
  }
}

}  // namespace

/// On scenes of these seeds; true where lists were looked at for many rays.
static bool lists_are_complete(std::uint64_t first, std::uint64_t last) {
  Work work;
  std::size_t asked = 0;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    Random random(seed);
    const Scene scene = random_scene(random, 3 * (seed % 40));
    const Classification lists(scene);
    for (int i = 0; i < 200; ++i, ++asked) check(lists, some_ray(random, i), work);
  }
  return work.cells > asked / 3 && work.nodes > asked;
}

TEST_CASE("what a ray meets is in the list of its box") { CHECK(lists_are_complete(1, sanitized ? 5 : 40)); }
TEST_CASE("what a ray meets is in the list of its box, at length", "[long]") { CHECK(lists_are_complete(1000, 6000)); }

TEST_CASE("the rays of a box look at few elements, in the order of their distance") {
  Scene scene;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      for (int z = -5; z <= 5; ++z) add(scene, scene::Sphere{glm::dvec3(x, y, z), 0.1});
  const Classification lists(scene);
  Random random(1);
  Work work;
  const int rays = static_cast<int>(fewer_when_sanitized(300));
  for (int i = 0; i < rays; ++i) {
    const glm::dvec3 from = random.in_cube(5), v = random.direction();
    check(lists, {model::Punto(from), model::Vector(v)}, work);
  }
  CHECK(work.volumes < 1331 / 8 * static_cast<std::uint64_t>(rays));
  CHECK(work.candidates < 8 * static_cast<std::uint64_t>(rays));
  Work near;
  lists.any(
      trace::Ray(ray({0.5, 0.5, 0.5}, {1, 1, 1})), [] { return 0.5; }, [](ElementRef) { return false; }, near);
  CHECK(near.by_distance == 1);
}

TEST_CASE("lists are the same in whatever order, and on however many threads, they are asked for") {
  Random random(4);
  const Scene scene = random_scene(random, 200);
  std::vector<model::Rayo> rays;
  for (int i = 0; i < 500; ++i) rays.push_back(some_ray(random, i));
  const auto ask = [&](const Classification& lists, std::size_t i) {
    Work work;
    lists.any(
        trace::Ray(rays[i]), unlimited, [](ElementRef) { return false; }, work);
    return work;
  };
  const Classification forwards(scene), backwards(scene), at_once(scene);
  const accel::Size unasked = forwards.size();
  std::vector<Work> first(rays.size()), last(rays.size()), shared(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) first[i] = ask(forwards, i);
  for (std::size_t i = rays.size(); i-- > 0;) last[i] = ask(backwards, i);
  tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t i) { shared[i] = ask(at_once, i); });
  CHECK(first == last);
  CHECK(first == shared);
  CHECK(forwards.size() == backwards.size());
  CHECK(forwards.size() == at_once.size());
  CHECK(forwards.size().references > unasked.references);
}

TEST_CASE("rays from too far away are tried against all, and from beside the scene against none") {
  Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 1});
  add(scene, scene::Sphere{{5, 0, 0}, 1});
  add(scene, scene::Plane{{0, -3, 0}, {0, 1, 0}});
  const Classification lists(scene);
  const auto work_of = [&](const model::Rayo& rayo) {
    Work work;
    check(lists, rayo, work);
    return work;
  };
  CHECK(work_of(ray({-1e9, 0, 0}, {1, 0, 0})) == Work{.volumes = 1, .candidates = 2});
  CHECK(work_of(ray({-9, 9, 0}, {1, 0, 0})) == Work{.volumes = 1, .by_miss = 1});
  CHECK(work_of(ray({-9, 0, 0}, {1, 0, 0})).cells == 1);
  CHECK(lists.size().apart == 1);
}

TEST_CASE("lists hold for no element, and for many in one place") {
  const Scene none;
  CHECK(Classification(none).size() == accel::Size{});
  Scene scene;
  for (int i = 0; i < 3000; ++i) add(scene, scene::Sphere{{0, 0, 0}, 1});
  const Classification lists(scene);
  Work work;
  Random random(6);
  for (int i = 0; i < 20; ++i) check(lists, some_ray(random, i), work);
  CHECK(lists.size().depth <= 12);
}
