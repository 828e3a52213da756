// Large trees answer many segments in an order of their own: each answer must stand where its question does.
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "accel/each_alone.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using trace::QueryKind;

namespace {

scene::Scene many_spheres(std::size_t count) {
  Random random(7);
  scene::Scene scene;
  for (std::size_t i = 0; i < count; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.01});
  return scene;
}

std::vector<scene::Query> queries_from(Random& random, std::size_t count, double apart) {
  std::vector<scene::Query> queries;
  for (std::size_t i = 0; i < count; ++i)
    queries.push_back({{model::Punto(random.in_cube(apart)), model::Vector(random.direction())}});
  return queries;
}

}  // namespace

TEST_CASE("every ray is in the order once, where the tree is large and the rays are many and from many points") {
  const scene::Scene scene = many_spheres(30000);
  const scene::Scene few = many_spheres(100);
  const accel::WideBvh tree(scene), small(few);
  Random random(8);
  const std::vector<scene::Query> queries = queries_from(random, 3000, 1.5);
  std::vector<std::uint32_t> order = tree.order(queries, QueryKind::segment), all(queries.size());
  CHECK(!std::ranges::is_sorted(order));
  std::ranges::sort(order);
  std::iota(all.begin(), all.end(), 0);
  CHECK(order == all);
  CHECK(tree.order(queries, QueryKind::first).empty());
  CHECK(small.order(queries, QueryKind::segment).empty());
  CHECK(tree.order(queries_from(random, 100, 1.5), QueryKind::segment).empty());
  CHECK(tree.order(queries_from(random, 3000, 0), QueryKind::segment).empty());
  CHECK(tree.order({}, QueryKind::segment).empty());
}

TEST_CASE("many rays are sorted in parts, stably, whatever the number of threads") {
  const scene::Scene scene = many_spheres(30000);
  const accel::WideBvh tree(scene);
  const accel::RayOrderKey key_of(tree.nodes().front(), tree.spacing());
  Random random(10);
  const std::vector<scene::Query> queries = queries_from(random, 300000, 1.5);
  const auto ordered = [&](std::size_t threads) {
    const oneapi::tbb::global_control some(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    return tree.order(queries, QueryKind::segment);
  };
  const std::vector<std::uint32_t> order = ordered(1);
  REQUIRE(order.size() == queries.size());
  CHECK(std::ranges::is_sorted(order, {}, [&](std::uint32_t i) {
    return std::pair(key_of(queries[i].rayo.p().xyz(), queries[i].rayo.v().xyz()), i);
  }));
  for (const std::size_t threads : {2, 3}) CHECK(ordered(threads) == order);
}

TEST_CASE("answers of a large tree are those one by one, each in its place") {
  const scene::Scene scene = many_spheres(200000);
  const accel::WideBvh tree(scene);
  Random random(9);
  std::vector<scene::Query> queries = queries_from(random, 3000, 1.5);
  trace::Counts unseen;
  for (std::size_t i = 0; i < 500; ++i) {
    const scene::Hit hit = trace::first_hit_among(tree, queries[i].rayo, {}, unseen);
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
  }
  for (const QueryKind asked : {QueryKind::first, QueryKind::segment}) REQUIRE(!tree.order(queries, asked).empty());
  check_each_alone(tree, queries);
}
