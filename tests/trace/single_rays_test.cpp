#include "durero/trace/single_rays.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/held_block.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using trace::SingleRays;
using trace::SingleSearch;

namespace {

constexpr std::uint32_t first_name = 160;  // of the block of each test

double single(double x) { return static_cast<double>(static_cast<float>(x)); }
glm::dvec3 single(const glm::dvec3& x) { return {single(x.x), single(x.y), single(x.z)}; }

/// Up to eight triangles, as a block and as a scene.
struct SomeTriangles {
  HeldBlock held;
  scene::Scene scene;

  void put(const scene::Triangle& triangle) {
    held.push_back(triangle, static_cast<std::uint32_t>(scene.size()));
    add(scene, triangle);
  }
  trace::TriangleBlock block() const { return held.view(); }
};

/// Triangles about a place, of some size, in a block that need not be full. Those of every other block are a strip.
SomeTriangles some_triangles(Random& random, const glm::dvec3& about, double size) {
  SomeTriangles some;
  const auto count = static_cast<std::size_t>(random.uniform(1, 9));
  const bool is_strip = random.uniform(0, 2) < 1;
  std::array<glm::dvec3, 3> vertices;
  const auto any = [&] { return single(about + random.in_cube(size)); };
  for (glm::dvec3& vertex : vertices) vertex = any();
  for (std::size_t lane = 0; lane < count; ++lane) {
    some.put({vertices});
    vertices = is_strip ? std::array{vertices[1], any(), vertices[2]} : std::array{any(), any(), any()};
  }
  return some;
}

/// A point of a triangle's plane: within the triangle, on an edge, at a vertex or outside.
glm::dvec3 aimed_at(Random& random, const scene::Triangle& triangle) {
  double b = random.uniform(0, 1), c = random.uniform(0, 1 - b);
  const auto kind = static_cast<int>(random.uniform(0, 6));
  if (kind > 3) b += 1, c -= 0.5;
  if (kind == 1) c = 0;
  if (kind == 2) b = 1, c = 0;
  const auto& [p, q, r] = triangle.vertices;
  return p + b * (q - p) + c * (r - p);
}

/// Whether a direction is within range.
bool in_range(const glm::dvec3& v) {
  return std::min({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) >= 1 / SingleRays::range;
}

/// Rays towards the triangles, from a place.
std::vector<scene::Query> rays_towards(Random& random, const SomeTriangles& some, const glm::dvec3& from, double size) {
  std::vector<scene::Query> queries;
  const auto& triangles = some.scene.shapes<scene::Triangle>();
  for (std::size_t i = 0; i < SingleRays::size; ++i) {
    const glm::dvec3 p = from + random.in_cube(size);
    const glm::dvec3 v = aimed_at(random, triangles[i % triangles.size()]) - p;
    if (in_range(v)) queries.push_back({ray(p, v)});
  }
  return queries;
}

/// The rays, rounded and open.
SingleRays opened(const std::vector<scene::Query>& queries, SingleSearch search) {
  SingleRays rays;
  for (const scene::Query& query : queries)
    rays.push(query.rayo.p().xyz(), query.rayo.v().xyz(),
              query.en.empty() ? SingleRays::none : first_name + query.en[0].index);
  REQUIRE(trace::round_to_single(rays));
  std::fill_n(rays.limit.begin(), rays.count, search == SingleSearch::any ? 1 : HUGE_VALF);
  return rays;
}

/// How many rays were answered with a hit, and without one.
struct Answered {
  std::size_t hits = 0, misses = 0, left = 0;
};

/// Each answer is that of exact arithmetic, and its bounds hold the exact parameter.
void check_nearest(const SomeTriangles& some, const std::vector<scene::Query>& queries, unsigned triangles,
                   Answered& answered) {
  SingleRays rays = opened(queries, SingleSearch::nearest);
  trace::screen(some.block(), first_name, triangles, rays.open, SingleSearch::nearest, rays);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if ((rays.left >> i & 1) != 0) {
      ++answered.left;
      continue;
    }
    const scene::Hit hit = surface::exact::first_hit(some.scene, queries[i].rayo, queries[i].en);
    const std::uint32_t found = rays.found(i);
    ++(found == SingleRays::none ? answered.misses : answered.hits);
    REQUIRE((hit.resultado == model::Resultado::hit) == (found != SingleRays::none));
    if (found == SingleRays::none) continue;
    REQUIRE(hit.elementos == scene::ElementSet{{model::Tipo::soy_triangulo, some.block().element(found - first_name)}});
    REQUIRE(static_cast<double>(rays.low[i]) <= hit.t);
    REQUIRE(hit.t <= static_cast<double>(rays.limit[i]));
  }
}

void check_any(const SomeTriangles& some, const std::vector<scene::Query>& queries, unsigned triangles,
               Answered& answered) {
  SingleRays rays = opened(queries, SingleSearch::any);
  trace::screen(some.block(), first_name, triangles, rays.open, SingleSearch::any, rays);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if ((rays.left >> i & 1) != 0) {
      ++answered.left;
      continue;
    }
    ++(rays.meets(i) ? answered.hits : answered.misses);
    REQUIRE(rays.meets(i) == surface::exact::occluded_segment(some.scene, queries[i].rayo, queries[i].en));
  }
}

}  // namespace

