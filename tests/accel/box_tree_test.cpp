#include "durero/accel/box_tree.hpp"

#include <set>
#include <vector>

#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using accel::BoxTree;

namespace {

std::vector<surface::Box> random_boxes(test::Random& random, std::size_t count, double half) {
  std::vector<surface::Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 at = random.in_cube(half);
    const glm::dvec3 size{random.uniform(0, 0.5), random.uniform(0, 0.5), random.uniform(0, 0.5)};
    boxes.push_back({at, at + size});
  }
  return boxes;
}

/// The boxes that the slab test alone lets through.
std::set<std::uint32_t> met(const std::vector<surface::Box>& boxes, const trace::Ray& ray, double limit) {
  std::set<std::uint32_t> all;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (accel::stretch(boxes[i], accel::Beam(ray), limit).meets()) all.insert(i);
  return all;
}

}  // namespace

TEST_CASE("A tree over boxes visits each that the ray may meet up to the limit, once") {
  test::Random random(7);
  for (const std::size_t count : {0, 1, 2, 9, 300}) {
    const auto boxes = random_boxes(random, count, 2);
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const trace::Ray ray(test::random_ray(random));
      const double limit = i % 2 == 0 ? 0.7 : std::numeric_limits<double>::infinity();
      std::multiset<std::uint32_t> visited;
      const bool answered = tree.any(
          ray, [&] { return limit; },
          [&](std::uint32_t box) {
            visited.insert(box);
            return false;
          });
      CHECK_FALSE(answered);
      const auto expected = met(boxes, ray, limit);
      REQUIRE(std::set(visited.begin(), visited.end()) == expected);
      REQUIRE(visited.size() == expected.size());
    }
  }
}

TEST_CASE("A visit that answers ends the walk, and a limit that falls prunes it") {
  test::Random random(8);
  const auto boxes = random_boxes(random, 1000, 1);
  const BoxTree tree(boxes);
  const trace::Ray ray(model::Rayo(model::Punto(-9, 0.1, 0.2), model::Vector(1, 0, 0)));
  REQUIRE(met(boxes, ray, 1e9).size() > 3);
  std::size_t visits = 0;
  CHECK(tree.any(
      ray, [] { return 1e9; }, [&](std::uint32_t) { return ++visits == 2; }));
  CHECK(visits == 2);
  visits = 0;
  double limit = 1e9;
  tree.any(
      ray, [&] { return limit; },
      [&](std::uint32_t) {
        limit = 0;
        ++visits;
        return false;
      });
  CHECK(visits <= 1 + met(boxes, ray, 0).size());
}
