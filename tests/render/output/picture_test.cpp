#include "durero/render/output/picture.hpp"

#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a picture is black at first, and then holds what the rays brought, cut nowhere") {
  const render::Picture black({3, 2});
  CHECK(black.rgb == std::vector<glm::dvec3>(6, glm::dvec3(0)));
  scene::Scene scene = test::lit_ball();
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().background = glm::dvec3(3, 0x1p-900, 1e300);
  const auto engine = engine::find("analytic")->prepare(scene);
  const render::Picture picture = render::render(scene, *engine, {}, {.size = scene::Resolution{9, 7}});
  CHECK(picture.resolution == scene::Resolution{9, 7});
  REQUIRE(picture.rgb.size() == 63);
  CHECK(picture.rgb.front() == glm::dvec3(3, 0x1p-900, 1e300));
}
