// Streams of rays find what each of their rays finds alone.
#include "durero/accel/wide/stream_traversal.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>
#include <utility>

#include "accel/each_alone.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::StreamRay;
using accel::WideNode;

namespace {

constexpr double infinity = trace::no_limit;

scene::Scene some_spheres(std::size_t count) {
  Random random(11);
  scene::Scene scene;
  for (std::size_t i = 0; i < count; ++i) add(scene, scene::Sphere{random.in_cube(1), random.uniform(0.01, 0.1)});
  return scene;
}

/// Rays into one octant; every fourth one along a plane of its axes, every third one with an end.
std::vector<StreamRay> stream_into(Random& random, unsigned octant, std::size_t count) {
  std::vector<StreamRay> rays;
  for (std::uint32_t i = 0; i < count; ++i) {
    glm::dvec3 v = glm::abs(random.direction());
    if (i % 4 == 0) v[static_cast<int>(i / 4 % 3)] = 0;
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::copysign(v[axis], (octant >> axis & 1) != 0 ? -1.0 : 1.0);
    const accel::Beam beam{trace::Ray(ray(random.in_cube(1.5), v))};
    rays.push_back({beam, i % 3 == 0 ? random.uniform(0, 2) : infinity, i});
  }
  return rays;
}

surface::Box box_of(const WideNode& node, std::size_t place) {
  surface::Box box{};
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[static_cast<int>(i)] = static_cast<double>(node.planes[i][place]);
    box.high[static_cast<int>(i)] = static_cast<double>(node.planes[i + 3][place]);
  }
  return box;
}

using Pairs = std::multiset<std::pair<std::uint32_t, scene::ElementRef>>;

/// What each ray comes to alone.
Pairs alone(std::span<const WideNode> nodes, std::span<const StreamRay> rays, std::span<const trace::Ray> whole) {
  Pairs pairs;
  for (const StreamRay& ray : rays) {
    accel::SingleRayTraversal walker(whole[ray.number]);
    while (walker.advance(nodes.data(), trace::TriangleBlocks({}), ray.limit) != accel::SingleRayTraversal::Next::end)
      pairs.emplace(ray.number, walker.element);
  }
  return pairs;
}

}  // namespace

TEST_CASE("a stream meets the boxes that its rays meet, and enters them where they do") {
  Random random(12);
  const scene::Scene scene = some_spheres(200);
  const accel::WideBvh tree(scene);
  accel::StreamPairs met;
  for (unsigned octant = 0; octant < 8; ++octant) {
    const std::vector<StreamRay> rays = stream_into(random, octant, 40);
    std::vector<std::uint32_t> some;
    for (std::uint32_t i = 0; i < rays.size(); i += 1 + i % 2) some.push_back(i);
    for (const WideNode& node : tree.nodes()) {
      accel::meet(node, rays, some, met);
      std::set<std::pair<std::uint32_t, std::size_t>> found, expected;
      for (std::size_t i = 0; i < met.size; ++i) {
        const std::uint32_t ray = accel::StreamPairs::ray(met.whose[i]);
        const std::size_t place = accel::StreamPairs::place(met.whose[i]);
        CHECK(found.emplace(ray, place).second);
        CHECK(met.entries[i] == stretch(box_of(node, place), rays[ray].beam, rays[ray].limit).entry);
      }
      for (const std::uint32_t ray : some)
        for (std::size_t place = 0; place < WideNode::width; ++place)
          if (stretch(box_of(node, place), rays[ray].beam, rays[ray].limit).meets()) expected.emplace(ray, place);
      CHECK(found == expected);
      for (std::size_t place = 0; place < WideNode::width; ++place) {
        std::size_t count = 0;
        double soonest = trace::no_limit;
        for (std::size_t i = 0; i < met.size; ++i) {
          if (accel::StreamPairs::place(met.whose[i]) != place) continue;
          ++count;
          soonest = std::min(soonest, met.entries[i]);
        }
        CHECK(met.count[place] == count);
        CHECK(met.soonest[place] == soonest);
      }
    }
  }
  accel::meet(tree.nodes()[0], {}, {}, met);
  CHECK(met.size == 0);
  CHECK(met.count == decltype(met.count){});
}

TEST_CASE("a stream comes to the elements that its rays come to alone, each once") {
  Random random(13);
  const scene::Scene scene = some_spheres(300);
  const accel::WideBvh tree(scene);
  for (unsigned octant = 0; octant < 8; ++octant) {
    std::vector<trace::Ray> whole;
    std::vector<StreamRay> rays;
    for (std::uint32_t i = 0; i < 100; ++i) {
      glm::dvec3 v = random.direction();
      for (int axis = 0; axis < 3; ++axis) v[axis] = std::copysign(v[axis], (octant >> axis & 1) != 0 ? -1.0 : 1.0);
      whole.emplace_back(ray(random.in_cube(1.5), v));
      rays.push_back({accel::Beam(whole.back()), i % 3 == 0 ? 0.5 : infinity, i});
    }
    const Pairs expected = alone(tree.nodes(), rays, whole);
    Pairs found;
    const auto limit = [&](std::uint32_t number) { return number % 3 == 0 ? 0.5 : infinity; };
    const auto take = [&](std::uint32_t number, scene::ElementRef e) { found.emplace(number, e); };
    accel::StreamTraversal stream(tree.nodes(), tree.leaves().blocks(), limit, take);
    stream.walk(rays);
    CHECK(found == expected);
    stream.walk({});
    CHECK(found == expected);
  }
}

TEST_CASE("many rays into all directions get the answers that each gets alone") {
  const scene::Scene scene = some_spheres(300);
  const accel::WideBvh tree(scene);
  Random random(14);
  std::vector<scene::Query> queries;
  trace::Counts unseen;
  for (std::size_t i = 0; i < 2000; ++i) {
    queries.push_back({{model::Punto(random.in_cube(1.5)), model::Vector(random.direction())}});
    const scene::Hit hit = trace::first_hit_among(tree, queries.back().rayo, {}, unseen);
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
  }
  check_each_alone(tree, queries);
}
