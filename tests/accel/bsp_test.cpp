#include "durero/accel/bsp.hpp"

#include <iostream>
#include <map>
#include <set>

#include "accel/rational_walk.hpp"
#include "durero/accel/octree.hpp"
#include "durero/accel/structure.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::AxisRay;
using accel::Bsp;
using accel::Placing;
using accel::PlaneCrossing;
using accel::Work;

static_assert(accel::Structure<Bsp> && accel::Structure<accel::BspByLocation>);

namespace {

constexpr auto no_limit = [] { return trace::no_limit; };
constexpr std::array placings{Placing::middle, Placing::median, Placing::surface_area};

using Visits = std::map<std::size_t, int>;

std::vector<int> walked(const Bsp& bsp, const model::Rayo& rayo, Visits& visits) {
  std::vector<int> leaves;
  bsp.walk(
      AxisRay(trace::Ray(rayo)),
      [&](std::size_t leaf, const PlaneCrossing&) { return leaves.push_back(static_cast<int>(leaf)), false; },
      [&](std::size_t place) { ++visits[place]; });
  return leaves;
}

std::vector<int> walked_by_location(const Bsp& bsp, const model::Rayo& rayo, Visits& visits) {
  std::vector<int> leaves;
  bsp.walk_by_location(
      AxisRay(trace::Ray(rayo)),
      [&](std::size_t leaf, const PlaneCrossing&) { return leaves.push_back(static_cast<int>(leaf)), false; },
      [&](std::size_t place) { ++visits[place]; });
  return leaves;
}

/// Through a corner of a leaf, or on a face of it, or in the middle of nothing; from inside or outside.
model::Rayo drawn(Random& random, const std::vector<surface::Box>& cells) {
  const surface::Box& box = random.any_of(cells);
  glm::dvec3 through = random.in_cube(2);
  for (int axis = 0; axis < 3; ++axis)
    if (random.chance(3, 4)) through[axis] = (random.chance(1, 2) ? box.low : box.high)[axis];
  const glm::dvec3 way = random.chance(2, 3) ? random.lattice_vector(2) : random.direction();
  return ray(through - random.any_of(std::array{0.0, 0.25, 1.0, 8.0}) * way, way);
}

int most(const Visits& visits) {
  int most = 0;
  for (const auto& [place, count] : visits) most = std::max(most, count);
  return most;
}

/// Small balls in a few heaps, no two of whose boxes end at one place.
scene::Scene heaps(Random& random, std::size_t n) {
  scene::Scene scene;
  const std::array<glm::dvec3, 3> middles{random.in_cube(1), random.in_cube(1), random.in_cube(1)};
  while (scene.size() < n) {
    const glm::dvec3 middle = random.any_of(middles);
    add(scene, scene::Sphere{middle + random.in_cube(0.01), 1e-5});
  }
  return scene;
}

}  // namespace

namespace {

/// The leaves visited, and the most visits of one inner node by one ray of the walk by location.
struct Walks {
  std::size_t visited = 0;
  int again = 0;
  std::size_t jansen = 0, location = 0;  // inner nodes, in all
};

/// Of so many rays in each of some scenes, wherever the planes are: the leaves visited are exactly those that hold
/// points of them, each once, in their order; Jansen's walk visits no inner node twice.
Walks check_walks_of_halves(std::uint64_t seed, std::size_t scenes, std::size_t rays) {
  Random random(seed);
  Walks all;
  for (std::size_t round = 0; round < scenes; ++round) {
    const scene::Scene scene = random_scene(random, 8);
    const Bsp bsp(scene, {.placing = placings[round % placings.size()], .max_depth = 6});
    const std::vector<surface::Box> cells = bsp.leaf_boxes();
    for (std::size_t i = 0; i < rays; ++i) {
      const model::Rayo rayo = drawn(random, cells);
      const std::vector<int> expected = rational_walk(rayo, cells);
      Visits jansen, location;
      if (walked(bsp, rayo, jansen) != expected || walked_by_location(bsp, rayo, location) != expected ||
          most(jansen) > 1)
        FAIL("seed " << seed << ", round " << round << ", ray " << i);
      all.again = std::max(all.again, most(location));
      for (const auto& [place, count] : jansen) all.jansen += static_cast<std::size_t>(count);
      for (const auto& [place, count] : location) all.location += static_cast<std::size_t>(count);
      all.visited += expected.size();
    }
  }
  return all;
}

}  // namespace

