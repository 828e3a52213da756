#include "durero/engine/engine.hpp"

#include <set>
#include <string>

#include "engine/same_bytes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using engine::EngineRow;

namespace {

scene::Scene random_scene() {
  scene::Scene scene;
  for (int i = 0; i < 4; ++i) {
    add(scene, *spheres(moderate()));
    add(scene, *cylinders(moderate()));
    add(scene, *cones(moderate()));
  }
  return scene;
}

/// Rays at random, a third of which start on an element.
std::vector<scene::Query> random_queries(int count) {
  std::vector<scene::Query> queries;
  for (int i = 0; i < count; ++i) {
    scene::Query query{*rays(moderate())};
    if (i % 3 == 0) query.en.push_back({static_cast<model::Tipo>(i % 9 / 3), 1});
    queries.push_back(query);
  }
  return queries;
}

}  // namespace

TEST_CASE("an engine is found by its name, and every name is one engine's") {
  std::set<std::string_view> names;
  for (const EngineRow& row : engine::engines()) {
    CHECK(names.insert(row.name).second);
    CHECK(engine::find(row.name) == &row);
    CHECK_FALSE(row.what.empty());
  }
  CHECK(engine::find("no-such-engine") == nullptr);
  CHECK(engine::find(engine::default_engine) != nullptr);
}

TEST_CASE("an engine that promises the bytes of exact has them, on any number of threads, alone and among others") {
  property("first hits and occluded segments", [] {
    const scene::Scene scene = random_scene();
    const std::vector<scene::Query> queries = random_queries(300);
    const auto exact = engine::find("exact")->prepare(scene);
    const std::vector<scene::Hit> hits = engine::first_hits(*exact, queries);
    const auto blocked = occluded(*exact, queries);
    for (const EngineRow& row : engine::engines()) {
      if (!row.exact_bytes) continue;
      RC_ASSERT(row.honours_origins);
      const auto other = row.prepare(scene);
      RC_ASSERT(on_threads(1, [&] { return engine::first_hits(*other, queries); }) == hits);
      RC_ASSERT(engine::first_hits(*other, queries) == hits);
      RC_ASSERT(occluded(*other, queries) == blocked);
      RC_ASSERT(engine::first_hit(*other, queries[7]) == hits[7]);
      RC_ASSERT(engine::occluded_segment(*other, queries[7]) == blocked[7]);
    }
  });
}

TEST_CASE("an engine without origins answers as if there were none") {
  scene::Scene scene;
  const scene::ElementRef ball = add(scene, scene::Sphere{{0, 0, 0}, 1});
  const scene::Query leaves{ray({0, 0, -1}, {0, 0, -1}), {ball}};
  for (const EngineRow& row : engine::engines()) {
    const auto engine = row.prepare(scene);
    CAPTURE(row.name);
    if (row.honours_origins)
      CHECK(engine::first_hit(*engine, leaves).resultado == model::Resultado::miss);
    else
      CHECK(engine::first_hit(*engine, leaves) == engine::first_hit(*engine, {leaves.rayo}));
  }
}
