#include "durero/accel/wide/packet_traversal.hpp"

#include <bit>
#include <set>

#include "accel/each_alone.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

using Pair = std::pair<std::uint32_t, scene::ElementRef>;

/// Closes a ray at an element where a rule says so.
template <class Closes>
struct Closing {
  static constexpr bool any_hit = true;
  std::set<Pair>& taken;
  std::vector<bool>& open;
  Closes closes;

  static bool starts() { return false; }
  void operator()(std::uint32_t number, scene::ElementRef own) const {
    if (!open[number]) return;
    CHECK(taken.emplace(number, own).second);
    if (closes(number, own)) open[number] = false;
  }
  template <class Numbers>
  std::uint64_t operator()(const trace::RayColumns& rays, const Numbers& numbers, std::uint64_t which,
                           scene::ElementRef own) const {
    std::uint64_t closed = 0;
    for (std::size_t place = 0; place < trace::RayColumns::size; ++place) {
      if ((which >> place & 1) == 0) continue;
      CHECK(open[numbers[place]]);
      CHECK(rays.speed[place] > 0);
      (*this)(numbers[place], own);
      closed |= std::uint64_t{!open[numbers[place]]} << place;
    }
    return closed;
  }
};

/// From about some points, each for a while, towards one.
std::vector<trace::Ray> towards_one_point(Random& random, std::size_t count, double apart) {
  std::vector<trace::Ray> rays;
  glm::dvec3 about{};
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 37 == 0) about = random.in_cube(1);
    const glm::dvec3 from = about + random.in_cube(apart);
    rays.emplace_back(ray(from, glm::dvec3(3, 9, -4) - from));
  }
  return rays;
}

}  // namespace

TEST_CASE("of rays that any hit decides, each takes all that it may meet, once, until it is closed") {
  Random random(3);
  for (const int elements : {1, 9, 60, 700}) {
    scene::Scene scene;
    for (int i = 0; i < elements; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.6 / std::cbrt(elements)});
    const accel::WideBvh tree(scene);
    for (const double apart : {0.0, 0.02, 0.3}) {
      for (const std::uint32_t one_in : {1u, 3u, 40u}) {
        const std::vector<trace::Ray> rays = towards_one_point(random, 500, apart);
        std::set<Pair> taken;
        std::vector<bool> open(rays.size(), true);
        const auto closes = [&](std::uint32_t number, scene::ElementRef own) {
          return (number + 7 * own.index) % one_in == 0;
        };
        tree.pairs(
            rays, [&](std::uint32_t number) { return open[number] ? 1.0 : 0.0; }, Closing{taken, open, closes}, [] {});
        for (std::uint32_t number = 0; number < rays.size(); ++number) {
          if (!open[number]) continue;
          tree.any(
              rays[number], [] { return 1.0; },
              [&](scene::ElementRef e) {
                bool found = false;
                for (std::uint32_t leaf = 0; leaf < scene.size(); ++leaf)
                  found |= taken.contains({number, {e.tipo, leaf}}) && tree.element({e.tipo, leaf}) == e;
                CHECK(found);
                return false;
              });
        }
      }
    }
  }
}

TEST_CASE("what rays of a bundle start on is met by its other point alone, far as their origins may lie from it") {
  for (const int others : {0, 20}) {  // few elements are tested against every ray, and many are come to in a tree
    scene::Scene scene;
    const scene::ElementRef cylinder = add(scene, scene::Cylinder{{-5, 0, 0}, 1, {1, 0, 0}, 10});
    for (int i = 0; i < others; ++i) add(scene, scene::Cylinder{{-5, 100.0 + 3 * i, 0}, 1, {1, 0, 0}, 10});
    const accel::WideBvh tree(scene);
    REQUIRE(trace::RayColumns::number(tree.own(cylinder)) > 0);  // no column of zeros says that they start on it
    std::vector<scene::Query> queries;  // as starts, met again at t = 1.5; if the origin lay on nothing, at 0.25
    for (int i = 0; i < 20; ++i) queries.push_back({ray({1e-3 * i, 0.01, -1.5}, {0.01, 0.01, 2}), {cylinder}});
    check_each_alone(tree, queries);
  }
}

TEST_CASE("of few elements each is tested against each ray, and all pairs are counted") {
  scene::Scene scene;
  for (int i = 0; i < 3; ++i) add(scene, scene::Sphere{{2.5 * i, 0, 0}, 1});
  const accel::WideBvh tree(scene);
  std::vector<scene::Query> queries;
  for (int i = 0; i < 100; ++i) queries.push_back({ray({0.009 * i, 0.02, -5}, {0.001, 0.002, 1}), {}});
  std::vector<scene::Hit> hits(queries.size());
  trace::Counts counts;
  trace::first_hits_among(tree, queries, hits, &counts);
  CHECK(counts.element[0] == 3 * queries.size());
}

namespace {

/// What is taken of rays in columns, and alone.
struct Counting {
  std::uint64_t &together, &alone;