TEST_CASE("both walks visit exactly the leaves that hold points of the ray, wherever the planes are") {
  const Walks walks = check_walks_of_halves(1, placings.size(), fewer_when_sanitized(400));
  CHECK(walks.again > 1);
  CHECK(walks.jansen < walks.location);
  CHECK(walks.visited > fewer_when_sanitized(1000));
}
TEST_CASE("both walks visit exactly the leaves of a million rays, wherever the planes are", "[long]") {
  const Walks walks = check_walks_of_halves(100, 1002, 1000);
  CHECK(walks.visited > 1'000'000);
  std::cout << "inner nodes a ray: " << static_cast<double>(walks.jansen) / 1'002'000 << " by Jansen's walk, "
            << static_cast<double>(walks.location) / 1'002'000 << " by location\n";
}

TEST_CASE("every element that a ray meets is visited, once, by both walks of a BSP tree") {
  for (const Placing placing : placings)
    for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(10); ++seed) {
      Random random(seed);
      const scene::Scene scene = random_scene(random, 60);
      const accel::BspByLocation bsp(scene, {.placing = placing});
      for (int i = 0; i < 60; ++i) {
        const model::Rayo rayo = random_ray(random);
        std::vector<scene::ElementRef> elements, by_location;
        accel::CandidateSource<Bsp>(bsp).any(trace::Ray(rayo), no_limit,
                                             [&](scene::ElementRef e) { return elements.push_back(e), false; });
        accel::CandidateSource(bsp).any(trace::Ray(rayo), no_limit,
                                        [&](scene::ElementRef e) { return by_location.push_back(e), false; });
        REQUIRE(elements == by_location);
        std::ranges::sort(elements);
        REQUIRE(std::ranges::adjacent_find(elements) == elements.end());
        for (const scene::ElementRef e : bsp.contents().elements)
          if (!surface::exact::reach(scene, e, rayo).empty()) REQUIRE(std::ranges::binary_search(elements, e));
      }
    }
}

TEST_CASE("middle planes in turn divide space as the octree does") {
  Random random(2);
  for (int depth = 0; depth <= 4; ++depth) {
    const scene::Scene scene = random_scene(random, 30);
    const accel::Octree octree(scene, {.max_depth = depth, .max_bytes = 100'000'000});
    const Bsp bsp(scene, {.placing = Placing::middle, .max_depth = 3 * depth, .max_bytes = 100'000'000});
    using Cell = std::tuple<double, double, double, double, std::vector<std::uint32_t>>;
    const auto cell = [](const surface::Box& box, std::span<const std::uint32_t> list) {
      return Cell{box.low.x, box.low.y, box.low.z, box.high.x, {list.begin(), list.end()}};
    };
    std::set<Cell> of_octree, of_bsp;
    for (std::size_t i = 0; i < octree.leaves().size(); ++i)
      of_octree.insert(cell(octree.box(octree.leaves()[i]), octree.lists()[i]));
    for (std::size_t i = 0; i < bsp.leaf_boxes().size(); ++i) of_bsp.insert(cell(bsp.leaf_boxes()[i], bsp.lists()[i]));
    CHECK((of_octree == of_bsp));
    Work by_octree, by_bsp;
    for (int i = 0; i < 200; ++i) {
      const trace::Ray any(random_ray(random));
      octree.any(
          any, no_limit, [](scene::ElementRef) { return false; }, by_octree);
      bsp.any(
          any, no_limit, [](scene::ElementRef) { return false; }, by_bsp);
    }
    CHECK(by_octree.candidates == by_bsp.candidates);
    CHECK(by_octree.cells == by_bsp.cells);
  }
}

TEST_CASE("a plane at the median has as many elements on either side, and the tree is balanced") {
  Random random(3);
  for (const std::size_t n : {10, 100, 1000}) {
    const scene::Scene scene = heaps(random, n);
    const Bsp bsp(scene, {.placing = Placing::median});
    std::vector<std::set<std::uint32_t>> within(bsp.nodes().size());
    for (std::size_t place = bsp.nodes().size(); place-- > 0;) {
      const Bsp::Node& node = bsp.nodes()[place];
      if (node.leaf()) {
        within[place] = {bsp.lists()[node.below].begin(), bsp.lists()[node.below].end()};
        continue;
      }
      std::ranges::set_union(within[node.below], within[node.below + 1],
                             std::inserter(within[place], within[place].end()));
      const auto axis = static_cast<int>(node.axis);
      int below = 0, above = 0;
      for (const std::uint32_t e : within[place]) {
        below += bsp.contents().box_of(e).high[axis] < node.plane ? 1 : 0;
        above += node.plane < bsp.contents().box_of(e).low[axis] ? 1 : 0;
      }
      REQUIRE(std::abs(below - above) <= 1);
    }
    CHECK(bsp.size().depth <= std::bit_width(n - 1) + 2);
    CHECK(bsp.size().depth < Bsp(scene, {.placing = Placing::middle}).size().depth);
  }
}

