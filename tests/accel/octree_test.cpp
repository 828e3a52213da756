#include "durero/accel/octree.hpp"

#include <array>
#include <cmath>
#include <iostream>
#include <set>

#include "accel/rational_walk.hpp"
#include "durero/accel/structure.hpp"
#include "durero/accel/touch.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::AxisRay;
using accel::Octree;
using accel::PlaneCrossing;
using accel::Work;

static_assert(accel::Structure<Octree> && accel::Structure<accel::OctreeByLocation>);

namespace {

constexpr auto no_limit = [] { return trace::no_limit; };

std::vector<surface::Box> boxes(const Octree& octree) {
  std::vector<surface::Box> boxes;
  for (const Octree::Leaf& leaf : octree.leaves()) boxes.push_back(octree.box(leaf));
  return boxes;
}

std::vector<int> walked(const Octree& octree, const model::Rayo& rayo, std::array<int, 10>& siblings) {
  std::vector<int> leaves;
  Work work;
  octree.walk(
      AxisRay(trace::Ray(rayo)),
      [&](std::size_t leaf, const PlaneCrossing&) {
        leaves.push_back(static_cast<int>(leaf));
        return false;
      },
      [&](unsigned count) { ++siblings[count]; }, work);
  return leaves;
}

std::vector<int> walked_by_location(const Octree& octree, const model::Rayo& rayo) {
  std::vector<int> leaves;
  Work work;
  octree.walk_by_location(
      AxisRay(trace::Ray(rayo)),
      [&](std::size_t leaf, const PlaneCrossing&) {
        leaves.push_back(static_cast<int>(leaf));
        return false;
      },
      work);
  return leaves;
}

/// Through a corner of a leaf, or on a face of it, or in the middle of nothing; from inside or outside.
model::Rayo drawn(Random& random, const Octree& octree) {
  const surface::Box box = octree.box(octree.leaves()[random.below(octree.leaves().size())]);
  glm::dvec3 through = random.in_cube(2);
  for (int axis = 0; axis < 3; ++axis)
    if (random.chance(3, 4)) through[axis] = (random.chance(1, 2) ? box.low : box.high)[axis];
  const glm::dvec3 way = random.chance(2, 3) ? random.lattice_vector(2) : random.direction();
  return ray(through - random.any_of(std::array{0.0, 0.25, 1.0, 8.0}) * way, way);
}

}  // namespace

/// Of so many rays in each of some scenes: how many leaves they visit, which are exactly those that hold points of
/// them, each once, in their order.
static std::size_t check_walks(std::uint64_t seed, int scenes, std::size_t rays) {
  Random random(seed);
  std::array<int, 10> siblings{};
  std::size_t visited = 0;
  for (int round = 0; round < scenes; ++round) {
    const scene::Scene scene = random_scene(random, 6);
    const Octree octree(scene, {.max_depth = 3 + round % 2});
    const std::vector<surface::Box> cells = boxes(octree);
    for (std::size_t i = 0; i < rays; ++i) {
      const model::Rayo rayo = drawn(random, octree);
      const std::vector<int> expected = rational_walk(rayo, cells);
      if (walked(octree, rayo, siblings) == expected && walked_by_location(octree, rayo) == expected) {
        visited += expected.size();
        continue;
      }
      FAIL("seed " << seed << ", round " << round << ", ray " << i);
    }
  }
  return visited;
}

TEST_CASE("both walks visit exactly the leaves that hold points of the ray, each once, in its order") {
  CHECK(check_walks(1, 4, fewer_when_sanitized(400)) > fewer_when_sanitized(2000));
}
TEST_CASE("both walks visit exactly the leaves of a million rays", "[long]") {
  CHECK(check_walks(100, 1000, 1000) > 2'000'000);
}

TEST_CASE("a ray goes through at most four of eight siblings, and both walks agree on many rays") {
  Random random(2);
  const scene::Scene scene = random_scene(random, 200);
  const Octree octree(scene);
  std::array<int, 10> siblings{};
  for (std::size_t i = 0; i < fewer_when_sanitized(10000); ++i) {
    const model::Rayo rayo = i % 2 == 0 ? random_ray(random) : drawn(random, octree);
    const std::vector<int> leaves = walked(octree, rayo, siblings);
    REQUIRE(walked_by_location(octree, rayo) == leaves);
    REQUIRE(std::set<int>(leaves.begin(), leaves.end()).size() == leaves.size());
  }
  CHECK(siblings[0] == 0);
  for (std::size_t count = 1; count <= 4; ++count) CHECK(siblings[count] > 0);
  for (std::size_t count = 5; count < siblings.size(); ++count) CHECK(siblings[count] == 0);
}