  static bool starts() { return false; }
  void operator()(std::uint32_t, scene::ElementRef) const { ++alone; }
  template <class Numbers>
  std::uint64_t operator()(const trace::RayColumns&, const Numbers&, std::uint64_t which, scene::ElementRef) const {
    together += static_cast<std::uint64_t>(std::popcount(which));
    return 0;
  }
};

}  // namespace

TEST_CASE("rays that stay together are bundled and others are not, and either way all come to what they may meet") {
  Random random(21);
  scene::Scene scene;
  for (int i = 0; i < 300; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.15});
  const accel::WideBvh tree(scene);
  const auto no_limit = [](std::uint32_t) { return trace::no_limit; };
  enum class Kind { close, scattered, opposed };  // of what is opposed, no ray asked may walk with the next
  for (const Kind kind : {Kind::close, Kind::scattered, Kind::opposed}) {
    CAPTURE(static_cast<int>(kind));
    const bool close = kind == Kind::close;
    std::vector<trace::Ray> rays;
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 v = close ? glm::dvec3(0.1 + 1e-5 * i, 0.2, 1) : random.direction();
      const double side = kind == Kind::opposed && (v.x > 0) == (i % 2 == 0) ? -1 : 1;
      rays.emplace_back(close ? ray({0, 0, -3}, v) : ray(random.in_cube(1), v * side));
    }
    std::uint64_t together = 0, alone = 0, expected = 0;
    tree.pairs(rays, no_limit, Counting{together, alone}, [] {});
    for (const trace::Ray& each : rays)
      tree.any(
          each, [] { return trace::no_limit; }, [&](scene::ElementRef) { return ++expected, false; });
    CHECK(together + alone == expected);
    CHECK((together > 0) == close);
  }
}

TEST_CASE("company is looked for where a quarter of the rays may walk with the next") {
  Random random(22);
  scene::Scene scene;
  for (int i = 0; i < 300; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.15});
  const accel::WideBvh tree(scene);
  const auto together_of = [&](int in_a_row) {  // of every forty, so many are close
    std::vector<trace::Ray> rays;
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec3 p = random.in_cube(1), v = random.direction();
      rays.emplace_back(i % 40 < in_a_row ? ray({0, 0, -3}, {0.1 + 1e-5 * i, 0.2, 1}) : ray(p, v));
    }
    std::uint64_t together = 0, alone = 0;
    tree.pairs(
        rays, [](std::uint32_t) { return trace::no_limit; }, Counting{together, alone}, [] {});
    return together;
  };
  CHECK(together_of(7) == 0);
  CHECK(together_of(20) > 0);
}

TEST_CASE("in a tree of one node every open ray is tested in columns, against its elements and those without a box") {
  Random random(5);
  scene::Scene scene;
  add(scene, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  for (int i = 0; i < 5; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.15});
  const accel::WideBvh tree(scene);
  REQUIRE(tree.nodes().size() == 1);
  std::vector<trace::Ray> rays;
  for (int i = 0; i < 150; ++i) {
    const glm::dvec3 p = random.in_cube(1);
    rays.emplace_back(ray(p, random.direction()));
  }
  const auto limit = [](std::uint32_t number) { return number % 3 == 0 ? 0 : trace::no_limit; };
  std::uint64_t together = 0, alone = 0;
  tree.pairs(rays, limit, Counting{together, alone}, [] {});
  CHECK(together == 100 * scene.size());
  CHECK(alone == 0);
}

namespace {

/// What rays in columns take closes them for all that lies beyond the middle of it.
struct Nearest {
  std::vector<double>& limits;
  std::uint64_t& taken;

  static bool starts() { return false; }
  void operator()(std::uint32_t, scene::ElementRef) const { FAIL("they walk together"); }
  template <class Numbers>
  std::uint64_t operator()(const trace::RayColumns&, const Numbers& numbers, std::uint64_t which,
                           scene::ElementRef) const {
    for (std::uint64_t left = which; left != 0; left &= left - 1)
      limits[numbers[static_cast<std::size_t>(std::countr_zero(left))]] = 5;
    taken += static_cast<std::uint64_t>(std::popcount(which));
    return which;
  }
};

}  // namespace

TEST_CASE("what a bundle has found is known before it comes to the next element, for however few of its rays") {
  scene::Scene scene;
  for (const double z : {5.0, 9.0, 13.0}) add(scene, scene::Sphere{{0, 0, z}, 1});
  for (int i = 0; i < 9; ++i) add(scene, scene::Sphere{{50, 50, 5 * i}, 1});  // so that a bundle walks
  const accel::WideBvh tree(scene);
  std::vector<trace::Ray> rays;  // of eight in a row one meets the spheres
  for (int i = 0; i < 64; ++i) rays.emplace_back(ray({i % 8 == 3 ? 0.1 : 1.5, 1e-3 * i, 0}, {1e-6, 1e-6, 1}));
  std::vector<double> limits(rays.size(), trace::no_limit);
  std::uint64_t taken = 0;
  tree.pairs(
      rays, [&](std::uint32_t number) { return limits[number]; }, Nearest{limits, taken}, [] {});
  CHECK(taken == 8);
}
