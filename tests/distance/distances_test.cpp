#include "durero/distance/distances.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "durero/distance/bounds.hpp"
#include "durero/distance/exact.hpp"
#include "durero/model/distancias.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using distance::Distances;
using scene::NearestCount;
using scene::Proximity;

namespace {

Proximity nearest(const scene::Scene& scene, const glm::dvec3& p) {
  distance::DistanceWork unseen;
  return Distances(scene).nearest(p, unseen);
}

std::vector<glm::dvec3> random_points(std::uint64_t seed, std::size_t count) {
  test::Random random(seed);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(random.in_cube(2));
  return points;
}

std::vector<Proximity> answers(const scene::Scene& scene, const std::vector<glm::dvec3>& points) {
  std::vector<Proximity> found(points.size());
  Distances(scene).nearest(points, found);
  return found;
}

/// |F(p) − F(q)| ≤ ‖p − q‖, but for the roundings of the three.
void check_lipschitz(std::uint64_t seed, std::size_t pairs) {
  INFO("seed " << seed);
  test::Random random(seed);
  const scene::Scene scene = test::random_scene(random, 40);
  const std::vector<glm::dvec3> points = random_points(seed + 1, 2 * pairs);
  const std::vector<Proximity> found = answers(scene, points);
  std::size_t broken = 0;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const double apart = glm::length(points[i] - points[i + 1]);
    if (std::abs(found[i].distance - found[i + 1].distance) > apart + 1e-14) ++broken;
    // And from a point to its own nearest point the distance falls to nothing, along the whole way.
    const glm::dvec3 half = 0.5 * (points[i] + found[i].point);
    const double left = nearest(scene, half).distance;
    if (i < 200 && std::abs(left - found[i].distance / 2) > 1e-13) ++broken;
  }
  CHECK(broken == 0);
}

}  // namespace

TEST_CASE("An empty scene has nothing nearest") { CHECK(nearest(scene::Scene(), {1, 2, 3}) == Proximity{}); }

TEST_CASE("Elements at one distance are all named, and of the nearest points the first is told") {
  scene::Scene scene;
  const auto left = test::add(scene, scene::Sphere{{-5, 0, 0}, 2}),
             right = test::add(scene, scene::Sphere{{5, 0, 0}, 2});
  CHECK(nearest(scene, {0, 0, 0}) == Proximity{NearestCount::many, 3, {-3, 0, 0}, {left, right}});
  CHECK(nearest(scene, {0x1p-60, 0, 0}) == Proximity{NearestCount::one, 3, {3, 0, 0}, {right}});
  CHECK(nearest(scene, {5, 0, 0}) == Proximity{NearestCount::many, 2, {3, 0, 0}, {right}});
  // A wall and its lid share a rim: one point, two elements.
  scene::Scene tin;
  const auto wall = test::add(tin, scene::Cylinder{{0, 0, 0}, 2, {0, 0, 1}, 6}),
             lid = test::add(tin, scene::Disc{{0, 0, 6}, 2, {0, 0, 1}});
  CHECK(nearest(tin, {5, 0, 10}) == Proximity{NearestCount::one, 5, {2, 0, 6}, {wall, lid}});
  CHECK(nearest(tin, {0, 0, 4}) == Proximity{NearestCount::many, 2, {-2, 0, 4}, {wall, lid}});
}

TEST_CASE(
    "Two tilted cones that are one another's image tie exactly, and are told apart by one unit of the last place") {
  // (x, y, z) and (−x, y, z): the squared distances are functions of roots of two quartics.
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 0.7));
  const glm::dvec3 other(-axis.x, axis.y, axis.z);
  REQUIRE(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z != 1);
  scene::Scene scene;
  const auto one = test::add(scene, scene::Cone{{1, 0, 0}, 0.37, axis, 2.3}),
             image = test::add(scene, scene::Cone{{-1, 0, 0}, 0.37, other, 2.3});
  const Proximity tie = nearest(scene, {0, 0.4, 2.1});
  CHECK(tie.count == NearestCount::many);
  CHECK(tie.elementos == scene::ElementSet{one, image});
  CHECK(tie.point.x < 0);
  CHECK(nearest(scene, {0x1p-200, 0.4, 2.1}).elementos == scene::ElementSet{one});
  CHECK(nearest(scene, {-0x1p-200, 0.4, 2.1}).elementos == scene::ElementSet{image});
}