TEST_CASE("both walks agree on very many rays", "[long]") {
  Random random(3);
  std::array<int, 10> siblings{};
  for (int round = 0; round < 100; ++round) {
    const scene::Scene scene = random_scene(random, 1 + random.below(300));
    const Octree octree(scene);
    for (int i = 0; i < 10000; ++i) {
      const model::Rayo rayo = i % 2 == 0 ? random_ray(random) : drawn(random, octree);
      REQUIRE(walked_by_location(octree, rayo) == walked(octree, rayo, siblings));
    }
  }
  std::cout << "groups of eight by the siblings that a ray goes through:";
  std::size_t groups = 0;
  for (std::size_t count = 1; count < siblings.size(); ++count) {
    groups += static_cast<std::size_t>(siblings[count]);
    std::cout << ' ' << count << ": " << siblings[count];
    CHECK((siblings[count] > 0) == (count <= 4));
  }
  std::cout << '\n';
  CHECK(siblings[0] == 0);
  CHECK(groups > 10'000'000);
}

/// The leaves make up the root; each of so many points is in one of them, which is found in three ways, with as many
/// looks as it is deep.
static void check_leaves(std::size_t points) {
  Random random(4);
  const scene::Scene scene = random_scene(random, 40);
  const Octree octree(scene);
  const accel::Lattice& finest = octree.finest();
  std::uint64_t volume = 0;
  for (const Octree::Leaf& leaf : octree.leaves()) {
    const auto side = static_cast<std::uint64_t>(finest.count.x >> leaf.depth);
    volume += side * side * side;
  }
  CHECK(volume == finest.size());
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < points; ++i) {
    glm::dvec3 point;
    accel::Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      const int place = random.integer(0, finest.count[axis] - 1);
      point[axis] = finest.plane(axis, place) + (random.chance(1, 2) ? 0 : random.uniform(0, finest.h));
      cell[axis] = finest.place(axis, point[axis]);
    }
    std::size_t by_coordinates = 0, by_code = 0;
    const std::size_t leaf = octree.leaf_at(point, by_coordinates);
    REQUIRE(octree.leaf_at(cell, by_code) == leaf);
    REQUIRE(by_code == by_coordinates);
    REQUIRE(by_code == static_cast<std::size_t>(octree.leaves()[leaf].depth));
    deepest = std::max(deepest, by_code);
    const surface::Box box = octree.box(octree.leaves()[leaf]);
    for (int axis = 0; axis < 3; ++axis) REQUIRE((box.low[axis] <= point[axis] && point[axis] < box.high[axis]));
  }
  CHECK(deepest <= octree.size().depth);
}

TEST_CASE("the leaves make up the root, and each point is in one of them, found in three ways") {
  check_leaves(fewer_when_sanitized(20000));
}
TEST_CASE("each of a million points is in one of the leaves, found in three ways", "[long]") {
  check_leaves(1'000'000);
}

/// The elements that a visited leaf has, in the mean, where balls stand in a lattice of that many on a side.
static double elements_a_leaf(int side, int rays) {
  scene::Scene scene;
  scene.put_off_audits();
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) add(scene, scene::Sphere{glm::dvec3(x, y, z), 0.25});
  const Octree octree(scene);
  Random random(9);
  Work work;
  for (int i = 0; i < rays; ++i) {
    const glm::dvec3 from = random.in_cube(2.0 * side), to = (random.in_cube(0.5) + 0.5) * double(side);
    octree.any(
        trace::Ray(ray(from, to - from)), no_limit, [](scene::ElementRef) { return false; }, work);
  }
  const double mean = static_cast<double>(work.candidates + work.repeated) / static_cast<double>(work.cells);
  UNSCOPED_INFO(scene.size() << " elements: " << mean << " in a visited leaf");
  return mean;
}

