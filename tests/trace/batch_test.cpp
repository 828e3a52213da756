// The batch tells its kernel of each ray's nearest hit once, and leaves alone what the lanes cannot answer.
#include "durero/trace/batch.hpp"

#include <map>
#include <set>

#include "durero/trace/tables.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

namespace {

/// Keeps what it is told; points are the ends of what the triage says.
struct Recorder {
  using Findings = trace::Findings;
  struct Point {
    double t = trace::no_limit, error = 0;
    double low() const { return t - error; }
    double high() const { return t + error; }
  };
  static constexpr bool counted = true;
  static void triage(const trace::Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage(packet, tipo, findings);
  }
  static std::pair<double, double> bounds(const Findings& findings, std::size_t lane) {
    return {findings.low(lane), findings.high(lane)};
  }
  static Point point(const Findings& findings, std::size_t lane) { return {findings.t[lane], findings.error[lane]}; }
  void miss(std::uint32_t number) { CHECK(missing.insert(number).second); }
  void hit(std::uint32_t number, const trace::Ray& ray, const trace::Tables& tables, ElementRef own,
           const Point& point) {
    CHECK(rays.insert(number).second);
    CHECK(std::abs(ray.p.z + point.t * ray.v.z - 4) < 1e-9);
    elements[number] = tables.element(own);
  }
  std::set<std::uint32_t> rays, missing;
  std::map<std::uint32_t, ElementRef> elements;
};

/// Takes rays that start on an element too.
struct Starting : Recorder {
  static void triage_from(const trace::Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage_from(packet, tipo, findings);
  }
  void hit(std::uint32_t number, const trace::Ray&, const trace::Tables& tables, ElementRef e, const Point& point) {
    CHECK(rays.insert(number).second);
    elements[number] = tables.element(e);
    at[number] = point.t;
  }
  void hit_own(std::uint32_t number, const trace::Ray&, ElementRef e, const Point& point) {
    CHECK(rays.insert(number).second);
    own[number] = e;
    at[number] = point.t;
  }
  std::map<std::uint32_t, ElementRef> own;
  std::map<std::uint32_t, double> at;
};

template <class Observer = Recorder>
struct Block {
  Observer told;
  std::set<std::uint32_t> alone;
  std::uint64_t decided = 0;
  Block(const scene::Scene& scene, const std::vector<scene::Query>& queries) {
    const trace::Tables tables(scene);
    trace::Batch batch(tables, queries, told);
    batch.answer();
    batch.for_each_alone([&](std::uint32_t number) { CHECK(alone.insert(number).second); });
    decided = batch.decided();
  }
};

}  // namespace

TEST_CASE("a batch finds the nearest element of every ray that the lanes can answer") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 9}, 1});
  const ElementRef left = add(scene, scene::Sphere{{-3, 0, 5}, 1}), right = add(scene, scene::Sphere{{3, 0, 5}, 1});
  add(scene, scene::Sphere{{9, 0, 5}, 1});
  add(scene, scene::Sphere{{9, 0, 4.5}, 0.5});
  std::vector<scene::Query> queries;
  for (int i = 0; i < 7; ++i) queries.push_back({ray({-3, 0, 0}, {0, 0, 1.0 + i}), {}});
  for (int i = 0; i < 7; ++i) queries.push_back({ray({3, 0, 0}, {0, 0, 1.0 + i}), {}});
  queries.push_back({ray({0, 0, 0}, {0, 1, 0}), {}});        // 14: misses
  queries.push_back({ray({9, 0, 0}, {0, 0, 1}), {}});        // 15: two elements at one point
  queries.push_back({ray({-3, 0, 4}, {0, 0, 1}), {left}});   // 16: starts on an element
  queries.push_back({ray({3, 0, 0}, {0, 0, 0x1p200}), {}});  // 17: out of the ordinary
  const Block<> block(scene, queries);
  CHECK(block.alone == std::set<std::uint32_t>{15, 16, 17});
  REQUIRE(block.told.rays.size() == 14);
  for (std::uint32_t i = 0; i < 14; ++i) CHECK(block.told.elements.at(i) == (i < 7 ? left : right));
  CHECK(block.told.missing == std::set<std::uint32_t>{14});
  CHECK(block.decided >= 14);
}

TEST_CASE("where elements are out of the ordinary every ray is left alone") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 0x1p200});
  add(scene, scene::Sphere{{0, 0, 5}, 1});
  const Block<> block(scene, {{ray({0, 0, 0}, {0, 0, 1}), {}}, {ray({0, 0, 1}, {0, 0, 1}), {}}});
  CHECK(block.alone == std::set<std::uint32_t>{0, 1});
  CHECK(block.told.rays.empty());
}

TEST_CASE("a ray that starts on an element meets it where it leaves it, what is nearer, and what is beyond") {
  scene::Scene scene;
  const ElementRef ball = add(scene, scene::Sphere{{0, 0, 5}, 1}),
                   inside = add(scene, scene::Sphere{{0.5, 0, 5}, 0.25});
  const ElementRef floor = add(scene, scene::Plane{{0, 0, -2}, {0, 0, 1}});
  const ElementRef large = add(scene, scene::Sphere{{0, 0, 0}, 0x1p5});
  std::vector<scene::Query> queries;
  for (int i = 0; i < 9; ++i) queries.push_back({ray({0, 0, 4}, {0, 0, 1.0 + i}), {ball}});  // through it
  queries.push_back({ray({0, 0, 4}, {0, 0, -1}), {ball}});                                   // 9: away from it
  queries.push_back({ray({0, 0, 4}, {0.5, 0, 1}), {ball}});   // 10: something is nearer than where it leaves it
  queries.push_back({ray({1, 2, -2}, {0, 0, -1}), {floor}});  // 11: from a plane
  queries.push_back({ray({0, 0, 4}, {1, 0, 0}), {ball}});     // 12: touches it where it starts
  queries.push_back({ray({0, 0, 4}, {0, 1, 1}), {}});         // 13: does not start on it, as far as it says
  queries.push_back({ray({0, 0, 4}, {0, 0, 1}), {ball, inside}});
  const Block<Starting> block(scene, queries);
  for (std::uint32_t i = 0; i < 9; ++i) {
    REQUIRE(block.told.own.contains(i));
    CHECK(block.told.own.at(i) == ball);
    CHECK(std::abs(block.told.at.at(i) - 2.0 / (1.0 + i)) < 1e-9);
  }
  CHECK(block.told.elements.at(9) == floor);
  CHECK(std::abs(block.told.at.at(9) - 6) < 1e-9);
  CHECK(block.told.elements.at(10) == inside);
  CHECK(block.told.elements.at(11) == large);
  CHECK(block.alone.contains(13));
  CHECK(block.alone.contains(14));
  for (const std::uint32_t number : block.alone) CHECK(!block.told.rays.contains(number));
}