TEST_CASE("mas_cercano.def.1: the answers are those of the text, on spheres and flat elements") {
  scene::Scene scene;
  test::add(scene, scene::Sphere{{0, 0, 0}, 2});
  test::add(scene, scene::Disc{{0, 0, 3}, 1, {0, 0, 1}});
  test::add(scene, scene::Triangle{{glm::dvec3{4, 0, 0}, {4, 3, 0}, {4, 0, 3}}});
  const model::Escena escena = scene::retrieve(scene);
  std::vector<model::ExactPoint> samples;
  for (const glm::dvec3& w : {glm::dvec3{0, 0, 2}, {2, 0, 0}, {0, 0, 3}, {1, 0, 3}, {4, 0, 0}, {4, 1, 1}, {-2, 0, 0}})
    samples.emplace_back(model::Punto(w));
  const auto check = [&](const glm::dvec3& p) {
    const Proximity found = nearest(scene, p);
    std::set<model::Elemento> names;
    for (const auto e : found.elementos) names.insert(scene.name(e));
    const number::Rational d = number::exact(found.distance);
    CHECK(model::mas_cercano(escena, model::Punto(p), {number::Surd(number::Rational(d * d))},
                             model::Punto(found.point), names, samples));
  };
  check({0, 0, 2.5});  // half-way between two, each at one half
  check({0, 0, 7});
  check({3, 0, 0});
  check({9, 1, 1});
  check({0, 0, 0});
  check({3, 0, 0x1p-40});
}

TEST_CASE("Pruned by boxes or not, the answers are those of every element, and few elements are computed exactly") {
  const std::uint64_t seed = std::random_device()();
  INFO("seed " << seed);
  test::Random random(seed);
  const scene::Scene scene = test::random_scene(random, 150);
  const Distances distances(scene);
  distance::DistanceWork work;
  const std::vector<glm::dvec3> points = random_points(seed + 1, 60);
  for (const glm::dvec3& p : points) {
    const Proximity found = distances.nearest(p, work);
    std::optional<distance::exact::Nearest> least;
    scene::ElementSet elementos;
    scene.for_each([&](scene::ElementRef e, const auto& shape) {
      if (distance::bounds(shape, p).low > found.distance + 0.25) return;  // spares most of the time
      auto of = distance::exact::nearest(shape, p);
      const auto by = least ? algebra::compare(of.squared, least->squared) : std::strong_ordering::less;
      if (by < 0) elementos.clear();
      if (by <= 0) elementos.push_back(e);
      if (by < 0) least = std::move(of);
    });
    REQUIRE(found.elementos == elementos);
    REQUIRE(found.distance == algebra::rounded_root(least->squared));
  }
  CHECK(work.exact < 2 * points.size());
  CHECK(work.bounds < 100 * points.size());
}

TEST_CASE("The answers are the same for any number of threads") {
  test::Random random(7);
  const scene::Scene scene = test::random_scene(random, 50);
  const std::vector<glm::dvec3> points = random_points(8, 300);
  CHECK(test::on_threads(1, [&] { return answers(scene, points); }) == answers(scene, points));
}

TEST_CASE("The distance changes no faster than the point moves") { check_lipschitz(std::random_device()(), 2000); }
TEST_CASE("The distance changes no faster than the point moves, 10⁶ pairs [long]", "[long]") {
  check_lipschitz(std::random_device()(), 1'000'000);
}

TEST_CASE("con_signo.def.1: a sphere's distance is negative inside, and open surfaces have no sign") {
  scene::Scene scene;
  const auto sphere = test::add(scene, scene::Sphere{{1, 2, 3}, 2});
  CHECK(distance::signed_distance(scene, sphere, {1, 2, 4}) == -1.0);
  CHECK(distance::signed_distance(scene, sphere, {1, 2, 9}) == 4.0);
  CHECK(distance::signed_distance(scene, sphere, {1, 2, 5}) == 0.0);
  CHECK(distance::signed_distance(scene, sphere, {1, 2, 3}) == -2.0);
  for (const auto open : {test::add(scene, scene::Cylinder{{0, 0, 0}, 2, {0, 0, 1}, 6}),
                          test::add(scene, scene::Plane{{0, 0, 0}, {0, 0, 1}})})
    CHECK_FALSE(distance::signed_distance(scene, open, {1, 2, 4}));
}
