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
  static void triage(const trace::Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage(packet, tipo, findings);
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

struct Block {
  Recorder told;
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
  const Block block(scene, queries);
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
  const Block block(scene, {{ray({0, 0, 0}, {0, 0, 1}), {}}, {ray({0, 0, 1}, {0, 0, 1}), {}}});
  CHECK(block.alone == std::set<std::uint32_t>{0, 1});
  CHECK(block.told.rays.empty());
}
