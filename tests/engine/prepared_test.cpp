#include "durero/engine/prepared.hpp"

#include <stdexcept>

#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// Two heaps of balls far apart, and groups of one of each heap, which no search would choose.
scene::GroupedScene across() {
  scene::GroupedScene input;
  for (int i = 0; i < 6; ++i) add(input.scene, scene::Sphere{{i % 2 == 0 ? 0.0 : 100.0, 2.0 * i, 0}, 0.5});
  for (std::uint32_t i = 0; i < 6; i += 2) {
    scene::Group pair;
    for (const std::uint32_t of : {i, i + 1})
      pair.elementos.insert(input.scene.name({model::Tipo::soy_esfera, of}).name());
    REQUIRE(input.groups.apply_total(scene::Grouping{"pair" + std::to_string(i), pair}, input.scene).ok());
  }
  return input;
}

}  // namespace

TEST_CASE("an engine is made ready with the hierarchy that is asked for, and answers the same") {
  const scene::GroupedScene input = across();
  const engine::EngineRow& bvh = *engine::find("bvh");
  const auto own = engine::prepared(bvh, engine::automatic, input),
             hand = engine::prepared(bvh, engine::by_hand, input);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 from = random.in_cube(20), aside = random.in_cube(0.4);
    const glm::dvec3 to = glm::dvec3(i % 2 == 0 ? 0 : 100, 2.0 * random.integer(0, 5), 0) + aside;
    const scene::Query query{ray(from, to - from), {}};
    CHECK(engine::first_hit(*hand, query) == engine::first_hit(*own, query));
  }
}

namespace {

const scene::Groups* followed = nullptr;

}  // namespace

TEST_CASE("by hand an engine is given the groups of the scene, and otherwise none") {
  const scene::GroupedScene input = across();
  engine::EngineRow watched = *engine::find("bvh");
  watched.prepare_by_hand = [](const scene::Scene& scene, const scene::Groups& groups) {
    followed = &groups;
    return engine::find("bvh")->prepare(scene);
  };
  engine::prepared(watched, engine::automatic, input);
  CHECK(followed == nullptr);
  engine::prepared(watched, engine::by_hand, input);
  CHECK(followed == &input.groups);
}

TEST_CASE("who follows no groups says so, and which engines do") {
  const scene::GroupedScene input = across();
  for (const engine::EngineRow& row : engine::engines()) {
    CAPTURE(row.name);
    CHECK(engine::prepared(row, engine::automatic, input) != nullptr);
    CHECK_THROWS_WITH(engine::prepared(row, "none", input),
                      "hierarchy: there is no such one; expected automatic or hand");
    if (row.prepare_by_hand != nullptr)
      CHECK(engine::prepared(row, engine::by_hand, input) != nullptr);
    else
      CHECK_THROWS_WITH(engine::prepared(row, engine::by_hand, input),
                        "hierarchy hand: " + std::string(row.name) + " follows no groups; expected engine bvh");
  }
}