TEST_CASE("a leaf that a ray visits has one element or two, however many there are") {
  for (const int side : {5, 10, 20}) CHECK(elements_a_leaf(side, 200) <= 3);
}
TEST_CASE("a leaf that a ray visits has one element or two, up to a million of them", "[long]") {
  std::vector<double> means;
  for (const int side : {10, 22, 46, 100}) means.push_back(elements_a_leaf(side, 1000));
  for (const double mean : means) CHECK(mean <= 3);
  // From a thousand to a million there are fewer empty leaves around; as a power of the number it grows with less than
  // this.
  CHECK(std::log(means.back() / means.front()) / std::log(1000.0) < 0.06);
}

TEST_CASE("each leaf lists what touches it, and is one for the reason that it says") {
  Random random(5);
  const scene::Scene scene = random_scene(random, 60);
  for (const accel::OctreeOptions& options : {accel::OctreeOptions{.max_bytes = 100'000'000},
                                              {.max_depth = 2, .max_bytes = 100'000'000},
                                              {.max_objects = 10, .max_bytes = 100'000'000},
                                              {.max_bytes = 20000},
                                              {.max_depth = 0}}) {
    const Octree octree(scene, options);
    std::array<int, 3> reasons{};
    for (std::size_t i = 0; i < octree.leaves().size(); ++i) {
      const Octree::Leaf& leaf = octree.leaves()[i];
      const auto list = octree.lists()[i];
      const surface::Box box = octree.box(leaf);
      for (std::uint32_t e = 0; e < octree.contents().elements.size(); ++e) {
        const bool touched =
            scene.visit(octree.contents().elements[e], [&](const auto& shape) { return accel::touches(shape, box); });
        // The boxes above a leaf may have been kept from by what parts no smaller one, never the other way round.
        if (std::ranges::binary_search(list, e)) REQUIRE(touched);
      }
      ++reasons[static_cast<std::size_t>(leaf.why)];
      if (leaf.why == Octree::Why::few_objects) REQUIRE(list.size() <= options.max_objects);
      if (leaf.why == Octree::Why::max_depth) REQUIRE(octree.finest().count.x >> leaf.depth == 1);
      if (leaf.why != Octree::Why::few_objects) REQUIRE(list.size() > options.max_objects);
    }
    CHECK((options.max_depth == 0 || octree.size().bytes <= options.max_bytes));
    CHECK((reasons[static_cast<std::size_t>(Octree::Why::max_bytes)] > 0) == (options.max_bytes == 20000));
    const accel::Lists leaves_of = octree.lists().inverse(octree.contents().elements.size());
    CHECK(leaves_of.inverse(octree.leaves().size()) == octree.lists());
  }
  CHECK_THROWS_AS(Octree(scene, {.max_depth = Octree::deepest + 1}), std::invalid_argument);
  CHECK(Octree(scene).size() == Octree(scene).size());
}

TEST_CASE("every element that a ray meets is visited, once, by both") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 60);
    const accel::OctreeByLocation octree(scene);
    for (int i = 0; i < 60; ++i) {
      const model::Rayo rayo = random_ray(random);
      std::vector<scene::ElementRef> elements, by_location;
      accel::CandidateSource<Octree>(octree).any(trace::Ray(rayo), no_limit,
                                                 [&](scene::ElementRef e) { return elements.push_back(e), false; });
      accel::CandidateSource(octree).any(trace::Ray(rayo), no_limit,
                                         [&](scene::ElementRef e) { return by_location.push_back(e), false; });
      REQUIRE(elements == by_location);
      std::ranges::sort(elements);
      REQUIRE(std::ranges::adjacent_find(elements) == elements.end());
      for (const scene::ElementRef e : octree.contents().elements)
        if (!surface::exact::reach(scene, e, rayo).empty()) REQUIRE(std::ranges::binary_search(elements, e));
    }
  }
}

TEST_CASE("a leaf beyond the limit is passed over, and so is all that is not in the way") {
  scene::Scene scene;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y) add(scene, scene::Sphere{{x + 0.5, y + 0.5, 0.5}, 0.25});
  const Octree octree(scene);
  Work whole, half;
  const trace::Ray along(ray({-1, 0.5, 0.5}, {1, 0, 0}));
  octree.any(
      along, no_limit, [](scene::ElementRef) { return false; }, whole);
  octree.any(
      along, [] { return 8.5; }, [](scene::ElementRef) { return false; }, half);
  CHECK(whole.candidates >= 16);
  CHECK(whole.candidates <= 32);
  CHECK(half.candidates >= 8);
  CHECK(half.candidates * 3 <= whole.candidates * 2);
  CHECK(half.by_distance == 1);
}
