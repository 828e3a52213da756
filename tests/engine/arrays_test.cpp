#include "durero/engine/arrays.hpp"

#include <oneapi/tbb/global_control.h>

#include <stdexcept>
#include <vector>

#include "engine/same_bytes.hpp"
#include "support/catch.hpp"
#include "support/failing_new.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// Rays and answers in arrays, and the queries that say the same.
struct Arrays {
  explicit Arrays(Queries of)
      : queries(std::move(of)), elements(queries.size()), t(queries.size()), point{t, t, t}, occluded(queries.size()) {
    for (const scene::Query& query : queries) {
      for (int axis = 0; axis < 3; ++axis) {
        p[static_cast<std::size_t>(axis)].push_back(query.rayo.p().xyz()[axis]);
        v[static_cast<std::size_t>(axis)].push_back(query.rayo.v().xyz()[axis]);
      }
      start.push_back(query.en.empty() ? std::nullopt : std::optional(query.en[0]));
    }
  }
  engine::RayArrays rays() const { return {{p[0], p[1], p[2]}, {v[0], v[1], v[2]}, start}; }
  engine::PointArrays points() { return {t, {point[0], point[1], point[2]}}; }
  std::span<bool> blocked() { return {occluded.data(), occluded.size()}; }

  Queries queries;
  std::array<std::vector<double>, 3> p, v;
  std::vector<std::optional<scene::ElementRef>> start;
  std::vector<trace::FirstElement> elements;
  std::vector<double> t;
  std::array<std::vector<double>, 3> point;
  boost::container::vector<bool> occluded;
};

/// Towards the middle of the scene from outside; each third starts on an element, as it stands there or not.
Queries queries(std::size_t count) {
  Random random(7);
  Queries queries;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 from = 4.0 * random.direction();
    queries.push_back({ray(from, random.in_cube(1) - from), {}});
    if (i % 3 == 0) queries.back().en.push_back({model::Tipo::soy_esfera, 0});
  }
  return queries;
}

/// A ball that rays start on, and some around it.
scene::Scene some_balls() {
  scene::Scene scene;
  Random random(8);
  for (int i = 0; i < 40; ++i) add(scene, scene::Sphere{random.in_cube(1), 0.2});
  return scene;
}

}  // namespace

TEST_CASE("arrays are answered as queries are, also where they are more than are answered at a time") {
  const scene::Scene scene = some_balls();
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, (std::size_t{1} << 17) + 5}) {
    Arrays arrays(queries(count));
    const auto fast = engine::find("fast")->prepare(scene);
    const std::vector<scene::Hit> hits = engine::first_hits(*fast, arrays.queries);
    const auto blocked = occluded(*fast, arrays.queries);
    engine::first_hits(*fast, arrays.rays(), arrays.elements, arrays.points());
    std::size_t same = 0, met = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 point(arrays.point[0][i], arrays.point[1][i], arrays.point[2][i]);
      same += arrays.elements[i] == trace::first_element(hits[i]) && arrays.t[i] == hits[i].t && point == hits[i].punto;
      met += hits[i].resultado == model::Resultado::hit;
    }
    CHECK(same == count);
    CHECK((count < 2 || (met > count / 8 && met < count)));
    std::ranges::fill(arrays.elements, trace::FirstElement{});
    engine::first_elements(*fast, arrays.rays(), arrays.elements);
    CHECK(std::ranges::equal(arrays.elements, hits, {}, {}, trace::first_element));
    engine::occluded_segments(*fast, arrays.rays(), arrays.blocked());
    CHECK(arrays.occluded == blocked);
  }
}

TEST_CASE("no ray of an array asks for memory") {
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const scene::Scene scene = some_balls();
  const auto fast = engine::find("fast")->prepare(scene);
  Arrays arrays(queries(1 << 16));
  // A block of rays takes some arrays, which are as many however many rays it has.
  constexpr long blocks = 64, of_a_block = 128;
  CHECK(allocations_of([&] { engine::first_hits(*fast, arrays.rays(), arrays.elements, arrays.points()); }) <
        blocks * of_a_block);
  CHECK(allocations_of([&] { engine::first_elements(*fast, arrays.rays(), arrays.elements); }) < blocks * of_a_block);
  CHECK(allocations_of([&] { engine::occluded_segments(*fast, arrays.rays(), arrays.blocked()); }) <
        blocks * of_a_block);
}

TEST_CASE("arrays of several lengths are refused, and so are numbers that are none of a ray") {
  const scene::Scene scene = some_balls();
  const auto fast = engine::find("fast")->prepare(scene);
  Arrays arrays(queries(5));
  const engine::RayArrays whole = arrays.rays();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    engine::RayArrays short_p = whole, short_v = whole;
    short_p.p[axis] = short_p.p[axis].first(4);
    short_v.v[axis] = short_v.v[axis].first(4);
    CHECK_THROWS_AS(engine::first_elements(*fast, short_p, arrays.elements), std::invalid_argument);
    CHECK_THROWS_AS(engine::occluded_segments(*fast, short_v, arrays.blocked()), std::invalid_argument);
    engine::PointArrays short_point = arrays.points();
    short_point.point[axis] = short_point.point[axis].first(4);
    CHECK_THROWS_AS(engine::first_hits(*fast, whole, arrays.elements, short_point), std::invalid_argument);
  }
  engine::RayArrays short_start = whole;
  short_start.start = short_start.start.first(4);
  CHECK_THROWS_AS(engine::first_elements(*fast, short_start, arrays.elements), std::invalid_argument);
  CHECK_THROWS_AS(engine::first_elements(*fast, whole, std::span(arrays.elements).first(4)), std::invalid_argument);
  CHECK_THROWS_AS(engine::occluded_segments(*fast, whole, arrays.blocked().first(4)), std::invalid_argument);
  CHECK_THROWS_AS(
      engine::first_hits(*fast, whole, arrays.elements, {std::span(arrays.t).first(4), arrays.points().point}),
      std::invalid_argument);
  arrays.p[1][3] = HUGE_VAL;
  CHECK_THROWS_AS(engine::first_elements(*fast, whole, arrays.elements), std::domain_error);
  arrays.p[1][3] = 0;
  for (std::vector<double>& column : arrays.v) column[2] = 0;
  CHECK_THROWS_AS(engine::first_elements(*fast, whole, arrays.elements), contract::contract_violation);
}
