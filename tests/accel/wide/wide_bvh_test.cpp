#include "durero/accel/wide/wide_bvh.hpp"

#include <cmath>
#include <set>

#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideBvh;
using accel::WideChild;
using accel::WideNode;
using scene::ElementRef;

namespace {

static_assert(accel::Structure<WideBvh> && trace::PairCandidates<WideBvh>);

surface::Box box_at(const WideNode& node, std::size_t place) {
  surface::Box box{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    box.low[axis] = static_cast<double>(node.planes[i][place]);
    box.high[axis] = static_cast<double>(node.planes[i + 3][place]);
  }
  return box;
}

bool within(const surface::Box& inner, const surface::Box& outer) {
  for (int i = 0; i < 3; ++i)
    if (!(outer.low[i] <= inner.low[i] && inner.high[i] <= outer.high[i])) return false;
  return true;
}

/// Whether a box of binary32 is the other, rounded outwards: by less than a unit in the last place, as proofs/Wide.v
/// has it.
bool rounded_outwards(const WideNode& node, std::size_t place, const surface::Box& box) {
  const auto is_below = [](float y, double x) { return double{y} <= x && double{std::nextafter(y, HUGE_VALF)} > x; };
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    good =
        good && is_below(node.planes[i][place], box.low[axis]) && is_below(-node.planes[i + 3][place], -box.high[axis]);
  }
  return good;
}

/// Whether an element among the children of a node lies in its box; it is added to `found`.
bool leaf_within(const WideBvh& tree, const WideNode& node, std::size_t place, std::multiset<ElementRef>& found) {
  const ElementRef leaf = node.children[place].element(), e = tree.element(leaf);
  found.insert(e);
  const surface::Box of_element = tree.scene().visit(e, [](const auto& shape) { return surface::box(shape); });
  const surface::Box of_leaf = tree.visit(leaf, [](const auto& shape) { return surface::box(shape); });
  return tree.own(e) == leaf && of_leaf.low == of_element.low && of_leaf.high == of_element.high &&
         within(of_element, box_at(node, place)) && rounded_outwards(node, place, of_element);
}

/// Whether all below a node lies in a box; each element is added to `found`.
bool all_within(const WideBvh& tree, std::size_t at, const surface::Box& box, std::multiset<ElementRef>& found) {
  bool good = true;
  const WideNode& node = tree.nodes()[at];
  for (std::size_t place = 0; place < WideNode::width; ++place) {
    const WideChild& child = node.children[place];
    if (child.kind == WideChild::Kind::none) continue;
    const surface::Box own = box_at(node, place);
    good = good && within(own, box);
    if (child.kind == WideChild::Kind::node) {
      good = good && child.index > at && all_within(tree, child.index, own, found);
    } else if (child.kind == WideChild::Kind::block) {
      WideNode block;
      accel::unpack(tree.leaves().blocks(), child.index, block);
      for (std::size_t lane = 0; lane < WideNode::width; ++lane)
        if (block.children[lane].kind != WideChild::Kind::none)
          good = good && within(box_at(block, lane), own) && leaf_within(tree, block, lane, found);
    } else {
      good = good && leaf_within(tree, node, place, found);
    }
  }
  return good;
}

constexpr double infinity = trace::no_limit;
const surface::Box everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};

/// Every element is in the tree, in its box and those of all nodes above, or is kept apart: exactly once.
bool holds_all(const WideBvh& tree) {
  std::multiset<ElementRef> found(tree.unbounded().begin(), tree.unbounded().end());
  found.insert(tree.extraordinary().begin(), tree.extraordinary().end());
  const bool boxed = tree.nodes().empty() || all_within(tree, 0, everywhere, found);
  const bool named =
      std::ranges::all_of(tree.unbounded(), [&](ElementRef e) { return tree.element(tree.own(e)) == e; });
  return boxed && named && found.size() == tree.scene().size() &&
         std::set<ElementRef>(found.begin(), found.end()).size() == found.size();
}

scene::Scene balls(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  scene::Scene scene;
  for (std::size_t i = 0; i < count; ++i) add(scene, scene::Sphere{random.in_cube(10), random.uniform(0.01, 0.2)});
  return scene;
}

