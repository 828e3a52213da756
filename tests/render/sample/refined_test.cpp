#include "durero/render/sample/refined.hpp"

#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

scene::Scene seen_ball() {
  scene::Scene scene = test::lit_ball();
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{24, 16};
  return scene;
}

double distance(const render::Picture& a, const render::Picture& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) squares += (a.rgb[i].x - b.rgb[i].x) * (a.rgb[i].x - b.rgb[i].x);
  return squares;
}

}  // namespace

TEST_CASE("the first pass is the picture of one ray a pixel, and later ones come nearer to that of many") {
  const scene::Scene scene = seen_ball();
  const auto engine = engine::find("analytic")->prepare(scene);
  render::Refined refined(scene, *engine, {});
  CHECK(refined.passes() == 0);
  refined.pass();
  CHECK(refined.passes() == 1);
  CHECK(refined.picture().rgb == render::render(scene, *engine).rgb);
  const render::Picture truth = render::render(scene, *engine, {}, {.samples = {.most = 1024}});
  const double first = distance(refined.picture(), truth);
  while (refined.passes() < 64) refined.pass();
  CHECK(distance(refined.picture(), truth) < first / 50);
}

TEST_CASE("a pass that is stopped has not been") {
  const scene::Scene scene = seen_ball();
  const auto engine = engine::find("analytic")->prepare(scene);
  render::Refined refined(scene, *engine, {}), whole(scene, *engine, {});
  struct Stop {};
  refined.pass();
  for (const double at : {0.0, 0.5, 0.99}) {
    CHECK_THROWS_AS(refined.pass([&](double share) {
      if (share > at) throw Stop{};
    }),
                    Stop);
    CHECK(refined.passes() == 1);
  }
  refined.pass();
  whole.pass();
  whole.pass();
  CHECK(refined.picture().rgb == whole.picture().rgb);
}

TEST_CASE("a preview of nothing is refused as a picture is") {
  scene::Scene scene = seen_ball();
  const auto engine = engine::find("analytic")->prepare(scene);
  CHECK_THROWS_AS(render::Refined(scene, *engine, {.crop = render::Crop{24, 0, {1, 1}}}), std::out_of_range);
  scene.stage().camera.reset();
  CHECK_THROWS_AS(render::Refined(scene, *engine, {}), std::domain_error);
}
