#include "durero/accel/wide/wide_traversal.hpp"

#include <map>

#include "accel/each_alone.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("a walk takes of each ray, bundled or not, nothing twice, and nothing of one whose limit is 0") {
  Random random(1);
  scene::Scene scene;
  for (int i = 0; i < 300; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.05});
  const accel::WideBvh tree(scene);
  for (const double apart : {0.0, 1e-3, 1e-1, 3.0}) {
    std::vector<trace::Ray> rays;
    for (int i = 0; i < 256; ++i) {
      const glm::dvec3 from = glm::dvec3(0.1, 0.2, -3) + random.in_cube(apart);
      rays.emplace_back(ray(from, glm::dvec3(0.01, 0.02, 1) + random.in_cube(apart / 3)));
    }
    std::map<std::uint32_t, std::size_t> taken;
    const auto limit = [](std::uint32_t number) { return number % 5 == 0 ? 0.0 : trace::no_limit; };
    tree.pairs(
        rays, limit, [&](std::uint32_t number, scene::ElementRef) { ++taken[number]; }, [] {});
    for (std::uint32_t number = 0; number < rays.size(); ++number) {
      std::size_t alone = 0;
      tree.any(
          rays[number], [] { return trace::no_limit; },
          [&](scene::ElementRef) {
            ++alone;
            return false;
          });
      CHECK(taken[number] == (number % 5 == 0 ? 0 : alone));
    }
  }
}

TEST_CASE("rays that walk together, and segments from where they hit, are answered as each alone") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 60);
    const accel::WideBvh tree(scene);
    std::vector<scene::Query> queries;
    const glm::dvec3 eye(-0.3, -0.3, -6);  // every direction is of one sign along each axis
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) queries.push_back({ray(eye, glm::dvec3(x + 0.5, y + 0.5, 240) / 240.0)});
    trace::Counts unseen;
    std::size_t hits = 0;
    for (std::size_t i = 0; i < 24 * 24; ++i) {
      const scene::Hit hit = trace::first_hit_among(tree, queries[i].rayo, {}, unseen);
      if (hit.resultado != model::Resultado::hit) continue;
      ++hits;
      queries.push_back({ray(hit.punto, glm::dvec3(1, 9, -4) - hit.punto), hit.elementos});
    }
    CHECK(hits > 50);
    check_each_alone(tree, queries);
  }
}
