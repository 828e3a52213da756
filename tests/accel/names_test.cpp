#include "durero/accel/names.hpp"

#include <string>

#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Octree;
using accel::OctreeNames;

TEST_CASE("a name is its parent's and one digit more") {
  for (const accel::Name n : {accel::Name(0), accel::Name(1), accel::Name(52)})
    CHECK(OctreeNames::child(OctreeNames::child(n, 3), 7) == 100 * n + 37);
  accel::Name deepest = OctreeNames::root_name;
  for (int depth = 0; depth < Octree::deepest; ++depth) deepest = OctreeNames::child(deepest, 8);
  CHECK(std::to_string(deepest) == std::string(19, '8'));
}

TEST_CASE("a leaf found by names is the leaf found by coordinates, and a name that nobody has is an empty leaf's") {
  Random random(1);
  const scene::Scene scene = random_scene(random, 40);
  const Octree octree(scene);
  const OctreeNames names(octree, 1009);
  std::size_t empty = 0;
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = octree.finest().plane(axis, random.integer(0, octree.finest().count[axis] - 1));
    std::size_t by_coordinates = 0, by_names = 0;
    const std::size_t leaf = octree.leaf_at(point, by_coordinates);
    const std::optional<std::size_t> named = names.leaf_at(point, by_names);
    REQUIRE(named.has_value() == !octree.lists()[leaf].empty());
    if (named) REQUIRE(*named == leaf);
    REQUIRE(by_names <= by_coordinates + 1);
    empty += named ? 0 : 1;
  }
  CHECK(empty > 10);
}

TEST_CASE("names and octal codes are one to one, and the table finds each") {
  Random random(2);
  const scene::Scene scene = random_scene(random, 60);
  const Octree octree(scene);
  for (const std::size_t lists : {std::size_t{1}, std::size_t{97}, std::size_t{100003}}) {
    const OctreeNames names(octree, lists);
    for (std::uint32_t i = 0; i < octree.leaves().size(); ++i) {
      const Octree::Leaf& leaf = octree.leaves()[i];
      const accel::Name name = names.name(leaf, leaf.depth);
      const std::string digits = leaf.depth == 0 ? "" : std::to_string(name);
      REQUIRE(digits.size() == static_cast<std::size_t>(leaf.depth));
      for (int depth = 1; depth <= leaf.depth; ++depth)
        REQUIRE(digits[static_cast<std::size_t>(depth - 1)] - '1' ==
                static_cast<int>(octree.octal_digit(leaf.corner, depth)));
      if (octree.lists()[i].empty()) {
        REQUIRE_FALSE(names.table().find(name));
      } else {
        REQUIRE(names.table().find(name) == i);
      }
    }
    CHECK((lists == 1) == (names.table().longest_chain() == names.table().names()));
    if (lists == 100003) CHECK(names.table().longest_chain() <= 8);
  }
}

TEST_CASE("a tree of halves is found by names as by its nodes, each point in one leaf") {
  Random random(3);
  const scene::Scene scene = random_scene(random, 50);
  for (const accel::Placing placing : {accel::Placing::middle, accel::Placing::median, accel::Placing::surface_area}) {
    const accel::Bsp bsp(scene, {.placing = placing});
    const accel::BspNames names(bsp, 1009);
    CHECK(names.table().names() == bsp.nodes().size());
    const std::vector<surface::Box> cells = bsp.leaf_boxes();
    for (std::size_t i = 0; i < fewer_when_sanitized(2000); ++i) {
      const surface::Box& near = random.any_of(cells);
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis)
        point[axis] = random.chance(1, 2) ? near.low[axis] : random.uniform(near.low[axis], near.high[axis]);
      const surface::Box& cell = cells[names.leaf_at(point)];
      for (int axis = 0; axis < 3; ++axis) REQUIRE((cell.low[axis] <= point[axis] && point[axis] < cell.high[axis]));
    }
  }
  CHECK_THROWS_AS(accel::Bsp(scene, {.max_depth = accel::Bsp::deepest + 1}), std::invalid_argument);
}
