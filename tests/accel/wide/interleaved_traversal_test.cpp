#include "durero/accel/wide/interleaved_traversal.hpp"

#include <map>
#include <numeric>
#include <set>

#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

scene::Scene some_spheres(Random& random) {
  scene::Scene scene;
  for (int i = 0; i < 400; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.1});
  return scene;
}

trace::Ray some_ray(Random& random) {
  const glm::dvec3 p = random.in_cube(1);
  const glm::dvec3 v = random.direction();
  return trace::Ray(ray(p, v));
}

}  // namespace

TEST_CASE(
    "rays that walk in turns take what each takes alone, nearest first and nothing twice, however many there are") {
  Random random(1);
  const scene::Scene scene = some_spheres(random);
  const accel::WideBvh tree(scene);
  std::vector<trace::Ray> rays;
  std::vector<double> limits;
  for (int i = 0; i < 300; ++i) {
    rays.push_back(some_ray(random));
    limits.push_back(i % 4 == 0 ? trace::no_limit : random.uniform(0, 1));
  }
  for (const std::size_t count : {0, 1, 2, 23, 24, 25, 49, 300}) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.rbegin(), numbers.rend(), 300 - static_cast<std::uint32_t>(count));
    std::map<std::uint32_t, std::vector<scene::ElementRef>> taken;
    const auto limit = [&](std::uint32_t number) { return limits[number]; };
    const auto take = [&](std::uint32_t number, scene::ElementRef leaf) { taken[number].push_back(leaf); };
    accel::InterleavedTraversal(tree.nodes(), tree.leaves(), rays, limit, take).walk(numbers);
    std::size_t some = 0;
    for (const std::uint32_t number : numbers) {
      accel::SingleRayTraversal walker(rays[number]);
      std::vector<scene::ElementRef> alone;
      while (walker.advance(tree.nodes().data(), tree.leaves().blocks(), limits[number]) !=
             accel::SingleRayTraversal::Next::end)
        alone.push_back(walker.element);
      some += alone.size();
      CHECK(taken[number] == alone);
      taken.erase(number);
    }
    CHECK(taken.empty());
    if (count > 20) CHECK(some > count / 2);
  }
}

TEST_CASE("a ray goes on by its limit as it is in each turn") {
  Random random(2);
  const scene::Scene scene = some_spheres(random);
  const accel::WideBvh tree(scene);
  std::vector<trace::Ray> rays;
  for (int i = 0; i < 100; ++i) rays.push_back(some_ray(random));
  std::vector<std::uint32_t> numbers(rays.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::vector<double> limits(rays.size(), trace::no_limit);
  std::vector<std::size_t> taken(rays.size());
  const auto limit = [&](std::uint32_t number) { return limits[number]; };
  const auto take = [&](std::uint32_t number, scene::ElementRef) {
    ++taken[number];
    limits[number] = 0;  // so that only boxes about the origin are left
  };
  accel::InterleavedTraversal(tree.nodes(), tree.leaves(), rays, limit, take).walk(numbers);
  std::size_t boxes = 0, rays_with_some = 0;
  for (const std::uint32_t number : numbers) {
    accel::SingleRayTraversal about(rays[number]), whole(rays[number]);
    std::set<scene::ElementRef> expected;
    while (about.advance(tree.nodes().data(), tree.leaves().blocks(), 0) != accel::SingleRayTraversal::Next::end)
      expected.insert(about.element);
    boxes += expected.size();
    if (whole.advance(tree.nodes().data(), tree.leaves().blocks(), trace::no_limit) !=
        accel::SingleRayTraversal::Next::end) {
      expected.insert(whole.element);
      ++rays_with_some;
    }
    CHECK(taken[number] == expected.size());
  }
  CHECK(boxes > 0);
  CHECK(rays_with_some > boxes);
}