/// Triangles at random, whose coordinates are numbers of binary32 but for one of each `every`.
scene::Scene triangles(std::size_t count, std::uint64_t seed, std::size_t every = ~std::size_t{0}) {
  Random random(seed);
  scene::Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 centre = random.in_cube(1);
    std::array<glm::dvec3, 3> vertices;
    for (glm::dvec3& vertex : vertices) {
      vertex = centre + 0.2 * random.in_cube(1);
      if (i % every != every - 1) vertex = glm::dvec3(glm::vec3(vertex));
    }
    add(scene, scene::Triangle{vertices});
  }
  return scene;
}

using Found = std::set<ElementRef>;

Found by_one(const WideBvh& tree, const trace::Ray& ray, double limit = infinity) {
  Found found;
  tree.any(
      ray, [&] { return limit; },
      [&](ElementRef e) {
        CHECK(found.insert(e).second);
        return false;
      });
  return found;
}

/// What pairs takes of each ray.
std::vector<Found> by_all(const WideBvh& tree, const std::vector<trace::Ray>& rays, double limit = infinity) {
  std::vector<Found> found(rays.size());
  tree.pairs(
      rays, [&](std::uint32_t) { return limit; },
      [&](std::uint32_t number, ElementRef leaf) { CHECK(found[number].insert(tree.element(leaf)).second); }, [] {});
  return found;
}

/// The elements that the ray meets at 0 < t ≤ limit, exactly.
Found met_exactly(const scene::Scene& scene, const model::Rayo& rayo, double limit = infinity) {
  Found met;
  trace::Counts unseen;
  const trace::Search search(scene, rayo, {}, unseen);
  scene.for_each([&](ElementRef e, const auto&) {
    const trace::Meeting at = search.meeting(e, infinity);
    if (at.kind != trace::Meeting::Kind::none && at.high <= limit) met.insert(e);
  });
  return met;
}

bool includes(const Found& all, const Found& part) { return std::ranges::includes(all, part); }

/// No ray loses an element that it meets, alone or among others.
void check_no_loss(const scene::Scene& scene, const std::vector<model::Rayo>& rayos, double limit = infinity) {
  const WideBvh tree(scene);
  const Found apart(tree.extraordinary().begin(), tree.extraordinary().end());
  std::vector<trace::Ray> rays;
  for (const model::Rayo& rayo : rayos) rays.emplace_back(rayo);
  const std::vector<Found> many = by_all(tree, rays, limit);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Found met = met_exactly(scene, rayos[i], limit);
    std::erase_if(met, [&](ElementRef e) { return apart.contains(e); });
    INFO("ray " << i);
    CHECK(includes(by_one(tree, rays[i], limit), met));
    CHECK(includes(many[i], met));
  }
}

/// Two hundred rays a hair's breadth apart.
std::vector<model::Rayo> bunch(const glm::dvec3& p, const glm::dvec3& v, double apart) {
  std::vector<model::Rayo> rays;
  for (int i = 0; i < 200; ++i)
    rays.push_back(ray(p + apart * glm::dvec3(i % 7, i % 11, i % 13), v + apart * glm::dvec3(i % 5, i % 3, i % 17)));
  return rays;
}

/// Rays at random, and two bunches of rays, with limits and without.
void check_no_loss_alone_or_in_bundles(const scene::Scene& scene, Random& random) {
  std::vector<model::Rayo> rays;
  for (std::size_t i = 0; i < fewer_when_sanitized(300); ++i) rays.push_back(random_ray(random));
  check_no_loss(scene, rays);
  check_no_loss(scene, rays, 1);
  check_no_loss(scene, bunch({3, 2, 1}, {-3, -2, -1}, 0x1p-10));
  check_no_loss(scene, bunch({-3, 2, -1}, {3, -2, 1}, -0x1p-10), 1);
}

}  // namespace

TEST_CASE("each element lies in its box and in those of all nodes above it") {
  for (const std::size_t count : {0, 1, 2, 7, 8, 9, 63, 64, 65, 300}) {
    Random random(count);
    const scene::Scene scene = random_scene(random, count);
    const WideBvh tree(scene);
    CHECK(holds_all(tree));
    CHECK(tree.size().elements + tree.size().apart == count);
  }
  CHECK(holds_all(WideBvh(balls(fewer_when_sanitized(9000), 1))));
}