TEST_CASE("a ray is rounded in two parts, and rays out of range are refused") {
  Random random(1);
  SingleRays rays;
  std::vector<glm::dvec3> from;
  for (int i = 0; i < 13; ++i) {
    from.push_back(random.in_cube(1000));
    rays.push(from.back(), random.direction(), SingleRays::none);
  }
  REQUIRE(trace::round_to_single(rays));
  CHECK(rays.open == (std::uint64_t{1} << 13) - 1);
  for (std::size_t i = 0; i < 13; ++i) {
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double p = from[i][static_cast<int>(axis)];
      const double parts = static_cast<double>(rays.p[axis][i]) + static_cast<double>(rays.rest[axis][i]);
      CHECK(std::abs(parts - p) <= 0x1p-48 * std::abs(p));
      CHECK(std::abs(static_cast<double>(rays.p[axis][i]) - p) <= 0x1p-24 * std::abs(p));
      size += std::abs(p);
    }
    CHECK(static_cast<double>(rays.slack[i]) > 7.9 * 0x1p-24 * size);
    CHECK(rays.limit[i] < 0);
    CHECK(rays.found(i) == SingleRays::none);
  }
  const auto fits = [](const glm::dvec3& p, const glm::dvec3& v) {
    SingleRays one;
    one.push(p, v, SingleRays::none);
    return trace::round_to_single(one);
  };
  CHECK(fits({1, 1, 1}, {0x1p-30, 1, -1}));
  CHECK_FALSE(fits({1, 1, 1}, {0x1p-31, 1, -1}));
  CHECK(fits({1, 1, 1}, {1, 0, -0.0}));
  CHECK_FALSE(fits({1, 1, 1}, {1, -0x1p31, 1}));
  CHECK_FALSE(fits({-0x1p31, 1, 1}, {1, 1, 1}));
  CHECK(fits({1e-300, 0, 0x1p29}, {1, 1, 1}));
}

TEST_CASE("rays are closed once, and belong to the set that closed them") {
  SingleRays rays;
  for (int i = 0; i < 10; ++i) rays.push({1, 1, 1}, {1, 1, 1}, SingleRays::none);
  REQUIRE(trace::round_to_single(rays));
  rays.close(0b1011, rays.hit);
  rays.close(0b110000000110, rays.left);
  CHECK(rays.hit == 0b1011);
  CHECK(rays.left == 0b100);
  CHECK(rays.open == 0b1111110000);
  CHECK(rays.meets(3));
  CHECK_FALSE(rays.meets(2));
}

TEST_CASE("the test of triangles in binary32 says what exact arithmetic says, at every scale, or hands the ray back") {
  Random random(2);
  for (const double scale : {1.0, 1e-4, 0x1p26}) {
    Answered nearest, any;
    for (int turn = 0; turn < 120; ++turn) {
      const double size = scale * (turn % 3 == 0 ? 1 : turn % 3 == 1 ? 0.01 : 1e-4);
      const glm::dvec3 about = scale * random.in_cube(2);
      const SomeTriangles some = some_triangles(random, about, size);
      const glm::dvec3 from = about + (turn % 2 == 0 ? size : scale) * 3.0 * random.direction();
      std::vector<scene::Query> queries = rays_towards(random, some, from, turn % 5 == 0 ? 0 : size);
      // Many rays take the triangles one after another, and few take them side by side.
      if (turn % 4 == 0) queries.erase(queries.begin() + 3, queries.end());
      const unsigned triangles = turn % 4 == 1 ? some.block().lanes() : 0xff;
      check_nearest(some, queries, triangles, nearest);
      check_any(some, queries, triangles, any);
    }
    CAPTURE(scale, nearest.hits, nearest.misses, nearest.left, any.hits, any.misses, any.left);
    CHECK(nearest.hits > 400);
    CHECK(nearest.misses > 100);
    CHECK(any.hits > 100);
    CHECK(any.misses > 100);
    CHECK(nearest.left < nearest.hits + nearest.misses);
  }
}

