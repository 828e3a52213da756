// A million elements in one place, which no structure can part: each is made in memory of the order of their number,
// and answers.
#include <span>

#include "durero/engine/engine.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// So many identical spheres: past them and through them, by every engine with a structure.
void check_identical(std::uint32_t elements) {
  scene::Scene scene;
  scene.put_off_audits();
  for (std::uint32_t i = 0; i < elements; ++i) add(scene, scene::Sphere{{0, 0, 0}, 1});
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 60};
  scene.stage().resolution = scene::Resolution{4, 4};
  scene.stage().lights.push_back({{0, 0, -9}, {1, 1, 1}});
  const std::vector<scene::Query> queries{{ray({0, 0, -5}, {0, 0, 1}), {}}, {ray({0, 3, -5}, {0, 0, 1}), {}}};
  const std::span past(queries.data() + 1, 1);
  for (const engine::EngineRow& row : engine::engines()) {
    if (row.measure == nullptr) continue;
    INFO(row.name);
    const auto engine = row.prepare(scene);
    const std::vector<scene::Hit> hits = engine::first_hits(*engine, queries);
    CHECK(engine::occluded_segment(*engine, {ray({0, 0, -5}, {0, 0, 5}), {}}));
    CHECK_FALSE(engine::occluded_segment(*engine, {ray({0, 0, -5}, {0, 0, 3}), {}}));
    CHECK(hits[0].t == 4);
    CHECK(hits[0].elementos.size() == elements);
    CHECK(hits[1].resultado == model::Resultado::miss);
    const engine::Figures figures = row.measure(scene, past);
    UNSCOPED_INFO(row.name << ": " << figures.size.bytes / elements << " bytes an element, built in "
                           << figures.building_seconds << " s");
    CHECK(figures.size.bytes <= std::size_t{2048} * elements);
    CHECK(figures.size.depth <= 64);
  }
}

}  // namespace

TEST_CASE("every structure holds three thousand identical elements") { check_identical(3000); }
TEST_CASE("every structure holds a million identical elements", "[long]") { check_identical(1'000'000); }