TEST_CASE("boxes are rounded outwards, and what has none in binary32 is kept apart") {
  scene::Scene scene;
  add(scene, scene::Sphere{{1 + 0x1p-40, -1 - 0x1p-40, 0x1p-60}, 0.1});
  add(scene, scene::Sphere{{0x1p100, -0x1p100, 0}, 0x1p-100});
  add(scene, scene::Sphere{{0x1p-100, 0, 0}, 0x1p-100});
  add(scene, scene::Triangle{{glm::dvec3{1, 2, 3}, glm::dvec3{-2, 0.5, 5}, glm::dvec3{0, -0.0, 2}}});  // exactly
  const ElementRef wide = add(scene, scene::Cone{{0, 0, 0}, 0x1p90, {0, 0, 1}, 0x1p90});
  const ElementRef plane = add(scene, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  const ElementRef huge = add(scene, scene::Sphere{{0, 0, 0}, 1e300});
  const WideBvh tree(scene);
  CHECK(holds_all(tree));
  CHECK(std::ranges::equal(tree.unbounded(), std::array{std::min(wide, plane), std::max(wide, plane)}));
  CHECK(std::ranges::equal(tree.extraordinary(), std::array{huge}));
}

TEST_CASE("elements at one place, in a row of growing distances, and all in a plane make a tree of some levels") {
  scene::Scene same, row, flat;
  for (std::size_t i = 0; i < fewer_when_sanitized(3000); ++i) {
    const auto x = static_cast<double>(i);
    add(same, scene::Sphere{{1, 2, 3}, 1});
    add(row, scene::Sphere{{std::ldexp(1.0, static_cast<int>(i % 100)), 0, 0}, 0x1p-90});
    add(flat, scene::Sphere{{x, std::fmod(x * x, 97), 0}, 0.1});
  }
  for (const scene::Scene* scene : {&same, &row, &flat}) {
    const WideBvh tree(*scene);
    CHECK(holds_all(tree));
    CHECK(tree.size().depth <= accel::most_levels);
  }
}

TEST_CASE("each triangle lies in its box, in a block of several or alone") {
  for (const std::size_t count : {1, 2, 7, 8, 9, 16, 17, 64, 65, 300}) {
    CHECK(holds_all(WideBvh(triangles(count, count))));
    CHECK(holds_all(WideBvh(triangles(count, count, 3))));
  }
  CHECK(holds_all(WideBvh(triangles(fewer_when_sanitized(9000), 6))));  // in parts, by several threads
  Random random(3);
  scene::Scene mixed = random_scene(random, 200);
  triangles(200, 4).for_each([&](ElementRef, const auto& shape) { add(mixed, shape); });
  const WideBvh tree(mixed);
  CHECK(holds_all(tree));
  CHECK_FALSE(tree.leaves().blocks().empty());
  CHECK(WideBvh(triangles(200, 5, 1)).leaves().blocks().empty());
}

TEST_CASE("a triangle of binary32 takes 60 bytes at most, in a tree of many") {
  CHECK(WideBvh(triangles(10000, 4)).size().bytes <= 600'000);
}

TEST_CASE("no ray loses a triangle that it meets, alone or in bundles, up to any limit") {
  Random random(6);
  check_no_loss_alone_or_in_bundles(triangles(300, 7, 5), random);
}

TEST_CASE("a tree does not depend on the number of threads") {
  const scene::Scene scene = balls(fewer_when_sanitized(20000), 3);
  const auto nodes = [&](int threads) {
    return on_threads(threads, [&] {
      const WideBvh tree(scene);
      std::vector<std::uint32_t> numbers;
      for (const WideNode& node : tree.nodes()) {
        for (const WideChild& child : node.children) numbers.insert(numbers.end(), {child.index, unsigned(child.kind)});
        for (const auto& plane : node.planes)
          for (const float x : plane) numbers.push_back(std::bit_cast<std::uint32_t>(x));
      }
      return numbers;
    });
  };
  CHECK(nodes(1) == nodes(2));
}

TEST_CASE("it takes 120 bytes an element at most") { CHECK(WideBvh(balls(10000, 4)).size().bytes <= 1'200'000); }

TEST_CASE("it takes 120 bytes an element at most, of a hundred thousand", "[long]") {
  CHECK(WideBvh(balls(100000, 4)).size().bytes <= 12'000'000);
}

TEST_CASE("no ray loses what it meets, alone or in bundles, up to any limit") {
  Random random(5);
  const scene::Scene scene = random_scene(random, 60);
  check_no_loss_alone_or_in_bundles(scene, random);
}

TEST_CASE("no ray loses what it only touches: poles, equators and rims, with zeros in its direction") {
  scene::Scene scene;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y) {
      add(scene, scene::Sphere{{x, y, 0.1 * x}, 0.5});
      add(scene, scene::Cylinder{{x, y, 3}, 0.5, {0, 0, 1}, 1});
    }
  std::vector<model::Rayo> rays;
  for (int x = -5; x <= 5; ++x)
    for (const double zero : {0.0, -0.0})
      for (const double sign : {1.0, -1.0}) {
        rays.push_back(ray({0.5 * x, -6 * sign, 0.1 * x}, {zero, sign, zero}));
        rays.push_back(ray({0.5 * x, -6 * sign, 3}, {zero, sign, zero}));
        rays.push_back(ray({-6 * sign, 0.5 * x, 4}, {sign, zero, zero}));
        rays.push_back(ray({0.5 * x, 0.5, -9 * sign}, {zero, zero, sign}));
        rays.push_back(ray({-6 * sign, 0.5 * x - 6, 3}, {sign, 1, zero}));
      }
  check_no_loss(scene, rays);
}

TEST_CASE("no ray loses what lies far away, or is tiny, or has numbers whose products leave binary32") {
  scene::Scene scene;
  for (const int e : {-100, -99, -60, -1, 0, 1, 60, 99}) {
    const double size = std::ldexp(1.0, e);
    add(scene, scene::Sphere{{size, size, size}, size / 2});
    add(scene, scene::Sphere{{-size, size, 0}, size / 2});
    add(scene, scene::Disc{{size, -size, 0}, size, {0, 1, 0}});
  }
  std::vector<model::Rayo> rays;
  for (const int from : {-100, -30, 0, 30, 100})
    for (const int speed : {-100, 0, 100})
      for (const int to : {-100, -99, -60, -1, 0, 1, 60, 99}) {
        const double p = std::ldexp(1.0, from), v = std::ldexp(1.0, speed), at = std::ldexp(1.0, to);
        const glm::dvec3 toward = glm::dvec3(at, at, at) - glm::dvec3(p, -p, 0);
        const double size = std::max({std::abs(toward.x), std::abs(toward.y), std::abs(toward.z)});
        rays.push_back(ray({p, -p, 0}, toward / size * std::min(v, 0x1p99)));
        rays.push_back(ray({0, 0, 0}, {-v, v, 0}));
        rays.push_back(ray({at, p, 0}, {0, -v, 0}));
      }
  std::vector<model::Rayo> ordinary;
  for (const model::Rayo& rayo : rays)
    if (trace::Ray(rayo).ordinary) ordinary.push_back(rayo);
  CHECK(ordinary.size() > rays.size() / 2);
  check_no_loss(scene, ordinary);
}

TEST_CASE("what lies beyond the limit is passed over, and counted") {
  const scene::Scene scene = balls(2000, 8);
  const WideBvh tree(scene);
  Random random(9);
  accel::Work work;
  std::size_t without_limit = 0;
  for (int i = 0; i < 100; ++i) {
    const trace::Ray along(ray(glm::dvec3(-20, 0, 0) + random.in_cube(5), {1, 0.01, 0.02}));
    without_limit += by_one(tree, along).size();
    CHECK(by_one(tree, along, 4).empty());
    double limit = infinity;
    tree.any(
        along, [&] { return limit; },
        [&](ElementRef) {
          limit = std::min(limit, 15.0);
          return false;
        },
        work);
  }
  CHECK(work.candidates > 0);
  CHECK(work.candidates < without_limit);
  CHECK(work.by_distance > 0);
  CHECK(work.by_miss > 0);
  CHECK(work.volumes == 8 * work.nodes);
}