TEST_CASE("rays that start next to a vertex have their answers, though their origins' distance is lost in binary32") {
  Random random(6);
  Answered nearest, any;
  for (int turn = 0; turn < 100; ++turn) {
    SomeTriangles some;
    const glm::dvec3 a = single(random.in_cube(1) + 2.0);
    some.put({std::array{a, single(a + random.direction()), single(a + random.direction())}});
    std::vector<scene::Query> queries;
    for (std::size_t i = 0; i < SingleRays::size; ++i) {
      const glm::dvec3 p = a + 1e-9 * random.in_cube(1), v = a + 2e-9 * random.in_cube(1) - p;
      if (in_range(1e9 * v)) queries.push_back({ray(p, 1e9 * v)});
    }
    check_nearest(some, queries, 0xff, nearest);
    check_any(some, queries, 0xff, any);
  }
  CHECK(nearest.hits > 50);
}

TEST_CASE("rays along a triangle's plane, and beside it, are handed back or missed") {
  Random random(3);
  Answered nearest, any;
  for (int turn = 0; turn < 60; ++turn) {
    SomeTriangles some = some_triangles(random, {0.5, 0.25, 1}, 1);
    std::vector<scene::Query> queries;
    const auto& triangles = some.scene.shapes<scene::Triangle>();
    for (std::size_t i = 0; i < SingleRays::size; ++i) {
      const auto& [a, b, c] = triangles[i % triangles.size()].vertices;
      const glm::dvec3 p = a - 2.0 * (b - a), beside = i % 3 == 0 ? 1e-9 * random.direction() : glm::dvec3(0);
      const glm::dvec3 v = b - a + (i % 2 == 0 ? 0.5 : 0.0) * (c - a);
      if (in_range(v)) queries.push_back({ray(p + beside, v)});
    }
    check_nearest(some, queries, 0xff, nearest);
    check_any(some, queries, 0xff, any);
  }
  CHECK(nearest.left > 100);
}

TEST_CASE("a ray does not meet the triangle that it starts on, and must be seen to cross its plane") {
  Random random(4);
  Answered nearest, any;
  std::size_t crossed = 0;
  for (int turn = 0; turn < 100; ++turn) {
    SomeTriangles some;  // lanes and rows are the same here
    for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane)
      some.put({{single(random.in_cube(1)), single(random.in_cube(1)), single(random.in_cube(1))}});
    std::vector<scene::Query> queries;
    for (std::uint32_t i = 0; i < (turn % 3 == 0 ? 4 : SingleRays::size); ++i) {
      const scene::ElementRef start{model::Tipo::soy_triangulo, i % 8};
      const scene::Triangle triangle = some.scene.shapes<scene::Triangle>()[start.index];
      const auto& [a, b, c] = triangle.vertices;
      const glm::dvec3 v = i % 16 == 5 ? b - a : random.direction();
      queries.push_back({ray((a + b + c) / 3.0, v), {start}});
    }
    const SingleRays rays = [&] {
      SingleRays some_rays = opened(queries, SingleSearch::nearest);
      trace::screen(some.block(), first_name, 0xff, some_rays.open, SingleSearch::nearest, some_rays);
      return some_rays;
    }();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (i % 16 == 5) CHECK_FALSE((rays.crossed >> i & 1) != 0);
      crossed += rays.crossed >> i & 1;
    }
    std::vector<scene::Query> crossing;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if ((rays.crossed >> i & 1) != 0) crossing.push_back(queries[i]);
    if (crossing.empty()) continue;
    check_nearest(some, crossing, 0xff, nearest);
    check_any(some, crossing, 0xff, any);
  }
  CHECK(crossed > 1000);
  CHECK(nearest.hits > 100);
}

TEST_CASE("a ray that starts on a triangle alone and leaves it is answered, in rows and in columns") {
  Random random(12);
  for (const std::size_t count : {1, 64}) {
    SomeTriangles some;
    some.put({std::array{single({-0.3, -0.7, 0.1}), single({0.9, -0.2, 0.3}), single({0.1, 0.8, -0.2})}});
    const auto& [a, b, c] = some.scene.shapes<scene::Triangle>()[0].vertices;
    const glm::dvec3 across = glm::cross(b - a, c - a);
    std::vector<scene::Query> queries;
    for (std::size_t i = 0; i < count; ++i)
      queries.push_back({ray((a + b + c) / 3.0, across + 0.3 * random.direction()), {{model::Tipo::soy_triangulo, 0}}});
    Answered nearest, any;
    check_nearest(some, queries, 1, nearest);
    check_any(some, queries, 1, any);
    CHECK(nearest.misses == count);
    CHECK(any.misses == count);
  }
}

