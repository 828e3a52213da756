#include "durero/render/sample/seen.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

/// The ball; a disc behind it; and a ball that touches the first where the middle ray meets it.
scene::Scene things() {
  scene::Scene scene = test::lit_ball();
  scene.apply(model::Agregar_Disco{model::Elemento("a-wall"), {0, 0, 3}, 9, {0, 0, 1}});
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 90};
  scene.stage().resolution = scene::Resolution{101, 101};
  return scene;
}

}  // namespace

TEST_CASE("what is seen in a pixel: how far, which way it faces, which element by name, and by which step") {
  const scene::Scene scene = things();
  const auto engine = engine::find("exact")->prepare(scene);
  const std::vector<render::PrimaryHit> all = render::seen(scene, *engine);
  CHECK(render::numbered(scene) == std::vector<std::string>{"a-wall", "ball"});
  const auto at = [&](std::size_t x, std::size_t y) { return all.at(y * 101 + x); };
  const render::PrimaryHit middle = at(50, 50);
  CHECK(middle.depth == Approx(4));
  CHECK(middle.normal.z == Approx(-1));  // towards the eye
  CHECK(middle.element == 2);
  CHECK(middle.level == 1);
  const render::PrimaryHit wall = at(90, 50);
  CHECK(wall.element == 1);
  CHECK(wall.normal.z == -1);  // though its vector points away
  const double across = 2.0 / 101 * 40;
  CHECK(wall.depth == Approx(8 * std::hypot(1, across)));
  const render::PrimaryHit nothing = at(0, 0);  // the wall's corner: 8·√2 beside the middle
  CHECK(std::isinf(nothing.depth));
  CHECK(nothing.normal == glm::dvec3(0));
  CHECK(nothing.element == 0);
  CHECK(nothing.level == 0);
}

TEST_CASE("a ray along a ball's tangent needs the exact step, whatever engine draws") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {1, 0, 5}, 1});
  scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90};
  const render::RenderSettings one{.size = scene::Resolution{1, 1}};
  for (const char* name : {"exact", "analytic", "fast"}) {
    const auto engine = engine::find(name)->prepare(scene);
    CHECK(render::seen(scene, *engine, one).at(0).level == 3);
  }
}

TEST_CASE("a crop sees what the whole picture does there, and of several elements the first by name is seen") {
  scene::Scene scene = things();
  scene.apply(model::Agregar_Esfera{model::Elemento("a-twin"), {0, 0, 0}, 1});
  const auto engine = engine::find("analytic")->prepare(scene);
  const std::vector<render::PrimaryHit> all = render::seen(scene, *engine);
  CHECK(all.at(50 * 101 + 50).element == 1);
  const std::vector<render::PrimaryHit> part = render::seen(scene, *engine, {.crop = render::Crop{40, 30, {20, 10}}});
  REQUIRE(part.size() == 200);
  for (std::size_t y = 0; y < 10; ++y)
    for (std::size_t x = 0; x < 20; ++x) {
      const render::PrimaryHit &a = part[y * 20 + x], &b = all[(30 + y) * 101 + 40 + x];
      CHECK((a.depth == b.depth && a.normal == b.normal && a.element == b.element && a.level == b.level));
    }
}