TEST_CASE("a plane by surface area is the best of all that end elements") {
  Random random(8);
  for (int round = 0; round < 30; ++round) {
    const scene::Scene scene = random_scene(random, 12);
    const Bsp bsp(scene);
    const accel::Contents& contents = bsp.contents();
    // What a ray that comes into the cell is expected to test: by the areas of the halves.
    const auto cost = [&](int axis, double plane) {
      double sum = 0;
      for (const bool above : {false, true}) {
        surface::Box half = bsp.root();
        (above ? half.low : half.high)[axis] = plane;
        double elements = 0;
        for (std::uint32_t e = 0; e < contents.elements.size(); ++e) {
          const surface::Box box = contents.box_of(e);
          elements += (above ? box.high[axis] >= plane : box.low[axis] <= plane) ? 1 : 0;
        }
        const glm::dvec3 side = half.high - half.low;
        sum += elements * (side.x * side.y + side.y * side.z + side.z * side.x);
      }
      return sum;
    };
    if (bsp.nodes()[0].leaf()) continue;
    const double own = cost(static_cast<int>(bsp.nodes()[0].axis), bsp.nodes()[0].plane);
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint32_t e = 0; e < contents.elements.size(); ++e)
        for (const double end : {contents.box_of(e).low[axis] - 1e-9, contents.box_of(e).high[axis] + 1e-9})
          if (bsp.root().low[axis] < end && end < bsp.root().high[axis]) REQUIRE(own <= cost(axis, end) * (1 + 1e-6));
  }
}

TEST_CASE("planes that follow the elements cost less than those that do not, where elements lie in heaps") {
  Random random(4);
  const scene::Scene scene = heaps(random, 300);
  std::map<Placing, Work> work;
  for (const Placing placing : placings) {
    const Bsp bsp(scene, {.placing = placing});
    Random same(5);
    for (int i = 0; i < 1000; ++i) {
      const scene::ElementRef at = bsp.contents().elements[same.below(300)];
      const glm::dvec3 from = same.in_cube(3);
      const glm::dvec3 to = scene.shapes<scene::Sphere>()[at.index].centro + same.in_cube(0.002);
      bsp.any(
          trace::Ray(ray(from, to - from)), no_limit, [](scene::ElementRef) { return false; }, work[placing]);
    }
  }
  CHECK(work[Placing::median].nodes < work[Placing::middle].nodes);
  CHECK(work[Placing::surface_area].nodes < work[Placing::middle].nodes);
  CHECK(work[Placing::surface_area].candidates < work[Placing::median].candidates);
}

TEST_CASE("leaves and bytes are limited, and the lists are those of both directions") {
  Random random(6);
  const scene::Scene scene = random_scene(random, 100);
  for (const Placing placing : placings) {
    const Bsp few(scene, {.placing = placing, .max_bytes = 20000}), flat(scene, {.placing = placing, .max_depth = 3});
    CHECK(few.size().bytes <= 20000);
    CHECK(few.size().cells > 1);
    CHECK(flat.size().depth <= 3);
    CHECK(flat.lists().inverse(flat.contents().elements.size()).inverse(flat.lists().rows()) == flat.lists());
    CHECK(Bsp(scene::Scene(), {.placing = placing}).size().references == 0);
  }
}

TEST_CASE("a leaf beyond the limit is passed over") {
  scene::Scene scene;
  for (int x = 0; x < 16; ++x) add(scene, scene::Sphere{{x + 0.5, 0.5, 0.5}, 0.25});
  const Bsp bsp(scene);
  Work half;
  bsp.any(
      trace::Ray(ray({-1, 0.5, 0.5}, {1, 0, 0})), [] { return 8.5; }, [](scene::ElementRef) { return false; }, half);
  CHECK(half.candidates >= 8);
  CHECK(half.candidates <= 11);
  CHECK(half.by_distance == 1);
}