TEST_CASE("the nearest of several blocks is kept, and two hits that are not told apart are handed back") {
  SomeTriangles near, far;
  const auto triangle = [](double z) {
    return scene::Triangle{std::array{glm::dvec3(-4, -4, z), glm::dvec3(4, -4, z), glm::dvec3(0, 4, z)}};
  };
  near.put(triangle(2));
  far.put(triangle(8));
  far.put(triangle(9));
  for (const std::size_t count : {2, 40})
    for (const bool near_first : {false, true}) {
      std::vector<scene::Query> queries(count, {ray({0.1, 0.1, 0.1}, {0.01, 0.02, 1})});
      SingleRays rays = opened(queries, SingleSearch::nearest);
      const auto test = [&](const SomeTriangles& some, std::uint32_t name) {
        trace::screen(some.block(), name, some.block().lanes(), rays.open, SingleSearch::nearest, rays);
      };
      if (near_first) test(near, 80);
      test(far, 160);
      CHECK(rays.found(count - 1) == (near_first ? 80 : 160));
      if (!near_first) test(near, 80);
      CHECK(rays.left == 0);
      for (std::size_t i = 0; i < count; ++i) CHECK(rays.found(i) == 80);
      test(near, 240);  // the same triangle once more, at the same t
      CHECK(rays.left == rays.open + rays.left);
      CHECK(rays.open == 0);
    }
}

TEST_CASE("a segment that ends on a triangle, or starts there unannounced, does not meet it") {
  SomeTriangles some;
  some.put({std::array{glm::dvec3(-4, -4, 2), glm::dvec3(4, -4, 2), glm::dvec3(0, 4, 2)}});
  const std::vector<scene::Query> queries{{ray({0.5, 0.5, 1}, {0.25, 0.25, 1})},
                                          {ray({0.5, 0.5, 2}, {0.25, 0.25, 1})},
                                          {ray({0.5, 0.5, 1}, {0.25, 0.25, 1.5})},
                                          {ray({0.5, 0.5, 1}, {0.25, 0.25, 0.75})},
                                          {ray({0.5, 0.5, 1}, {0.25, 0.25, -1})}};
  Answered answered;
  check_any(some, queries, 0xff, answered);
  CHECK(answered.hits == 1);
  CHECK(answered.misses >= 2);
  // The parameter is less than 1 by less than binary64 tells.
  const std::vector<scene::Query> nearly{{ray({0.3, 0.1, -1}, {0.1, 0.2, 3 * (1 + 0x1p-52)})}};
  REQUIRE(surface::exact::occluded_segment(some.scene, nearly[0].rayo));
  check_any(some, nearly, 0xff, answered);
}

TEST_CASE("what a ray may meet in a block has all that it meets up to the limit, and no empty lane") {
  Random random(9);
  std::size_t hits = 0, possible = 0, beyond = 0;
  for (int turn = 0; turn < 300; ++turn) {
    const double scale = turn % 3 == 0 ? 0x1p26 : 1;
    const SomeTriangles some = some_triangles(random, scale * random.in_cube(2), turn % 2 == 0 ? scale : 0.01 * scale);
    for (const scene::Query& query : rays_towards(random, some, scale * random.in_cube(4), scale)) {
      const trace::Ray traced(query.rayo);
      REQUIRE(trace::in_single_range(traced));
      const unsigned lanes = trace::possible_hits(traced, some.block(), trace::no_limit);
      REQUIRE((lanes & ~some.block().lanes()) == 0);
      for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane) {
        possible += lanes >> lane & 1;
        if (!some.block().has(lane)) continue;
        const scene::ElementRef e{model::Tipo::soy_triangulo, some.block().element(lane)};
        const surface::exact::Reach reach = surface::exact::reach(some.scene, e, query.rayo);
        if (reach.empty()) continue;
        const double t = surface::exact::rounded_hit(query.rayo, reach.first(), {e}).t;
        ++hits;
        REQUIRE((lanes >> lane & 1) != 0);
        REQUIRE((trace::possible_hits(traced, some.block(), t) >> lane & 1) != 0);
        beyond += (trace::possible_hits(traced, some.block(), 0.99 * t) >> lane & 1) == 0;
      }
    }
  }
  CHECK(hits > 1000);
  CHECK(possible < 2 * hits);
  CHECK(beyond > hits / 2);
}

TEST_CASE("the test in binary32 serves rays within range, with components 0 as well") {
  const auto serves = [](const glm::dvec3& p, const glm::dvec3& v) {
    return trace::in_single_range(trace::Ray(ray(p, v)));
  };
  CHECK(serves({0, 1e-300, 0x1p30}, {0, 0x1p-30, -0x1p30}));
  CHECK_FALSE(serves({0, 0, 0}, {0, 0x1p-31, 1}));
  CHECK_FALSE(serves({0, 0, 0}, {0, 0x1p31, 1}));
  CHECK_FALSE(serves({0, -0x1p31, 0}, {0, 1, 1}));
}
